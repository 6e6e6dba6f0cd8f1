#include "engine/solve/instant/drawn_motion.h"

#include <cmath>
#include <numbers>

namespace poinsot::solve::drawn {
namespace {

constexpr Real whole_turn = 2 * std::numbers::pi_v<Real>;

// Rodrigues' formula: the rotation by |angle_axis| about angle_axis.
Matrix3<Real> rotation(const Vector& angle_axis) {
  const Real angle = norm(angle_axis);
  if (angle == 0) return Matrix3<Real>::identity();
  const Matrix3<Real> K = cross_matrix(angle_axis / angle);
  const Real half = std::sin(angle / 2);
  return Matrix3<Real>::identity() + std::sin(angle) * K + (2 * half * half) * (K * K);
}

Matrix3<Real> attitude(const double* c) {
  const Real w = c[0], x = c[1], y = c[2], z = c[3];
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

std::vector<Displacement> displacements(const std::vector<CheckLink>& links, const std::vector<double>& q,
                                        const std::vector<double>& v, const std::vector<double>& a, Real t) {
  std::vector<Displacement> all(links.size());
  const auto travelled = [&](int k) { return Real(v[k]) * t + Real(a[k]) * t * t / 2; };
  for (std::size_t i = 0; i < links.size(); ++i) {
    const CheckLink& link = links[i];
    const Vector A = widened(link.anchor);
    Displacement own;
    switch (link.type) {
      case JointType::weld:
        break;
      case JointType::revolute:
      case JointType::prismatic:
      case JointType::screw: {
        const Vector u = normalized(widened(link.axis));
        // Whole turns are taken off, as the angle of a body that has turned often would lose the digits behind the
        // point.
        const Real now = link.type == JointType::revolute ? std::remainder(Real(q[link.position]), whole_turn)
                                                          : Real(q[link.position]);
        const Real x = now + travelled(link.velocity);
        if (link.type == JointType::prismatic) {
          own.shift = x * u;
        } else {
          own.turn = rotation(x * u);
          own.shift = A - own.turn * A;
          if (link.type == JointType::screw) own.shift += (x * Real(link.pitch)) * u;
        }
        break;
      }
      case JointType::ball:
      case JointType::free: {
        const int k = link.velocity;
        const Matrix3<Real> now = attitude(&q[link.position]);
        own.turn = now * rotation(Vector{travelled(k), travelled(k + 1), travelled(k + 2)});
        own.shift = A - own.turn * A;
        if (link.type == JointType::free) {
          own.shift += Vector{q[link.position + 4], q[link.position + 5], q[link.position + 6]};
          // The velocity stands on the body's axes: its rate in space is a + w x v.
          const Vector w{v[k], v[k + 1], v[k + 2]}, v_B{v[k + 3], v[k + 4], v[k + 5]},
              a_B{a[k + 3], a[k + 4], a[k + 5]};
          own.shift += now * (t * v_B + (t * t / 2) * (a_B + cross(w, v_B)));
        }
        break;
      }
    }
    if (link.parent < 0) {
      all[i] = own;
    } else {
      const Displacement& parent = all[static_cast<std::size_t>(link.parent)];
      all[i] = {parent.turn * own.turn, parent(own.shift)};
    }
  }
  return all;
}

Real pace_of(const std::vector<CheckLink>& links, const std::vector<double>& v, const std::vector<double>& a,
             Real length) {
  Real pace = 0;
  for (const CheckLink& link : links) {
    for (int k = 0; k < velocity_size(link.type); ++k) {
      const bool slides = link.type == JointType::prismatic || (link.type == JointType::free && k >= 3);
      const Real size = slides ? length : 1;
      pace += std::abs(Real(v[link.velocity + k])) / size + std::sqrt(std::abs(Real(a[link.velocity + k])) / size);
    }
  }
  return pace;
}

}  // namespace poinsot::solve::drawn
