#include "poinsot/engine/motion/closed_form/torque_free.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "poinsot/engine/mass/principal_axes.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {
namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;
constexpr double two_pi = 2 * std::numbers::pi;

template <class To, class From>
Vector3<To> converted(const Vector3<From>& v) {
  return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}
template <class To, class From>
Matrix3<To> converted(const Matrix3<From>& A) {
  return {converted<To>(A.row0), converted<To>(A.row1), converted<To>(A.row2)};
}
template <class To, class From>
Quaternion<To> converted(const Quaternion<From>& q) {
  return {static_cast<To>(q.w), static_cast<To>(q.x), static_cast<To>(q.y), static_cast<To>(q.z)};
}

// The quaternion alpha + beta i of complex alpha and beta, k the imaginary unit, divided by its length.
template <class Number>
Quaternion<Number> quaternion_of(const ComplexValue<Number>& alpha, const ComplexValue<Number>& beta) {
  return normalized(Quaternion<Number>{alpha.re, beta.re, beta.im, alpha.im});
}
// exp(k 2 pi fraction) q
Quaternion<double> turned(const Quaternion<double>& q, double fraction) {
  const auto [s, c] = sine_cosine(two_pi * fraction);
  return {c * q.w - s * q.z, c * q.x - s * q.y, c * q.y + s * q.x, c * q.z + s * q.w};
}
template <class Number>
ComplexValue<Number> times_minus_i(const ComplexValue<Number>& a) {
  return {a.im, -a.re};
}

}  // namespace

TorqueFreeMotion::TorqueFreeMotion(const Vector3<double>& moments, const Matrix3<double>& axes,
                                   const Quaternion<double>& attitude, const Vector3<double>& angular_velocity)
    : polhode_(moments, axes, angular_velocity), jacobi_(polhode_.solution().parameter) {
  set_up(attitude, angular_velocity);
}
TorqueFreeMotion::TorqueFreeMotion(const Vector3<double>& moments, const Quaternion<double>& attitude,
                                   const Vector3<double>& angular_velocity)
    : TorqueFreeMotion(moments, Matrix3<double>::identity(), attitude, angular_velocity) {}
TorqueFreeMotion::TorqueFreeMotion(const Vector3<long double>& moments, const Matrix3<long double>& axes,
                                   const Quaternion<double>& attitude, const Vector3<double>& angular_velocity)
    : polhode_(moments, axes, angular_velocity), jacobi_(polhode_.solution().parameter) {
  set_up(attitude, angular_velocity);
}

TorqueFreeMotion TorqueFreeMotion::of_tensor(const SymmetricMatrix3<double>& inertia,
                                             const Quaternion<double>& attitude,
                                             const Vector3<double>& angular_velocity) {
  // No two moments count as equal: the axes go with the moments as they are, and nearly equal ones do no harm.
  const SymmetricMatrix3<Real> tensor{inertia.xx, inertia.yy, inertia.zz, inertia.xy, inertia.yz, inertia.zx};
  const PrincipalAxes<Real> principal = principal_axes(tensor, 0.0L);
  return {principal.moments, principal.axes, attitude, angular_velocity};
}

void TorqueFreeMotion::set_up(const Quaternion<double>& attitude, const Vector3<double>& angular_velocity) {
  const Quaternion<Real> q0 = normalized(converted<Real>(attitude));
  if (!std::isfinite(norm_squared(q0))) {
    throw std::invalid_argument("TorqueFreeMotion: the attitude is no rotation: its length is zero or not finite");
  }
  const Polhode::Solution& p = polhode_.solution();
  const Real H = p.angular_momentum;
  angular_momentum_ = converted<double>(rotation_matrix(q0) * (p.axes * (H * p.direction)));

  if (polhode_.kind() == PolhodeKind::point) {
    // A turn about w: right takes w to z.
    constant_ = true;
    const Vector3<Real> w = converted<Real>(angular_velocity);
    const Real speed = norm(w);
    turns_ = Phase(speed / (4 * pi), 0);  // exp(k angle/2)
    const Quaternion<Real> to_z =
        speed > 0 ? conjugate(poinsot::quaternion_of(axes_with_z_along(w / speed))) : Quaternion<Real>::identity();
    left_ = converted<double>(q0 * conjugate(to_z));
    right_ = converted<double>(to_z);
    amplitude_ = angular_velocity;
    return;
  }

  const auto& [a_x, a_y, a_z] = p.amplitude;
  const auto& [I_x, I_y, I_z] = p.moments;
  const Real K = p.quarter_period;
  cells_ = CellPhase(p.rate, p.initial_argument, K);

  // The theta functions, with the shift v from sn^2 v and cn^2 v.
  const Real sine_square = p.differences.x / p.differences.y, cosine_square = p.differences.z / p.differences.y;
  const Real v =
      std::sqrt(sine_square) * carlson_rf(cosine_square, cosine_square + p.parameter.m * sine_square, Real(1));
  const ThetaLattice lattice{K, 2 * elliptic_complete_first(p.parameter.complementary())};
  const int sense = p.sense > 0 ? 1 : -1;
  ThetaSeries alpha(Theta::fourth, lattice, v, sense);
  ThetaSeries beta(Theta::first, lattice, v, sense);
  alpha.scale(1 / alpha.at_zero().re);
  beta.scale(a_x / ((1 + a_z) * beta.at_zero().re));
  argument_ = ThetaArgument<double>(lattice);
  alpha_ = ShiftedTheta<double, 4>(alpha.function());
  beta_ = ShiftedTheta<double, 4>(beta.function());

  // At u = 0, where l = (a_x, 0, a_z), the even part and the phase of alpha together turn at the rate of chi/2.
  const Real chi_rate = H * ((a_x * a_x) / I_x + (a_z * a_z + a_z) / I_z) / (1 + a_z);
  const Real even_rate = chi_rate / 2 - p.rate * alpha.slope_at_zero();
  turns_ = Phase(even_rate / (2 * pi), 0);
  cell_turns_ = Phase(alpha.turn_per_cell() / (2 * pi), 0);

  // alpha + beta i at t = 0 gives the place of (X, Y, Z) on the ground.
  const Quaternion<Real> local_axes = poinsot::quaternion_of(p.axes);
  const Quaternion<Real> initial = ThetaArgument<Real>(lattice).apply(p.initial_argument, [&](const auto& point) {
    return quaternion_of(alpha.function().at(point), times_minus_i(beta.function().at(point)));
  });
  left_ = converted<double>(q0 * local_axes * conjugate(initial));
  right_ = converted<double>(conjugate(local_axes));

  axes_ = converted<double>(p.axes);
  amplitude_ = converted<double>(Vector3<Real>{H * a_x / I_x, p.sense * H * a_y / I_y, H * a_z / I_z});

  // In a period, two cells, chi is the sum of the precession and of one turn of spin, forward or backward.
  mean_precession_rate_ = static_cast<double>(2 * even_rate);
  precession_per_period_ = std::numeric_limits<double>::infinity();
  if (!std::isinf(K)) {
    const Real period = 4 * K / p.rate;
    const Real angle = 2 * (even_rate * period - 2 * alpha.turn_per_cell()) + p.sense * 2 * pi;
    precession_per_period_ = static_cast<double>(angle);
    mean_precession_rate_ = static_cast<double>(angle / period);
  }
}

Quaternion<double> TorqueFreeMotion::attitude_at(const CellPhase::Place& place, double t) const {
  const double fraction = turns_.at(t).fraction;
  if (constant_) return left_ * turned(right_, fraction);
  const Quaternion<double> local = argument_.apply(place.argument, [&](const auto& point) {
    const ComplexValue<double> beta = beta_.at(point);
    const double sign = place.odd() ? -1 : 1;
    return quaternion_of(alpha_.at(point), {sign * beta.im, -sign * beta.re});
  });
  return left_ * turned(local, fraction - cell_turns_.at(place.count).fraction) * right_;
}

Vector3<double> TorqueFreeMotion::angular_velocity_at(const CellPhase::Place& place) const {
  if (constant_) return amplitude_;
  auto [sn, cn, dn] = jacobi_.in_middle_cell(place.argument);
  if (place.odd()) {
    sn = -sn;
    cn = -cn;
  }
  return axes_ * Vector3<double>{amplitude_.x * cn, amplitude_.y * sn, amplitude_.z * dn};
}

Quaternion<double> TorqueFreeMotion::attitude(double t) const { return attitude_at(cells_.at(t), t); }
Vector3<double> TorqueFreeMotion::angular_velocity(double t) const { return angular_velocity_at(cells_.at(t)); }
TorqueFreeMotion::State TorqueFreeMotion::at(double t) const {
  const CellPhase::Place here = cells_.at(t);
  return {attitude_at(here, t), angular_velocity_at(here)};
}

}  // namespace poinsot
