#include "engine/motion/rotation/principal_body.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot {

namespace {

using Vector = Vector3<double>;

}  // namespace

PrincipalBody::PrincipalBody(const RotatingBody& given) {
  const auto finite = [](const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  const PrincipalAxes<double> principal = principal_axes(given.inertia);
  moments = principal.moments;
  if (!finite(moments) || !(moments.x > 0.0 && moments.y > 0.0 && moments.z > 0.0))
    throw std::invalid_argument("rotation: the inertia must be finite and positive definite");
  if (!finite(given.first_moment) || !finite(given.gravity))
    throw std::invalid_argument("rotation: the first moment and gravity must be finite");
  axes = quaternion_of(principal.axes);
  const double g = norm(given.gravity);
  has_weight = g > 0.0 && norm_squared(given.first_moment) > 0.0;
  if (has_weight) {
    down = given.gravity / g;
    weight_arm = transpose_times(principal.axes, g * given.first_moment);
  }
  if (given.torque) body = &given;
}

Vector3<double> PrincipalBody::angular_velocity(const Quaternion<double>& attitude,
                                                const Vector3<double>& momentum) const {
  const Vector m = transpose_times(rotation_matrix(attitude), momentum);
  return {m.x / moments.x, m.y / moments.y, m.z / moments.z};
}

Vector3<double> PrincipalBody::torque(double t, const Quaternion<double>& attitude,
                                      const Vector3<double>& momentum) const {
  Vector sum{};
  if (has_weight) sum = cross(rotation_matrix(attitude) * weight_arm, down);
  if (body)
    sum += body->torque(t, attitude * conjugate(axes), rotation_matrix(axes) * angular_velocity(attitude, momentum));
  return sum;
}

double PrincipalBody::energy(const RotationState& state) const {
  const Matrix3<double> R = rotation_matrix(state.attitude);
  const Vector m = transpose_times(R, state.momentum);
  const double kinetic = 0.5 * (m.x * m.x / moments.x + m.y * m.y / moments.y + m.z * m.z / moments.z);
  return has_weight ? kinetic - dot(R * weight_arm, down) : kinetic;
}

// A turn by d on principal axes changes the momentum there by m x d and the vertical u by u x d, so the energy by
// (w x m - arm x u) d.
void PrincipalBody::restore_energy(RotationState& state, double energy, double most) const {
  const Matrix3<double> R = rotation_matrix(state.attitude);
  const Vector m = transpose_times(R, state.momentum);
  const Vector w{m.x / moments.x, m.y / moments.y, m.z / moments.z};
  const double kinetic = 0.5 * dot(m, w);
  double weight = 0.0;
  Vector gradient = cross(w, m);
  if (has_weight) {
    const Vector u = transpose_times(R, down);
    weight = -dot(weight_arm, u);
    gradient -= cross(weight_arm, u);
  }
  const double excess = kinetic + weight - energy;
  // Near a permanent rotation rounding alone would ask for turns that matter.
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (std::fabs(excess) <= rounding * (kinetic + std::fabs(weight))) return;
  const double steepness = norm_squared(gradient);
  if (!(excess * excess < most * most * steepness)) return;
  const Vector half = (-0.5 * excess / steepness) * gradient;
  state.attitude = state.attitude * Quaternion<double>{1.0 - 0.5 * norm_squared(half), half.x, half.y, half.z};
}

void write_rotation(const PrincipalBody& body, const RotationState& state, double* y) {
  const Quaternion<double> q = state.attitude * conjugate(body.axes);
  const Vector w = rotation_matrix(body.axes) * body.angular_velocity(state.attitude, state.momentum);
  y[0] = q.w;
  y[1] = q.x;
  y[2] = q.y;
  y[3] = q.z;
  y[4] = w.x;
  y[5] = w.y;
  y[6] = w.z;
}

RotationState read_rotation(const PrincipalBody& body, const double* y) {
  RotationState state;
  state.attitude = normalized(Quaternion<double>{y[0], y[1], y[2], y[3]} * body.axes);
  const Vector w = transpose_times(rotation_matrix(body.axes), Vector{y[4], y[5], y[6]});
  state.momentum =
      rotation_matrix(state.attitude) * Vector{body.moments.x * w.x, body.moments.y * w.y, body.moments.z * w.z};
  return state;
}

}  // namespace poinsot
