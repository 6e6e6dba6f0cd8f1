#include "engine/motion/rotation/rotation_splitting.h"

#include <cmath>

#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {

namespace {

// s17odr8a of Kahan and Li; symmetric, the middle one such that all add up to 1.
constexpr double first_parts[8] = {0.13020248308889008087881763,  0.56116298177510838456196441,
                                   -0.38947496264484728640807860, 0.15884190655515560089621075,
                                   -0.39590389413323757733623154, 0.18453964097831570709183254,
                                   0.25837438768632204729397911,  0.29501172360931029887096624};

constexpr double part(int i) {
  if (i > 8) i = 16 - i;
  if (i < 8) return first_parts[i];
  double rest = 1.0;
  for (const double a : first_parts) rest -= 2.0 * a;
  return rest;
}

// attitude turned about the principal axis i by the angle.
Quaternion<double> turned(const Quaternion<double>& attitude, std::size_t i, double angle) {
  const auto [s, c] = sine_cosine(0.5 * angle);
  return attitude * Quaternion<double>{c, i == 0 ? s : 0.0, i == 1 ? s : 0.0, i == 2 ? s : 0.0};
}

}  // namespace

RotationSplitting::RotationSplitting(const PrincipalBody& body) : body_(body) {
  double least = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const double Rj = 1.0 / body.moments[(i + 1) % 3];
    const double Rk = 1.0 / body.moments[(i + 2) % 3];
    if (std::fabs(Rj - Rk) < least) {
      least = std::fabs(Rj - Rk);
      axis_ = i;
      mean_ = 0.5 * (Rj + Rk);
      difference_ = 0.5 * (Rj - Rk);
      own_ = 1.0 / body.moments[i] - mean_;
    }
  }
}

// Energy m^2 mean/2 + m_i^2 own/2, and around it half of each of d m_j^2/2 and -d m_k^2/2. The momentum in space rests;
// every part turns the body about the momentum or about a principal axis, whose component of momentum it keeps.
void RotationSplitting::drift(RotationState& state, double h) const {
  const std::size_t j = (axis_ + 1) % 3;
  const std::size_t k = (axis_ + 2) % 3;
  const auto about = [&](std::size_t i, double rate_per_momentum, double time) {
    const Vector3<double> n = rotation_matrix(state.attitude) * Vector3<double>::unit(i);
    state.attitude = turned(state.attitude, i, rate_per_momentum * dot(n, state.momentum) * time);
  };
  if (!is_symmetric()) {
    about(j, difference_, 0.5 * h);
    about(k, -difference_, 0.5 * h);
  }
  about(axis_, own_, h);
  state.attitude = quaternion_exponential((mean_ * h) * state.momentum) * state.attitude;
  if (!is_symmetric()) {
    about(k, -difference_, 0.5 * h);
    about(j, difference_, 0.5 * h);
  }
}

void RotationSplitting::kick(RotationState& state, double t, double h) const {
  state.gain(h * body_.torque(t, state.attitude, state.momentum));
}

void RotationSplitting::step(RotationState& state, double t, double h) const {
  double at = t;
  for (int i = 0; i < 17; ++i) {
    const double a = part(i);
    drift(state, 0.5 * a * h);
    at += 0.5 * a * h;
    if (body_.has_torque()) kick(state, at, a * h);
    drift(state, 0.5 * a * h);
    at += 0.5 * a * h;
  }
  state.attitude = normalized(state.attitude);
}

}  // namespace poinsot
