// A glTF 2.0 file in its binary form (GLB): numbers go into one buffer, of which accessors tell what they are.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace poinsot::pictures {

class Glb {
 public:
  using Json = nlohmann::ordered_json;

  // Each returns the number of the accessor. Numbers are single precision.
  std::size_t add_scalars(const std::vector<float>& values);
  std::size_t add_vectors(const std::vector<std::array<float, 3>>& vectors);
  std::size_t add_quaternions(const std::vector<std::array<float, 4>>& quaternions);

  // The file, with what belongs to it beside buffer and accessors: nodes, meshes, ...
  std::string file(Json content) const;

 private:
  std::size_t add(const float* numbers, std::size_t count, std::size_t width, const char* type, bool bounds);

  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

}  // namespace poinsot::pictures
