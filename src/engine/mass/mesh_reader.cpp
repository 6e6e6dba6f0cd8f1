#include "poinsot/engine/mass/mesh_reader.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/mass/mesh_formats.h"
#include "engine/mass/text_scanner.h"

namespace poinsot {
namespace {

MeshReadResult failed(const std::string& name, const std::string& message) {
  return {std::nullopt, {name + ": " + message, 0, 0}};
}

std::string too_large(std::uintmax_t size, const MeshLimits& limits) {
  return fmt::format("{} bytes are more than the limit of {}", size, limits.bytes);
}

}  // namespace

MeshReadResult read_mesh(std::string_view bytes, MeshFormat format, const std::string& name, const MeshLimits& limits) {
  if (bytes.size() > limits.bytes) return failed(name, too_large(bytes.size(), limits));
  MeshReadResult result =
      format == MeshFormat::stl ? mesh_text::read_stl(bytes, name, limits) : mesh_text::read_obj(bytes, name, limits);
  if (result.mesh && result.mesh->triangles.empty()) return failed(name, "the file has no triangles");
  return result;
}

MeshReadResult read_mesh_file(const std::string& path, const MeshLimits& limits) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const bool is_stl = mesh_text::equal_ignoring_case(ending, ".stl");
  if (!is_stl && !mesh_text::equal_ignoring_case(ending, ".obj")) {
    return failed(path, "unknown kind of mesh file; expected a name that ends in .stl or .obj");
  }
  // Devices and folders have no size to hold against the limit.
  std::error_code trouble;
  const auto status = std::filesystem::status(path, trouble);
  if (!std::filesystem::exists(status)) return failed(path, "the file does not exist");
  if (!std::filesystem::is_regular_file(status)) return failed(path, "not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, trouble);
  if (trouble) return failed(path, "cannot be read: " + trouble.message());
  if (size > limits.bytes) return failed(path, too_large(size, limits));

  std::ifstream stream(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
    return failed(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  return read_mesh(bytes, is_stl ? MeshFormat::stl : MeshFormat::obj, path, limits);
}

}  // namespace poinsot
