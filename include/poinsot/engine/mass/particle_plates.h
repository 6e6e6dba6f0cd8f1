// Particles for thin plates; names and arguments as in poinsot/engine/mass/plates.h.
#pragma once

#include <array>

#include "poinsot/engine/mass/particle_set.h"

namespace poinsot::particles {

template <class Scalar>
ParticleSet<Scalar> rectangle(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a,
                              const Vector3<Scalar>& edge_b) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_parallelogram(center - (edge_a + edge_b) / Scalar(2), edge_a, edge_b);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> rectangle_from_corners(const Vector3<Scalar>& A, const Vector3<Scalar>& B,
                                           const Vector3<Scalar>& C) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_parallelogram(B, A - B, C - B);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> triangle(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_triangle(A, B, C, norm(cross(B - A, C - A)) / 2);
  return gatherer.finish();
}

// Triangles fanned from the first vertex, each with the sign of its turn; a reflex corner gives negative fractions.
template <class Scalar>
ParticleSet<Scalar> polygon(const std::vector<Vector3<Scalar>>& vertices) {
  const Vector3<Scalar>& apex = vertices.front();
  Vector3<Scalar> turn = Vector3<Scalar>::zero();
  for (std::size_t i = 2; i < vertices.size(); ++i) turn += cross(vertices[i - 1] - apex, vertices[i] - apex);
  const Vector3<Scalar> normal = turn / norm(turn);
  cubature::Gatherer<Scalar> gatherer;
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    const Scalar area = dot(cross(vertices[i - 1] - apex, vertices[i] - apex), normal) / 2;
    gatherer.add_triangle(apex, vertices[i - 1], vertices[i], area);
  }
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> polygon_in_plane(const std::vector<std::array<Scalar, 2>>& coordinates,
                                     const Vector3<Scalar>& origin, const Vector3<Scalar>& axis_u,
                                     const Vector3<Scalar>& axis_v) {
  const cubature::Triad<Scalar> triad(cross(axis_u, axis_v), axis_u);
  std::vector<Vector3<Scalar>> vertices;
  for (const auto& [u, v] : coordinates) vertices.push_back(origin + u * triad.first + v * triad.second);
  return polygon(vertices);
}

template <class Scalar>
ParticleSet<Scalar> annulus(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& outer_radius,
                            const Scalar& inner_radius) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_annulus(center, cubature::Triad<Scalar>(normal), inner_radius, outer_radius);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> disk(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius) {
  return annulus(center, normal, radius, Scalar(0));
}

template <class Scalar>
ParticleSet<Scalar> semicircle(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& toward) {
  const cubature::Triad<Scalar> triad(cross(A - B, toward), A - B);
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_sector((A + B) / Scalar(2), triad, norm(A - B) / 2, Scalar(0), std::numbers::pi_v<Scalar>);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius,
                           const Vector3<Scalar>& middle_direction, const Scalar& angle) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_sector(center, {normal, middle_direction}, radius, -angle / 2, angle / 2);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> annular_sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                   const Scalar& outer_radius, const Scalar& inner_radius,
                                   const Vector3<Scalar>& middle_direction, const Scalar& angle) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_sector(center, {normal, middle_direction}, outer_radius, -angle / 2, angle / 2, inner_radius);
  return gatherer.finish();
}

}  // namespace poinsot::particles
