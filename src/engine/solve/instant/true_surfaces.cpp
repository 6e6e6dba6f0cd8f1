#include "engine/solve/instant/true_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "poinsot/engine/solve/instant/contact_curvature.h"

namespace poinsot::solve {
namespace drawn {
namespace {

using Surface = ContactSurface<Real>;
using Square = Matrix3<Real>;

Square dyad(const Vector& a, const Vector& b) { return {a.x * b, a.y * b, a.z * b}; }

bool is_point(const Surface& s) { return s.kind == SurfaceKind::sphere && s.radius == 0; }
bool is_curve(const Surface& s) {
  return is_point(s) || (s.kind == SurfaceKind::cylinder && s.radius == 0) ||
         (s.kind == SurfaceKind::torus && s.tube == 0);
}

// F with its first and second derivatives.
struct Equation {
  Real value;
  Vector slope;
  Square second;
};
Equation equation_of(const Surface& s, const Vector& x) {
  const Vector r = x - s.center;
  const Square one = Square::identity();
  switch (s.kind) {
    case SurfaceKind::plane:
      return {dot(r, s.axis), s.axis, Real(0) * one};
    case SurfaceKind::sphere:
      return {(norm_squared(r) - s.radius * s.radius) / 2, r, one};
    case SurfaceKind::cylinder: {
      const Vector across = r - dot(r, s.axis) * s.axis;
      return {(norm_squared(across) - s.radius * s.radius) / 2, across, one - dyad(s.axis, s.axis)};
    }
    case SurfaceKind::cone: {
      // rho^2 cos^2 = z^2 sin^2.
      const Real z = dot(r, s.axis), cc = s.cosine * s.cosine;
      const Vector across = r - z * s.axis;
      return {(norm_squared(across) * cc - z * z * s.sine * s.sine) / 2, cc * across - (z * s.sine * s.sine) * s.axis,
              cc * one - dyad(s.axis, s.axis)};
    }
    case SurfaceKind::torus: {
      const Real z = dot(r, s.axis);
      const Vector across = r - z * s.axis;
      const Real rho = norm(across), beside = rho - s.radius;
      const Vector e = across / rho;
      return {(beside * beside + z * z - s.tube * s.tube) / 2, beside * e + z * s.axis,
              dyad(e, e) + dyad(s.axis, s.axis) + (beside / rho) * (one - dyad(s.axis, s.axis) - dyad(e, e))};
    }
    case SurfaceKind::ellipsoid: {
      Equation sum{-Real(0.5), Vector::zero(), Real(0) * one};
      for (const Vector& a : s.semi_axes) {
        const Vector b = a / norm_squared(a);
        const Real part = dot(b, r);
        sum.value += part * part / 2;
        sum.slope += part * b;
        sum.second = sum.second + dyad(b, b);
      }
      return sum;
    }
  }
  return {};
}

// A curve at a place on it: dx/ds and the second derivative by the length s.
struct CurvePlace {
  Vector point, along, bend;
};
CurvePlace curve_at(const Surface& s, const Vector& near) {
  const Vector r = near - s.center;
  if (is_point(s)) return {s.center, Vector::zero(), Vector::zero()};
  if (s.kind == SurfaceKind::cylinder) return {s.center + dot(r, s.axis) * s.axis, s.axis, Vector::zero()};
  const Vector e = normalized(Vector(r - dot(r, s.axis) * s.axis));
  return {s.center + s.radius * e, cross(s.axis, e), -e / s.radius};
}

// Of a length: what Newton's method leaves. Rounding of places is some 1e-19 of them, magnified by how flat the
// contact is.
constexpr Real settled = 1e-15L;

// Along a curve, where F is stationary on it.
std::optional<Vector> stationary_on_curve(const Surface& curve, const Surface& other, Vector x) {
  Real step = 0;
  const Real size = norm(x - other.center) + norm(x - curve.center);
  for (int round = 0; round < 60; ++round) {
    const CurvePlace at = curve_at(curve, x);
    x = at.point;
    if (is_point(curve)) return x;
    const Equation F = equation_of(other, x);
    step = -dot(F.slope, at.along) / (dot(at.along, F.second * at.along) + dot(F.slope, at.bend));
    if (!std::isfinite(step)) return std::nullopt;
    x = x + step * at.along;
    if (std::abs(step) < settled * size) return curve_at(curve, x).point;
  }
  return std::nullopt;
}

// Solves four linear equations by elimination with pivots.
std::optional<std::array<Real, 4>> solved_four(std::array<std::array<Real, 5>, 4> A) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 4; ++r)
      if (std::abs(A[r][c]) > std::abs(A[pivot][c])) pivot = r;
    std::swap(A[c], A[pivot]);
    if (!(std::abs(A[c][c]) > 0)) return std::nullopt;
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const Real part = A[r][c] / A[c][c];
      for (std::size_t k = c; k < 5; ++k) A[r][k] -= part * A[c][k];
    }
  }
  return std::array<Real, 4>{A[0][4] / A[0][0], A[1][4] / A[1][1], A[2][4] / A[2][2], A[3][4] / A[3][3]};
}

// On the surface G = 0, where F is stationary on it.
std::optional<Vector> stationary_on_surface(const Surface& own, const Surface& other, Vector x) {
  Equation F = equation_of(other, x), G = equation_of(own, x);
  Real m = dot(F.slope, G.slope) / norm_squared(G.slope);
  const Real size = norm(x - other.center) + norm(x - own.center);
  for (int round = 0; round < 60; ++round) {
    const Vector left = F.slope - m * G.slope;
    const Square K = F.second - m * G.second;
    std::array<std::array<Real, 5>, 4> A{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) A[i][k] = K(static_cast<int>(i), static_cast<int>(k));
      A[i][3] = -G.slope[i];
      A[3][i] = G.slope[i];
      A[i][4] = -left[i];
    }
    A[3][4] = -G.value;
    const auto step = solved_four(A);
    if (!step) return std::nullopt;
    const Vector d{(*step)[0], (*step)[1], (*step)[2]};
    if (!std::isfinite(norm(d))) return std::nullopt;
    x = x + d;
    m += (*step)[3];
    F = equation_of(other, x);
    G = equation_of(own, x);
    if (norm(d) < settled * size) return x;
  }
  return std::nullopt;
}

// Two unit vectors across n.
std::array<Vector, 2> across_normal(const Vector& n) {
  const Vector other = std::abs(n.x) < Real(0.6) ? Vector::unit(0) : Vector::unit(1);
  const Vector a = normalized(cross(n, other));
  return {a, cross(n, a)};
}

// The normal curvature of a surface along directions a and b, seen from its outside, with the sign of its side.
Real curvature_of(const Surface& s, const Vector& x, const Vector& a, const Vector& b) {
  const Equation F = equation_of(s, x);
  return (s.inside ? -1 : 1) * dot(a, F.second * b) / norm(F.slope);
}

}  // namespace

std::optional<NearestPlace> nearest_place(const Surface& on, const Surface& from, const Vector& guess) {
  const bool of_from = is_curve(from);
  if (of_from && is_curve(on)) return std::nullopt;
  const Surface &own = of_from ? from : on, &other = of_from ? on : from;
  const std::optional<Vector> x =
      is_curve(own) ? stationary_on_curve(own, other, guess) : stationary_on_surface(own, other, guess);
  if (!x) return std::nullopt;
  const Equation F = equation_of(other, *x);
  const Real size = norm(F.slope), side = other.inside ? -1 : 1;
  return NearestPlace{*x, (of_from ? -side : side) * F.slope / size, side * F.value / size};
}

Vector place_of_solver(const Surface& on, const Surface& from, double branch) {
  return widened(nearest_points(poinsot::detail::plain_surface(on), poinsot::detail::plain_surface(from), branch).on);
}

}  // namespace drawn

std::optional<double> least_relative_curvature(const ContactSurface<double>& on, const ContactSurface<double>& from,
                                               const Vector3<double>& place, const Vector3<double>& normal) {
  using namespace drawn;
  const auto wide = [](const ContactSurface<double>& s) {
    return converted_surface<Real>(s, widened, widened, [](double x) { return Real(x); });
  };
  const Surface a = wide(on), b = wide(from);
  const Vector x = widened(place), n = widened(normal);
  if (is_curve(a) && is_curve(b)) return std::nullopt;
  if (is_point(a) || is_point(b)) return std::numeric_limits<double>::infinity();
  if (is_curve(a) || is_curve(b)) {
    const Surface &curve = is_curve(a) ? a : b, &other = is_curve(a) ? b : a;
    const CurvePlace at = curve_at(curve, x);
    // It bends away from its outward normal.
    const Vector out = is_curve(a) ? Vector(-n) : n;
    return static_cast<double>(-dot(at.bend, out) + curvature_of(other, x, at.along, at.along));
  }
  const auto [p, q] = across_normal(n);
  const auto sum = [&](const Vector& u, const Vector& v) {
    return curvature_of(a, x, u, v) + curvature_of(b, x, u, v);
  };
  const Real pp = sum(p, p), pq = sum(p, q), qq = sum(q, q);
  return static_cast<double>((pp + qq) / 2 - std::hypot((pp - qq) / 2, pq));
}

}  // namespace poinsot::solve
