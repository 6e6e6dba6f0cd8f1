// Particles for rods and wires; names and arguments as in poinsot/engine/mass/lines.h.
#pragma once

#include "poinsot/engine/mass/particle_set.h"

namespace poinsot::particles {

template <class Scalar>
ParticleSet<Scalar> particle(const Vector3<Scalar>& point) {
  return {Scalar(0), {{Scalar(1), point}}};
}

template <class Scalar>
ParticleSet<Scalar> rod(const Vector3<Scalar>& A, const Vector3<Scalar>& B) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_rod(A, B);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> polyline(const std::vector<Vector3<Scalar>>& points) {
  cubature::Gatherer<Scalar> gatherer;
  for (std::size_t i = 1; i < points.size(); ++i) gatherer.add_rod(points[i - 1], points[i]);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> arc(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                        const Vector3<Scalar>& start_direction, const Scalar& radius, const Scalar& angle) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_arc(center, {normal, start_direction}, radius, Scalar(0), angle);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> arc_from_point(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                   const Vector3<Scalar>& start_point, const Scalar& angle) {
  const Scalar radius = norm(cross(normal, start_point - center)) / norm(normal);
  return arc(center, normal, start_point - center, radius, angle);
}

template <class Scalar>
ParticleSet<Scalar> ring(const Vector3<Scalar>& center, const Vector3<Scalar>& normal, const Scalar& radius) {
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_circle(center, cubature::Triad<Scalar>(normal), radius, 2 * std::numbers::pi_v<Scalar> * radius);
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> semicircular_arc(const Vector3<Scalar>& A, const Vector3<Scalar>& B,
                                     const Vector3<Scalar>& toward) {
  // From A through the bulge to B: the first vector of the triad points to A, the second bulges.
  const cubature::Triad<Scalar> triad(cross(A - B, toward), A - B);
  cubature::Gatherer<Scalar> gatherer;
  gatherer.add_arc((A + B) / Scalar(2), triad, norm(A - B) / 2, Scalar(0), std::numbers::pi_v<Scalar>);
  return gatherer.finish();
}

}  // namespace poinsot::particles
