// Particles for solids; names and arguments as in poinsot/engine/mass/solids.h.
#pragma once

#include "poinsot/engine/mass/particle_set.h"

namespace poinsot::particles {

template <class Scalar>
ParticleSet<Scalar> box(const Vector3<Scalar>& center, const Vector3<Scalar>& edge_a, const Vector3<Scalar>& edge_b,
                        const Vector3<Scalar>& edge_c) {
  const auto& nodes = cubature::gauss<2, Scalar>();
  const Vector3<Scalar> low = center - (edge_a + edge_b + edge_c) / Scalar(2);
  const Scalar volume = std::abs(dot(edge_a, cross(edge_b, edge_c)));
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : nodes) {
    for (const auto& t : nodes) {
      for (const auto& u : nodes) {
        gatherer.add(low + s.at * edge_a + t.at * edge_b + u.at * edge_c, s.weight * t.weight * u.weight * volume);
      }
    }
  }
  return gatherer.finish();
}

template <class Scalar>
ParticleSet<Scalar> box_between(const Vector3<Scalar>& corner, const Vector3<Scalar>& opposite,
                                const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  const Vector3<Scalar> diagonal = opposite - corner;
  Vector3<Scalar> edges[3];
  for (std::size_t i = 0; i < 3; ++i) edges[i] = dot(diagonal, axes.column(i)) * axes.column(i);
  return box((corner + opposite) / Scalar(2), edges[0], edges[1], edges[2]);
}

// On the coordinate axes.
template <class Scalar>
ParticleSet<Scalar> cube(const Vector3<Scalar>& center, const Scalar& edge) {
  return box(center, edge * Vector3<Scalar>::unit(0), edge * Vector3<Scalar>::unit(1), edge * Vector3<Scalar>::unit(2));
}

// The three edges that meet at B lean evenly round the diagonal, a third of it each along it.
template <class Scalar>
ParticleSet<Scalar> cube_from_diagonal(const Vector3<Scalar>& B, const Vector3<Scalar>& C) {
  const cubature::Triad<Scalar> triad(C - B);
  const Scalar length = norm(C - B);
  Vector3<Scalar> edges[3];
  for (int k = 0; k < 3; ++k) {
    const Scalar turn = 2 * std::numbers::pi_v<Scalar> * Scalar(k) / 3;
    edges[k] = (length / 3) * triad.third + (length * std::sqrt(Scalar(2)) / 3) * triad.at_angle(turn);
  }
  return box((B + C) / Scalar(2), edges[0], edges[1], edges[2]);
}

namespace detail {

// Frustum of a cone with a coaxial conical hole: radii from inner_A..outer_A at A to inner_B..outer_B at B.
template <class Scalar>
ParticleSet<Scalar> turned_solid(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& outer_A,
                                 const Scalar& outer_B, const Scalar& inner_A, const Scalar& inner_B) {
  const cubature::Triad<Scalar> triad(B - A);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<3, Scalar>()) {
    const Scalar outer = outer_A + s.at * (outer_B - outer_A);
    const Scalar inner = inner_A + s.at * (inner_B - inner_A);
    for (const auto& t : cubature::gauss<2, Scalar>()) {
      const Scalar radius = inner + t.at * (outer - inner);
      gatherer.add_circle(
          A + s.at * (B - A), triad, radius,
          s.weight * norm(B - A) * t.weight * (outer - inner) * 2 * std::numbers::pi_v<Scalar> * radius);
    }
  }
  return gatherer.finish();
}

// Part of an ellipsoid with the semi-axis vectors a, b, c between the heights `low` and 1 along c: the image of part of
// the unit ball, integrated over radius, height and azimuth.
template <class Scalar>
ParticleSet<Scalar> ball_image(const Vector3<Scalar>& center, const Vector3<Scalar>& a, const Vector3<Scalar>& b,
                               const Vector3<Scalar>& c, const Scalar& low) {
  const Scalar stretch = std::abs(dot(a, cross(b, c)));
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<3, Scalar>()) {
    for (const auto& t : cubature::gauss<2, Scalar>()) {
      const Scalar height = low + t.at * (1 - low);
      const Scalar side = std::sqrt(1 - height * height);
      for (int k = 0; k < 3; ++k) {
        const Scalar azimuth = 2 * std::numbers::pi_v<Scalar> * Scalar(k) / 3;
        const Vector3<Scalar> direction = (side * std::cos(azimuth)) * a + (side * std::sin(azimuth)) * b + height * c;
        gatherer.add(center + s.at * direction,
                     stretch * s.weight * s.at * s.at * t.weight * (1 - low) * 2 * std::numbers::pi_v<Scalar> / 3);
      }
    }
  }
  return gatherer.finish();
}

}  // namespace detail

template <class Scalar>
ParticleSet<Scalar> cylinder(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius) {
  return detail::turned_solid(A, B, radius, radius, Scalar(0), Scalar(0));
}

template <class Scalar>
ParticleSet<Scalar> tube(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& outer_radius,
                         const Scalar& inner_radius) {
  return detail::turned_solid(A, B, outer_radius, outer_radius, inner_radius, inner_radius);
}

template <class Scalar>
ParticleSet<Scalar> cone(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center, const Scalar& radius) {
  return detail::turned_solid(apex, base_center, Scalar(0), radius, Scalar(0), Scalar(0));
}

template <class Scalar>
ParticleSet<Scalar> frustum(const Vector3<Scalar>& A, const Scalar& radius_A, const Vector3<Scalar>& B,
                            const Scalar& radius_B) {
  return detail::turned_solid(A, B, radius_A, radius_B, Scalar(0), Scalar(0));
}

template <class Scalar>
ParticleSet<Scalar> ellipsoid(const Vector3<Scalar>& center, const Vector3<Scalar>& semi_axis_a,
                              const Vector3<Scalar>& semi_axis_b, const Vector3<Scalar>& semi_axis_c) {
  return detail::ball_image(center, semi_axis_a, semi_axis_b, semi_axis_c, Scalar(-1));
}

template <class Scalar>
ParticleSet<Scalar> sphere(const Vector3<Scalar>& center, const Scalar& radius) {
  return ellipsoid(center, radius * Vector3<Scalar>::unit(0), radius * Vector3<Scalar>::unit(1),
                   radius * Vector3<Scalar>::unit(2));
}

template <class Scalar>
ParticleSet<Scalar> hemisphere(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& radius) {
  const cubature::Triad<Scalar> triad(axis);
  return detail::ball_image(center, radius * triad.first, radius * triad.second, radius * triad.third, Scalar(0));
}

// Circles round the axis through points of the section, which lie on circles of three radii, four points on each: the
// distance from the axis enters cubed.
template <class Scalar>
ParticleSet<Scalar> torus(const Vector3<Scalar>& center, const Vector3<Scalar>& axis, const Scalar& ring_radius,
                          const Scalar& section_radius) {
  const Scalar full_turn = 2 * std::numbers::pi_v<Scalar>;
  const cubature::Triad<Scalar> triad(axis);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<3, Scalar>()) {
    const Scalar r = s.at * section_radius;
    for (int k = 0; k < 4; ++k) {
      const Scalar angle = full_turn * Scalar(k) / 4;
      const Scalar distance = ring_radius + r * std::cos(angle);
      gatherer.add_circle(center + (r * std::sin(angle)) * triad.third, triad, distance,
                          s.weight * section_radius * (full_turn * r / 4) * (full_turn * distance));
    }
  }
  return gatherer.finish();
}

// Four points on the lines from the centroid to the corners (Keast's rule of degree 2).
template <class Scalar>
ParticleSet<Scalar> tetrahedron(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C,
                                const Vector3<Scalar>& D) {
  const Scalar far = (5 - std::sqrt(Scalar(5))) / 20;
  const Scalar near = 1 - 4 * far;
  const Scalar volume = std::abs(dot(B - A, cross(C - A, D - A))) / 6;
  const Vector3<Scalar> all = far * (A + B + C + D);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& corner : {A, B, C, D}) gatherer.add(all + near * corner, volume / 4);
  return gatherer.finish();
}

// Triangles fanned from the first vertex of the base, with the signs of their turns, at two heights.
template <class Scalar>
ParticleSet<Scalar> prism(const std::vector<Vector3<Scalar>>& base, const Vector3<Scalar>& edge) {
  Vector3<Scalar> turn = Vector3<Scalar>::zero();
  for (std::size_t i = 2; i < base.size(); ++i) turn += cross(base[i - 1] - base[0], base[i] - base[0]);
  const Scalar sense(dot(turn, edge) < 0 ? -1 : 1);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<2, Scalar>()) {
    const Vector3<Scalar> up = s.at * edge;
    for (std::size_t i = 2; i < base.size(); ++i) {
      const Scalar volume = sense * dot(cross(base[i - 1] - base[0], base[i] - base[0]), edge) / 2;
      gatherer.add_triangle(base[0] + up, base[i - 1] + up, base[i] + up, s.weight * volume);
    }
  }
  return gatherer.finish();
}

// Points on half circles of two radii across the axis, at two heights.
template <class Scalar>
ParticleSet<Scalar> half_cylinder(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Scalar& radius,
                                  const Vector3<Scalar>& toward) {
  const cubature::Triad<Scalar> triad(B - A, cross(toward, B - A));
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<2, Scalar>())
    for (const auto& t : cubature::gauss<2, Scalar>())
      for (const auto& u : cubature::gauss<cubature::points_on_arc, Scalar>()) {
        const Scalar r = t.at * radius;
        gatherer.add(A + s.at * (B - A) + r * triad.at_angle(u.at * std::numbers::pi_v<Scalar>),
                     s.weight * norm(B - A) * t.weight * radius * r * u.weight * std::numbers::pi_v<Scalar>);
      }
  return gatherer.finish();
}

// Sectors at two heights.
template <class Scalar>
ParticleSet<Scalar> thick_sector(const Vector3<Scalar>& center, const Vector3<Scalar>& normal,
                                 const Scalar& outer_radius, const Scalar& inner_radius,
                                 const Vector3<Scalar>& middle_direction, const Scalar& angle,
                                 const Scalar& thickness) {
  const cubature::Triad<Scalar> triad(normal, middle_direction);
  const Scalar wide = outer_radius - inner_radius;
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<2, Scalar>())
    for (const auto& t : cubature::gauss<2, Scalar>())
      for (const auto& u : cubature::gauss<cubature::points_on_arc, Scalar>()) {
        const Scalar r = inner_radius + t.at * wide;
        gatherer.add(
            center + (s.at - Scalar(0.5)) * thickness * triad.third + r * triad.at_angle((u.at - Scalar(0.5)) * angle),
            s.weight * thickness * t.weight * wide * r * u.weight * angle);
      }
  return gatherer.finish();
}

// Disks across the axis, whose radii squared grow with the distance from the apex.
template <class Scalar>
ParticleSet<Scalar> paraboloid(const Vector3<Scalar>& apex, const Vector3<Scalar>& base_center, const Scalar& radius) {
  const cubature::Triad<Scalar> triad(base_center - apex);
  cubature::Gatherer<Scalar> gatherer;
  for (const auto& s : cubature::gauss<3, Scalar>()) {
    const Scalar outer = radius * std::sqrt(s.at);
    for (const auto& t : cubature::gauss<2, Scalar>())
      gatherer.add_circle(
          apex + s.at * (base_center - apex), triad, t.at * outer,
          s.weight * norm(base_center - apex) * t.weight * t.at * outer * outer * 2 * std::numbers::pi_v<Scalar>);
  }
  return gatherer.finish();
}

}  // namespace poinsot::particles
