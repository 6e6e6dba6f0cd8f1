// The readers of single mesh formats, chosen by read_mesh.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "poinsot/engine/mass/mesh_reader.h"

namespace poinsot::mesh_text {

inline MeshReadResult error_at_line(const std::string& name, std::size_t line, const std::string& message) {
  return {std::nullopt, {fmt::format("{}:{}: {}", name, line, message), line, 0}};
}
inline MeshReadResult error_at_byte(const std::string& name, std::size_t offset, const std::string& message) {
  return {std::nullopt, {fmt::format("{}: byte {}: {}", name, offset, message), 0, offset}};
}
inline std::string too_many_triangles(const MeshLimits& limits) {
  return fmt::format("more than {} triangles; simplify the mesh or raise the limit", limits.triangles);
}

MeshReadResult read_stl(std::string_view bytes, const std::string& name, const MeshLimits& limits);
MeshReadResult read_obj(std::string_view bytes, const std::string& name, const MeshLimits& limits);

}  // namespace poinsot::mesh_text
