#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/math/algebra/sine_cosine.h"
#include "poinsot/engine/motion/closed_form/symmetric_top.h"

namespace poinsot {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

ComplexValue<double> product(const ComplexValue<double>& a, const ComplexValue<double>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
double size_squared(const ComplexValue<double>& a) { return a.re * a.re + a.im * a.im; }

}  // namespace

// The halves of the attitude at t, and their rates but for real multiples of the halves that are common to both.
SymmetricTop::Halves SymmetricTop::halves(double t) const {
  const auto even_part = [t](const Half& half, double count) {
    const double fraction = half.turns.at(t).fraction - half.cell_turns.at(count).fraction;
    const auto [s, c] = sine_cosine(two_pi * fraction);
    return product({c, s}, half.start);
  };
  Halves result;
  if (steady_) {
    result.upper = even_part(upper_, 0);
    result.lower = even_part(lower_, 0);
    result.upper_rate = {-upper_.rate * result.upper.im, upper_.rate * result.upper.re};
    result.lower_rate = {-lower_.rate * result.lower.im, lower_.rate * result.lower.re};
    return result;
  }
  const CellPhase::Place here = cells_.at(t);
  const double sign = here.odd() ? -1 : 1;
  const double slope_factor = sign * argument_.rate() * static_cast<double>(rate_);
  const auto evaluate = [&](const Half& half, ComplexValue<double>& value, ComplexValue<double>& rate,
                            const auto& point) {
    const auto [theta, slope] = half.theta.with_slope(point);
    const ComplexValue<double> even = even_part(half, here.count);
    value = product(even, {sign * theta.re, sign * theta.im});
    rate = product(even, {slope_factor * slope.re, slope_factor * slope.im});
    rate.re -= half.rate * value.im;
    rate.im += half.rate * value.re;
  };
  argument_.apply(here.argument, [&](const auto& point) {
    evaluate(upper_, result.upper, result.upper_rate, point);
    evaluate(lower_, result.lower, result.lower_rate, point);
  });
  return result;
}

Quaternion<double> SymmetricTop::attitude(double t) const { return attitude_of(halves(t)); }
Vector3<double> SymmetricTop::angular_velocity(double t) const { return angular_velocity_of(halves(t)); }
SymmetricTop::Turning SymmetricTop::turning(double t) const {
  const Halves h = halves(t);
  return {attitude_of(h), angular_velocity_of(h)};
}

Quaternion<double> SymmetricTop::attitude_of(const Halves& h) const {
  const Quaternion<double> q = normalized(Quaternion<double>{h.upper.re, h.lower.re, h.lower.im, h.upper.im});
  // Half a turn back about y.
  return inverted_ ? q * Quaternion<double>{0, 0, -1, 0} : q;
}

Vector3<double> SymmetricTop::angular_velocity_of(const Halves& h) const {
  // w = 2 conj(q) dq/dt for q = upper + lower i: 2 (conj(upper) d(lower) - lower conj(d(upper))) across the axis.
  const double factor = 2 / (size_squared(h.upper) + size_squared(h.lower));
  const ComplexValue<double> conjugate{h.upper.re, -h.upper.im}, conjugate_rate{h.upper_rate.re, -h.upper_rate.im};
  const ComplexValue<double> p = product(conjugate, h.lower_rate), r = product(h.lower, conjugate_rate);
  const double x = factor * (p.re - r.re), y = factor * (p.im - r.im), z = static_cast<double>(start_.axial_rate);
  return inverted_ ? Vector3<double>{-x, y, -z} : Vector3<double>{x, y, z};
}

// The angle of a half but for its mean growth, periodic from cell to cell.
double SymmetricTop::angle(const Half& half, const CellPhase::Place& here) const {
  const ComplexValue<double> theta =
      argument_.apply(here.argument, [&half](const auto& point) { return half.theta.at(point); });
  // Without a sense the real or the imaginary part vanishes, and the angle jumps forth and back by pi.
  if (half.sense == 0) {
    const double sign = here.odd() ? -1 : 1;
    return std::atan2(sign * theta.im, sign * theta.re);
  }
  // In the middle cell the real part keeps its sign, that of `side`.
  return half.side * std::atan2(theta.im, half.side * theta.re) - half.drift * here.argument;
}

// theta and the rates of theta and phi, from the roots: each to its own last places.
SymmetricTop::Axis SymmetricTop::axis_at(const CellPhase::Place& here) const {
  const auto [sn, cn, dn] = jacobi_.in_middle_cell(here.argument);
  const Real spread = roots_.spread;
  const Real above = roots_.above2 + spread * cn * cn;  // 1 - x
  const Real below = roots_.below1 + spread * sn * sn;  // 1 + x
  Axis axis;
  const Real root_above = std::sqrt(above), root_below = std::sqrt(below);
  axis.nutation =
      static_cast<double>(2 * (inverted_ ? std::atan2(root_below, root_above) : std::atan2(root_above, root_below)));
  // dx/dt = 2 rate (x2 - x1) sn cn dn = -sin(theta) d theta/dt
  const Real c = above > 0 ? cn / root_above : 1 / std::sqrt(spread);
  const Real s = below > 0 ? sn / root_below : 1 / std::sqrt(spread);
  axis.nutation_rate = static_cast<double>((inverted_ ? 2 : -2) * rate_ * spread * s * c * dn);
  // d phi/dt = (a - b x)/(1 - x^2), with a - b x from the nearer root.
  if (roots_.through_top) {
    axis.precession_rate = static_cast<double>(roots_.b / below);
  } else if (roots_.through_bottom) {
    axis.precession_rate = static_cast<double>(-roots_.b / above);
  } else {
    const Real moment =
        sn * sn < cn * cn ? roots_.low - roots_.b * spread * sn * sn : roots_.high + roots_.b * spread * cn * cn;
    axis.precession_rate = static_cast<double>(moment / (above * below));
  }
  return axis;
}

TopState SymmetricTop::at(double t) const {
  // Also on the vertical, where the motion itself does not tell phi from psi.
  if (t == 0) return given_;
  const double precession_mean = mean_precession_rate_, spin_mean = inverted_ ? -mean_spin_rate_ : mean_spin_rate_;
  Axis axis;
  double upper_angle = 0, lower_angle = 0;
  if (steady_) {
    axis = {given_.nutation, 0, given_.precession_rate};
  } else {
    const CellPhase::Place here = cells_.at(t);
    axis = axis_at(here);
    upper_angle = angle(upper_, here) - upper_.offset;
    lower_angle = angle(lower_, here) - lower_.offset;
  }
  TopState state;
  const double precession = precession_mean * t + (upper_angle + lower_angle);
  const double spin = spin_mean * t + (upper_angle - lower_angle);
  // Turned back where the body is turned over.
  const int sign = inverted_ ? -1 : 1;
  state.nutation = axis.nutation;
  state.nutation_rate = axis.nutation_rate;
  state.precession = given_.precession + precession;
  state.precession_rate = axis.precession_rate;
  state.spin = given_.spin + sign * spin;
  state.axial_rate = given_.axial_rate;
  return state;
}

std::vector<double> SymmetricTop::times_at_nutation(double theta, double from, double to) const {
  std::vector<double> times;
  if (steady_ || !(from <= to) || !(theta >= 0 && theta <= std::numbers::pi)) return times;
  // sn^2 u and cn^2 u times x2 - x1, from 1 - x or from 1 + x, whichever is the smaller. What is on an
  // extreme up to rounding is on it.
  Real sine = std::sin(static_cast<Real>(theta) / 2), cosine = std::cos(static_cast<Real>(theta) / 2);
  if (inverted_) std::swap(sine, cosine);
  const Real reach = 4 * std::numeric_limits<double>::epsilon() * std::fabs(theta * sine * cosine);
  const Real above = 2 * sine * sine, below = 2 * cosine * cosine;
  Real s2 = above < below ? roots_.above1 - above : below - roots_.below1;
  Real c2 = above < below ? above - roots_.above2 : roots_.below2 - below;
  if (s2 < -reach || c2 < -reach) return times;
  s2 = s2 <= reach ? 0 : s2 / roots_.spread;
  c2 = c2 <= reach ? 0 : c2 / roots_.spread;
  const Real u = std::sqrt(s2) * carlson_rf(c2, c2 + parameter_.complement * s2, Real(1));
  const Real K = quarter_period_;
  if (!std::isfinite(u)) return times;

  const Real first = rate_ * from + initial_argument_, last = rate_ * to + initial_argument_;
  const auto take = [&](Real argument) {
    const double t = static_cast<double>((argument - initial_argument_) / rate_);
    if (t >= from && t <= to) times.push_back(t);
  };
  if (endless_) {
    take(-u);
    if (u > 0) take(u);
    return times;
  }
  const Real first_cell = std::floor((first - K) / (2 * K)), last_cell = std::ceil((last + K) / (2 * K));
  if (!(last_cell - first_cell < 1e6L)) {
    throw std::invalid_argument("SymmetricTop::times_at_nutation: more than a million periods lie between the times");
  }
  const int cells = static_cast<int>(last_cell - first_cell);
  for (int i = 0; i <= cells; ++i) {
    const Real cell = first_cell + Real(i);
    if (u < K && c2 > 0) {
      take(2 * K * cell - u);
      if (u > 0) take(2 * K * cell + u);
    } else {
      take(2 * K * cell + K);
    }
  }
  return times;
}

}  // namespace poinsot
