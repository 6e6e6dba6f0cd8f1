// Bodies given by closed triangle meshes: volume, centroid and inertia, and checks that a mesh encloses a body.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/mass/shape_properties.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

template <class Scalar = double>
struct TriangleMesh {
  std::vector<Vector3<Scalar>> vertices;                // m, unless the caller scales
  std::vector<std::array<std::uint32_t, 3>> triangles;  // vertex numbers, counter-clockwise seen from outside
};

// Work counted for each triangle wherever all of them are gone through: a mesh may have a million.
inline constexpr Work work_of_triangle = 100;

// The mean of the vertices: a point near the mesh, from which its tetrahedra are measured so that bodies far from the
// origin lose no digits.
template <class Scalar>
Vector3<Scalar> mean_vertex(const TriangleMesh<Scalar>& mesh) {
  Vector3<Scalar> total = Vector3<Scalar>::zero();
  for (const auto& vertex : mesh.vertices) total += vertex;
  return total / Scalar(static_cast<double>(mesh.vertices.size()));
}

namespace detail {

// Sums over the triangles pqr of a mesh, each with its part of the whole, measure(p, q, r). The part has its first
// moment in the mean of `corners` points, of which p, q, r are three and the others the reference, and its second
// moments as masses part/second have at p, q, r and p + q + r.
template <class Scalar, class Measure>
ShapeProperties<Scalar> over_triangles(const TriangleMesh<Scalar>& mesh, int corners, int second,
                                       const Measure& measure) {
  const Vector3<Scalar> reference = mean_vertex(mesh);
  Scalar whole(0);
  Vector3<Scalar> first_moment = Vector3<Scalar>::zero();
  SymmetricMatrix3<Scalar> inertia = SymmetricMatrix3<Scalar>::zero();
  for (const auto& [i, j, k] : mesh.triangles) {
    count_work(work_of_triangle);
    const Vector3<Scalar> p = mesh.vertices[i] - reference;
    const Vector3<Scalar> q = mesh.vertices[j] - reference;
    const Vector3<Scalar> r = mesh.vertices[k] - reference;
    const Vector3<Scalar> all = p + q + r;
    const Scalar part = measure(p, q, r);
    whole += part;
    first_moment += (part / Scalar(corners)) * all;
    inertia += (part / Scalar(second)) *
               (unit_mass_inertia(p) + unit_mass_inertia(q) + unit_mass_inertia(r) + unit_mass_inertia(all));
  }
  const Vector3<Scalar> offset = first_moment / whole;
  return {whole, reference + offset, (Scalar(1) / whole) * inertia - unit_mass_inertia(offset)};
}

}  // namespace detail

// The uniform solid inside a closed mesh: the signed tetrahedra between its triangles and a point near it. Inner
// surfaces (cavities) face inward into the cavity. Nothing is checked here: see find_faults.
template <class Scalar>
ShapeProperties<Scalar> solid_of_mesh(const TriangleMesh<Scalar>& mesh) {
  using Vector = Vector3<Scalar>;
  return detail::over_triangles(mesh, 4, 20, [](const Vector& p, const Vector& q, const Vector& r) {
    return Scalar(dot(p, cross(q, r)) / Scalar(6));
  });
}

// The uniform sheet on a mesh, closed or not.
template <class Scalar>
ShapeProperties<Scalar> shell_of_mesh(const TriangleMesh<Scalar>& mesh) {
  using Vector = Vector3<Scalar>;
  return detail::over_triangles(mesh, 3, 12, [](const Vector& p, const Vector& q, const Vector& r) {
    return Scalar(Scalar(0.5) * norm(cross(q - p, r - p)));
  });
}

namespace particles {

// Four particles in each tetrahedron between a triangle and the first vertex, with the sign of its volume (Keast's rule
// of degree 2).
template <class Scalar>
ParticleSet<Scalar> solid_of_mesh(const TriangleMesh<Scalar>& mesh) {
  const Scalar far = (5 - std::sqrt(Scalar(5))) / 20;
  const Scalar near = 1 - 4 * far;
  const Vector3<Scalar>& apex = mesh.vertices.front();
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& triangle : mesh.triangles) {
    count_work(work_of_triangle);
    const Vector3<Scalar>& A = mesh.vertices[triangle[0]];
    const Vector3<Scalar>& B = mesh.vertices[triangle[1]];
    const Vector3<Scalar>& C = mesh.vertices[triangle[2]];
    const Scalar volume = determinant(Matrix3<Scalar>{A - apex, B - apex, C - apex}) / 6;
    const Vector3<Scalar> all = far * (apex + A + B + C);
    for (const auto& corner : {apex, A, B, C}) gatherer.add(all + near * corner, volume / 4);
  }
  return gatherer.finish();
}

}  // namespace particles

enum class MeshRule {
  has_triangles,
  known_vertices,  // every triangle refers to existing vertices
  finite_vertices,
  proper_triangles,        // three different corners that are not on a line
  closed_surface,          // every edge belongs to two triangles
  consistent_orientation,  // and they run along it in opposite directions
  outward_orientation,     // the volume is positive
  separate_parts,          // parts are separate, or are cavities in each other
};

struct MeshFault {
  MeshRule rule{};
  std::string message;    // what is wrong, how often, and where first
  std::size_t count = 0;  // triangles, vertices or edges at fault
};

// Every rule that the mesh breaks, with one entry for each; empty for a mesh that encloses a body. `name` is the mesh's
// name in messages. Later rules are checked only if earlier ones allow it.
std::vector<MeshFault> find_faults(const TriangleMesh<double>& mesh, const std::string& name);

}  // namespace poinsot
