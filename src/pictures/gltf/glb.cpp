#include "pictures/gltf/glb.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace poinsot::pictures {
namespace {

constexpr int float_component = 5126;

// Four bytes, the lowest first.
void append(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xffU);
}

// A part of the file, filled up to a multiple of four bytes.
std::string chunk(std::string content, const char* type, char filling) {
  content.resize((content.size() + 3) / 4 * 4, filling);
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(content.size()));
  return bytes.append(type, 4) + content;
}

}  // namespace

std::size_t Glb::add(const float* numbers, std::size_t count, std::size_t width, const char* type, bool bounds) {
  views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", 4 * count * width}});
  Json accessor{
      {"bufferView", views_.size() - 1}, {"componentType", float_component}, {"count", count}, {"type", type}};
  if (bounds) {
    Json least = Json::array(), greatest = Json::array();
    for (std::size_t part = 0; part < width; ++part) {
      float low = numbers[part], high = numbers[part];
      for (std::size_t i = 0; i < count; ++i) {
        low = std::min(low, numbers[i * width + part]);
        high = std::max(high, numbers[i * width + part]);
      }
      least.push_back(low);
      greatest.push_back(high);
    }
    accessor["min"] = least;
    accessor["max"] = greatest;
  }
  for (std::size_t i = 0; i < count * width; ++i) append(bytes_, std::bit_cast<std::uint32_t>(numbers[i]));
  accessors_.push_back(accessor);
  return accessors_.size() - 1;
}

std::size_t Glb::add_scalars(const std::vector<float>& values) {
  return add(values.data(), values.size(), 1, "SCALAR", true);
}
std::size_t Glb::add_vectors(const std::vector<std::array<float, 3>>& vectors) {
  return add(vectors.front().data(), vectors.size(), 3, "VEC3", true);
}
std::size_t Glb::add_quaternions(const std::vector<std::array<float, 4>>& quaternions) {
  return add(quaternions.front().data(), quaternions.size(), 4, "VEC4", false);
}

std::string Glb::file(Json content) const {
  if (!accessors_.empty()) {
    content["accessors"] = accessors_;
    content["bufferViews"] = views_;
    content["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  }
  std::string chunks = chunk(content.dump(-1, ' ', false, Json::error_handler_t::replace), "JSON", ' ');
  if (!bytes_.empty()) chunks += chunk(bytes_, "BIN\0", '\0');
  std::string file = "glTF";
  append(file, 2);
  append(file, static_cast<std::uint32_t>(12 + chunks.size()));
  return file + chunks;
}

}  // namespace poinsot::pictures
