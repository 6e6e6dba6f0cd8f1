#include "engine/solve/instant/drawn_motion.h"

#include <cmath>
#include <numbers>

namespace poinsot::solve::drawn {
namespace {

constexpr Real whole_turn = 2 * std::numbers::pi_v<Real>;

template <int of>
constexpr Real part = Real(1) / of;
struct SineCosine {
  Real sine, cosine;
};
// Differences turn by little, where few terms of the series have all digits, in a part of the time.
SineCosine sine_cosine(Real x) {
  constexpr Real little = 0.125L;  // the first terms left out, x^13/13! and x^14/14!, are below 1e-21
  if (std::abs(x) > little) return {std::sin(x), std::cos(x)};
  const Real y = x * x;
  return {
      x * (1 - y * part<6> * (1 - y * part<20> * (1 - y * part<42> * (1 - y * part<72> * (1 - y * part<110>))))),
      1 - y * part<2> *
              (1 - y * part<12> * (1 - y * part<30> * (1 - y * part<56> * (1 - y * part<90> * (1 - y * part<132>)))))};
}

// Rodrigues' formula: the rotation by an angle about u, which has length one, R = I + sin [u] + (1 - cos) (u u^T - I).
Matrix3<Real> rotation(const Vector& u, Real angle) {
  if (angle == 0) return Matrix3<Real>::identity();
  const auto [half, cosine] = sine_cosine(angle / 2);
  const Real s = 2 * half * cosine, c = 2 * half * half;
  const Real xy = c * u.x * u.y, yz = c * u.y * u.z, zx = c * u.z * u.x;
  const Real xx = c * u.x * u.x, yy = c * u.y * u.y, zz = c * u.z * u.z;
  return {{1 - (yy + zz), xy - s * u.z, zx + s * u.y},
          {xy + s * u.z, 1 - (zz + xx), yz - s * u.x},
          {zx - s * u.y, yz + s * u.x, 1 - (xx + yy)}};
}

Matrix3<Real> rotation(const Vector& angle_axis) {
  const Real angle = norm(angle_axis);
  return angle == 0 ? Matrix3<Real>::identity() : rotation(angle_axis / angle, angle);
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
          own.turn = rotation(u, x);
          own.shift = A - own.turn * A;
          if (link.type == JointType::screw) own.shift += (x * Real(link.pitch)) * u;
        }
        break;
      }
      case JointType::ball:
      case JointType::free: {
        const int k = link.velocity;
        const double* const turned = &q[link.position];
        const bool as_drawn = turned[0] == 1 && turned[1] == 0 && turned[2] == 0 && turned[3] == 0;
        const Matrix3<Real> now = as_drawn ? Matrix3<Real>::identity() : attitude(turned);
        own.turn = rotation(Vector{travelled(k), travelled(k + 1), travelled(k + 2)});
        if (!as_drawn) own.turn = now * own.turn;
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
