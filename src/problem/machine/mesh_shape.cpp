#include "problem/machine/mesh_shape.h"

#include <filesystem>
#include <map>

#include "poinsot/engine/mass/mesh_reader.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {
namespace {

// A problem file is small. Its meshes may be large, but within limits.
constexpr MeshLimits limits{std::size_t{64} << 20, 1'000'000};

std::string path_of(const Shape& shape, const std::string& problem_file) {
  namespace fs = std::filesystem;
  const fs::path folder = problem_file == "-" ? fs::path(".") : fs::path(problem_file).parent_path();
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder);
  const fs::path path = fs::weakly_canonical(root / shape.file);
  const auto inside = std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
  if (!inside || fs::path(shape.file).is_absolute())
    fail(problem_file, shape.mark, "the mesh '" + shape.file + "' does not lie in the folder of the problem file",
         "copy it there and name it without a path");
  return path.string();
}

// Reads the mesh in meters, with its origin at p_OM.
TriangleMesh<double> read_mesh(const Shape& shape, const Vector3<double>& p_OM, const std::string& problem_file) {
  if (!same_kind(shape.mesh_unit.dimension, dimensions::length))
    fail(problem_file, shape.mark,
         "the unit of a mesh is a unit of length, not " + to_string(shape.mesh_unit.dimension));
  const std::string path = path_of(shape, problem_file);
  MeshReadResult read = read_mesh_file(path, limits);
  if (!read.mesh) {
    // The message names the mesh as its author does.
    std::string message = read.error.message;
    if (message.starts_with(path)) message.replace(0, path.size(), "mesh '" + shape.file + "'");
    fail(problem_file, shape.mark, message);
  }
  for (Vector3<double>& vertex : read.mesh->vertices) vertex = shape.mesh_unit.factor * vertex + p_OM;
  const std::vector<MeshFault> faults = find_faults(*read.mesh, shape.file);
  if (!faults.empty()) fail(problem_file, shape.mark, faults.front().message);
  return *std::move(read.mesh);
}

}  // namespace

template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM) {
  if (is_exact<Scalar>) throw NoFormula("the numbers of a mesh are not exact");
  const TriangleMesh<double> mesh = read_mesh(arguments.shape(), plain(p_OM), arguments.file());
  const ShapeProperties<double> solid = solid_of_mesh(mesh);
  // The mesh itself is constant, but its place may vary.
  const Vector3<Scalar> moved = p_OM - lifted<Scalar>(plain(p_OM));
  const ShapeProperties<Scalar> properties{lifted<Scalar>(solid.measure), lifted<Scalar>(solid.center) + moved,
                                           lifted<Scalar>(solid.inertia_center)};
  return arguments.values(Extent::volume, properties, [&] { return particles::solid_of_mesh(mesh); });
}

template ShapeValues<double> mesh_shape(const ShapeArguments<double>&, const Vector3<double>&);
template ShapeValues<Dual<1>> mesh_shape(const ShapeArguments<Dual<1>>&, const Vector3<Dual<1>>&);
template ShapeValues<Formula> mesh_shape(const ShapeArguments<Formula>&, const Vector3<Formula>&);

}  // namespace poinsot::problem
