#include "poinsot/engine/solve/instant/particle_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace poinsot::solve {
namespace {

using Real = long double;
using Vector = Vector3<Real>;

constexpr Real whole_turn = 2 * std::numbers::pi_v<Real>;

Vector widened(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

// A rigid displacement from the drawn pose, on ground axes: x goes to shift + turn x.
struct Displacement {
  Matrix3<Real> turn = Matrix3<Real>::identity();
  Vector shift = Vector::zero();
  Vector operator()(const Vector& x) const { return turn * x + shift; }
};

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

// Where each link carries the space of the drawing at the time t from now. Coordinates go as q + v t + a t^2/2: first
// and second derivatives at t = 0 depend on no more.
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

// Central differences of eighth order over nine points.
constexpr std::array<Real, 4> first_weights{Real(4) / 5, -Real(1) / 5, Real(4) / 105, -Real(1) / 280};
constexpr Real second_center = -Real(205) / 72;
constexpr std::array<Real, 4> second_weights{Real(8) / 5, -Real(1) / 5, Real(8) / 315, -Real(1) / 560};

// std::max would lose a NaN; this keeps it.
Real larger(Real a, Real b) { return std::isnan(a) || a > b ? a : b; }

// A misfit over the size of its terms. What is not a number counts as infinite.
Real ratio(Real misfit, Real size) {
  if (!std::isfinite(misfit) || !std::isfinite(size)) return std::numeric_limits<Real>::infinity();
  return size > 0 ? misfit / size : misfit > 0 ? 1 : 0;
}

}  // namespace

CheckResult check_with_particles(const std::vector<CheckLink>& links, const std::vector<CheckBody>& bodies,
                                 const std::vector<double>& q, const std::vector<double>& v,
                                 const std::vector<double>& a) {
  // The step of the differences is so short that no angle changes by more than a few hundredths in it.
  Real pace = 0, length = 0;
  for (const CheckBody& body : bodies)
    for (const auto& particle : body.particles) length = std::max(length, norm(widened(particle.position)));
  for (const CheckLink& link : links) {
    for (int k = 0; k < velocity_size(link.type); ++k) {
      const bool slides = link.type == JointType::prismatic || (link.type == JointType::free && k >= 3);
      const Real size = slides ? (length > 0 ? length : 1) : 1;
      pace += std::abs(Real(v[link.velocity + k])) / size + std::sqrt(std::abs(Real(a[link.velocity + k])) / size);
    }
  }
  const Real h = Real(0.02) / (pace > 0 ? pace : 1);
  std::array<std::vector<Displacement>, 9> at;
  for (int j = -4; j <= 4; ++j) at[static_cast<std::size_t>(j + 4)] = displacements(links, q, v, a, Real(j) * h);

  CheckResult result;
  Real force_misfit = 0, moment_misfit = 0, force_size = 0, moment_size = 0;
  for (const CheckBody& body : bodies) {
    const auto link = static_cast<std::size_t>(body.link);
    Vector L = Vector::zero(), H = Vector::zero(), F = Vector::zero(), M = Vector::zero();
    Real T = 0, L_size = 0, H_size = 0, T_size = 0, F_size = 0, M_size = 0;
    for (const auto& particle : body.particles) {
      const Vector x0 = widened(particle.position);
      const Real m = particle.mass;
      const Vector x = at[4][link](x0);
      Vector velocity = Vector::zero(), acceleration = Vector::zero();
      // Differences are taken of displacements from the present place, so that a large distance from the origin does
      // not cancel.
      for (std::size_t j = 1; j <= 4; ++j) {
        const Vector ahead = at[4 + j][link](x0) - x, behind = at[4 - j][link](x0) - x;
        velocity += first_weights[j - 1] / h * (ahead - behind);
        acceleration += second_weights[j - 1] / (h * h) * (ahead + behind);
      }
      L += m * velocity;
      H += m * cross(x, velocity);
      T += m * norm_squared(velocity) / 2;
      F += m * acceleration;
      M += m * cross(x, acceleration);
      // A particle that is at rest for this instant has no speed to compare with: what its acceleration gives it in a
      // small part of the motion's own time takes its place.
      const Real speed = std::max(norm(velocity), Real(1e-5) * pace * norm(x));
      L_size += std::abs(m) * speed;
      H_size += std::abs(m) * norm(x) * speed;
      T_size += std::abs(m) * speed * speed / 2;
      F_size += std::abs(m) * norm(acceleration);
      M_size += std::abs(m) * norm(x) * norm(acceleration);
    }
    result.momentum =
        std::max<double>(result.momentum, static_cast<double>(ratio(norm(L - widened(body.momentum)), L_size)));
    result.momentum =
        std::max<double>(result.momentum, static_cast<double>(ratio(norm(H - widened(body.angular_momentum)), H_size)));
    result.energy =
        std::max<double>(result.energy, static_cast<double>(ratio(std::abs(T - Real(body.kinetic_energy)), T_size)));
    if (!body.forces_known) continue;
    const Vector force = widened(body.wrench.force), moment = widened(body.wrench.moment);
    force_misfit = larger(norm(F - force), force_misfit);
    moment_misfit = larger(norm(M - moment), moment_misfit);
    // On a body that glides without forces there are no forces to compare with: what would turn its momentum round in
    // the motion's own time takes their place.
    force_size = std::max({force_size, F_size, Real(body.force_size), pace * L_size});
    moment_size = std::max({moment_size, M_size, Real(body.moment_size), pace * H_size});
  }
  // Where only couples act the forces are small, and are compared with couples over the length of the mechanism; and
  // the other way round.
  if (length > 0) force_size = std::max(force_size, moment_size / length);
  moment_size = std::max(moment_size, force_size * length);
  result.newton_euler =
      static_cast<double>(std::max(ratio(force_misfit, force_size), ratio(moment_misfit, moment_size)));
  return result;
}

}  // namespace poinsot::solve
