#include "poinsot/engine/motion/closed_form/polhode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "poinsot/engine/math/elliptic/elliptic_functions.h"

namespace poinsot {
namespace {

using LongVector = Vector3<long double>;
using LongMatrix = Matrix3<long double>;

// The nearest rotation or reflection to a matrix that is one up to rounding (one step of Newton's iteration).
LongMatrix orthonormal(const LongMatrix& A) { return 0.5L * (A * (3.0L * LongMatrix::identity() - transpose(A) * A)); }

// Component of w along a unit vector. A sum of several terms that cancels to what the rounding of axes and w to doubles
// may leave is zero: a spin about a principal axis, on turned axes, stays one.
long double component(const LongVector& axis, const LongVector& w) {
  const LongVector terms{axis.x * w.x, axis.y * w.y, axis.z * w.z};
  const long double sum = terms.x + terms.y + terms.z;
  const int count = (terms.x != 0) + (terms.y != 0) + (terms.z != 0);
  return count > 1 && std::fabs(sum) <= 8 * std::numeric_limits<double>::epsilon() * norm(w) ? 0 : sum;
}

void check(const LongVector& moments, const Vector3<double>& w) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(moments[i] > 0) || !std::isfinite(moments[i])) {
      throw std::invalid_argument(
          fmt::format("Polhode: principal moment {} is {} kg m^2; it must be positive and finite", i + 1, moments[i]));
    }
    if (!std::isfinite(w[i])) {
      throw std::invalid_argument("Polhode: component " + std::to_string(i + 1) +
                                  " of the angular velocity is not finite");
    }
  }
}

Range ordered(long double a, long double b) {
  return {static_cast<double>(std::min(a, b)), static_cast<double>(std::max(a, b))};
}

}  // namespace

Polhode::Polhode(const Vector3<double>& moments, const Matrix3<double>& axes, const Vector3<double>& w) {
  const auto wide = [](const Vector3<double>& v) { return LongVector{v.x, v.y, v.z}; };
  set_up(wide(moments), {wide(axes.row0), wide(axes.row1), wide(axes.row2)}, w);
}

Polhode::Polhode(const Vector3<long double>& moments, const Matrix3<long double>& axes, const Vector3<double>& w) {
  set_up(moments, axes, w);
}

void Polhode::set_up(const LongVector& moments, const LongMatrix& given_axes, const Vector3<double>& w) {
  check(moments, w);
  const LongMatrix axes = orthonormal(given_axes);

  // Principal moments ascending, with their axes and the momenta along them.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return moments[a] < moments[b]; });
  LongVector I, L, w_axes;
  std::array<LongVector, 3> axis;
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = axes.column(order[i]);
    I[i] = moments[order[i]];
    w_axes[i] = component(axis[i], {w.x, w.y, w.z});
    L[i] = I[i] * w_axes[i];
  }
  if (dot(cross(axis[0], axis[1]), axis[2]) < 0) {
    axis[1] = -axis[1];
    L[1] = -L[1];
  }
  H_ = std::hypot(L.x, L.y, L.z);
  const LongVector l = H_ > 0 ? L / H_ : LongVector{0, 0, 1};
  T_ = 0.5L * (L.x * L.x / I.x + L.y * L.y / I.y + L.z * L.z / I.z);

  const auto difference = [&I](std::size_t i, std::size_t j) { return (I[j] - I[i]) / (I[i] * I[j]); };
  const long double D23 = difference(1, 2), D13 = difference(0, 2), D12 = difference(0, 1);

  // The sign of H^2/I2 - 2T tells which axis is encircled. From products alone: exact zeros of simple data stay zeros.
  // What rounding of the data leaves of a zero, as where a rate is a root, is none of theirs.
  constexpr long double rounding = 8 * std::numeric_limits<double>::epsilon();
  const long double about_z = I.z * (I.z - I.y) * w_axes.z * w_axes.z,
                    about_x = I.x * (I.y - I.x) * w_axes.x * w_axes.x;
  const long double difference_of_both = about_z - about_x;
  const long double excess_moment = std::fabs(difference_of_both) <= rounding * about_z ? 0 : difference_of_both;
  const long double excess = H_ > 0 ? excess_moment / (I.y * H_ * H_) : 0;
  const bool largest = excess >= 0;
  LongVector direction = largest ? l : LongVector{l.z, -l.y, l.x};
  std::array<LongVector, 3> local = largest ? axis : std::array<LongVector, 3>{axis[2], -axis[1], axis[0]};
  solution_.moments = largest ? I : LongVector{I.z, I.y, I.x};
  solution_.differences = largest ? LongVector{D23, D13, D12} : LongVector{D12, D13, D23};
  solution_.sense = largest ? 1 : -1;

  // Half a turn about one of the axes makes l_x and l_z positive.
  const bool turn_x = direction.x < 0, turn_z = direction.z < 0;
  const LongVector signs{turn_x ? -1.0L : 1.0L, turn_x != turn_z ? -1.0L : 1.0L, turn_z ? -1.0L : 1.0L};
  for (std::size_t i = 0; i < 3; ++i) {
    direction[i] *= signs[i];
    local[i] *= signs[i];
  }
  solution_.axes = LongMatrix::from_columns(local[0], local[1], local[2]);
  solution_.direction = direction;
  solution_.angular_momentum = H_;

  // Constant where no component changes: dl_x/dt is proportional to D_yz l_y l_z, and so on.
  const auto& [Dyz, Dxz, Dxy] = solution_.differences;
  const auto& [lx, ly, lz] = direction;
  if (H_ == 0 || (Dyz * ly * lz == 0 && Dxz * lx * lz == 0 && Dxy * lx * ly == 0)) {
    kind_ = PolhodeKind::point;
    solution_.amplitude = direction;
    return;
  }

  const long double ax2 = lx * lx + Dyz / Dxz * ly * ly;
  const long double ay2 = ly * ly + Dxz / Dyz * lx * lx;
  const long double az2 = lz * lz + Dxy / Dxz * ly * ly;
  solution_.amplitude = {std::sqrt(ax2), std::sqrt(ay2), std::sqrt(az2)};
  solution_.rate = H_ * solution_.amplitude.z * std::sqrt(Dxz * Dyz);
  solution_.parameter = {std::min(1.0L, Dxy * ax2 / (Dyz * az2)), std::min(1.0L, std::fabs(excess) / (Dyz * az2))};
  solution_.quarter_period = elliptic_complete_first(solution_.parameter);
  const long double sn = solution_.sense * ly / solution_.amplitude.y;
  solution_.initial_argument = sn * carlson_rf(lx * lx / ax2, lz * lz / az2, 1.0L);
  kind_ = solution_.parameter.complement == 0 ? PolhodeKind::separatrix
          : largest                           ? PolhodeKind::about_largest
                                              : PolhodeKind::about_smallest;
}

PrecessionSense Polhode::sense() const {
  switch (kind_) {
    case PolhodeKind::about_smallest:
      return PrecessionSense::direct;
    case PolhodeKind::about_largest:
      return PrecessionSense::retrograde;
    default:
      return PrecessionSense::none;
  }
}

double Polhode::invariable_plane_distance() const { return H_ > 0 ? static_cast<double>(2 * T_ / H_) : 0; }

double Polhode::period() const {
  return kind_ == PolhodeKind::point ? 0 : static_cast<double>(4 * solution_.quarter_period / solution_.rate);
}

template <class Key>
Polhode::Ends Polhode::ends_of(const LongVector& c, Key key) const {
  Ends ends{solution_.direction, solution_.direction};
  if (kind_ == PolhodeKind::point) return ends;
  const LongVector& a = solution_.amplitude;
  const JacobiFunctions jacobi(solution_.parameter);
  const auto take = [&](const LongVector& l) {
    if (key(l) < key(ends.at_minimum)) ends.at_minimum = l;
    if (key(l) > key(ends.at_maximum)) ends.at_maximum = l;
  };

  // c . l is smooth in u on the scale of one; its extremes lie where the slope changes its sign between samples. Beyond
  // u = 60 the path is at its corner on the y axis to more digits than are kept.
  const long double reach = std::min(solution_.quarter_period, 60.0L);
  const int samples = static_cast<int>(16 * reach);
  const double step = static_cast<double>(reach) / samples;
  for (const long double cell : {1.0L, -1.0L}) {
    if (cell < 0 && kind_ == PolhodeKind::separatrix) break;
    const LongVector A{cell * a.x, cell * solution_.sense * a.y, a.z};
    const auto at = [&](double u) {
      const auto [sn, cn, dn] = jacobi.in_middle_cell(u);
      return LongVector{A.x * cn, A.y * sn, A.z * dn};
    };
    const auto slope = [&](double u) {
      const auto [sn, cn, dn] = jacobi.in_middle_cell(u);
      return -c.x * A.x * sn * dn + c.y * A.y * cn * dn - c.z * A.z * solution_.parameter.m * sn * cn;
    };
    for (int i = -samples; i < samples; ++i) {
      double low = i * step, high = (i + 1) * step;
      take(at(low));
      const bool falls = slope(low) < 0;
      if (falls == (slope(high) < 0)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((slope(middle) < 0) == falls ? low : high) = middle;
      }
      take(at(low));
    }
    // The corner, at u = K.
    take({0, A.y, a.z * std::sqrt(solution_.parameter.complement)});
    if (kind_ == PolhodeKind::separatrix) take({0, -A.y, 0});
  }
  return ends;
}

Range Polhode::angular_velocity_range(const Vector3<double>& direction) const {
  const LongVector d = transpose_times(solution_.axes, LongVector{direction.x, direction.y, direction.z});
  const LongVector& I = solution_.moments;
  const LongVector c{H_ * d.x / I.x, H_ * d.y / I.y, H_ * d.z / I.z};
  const Ends ends = ends_of(c, [&c](const LongVector& l) { return dot(c, l); });
  return {static_cast<double>(dot(c, ends.at_minimum)), static_cast<double>(dot(c, ends.at_maximum))};
}

Range Polhode::nutation_range(const Vector3<double>& axis) const {
  const LongVector d = transpose_times(solution_.axes, LongVector{axis.x, axis.y, axis.z});
  // By sine and cosine: the cosine alone does not tell small angles apart.
  const auto angle = [&d](const LongVector& l) { return std::atan2(norm(cross(d, l)), dot(d, l)); };
  const Ends ends = ends_of(d, angle);
  return {static_cast<double>(angle(ends.at_minimum)), static_cast<double>(angle(ends.at_maximum))};
}

Range Polhode::speed_range() const {
  const auto& [ax, ay, az] = solution_.amplitude;
  const auto& [Ix, Iy, Iz] = solution_.moments;
  if (kind_ == PolhodeKind::point) {
    const long double speed = H_ * std::hypot(ax / Ix, ay / Iy, az / Iz);
    return ordered(speed, speed);
  }
  // |w|^2 is linear in sn^2.
  const long double corner = az * std::sqrt(solution_.parameter.complement);
  return ordered(H_ * std::hypot(ax / Ix, az / Iz), H_ * std::hypot(ay / Iy, corner / Iz));
}

Range Polhode::herpolhode_radii() const {
  if (kind_ == PolhodeKind::point) return {};
  // |w|^2 - (2T/H)^2 = H^2 times the sum of l_i^2 l_j^2 D_ij^2 over the pairs, linear in sn^2: one pair is left at
  // either end.
  const auto& [ax, ay, az] = solution_.amplitude;
  const auto& [Dyz, Dxz, Dxy] = solution_.differences;
  const long double corner = az * std::sqrt(solution_.parameter.complement);
  return ordered(H_ * ax * az * Dxz, H_ * ay * corner * Dyz);
}

}  // namespace poinsot
