// Particles for thin shells; names and arguments as in poinsot/engine/mass/shells.h.
#pragma once

#include "poinsot/engine/mass/particle_set.h"

namespace poinsot::particles {

template <class Scalar>
ParticleSet<Scalar> box_shell(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a,
                              const Vector3<Scalar>& edge_b, const Vector3<Scalar>& edge_c) {
  const Vector3<Scalar> low = center - (edge_a + edge_b + edge_c) / Scalar(2);
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_parallelogram(low, edge_a, edge_b);
  gatherer.add_parallelogram(low + edge_c, edge_a, edge_b);
  gatherer.add_parallelogram(low, edge_b, edge_c);
  gatherer.add_parallelogram(low + edge_a, edge_b, edge_c);
  gatherer.add_parallelogram(low, edge_c, edge_a);
  gatherer.add_parallelogram(low + edge_b, edge_c, edge_a);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> box_shell_between(const Vector3<Scalar>& corner, const Vector3<Scalar>& opposite,
                                      const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  const Vector3<Scalar> diagonal = opposite - corner;
  Vector3<Scalar> edges[3];
  for (std::size_t i = 0; i < 3; ++i) edges[i] = dot(diagonal, axes.column(i)) * axes.column(i);
  return box_shell((corner + opposite) / Scalar(2), edges[0], edges[1], edges[2]);
}

namespace detail {

// Zone of a sphere from the height `low` to the height `high` on the axis, both in radii: equal heights have equal
// areas.
template <class Scalar>
ParticleSet<Scalar> spherical_zone(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius,
                                   const Scalar& low, const Scalar& high) {
  const cubature::Triad<Scalar> triad(axis);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& u : cubature::gauss<2, Scalar>()) {
    const Scalar height = low + u.at * (high - low);
    gatherer.add_circle(center + (radius * height) * triad.third, triad, radius * std::sqrt(1 - height * height),
                        u.weight * (high - low) * 2 * std::numbers::pi_v<Scalar> * radius * radius);
  }
  return gatherer.finish();
}

template <class Scalar>
void add_wall(cubature::Gatherer<Scalar>& gatherer, const cubature::Triad<Scalar>& triad, const Vector3<Scalar>& A,
              const Vector3<Scalar>& B, const Scalar& radius) {
  for (const auto& s : cubature::gauss<2, Scalar>()) {
    gatherer.add_circle(A + s.at * (B - A), triad, radius,
                        s.weight * norm(B - A) * 2 * std::numbers::pi_v<Scalar> * radius);
  }
}

}  // namespace detail

template <class Scalar>
ParticleSet<Scalar> sphere_shell(const Vector3<Scalar>& center, const Scalar& radius) {
  return detail::spherical_zone(center, Vector3<Scalar>::unit(2), radius, Scalar(-1), Scalar(1));
}

template <class Scalar>
ParticleSet<Scalar> hemisphere_shell(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius) {
  return detail::spherical_zone(center, axis, radius, Scalar(0), Scalar(1));
}

template <class Scalar>
ParticleSet<Scalar> cylinder_shell(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius) {
  cubature::Gatherer<Scalar> gatherer;
  detail::add_wall(gatherer, cubature::Triad<Scalar>(B - A), A, B, radius);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> closed_cylinder_shell(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius) {
  const cubature::Triad<Scalar> triad(B - A);
  cubature::Gatherer<Scalar> gatherer;
  detail::add_wall(gatherer, triad, A, B, radius);
  gatherer.add_annulus(A, triad, Scalar(0), radius);
  gatherer.add_annulus(B, triad, Scalar(0), radius);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> cone_shell(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center, const Scalar& radius) {
  const cubature::Triad<Scalar> triad(base_center - apex);
  const Scalar slant = std::hypot(radius, norm(base_center - apex));
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<2, Scalar>()) {
    const Scalar r = s.at * radius;
    gatherer.add_circle(apex + s.at * (base_center - apex), triad, r,
                        s.weight * slant * 2 * std::numbers::pi_v<Scalar> * r);
  }
  return gatherer.finish();
}

}  // namespace poinsot::particles
