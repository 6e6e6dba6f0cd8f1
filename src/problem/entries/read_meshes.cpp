#include "problem/entries/read_meshes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/mass/mesh_reader.h"

namespace poinsot::problem {
namespace {

constexpr MeshLimits mesh_limits{most_bytes_of_named_file, 1'000'000};

std::optional<MeshFormat> format_of(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  if (ending == ".stl") return MeshFormat::stl;
  if (ending == ".obj") return MeshFormat::obj;
  return std::nullopt;
}

class MeshShelf {
 public:
  MeshShelf(const ReadNamedFile& read, const std::string& problem_file) : read_(read), problem_file_(problem_file) {}

  std::shared_ptr<const MeshSolid> solid(const Shape& shape) {
    if (!same_kind(shape.mesh_unit.dimension, dimensions::length))
      fail(problem_file_, shape.mark,
           "the unit of a mesh is a unit of length, not " + to_string(shape.mesh_unit.dimension));
    std::shared_ptr<const MeshSolid>& known = solids_[{shape.file, shape.mesh_unit.factor}];
    if (!known) known = read_solid(shape);
    return known;
  }

 private:
  std::shared_ptr<const MeshSolid> read_solid(const Shape& shape) {
    const std::string mesh = "mesh '" + shape.file + "'";
    const std::optional<MeshFormat> format = format_of(shape.file);
    if (!format)
      fail(problem_file_, shape.mark, mesh + ": unknown kind of mesh file; expected a name that ends in .stl or .obj");
    auto solid = std::make_shared<MeshSolid>();
    solid->bytes = bytes(shape);
    MeshReadResult read = read_mesh(*solid->bytes, *format, mesh, mesh_limits);
    if (!read.mesh) fail(problem_file_, shape.mark, read.error.message);
    solid->mesh = *std::move(read.mesh);
    for (Vector3<double>& vertex : solid->mesh.vertices) vertex = shape.mesh_unit.factor * vertex;
    const std::vector<MeshFault> faults = find_faults(solid->mesh, shape.file);
    if (!faults.empty()) fail(problem_file_, shape.mark, faults.front().message);
    solid->properties = solid_of_mesh(solid->mesh);
    return solid;
  }

  std::shared_ptr<const std::string> bytes(const Shape& shape) {
    std::shared_ptr<const std::string>& known = bytes_[shape.file];
    try {
      if (!known) known = std::make_shared<const std::string>(read_(shape.file));
    } catch (const FileRefused& refused) {
      fail(problem_file_, shape.mark, "mesh '" + shape.file + "': " + refused.what(), refused.hint());
    }
    return known;
  }

  const ReadNamedFile& read_;
  const std::string& problem_file_;
  std::map<std::string, std::shared_ptr<const std::string>> bytes_;                    // by the file's name
  std::map<std::pair<std::string, double>, std::shared_ptr<const MeshSolid>> solids_;  // and a unit's size in metres
};

}  // namespace

void read_meshes(Statement& statement, const ReadNamedFile& read) {
  MeshShelf shelf(read, statement.file);
  for (Situation& situation : statement.situations)
    for (Body& body : situation.bodies)
      for (std::vector<Part>* parts : {&body.parts, &body.added})
        for (Part& part : *parts)
          if (part.shape.kind == "mesh") part.shape.mesh = shelf.solid(part.shape);
}

}  // namespace poinsot::problem
