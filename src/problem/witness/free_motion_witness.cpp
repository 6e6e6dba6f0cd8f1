// The motion is taken apart by what its words mean: the angular velocity w turns the axis u of the body about the
// angular momentum H at the rate p, and the body about u at the rate s,
//
//   w = p H/|H| + s u.
//
// Energy and momentum fix the plane, at 2T/|H|, and the ellipsoid, whose semi-axes a make 2T/a^2 the moments. The
// polhode is about the largest moment where H^2/2T exceeds the middle one. T: of the motion about the mass center.
#include "problem/witness/free_motion_witness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::problem {
namespace free_motion_witness {

using solve::ParticlePaths;
using Real = ParticlePaths::Real;
using Vector = ParticlePaths::Vector;
using Matrix = Matrix3<Real>;
using Kind = ToldQuantity::Kind;

// A sine below which H is along the axis: w does not tell then which part of it is precession. Above it a thousand
// times the rounding is left in the rates.
constexpr Real along_axis = 1e-3L;
// Of the moments: what particles leave open of them, a millionth of which is looked at.
constexpr Real rounding_of_axis = 1e-6L;
// Of what decides on which side something lies: below it no side is told.
constexpr Real no_side = 1e-9L;

Real trace(const Matrix& M) { return M.row0.x + M.row1.y + M.row2.z; }
Real determinant_of(const Matrix& M) { return dot(M.row0, cross(M.row1, M.row2)); }
Matrix less(const Matrix& M, Real x) {
  Matrix found = M;
  found.row0.x -= x;
  found.row1.y -= x;
  found.row2.z -= x;
  return found;
}
// The coefficients of the polynomial of which the moments are the roots.
Vector symmetric_functions(const Vector& I) {
  return {I.x + I.y + I.z, I.x * I.y + I.y * I.z + I.z * I.x, I.x * I.y * I.z};
}
Vector symmetric_functions(const Matrix& I) {
  const Real squares = norm_squared(I.row0) + norm_squared(I.row1) + norm_squared(I.row2);
  return {trace(I), (trace(I) * trace(I) - squares) / 2, determinant_of(I)};
}
Real angle(const Vector& a, const Vector& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }
Witness number(Real value, Real size) { return {{value, 0, 0}, size}; }

struct Axis {
  Vector u;
  Real doubt = 0;  // of its direction, in units of the rounding of moments
};

// Second moments M = B 1 + c u u^T have the deviator c (u u^T - 1/3) and its determinant 2 c^3/27.
std::optional<Axis> axis_of(const ParticlePaths::Sums& sums, const Vector& sense) {
  const Matrix D = less(sums.moments, trace(sums.moments) / 3);
  const Real c = 3 * std::cbrt(determinant_of(D) / 2);
  if (c == 0) return std::nullopt;
  const Matrix cuu = less(D, -c / 3);
  Vector u = cuu.row0;
  for (const Vector& row : {cuu.row1, cuu.row2})
    if (norm(row) > norm(u)) u = row;
  if (!(norm(u) > 0)) return std::nullopt;
  u = u / norm(u);
  return Axis{dot(u, sense) < 0 ? -u : u, 1 + rounding_of_axis * sums.moments_size / std::abs(c)};
}

std::optional<Witness> found(const ToldQuantity& told, const ParticlePaths::Sums& sums, const Vector& w) {
  const Vector& H = sums.angular_momentum;
  const Real twice_energy = 2 * sums.kinetic_energy - norm_squared(sums.momentum) / sums.mass;
  if (told.kind == Kind::symmetry_axis) {
    const std::optional<Axis> axis = axis_of(sums, {told.first.x, told.first.y, told.first.z});
    return axis ? std::optional(Witness{axis->u, axis->doubt}) : std::nullopt;
  }
  if (told.kind == Kind::axis_stability) {
    // Of the deviator D of the moments: 4 J_2^3 - 27 J_3^2 vanishes where two of them are equal. Then all axes are
    // neutral but the third, which is not looked at.
    const Matrix D = less(sums.moments, trace(sums.moments) / 3);
    const Real half = (norm_squared(D.row0) + norm_squared(D.row1) + norm_squared(D.row2)) / 2, det = determinant_of(D);
    constexpr Real surely_apart = 1e-4L;
    if (!(half > no_side * trace(sums.moments) * trace(sums.moments)) ||
        !(4 * half * half * half - 27 * det * det > surely_apart * half * half * half))
      return std::nullopt;
    return Witness{{1, -1, 1}, 1};
  }
  const Real speed = norm(w);
  if (!(norm(H) > no_side * sums.moments_size * speed) || !(speed > 0)) return std::nullopt;
  const Vector up = H / norm(H);
  const Matrix I = less(Matrix{-sums.moments.row0, -sums.moments.row1, -sums.moments.row2}, -trace(sums.moments));
  switch (told.kind) {
    case Kind::precession_axis:
      return Witness{up, 1};
    case Kind::space_cone:
      return number(angle(H, w), 1);
    case Kind::invariable_plane:
      return number(twice_energy / norm(H), speed);
    case Kind::poinsot_ellipsoid: {
      const Vector a{told.value.x, told.value.y, told.value.z};
      const Vector moments{twice_energy / (a.x * a.x), twice_energy / (a.y * a.y), twice_energy / (a.z * a.z)};
      const Vector is = symmetric_functions(I), said = symmetric_functions(moments);
      if (!std::isfinite(norm(a)) || !(is.z > no_side * is.x * is.x * is.x)) return std::nullopt;
      const Vector off{said.x / is.x - 1, said.y / is.y - 1, said.z / is.z - 1};
      // The longest belongs to the smallest moment, which comes first.
      const Real least = std::min({a.x, a.y, a.z}), most = std::max({a.x, a.y, a.z});
      return Witness{Vector{most, a.x + a.y + a.z - least - most, least} + norm(a) * off, norm(a)};
    }
    case Kind::polhode: {
      const Real side = determinant_of(less(I, dot(H, H) / twice_energy));
      if (!(std::abs(side) > no_side * trace(I) * trace(I) * trace(I))) return std::nullopt;
      return number(side > 0 ? 1 : -1, 1);
    }
    default:
      break;
  }
  const std::optional<Axis> axis = axis_of(sums, {told.first.x, told.first.y, told.first.z});
  if (!axis) return std::nullopt;
  const Vector& u = axis->u;
  if (told.kind == Kind::body_cone) {
    const Real between = angle(u, w);
    return number(std::min(between, std::numbers::pi_v<Real> - between), axis->doubt);
  }
  const Vector arm = cross(up, u);
  const Real transverse = (trace(I) - dot(u, I * u)) / 2;
  const bool apart = norm(arm) > along_axis;
  const Real precession = apart ? dot(cross(w, u), arm) / norm_squared(arm) : norm(H) / transverse;
  const Real spin = dot(w - precession * up, u), size = axis->doubt * speed / (apart ? norm(arm) : 1);
  switch (told.kind) {
    case Kind::precession_rate:
      return number(precession, size);
    case Kind::spin_rate:
      return number(spin, size);
    case Kind::precession_sense:
      if (!(std::abs(spin) > no_side * size)) return std::nullopt;
      return number(spin > 0 ? 1 : -1, 1);
    default:
      return std::nullopt;
  }
}

}  // namespace free_motion_witness

std::optional<Witness> free_motion_of(const ToldQuantity& told, const solve::ParticlePaths::Sums& sums,
                                      const solve::ParticlePaths::Vector& angular_velocity) {
  return free_motion_witness::found(told, sums, angular_velocity);
}

}  // namespace poinsot::problem
