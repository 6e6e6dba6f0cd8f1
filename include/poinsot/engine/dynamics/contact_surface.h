// Smooth surfaces, and edges of disks, with which bodies touch: where two of them come nearest to each other.
//
// n is the common normal, into body `on`. On each surface the outward normal u is n or -n, and the point with this
// normal is known in closed form (support points):
//
//   sphere     C + r u                                  torus     C + s R u'/|u'| + r u,   u' = u - (u . e) e
//   ellipsoid  C + sum a_i (a_i . u) / |(a_i . u)|      cylinder  C + r u + any multiple of e,   u . e = 0
//   plane      any of its points,   u given             cone      any of the straight line,      u . e = -sin(angle)
//
// (a_i: the semi-axes as vectors; e: the axis; a circle is a torus without tube, a point a sphere and a straight line a
// cylinder without radius). The surfaces come nearest where the distance phi(n) = n . (X_on(n) - X_from(n)) between
// their tangent planes is stationary among the normals that both have; the gap is phi there. Its rate is the rate of
// approach at the points X (the normal does not count, as phi is stationary), and the motion of the points over the
// surfaces follows by differentiation: this is what the equations of contact of Montana (The kinematics of contact and
// grasp, Int. J. Robotics Research 7(3), 1988, eq. 12) say with the curvatures of both.
//
// Closed forms hold over all scalars: a plane with anything, a sphere with anything but an ellipsoid, two of cylinders,
// cones and lines that cross. For other pairs the stationary value is found by Newton's method on plain numbers, the
// least or the largest one according to which side touches; three more steps in the scalar bring its derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

enum class SurfaceKind { plane, sphere, cylinder, cone, torus, ellipsoid };

// The angle of a cone is that between its axis, from the apex into it, and its straight lines.
template <class Scalar>
struct ContactSurface {
  SurfaceKind kind = SurfaceKind::plane;
  bool inside = false;       // whether its hollow side touches
  Vector3<Scalar> center{};  // of a plane, cylinder or line one of its points, of a cone the apex
  Vector3<Scalar> axis{};    // unit vector; of a plane the normal out of the body
  Scalar radius{};           // of a torus that of its center line
  Scalar tube{};             // of a torus
  Scalar sine{}, cosine{};   // of a cone's angle
  std::array<Vector3<Scalar>, 3> semi_axes{};
  // Of a torus: whether it touches outside (1) or inside (-1) its center line; and beside a sphere, whether with the
  // half on the sphere's side (1) or the other one.
  double side = 1, half = 1;
};

// Two surfaces that touch, on the axes of their bodies from their origins.
template <class Scalar>
struct CurvedContact {
  ContactSurface<Scalar> on, from;
  // The shapes themselves where, in a motion in which both keep their axes parallel, spheres stand for disks or
  // cylinders above.
  ContactSurface<Scalar> shape_on, shape_from;
  double branch = 1;  // of two normals that two straight surfaces have in common
  // On the axes of `from`: the normal to which the directions of the contact belong (they turn with it), and a
  // direction across.
  Vector3<Scalar> normal{}, tangent{};
};

// A surface with everything in it converted: points and directions each by their own function.
template <class Target, class Source, class Point, class Vector, class Number>
ContactSurface<Target> converted_surface(const ContactSurface<Source>& s, Point&& point, Vector&& vector,
                                         Number&& number) {
  return {s.kind,
          s.inside,
          point(s.center),
          vector(s.axis),
          number(s.radius),
          number(s.tube),
          number(s.sine),
          number(s.cosine),
          {vector(s.semi_axes[0]), vector(s.semi_axes[1]), vector(s.semi_axes[2])},
          s.side,
          s.half};
}

// Whether the place where two surfaces touch has a closed form, so that it can be told in letters.
template <class Scalar>
bool has_closed_form(const ContactSurface<Scalar>& a, const ContactSurface<Scalar>& b) {
  using enum SurfaceKind;
  const auto straight = [](SurfaceKind kind) { return kind == cylinder || kind == cone; };
  if (a.kind == plane || b.kind == plane) return true;
  if (a.kind == sphere || b.kind == sphere) return a.kind != ellipsoid && b.kind != ellipsoid;
  return straight(a.kind) && straight(b.kind);
}

// Where two surfaces come nearest.
template <class Scalar>
struct Touching {
  Vector3<Scalar> normal, on, from;
};

namespace detail {

template <class Scalar>
Vector3<Scalar> support_point(const ContactSurface<Scalar>& s, const Vector3<Scalar>& u) {
  switch (s.kind) {
    case SurfaceKind::sphere:
    case SurfaceKind::cylinder:
      return s.center + s.radius * u;
    case SurfaceKind::torus: {
      const Vector3<Scalar> across = u - dot(u, s.axis) * s.axis;
      return s.center + (Scalar(s.side) * s.radius) * normalized(across) + s.tube * u;
    }
    case SurfaceKind::ellipsoid: {
      using std::sqrt;
      Vector3<Scalar> sum = Vector3<Scalar>::zero();
      Scalar square(0);
      for (const Vector3<Scalar>& a : s.semi_axes) {
        const Scalar part = dot(a, u);
        sum = sum + part * a;
        square += part * part;
      }
      return s.center + sum / Scalar(sqrt(square));
    }
    case SurfaceKind::plane:
    case SurfaceKind::cone:
      break;
  }
  return s.center;
}

// The straight line of a cylinder or cone on which the normal is u.
template <class Scalar>
Vector3<Scalar> straight_line(const ContactSurface<Scalar>& s, const Vector3<Scalar>& u) {
  if (s.kind == SurfaceKind::cylinder) return s.axis;
  return (s.axis + s.sine * u) / s.cosine;
}

// The point of an ellipsoid that is nearest to the point c or farthest from it, and the normal there: with z the point
// along the semi-axes a, x_i = a_i^2 z_i / (t + a_i^2), where t is the largest or the least root of
// F(t) = sum (a_i z_i / (t + a_i^2))^2 - 1 (Eberly, Distance from a point to an ellipse, an ellipsoid, 2013).
template <class Scalar>
std::pair<Vector3<Scalar>, Vector3<Scalar>> foot_on_ellipsoid(const ContactSurface<Scalar>& s, const Vector3<Scalar>& c,
                                                              bool far) {
  std::array<Scalar, 3> a, z;
  std::array<Vector3<Scalar>, 3> e;
  double t = -INFINITY;
  const double sign = far ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = norm(s.semi_axes[i]);
    e[i] = s.semi_axes[i] / a[i];
    z[i] = dot(e[i], c - s.center);
    t = std::max(t, -sign * plain(a[i]) * plain(a[i]) + plain(a[i]) * std::abs(plain(z[i])));
  }
  // F is convex on this side of its poles: Newton's method comes to the root from below, step by step.
  double slope = -1;
  for (int round = 0; round < 200; ++round) {
    double value = -1;
    slope = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double below = t + sign * plain(a[i]) * plain(a[i]), part = plain(a[i]) * plain(z[i]);
      if (part == 0) continue;
      value += part * part / (below * below);
      slope -= 2 * part * part / (below * below * below);
    }
    const double next = t - value / slope;
    if (!(next > t)) break;
    t = next;
  }
  Scalar root(t);
  for (int round = 0; round < 3; ++round) {
    Scalar value(-1);
    for (std::size_t i = 0; i < 3; ++i) {
      const Scalar part = a[i] * z[i] / (root + Scalar(sign) * a[i] * a[i]);
      value += part * part;
    }
    root -= value / Scalar(slope);
  }
  Vector3<Scalar> x = Vector3<Scalar>::zero(), normal = Vector3<Scalar>::zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar part = Scalar(sign) * z[i] / (root + Scalar(sign) * a[i] * a[i]);
    x = x + (a[i] * a[i] * part) * e[i];
    normal = normal + part * e[i];
  }
  return {s.center + x, normalized(normal)};
}

// The point of a surface where its normal leads to the point c, the nearest one or the farthest, and its outward normal
// there.
template <class Scalar>
std::pair<Vector3<Scalar>, Vector3<Scalar>> foot_on_surface(const ContactSurface<Scalar>& s, const Vector3<Scalar>& c,
                                                            bool far) {
  using Vector = Vector3<Scalar>;
  const Scalar sign(far ? -1 : 1);
  const Vector r = c - s.center;
  switch (s.kind) {
    case SurfaceKind::plane: {
      return {c - dot(r, s.axis) * s.axis, s.axis};
    }
    case SurfaceKind::sphere: {
      const Vector u = sign * normalized(r);
      return {s.center + s.radius * u, u};
    }
    case SurfaceKind::cylinder: {
      const Scalar along = dot(r, s.axis);
      const Vector u = sign * normalized(Vector(r - along * s.axis));
      return {s.center + along * s.axis + s.radius * u, u};
    }
    case SurfaceKind::cone: {
      const Vector across = normalized(Vector(r - dot(r, s.axis) * s.axis));
      const Vector u = (sign * s.cosine) * across - s.sine * s.axis;
      return {c - dot(r, u) * u, u};
    }
    case SurfaceKind::torus: {
      const Vector across = normalized(Vector(r - dot(r, s.axis) * s.axis));
      const Vector middle = s.center + (Scalar(s.half) * s.radius) * across;
      const Vector u = sign * normalized(Vector(c - middle));
      return {middle + s.tube * u, u};
    }
    case SurfaceKind::ellipsoid:
      break;
  }
  return foot_on_ellipsoid(s, c, far);
}

// The outward normals that two surfaces have where the common normal is n.
template <class Scalar>
Vector3<Scalar> outward_on(const ContactSurface<Scalar>& on, const Vector3<Scalar>& n) {
  return on.inside ? n : -n;
}
template <class Scalar>
Vector3<Scalar> outward_from(const ContactSurface<Scalar>& from, const Vector3<Scalar>& n) {
  return from.inside ? -n : n;
}

template <class Scalar>
Vector3<Scalar> between_supports(const ContactSurface<Scalar>& on, const ContactSurface<Scalar>& from,
                                 const Vector3<Scalar>& n) {
  return support_point(on, outward_on(on, n)) - support_point(from, outward_from(from, n));
}

// Two unit vectors across a third, which may be any.
inline std::pair<Vector3<double>, Vector3<double>> two_across(const Vector3<double>& n) {
  const Vector3<double> a = std::abs(n.x) < std::abs(n.y) && std::abs(n.x) < std::abs(n.z) ? Vector3<double>::unit(0)
                            : std::abs(n.y) < std::abs(n.z)                                ? Vector3<double>::unit(1)
                                                                                           : Vector3<double>::unit(2);
  const Vector3<double> p = normalized(cross(n, a));
  return {p, cross(n, p)};
}

// The normals near a first one: of all directions two parameters, of those of a straight surface one, the angle about
// its axis.
template <class Scalar>
struct NearNormals {
  const ContactSurface<Scalar>* straight = nullptr;
  bool of_on = false;
  Vector3<double> first;

  int parameters() const { return straight ? 1 : 2; }
  Vector3<Scalar> at(const Scalar& a, const Scalar& b) const {
    using Vector = Vector3<Scalar>;
    const Vector start = lifted<Scalar>(first);
    if (!straight) {
      const auto [p, q] = two_across(first);
      return normalized(Vector(start + a * lifted<Scalar>(p) + b * lifted<Scalar>(q)));
    }
    const Vector& e = straight->axis;
    const Vector across = normalized(Vector(start - dot(start, e) * e));
    Vector turned = normalized(Vector(across + a * cross(e, across)));
    const double out = (of_on ? -1 : 1) * (straight->inside ? -1 : 1);
    if (straight->kind == SurfaceKind::cylinder) return turned;
    return straight->cosine * turned - (Scalar(out) * straight->sine) * e;
  }
  // How the normal n varies with the parameter i, but for its size.
  Vector3<Scalar> along(int i, const Vector3<Scalar>& n) const {
    if (straight) return cross(straight->axis, n);
    const auto [p, q] = two_across(first);
    const Vector3<Scalar> d = lifted<Scalar>(i == 0 ? p : q);
    return d - dot(d, n) * n;
  }
};

// The tangential distances of the two support points, and how they vary with the parameters, on plain numbers.
struct NormalStep {
  std::array<double, 2> apart{};
  std::array<std::array<double, 2>, 2> slope{};
  double gap = 0;
};

template <class Scalar>
ContactSurface<double> plain_surface(const ContactSurface<Scalar>& s) {
  const auto vector = [](const Vector3<Scalar>& a) { return plain(a); };
  return converted_surface<double>(s, vector, vector, [](const Scalar& x) { return plain(x); });
}

inline NormalStep normal_step(const ContactSurface<double>& on, const ContactSurface<double>& from,
                              const NearNormals<double>& near) {
  using D = Dual<2>;
  const auto vector = [](const Vector3<double>& a) { return lifted<D>(a); };
  const auto number = [](double x) { return D(x); };
  const auto on_d = converted_surface<D>(on, vector, vector, number),
             from_d = converted_surface<D>(from, vector, vector, number);
  NearNormals<D> near_d{near.straight ? (near.of_on ? &on_d : &from_d) : nullptr, near.of_on, near.first};
  const Vector3<D> n = near_d.at(D::variable(0, 0), D::variable(0, 1));
  const Vector3<D> between = between_supports(on_d, from_d, n);
  NormalStep step;
  for (int i = 0; i < near.parameters(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const D apart = dot(between, near_d.along(i, n));
    step.apart[k] = apart.value;
    step.slope[k] = apart.partial;
  }
  step.gap = dot(between, n).value;
  return step;
}

// The common normal of a pair without closed form, by Newton's method: where phi is largest if both touch from outside,
// and least if one is inside the other.
template <class Scalar>
Vector3<Scalar> sought_normal(const ContactSurface<Scalar>& on, const ContactSurface<Scalar>& from) {
  const ContactSurface<double> on_0 = plain_surface(on), from_0 = plain_surface(from);
  const double sign = on.inside || from.inside ? -1 : 1;
  const auto straight = [](SurfaceKind kind) { return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone; };
  const bool of_on = straight(on.kind), of_from = straight(from.kind);
  NearNormals<double> best{of_on ? &on_0 : of_from ? &from_0 : nullptr, of_on, {}};
  double best_gap = -INFINITY;
  constexpr double converged = 1e-15, longest = 0.3;  // rad
  const auto try_from = [&](const Vector3<double>& start) {
    NearNormals<double> near = best;
    near.first = start;
    near.first = near.at(0, 0);
    if (!std::isfinite(norm(near.first))) return;
    NormalStep step = normal_step(on_0, from_0, near);
    for (int round = 0; round < 60; ++round) {
      const auto& J = step.slope;
      double a = 0, b = 0;
      if (best.straight) {
        a = sign * J[0][0] < 0 ? -step.apart[0] / J[0][0] : sign * step.apart[0] / (std::abs(step.apart[0]) + 1e-300);
      } else {
        const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
        if (det > 0 && sign * (J[0][0] + J[1][1]) < 0) {
          a = (-step.apart[0] * J[1][1] + step.apart[1] * J[0][1]) / det;
          b = (-step.apart[1] * J[0][0] + step.apart[0] * J[1][0]) / det;
        } else {
          const double size = std::hypot(step.apart[0], step.apart[1]) + 1e-300;
          a = sign * step.apart[0] / size;
          b = sign * step.apart[1] / size;
        }
      }
      const double size = std::hypot(a, b);
      if (!std::isfinite(size)) return;
      double part = size > longest ? longest / size : 1;
      NearNormals<double> next = near;
      NormalStep there;
      // A step that leads to a worse distance was too long.
      for (int halving = 0; halving < 8; ++halving, part /= 4) {
        next.first = near.at(part * a, part * b);
        there = normal_step(on_0, from_0, next);
        if (size < 1e-4 || sign * there.gap >= sign * step.gap) break;
      }
      near = next;
      step = there;
      if (size < converged) break;
    }
    if (sign * step.gap > best_gap) {
      best_gap = sign * step.gap;
      best.first = near.first;
    }
  };
  // Where they touch the distance is nothing, and worse at every other such normal. Of two that touch from outside the
  // way between their centers is near it, else the most promising of many directions, and last any of them.
  const double touching = 1e-7 * norm(on_0.center - from_0.center);
  if (sign > 0) try_from(normalized(on_0.center - from_0.center));
  if (!(best_gap >= -touching)) {
    std::array<std::pair<double, Vector3<double>>, 26> starts;
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          // A little aside, so that no start lies on an axis of symmetry.
          constexpr double aside = 0.1234;
          NearNormals<double> near = best;
          near.first = normalized(Vector3<double>{x + aside * y, y + aside * z, z - aside * x});
          near.first = near.at(0, 0);
          starts[count++] = {-sign * dot(near.first, between_supports(on_0, from_0, near.first)), near.first};
        }
    std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr std::size_t most_promising = 5;
    for (std::size_t i = 0; i < count && (i < most_promising || !(best_gap >= -touching)); ++i)
      try_from(starts[i].second);
  }
  const NormalStep step = normal_step(on_0, from_0, best);
  const NearNormals<Scalar> near{best.straight ? (of_on ? &on : &from) : nullptr, of_on, best.first};
  Scalar a(0), b(0);
  for (int round = 0; round < 4; ++round) {
    const Vector3<Scalar> n = near.at(a, b), between = between_supports(on, from, n);
    const Scalar f = dot(between, near.along(0, n));
    const auto& J = step.slope;
    if (best.straight) {
      a -= f / Scalar(J[0][0]);
      continue;
    }
    const Scalar g = dot(between, near.along(1, n));
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    a -= (Scalar(J[1][1]) * f - Scalar(J[0][1]) * g) / Scalar(det);
    b -= (Scalar(J[0][0]) * g - Scalar(J[1][0]) * f) / Scalar(det);
  }
  return near.at(a, b);
}

// The normal that two straight surfaces with crossing axes have in common: n . e is given by the angle of each.
template <class Scalar>
Vector3<Scalar> crossing_normal(const ContactSurface<Scalar>& on, const ContactSurface<Scalar>& from, double branch) {
  using std::sqrt;
  const Scalar k = on.inside ? Scalar(-on.sine) : on.sine, l = from.inside ? from.sine : Scalar(-from.sine);
  const Vector3<Scalar> across = cross(on.axis, from.axis);
  const Scalar c = dot(on.axis, from.axis), square = norm_squared(across);
  const Scalar x = (k - c * l) / square, y = (l - c * k) / square;
  const Scalar height = sqrt((Scalar(1) - x * k - y * l) / square);
  return x * on.axis + y * from.axis + (Scalar(branch) * height) * across;
}

}  // namespace detail

// Where two surfaces, both on the same axes, come nearest.
template <class Scalar>
Touching<Scalar> nearest_points(const ContactSurface<Scalar>& on, const ContactSurface<Scalar>& from, double branch) {
  using Vector = Vector3<Scalar>;
  const auto straight = [](SurfaceKind kind) { return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone; };
  // Beside a sphere it is the foot of its center.
  if (on.kind == SurfaceKind::sphere) {
    const auto [foot, u] = detail::foot_on_surface(from, on.center, on.inside);
    const Vector n = from.inside ? -u : u;
    return {n, detail::support_point(on, detail::outward_on(on, n)), foot};
  }
  if (from.kind == SurfaceKind::sphere) {
    const auto [foot, u] = detail::foot_on_surface(on, from.center, from.inside);
    const Vector n = on.inside ? u : -u;
    return {n, foot, detail::support_point(from, detail::outward_from(from, n))};
  }
  const Vector n = from.kind == SurfaceKind::plane            ? from.axis
                   : on.kind == SurfaceKind::plane            ? -on.axis
                   : straight(on.kind) && straight(from.kind) ? detail::crossing_normal(on, from, branch)
                                                              : detail::sought_normal(on, from);
  const Vector u_on = detail::outward_on(on, n), u_from = detail::outward_from(from, n);
  Vector X = detail::support_point(on, u_on), Y = detail::support_point(from, u_from);
  const Vector between = X - Y;
  if (on.kind == SurfaceKind::plane) return {n, Y + dot(n, between) * n, Y};
  if (from.kind == SurfaceKind::plane) return {n, X, X - dot(n, between) * n};
  // Along straight lines of the surfaces the points are free: they go where they lie above each other.
  if (straight(on.kind) && straight(from.kind)) {
    const Vector g = detail::straight_line(on, u_on), h = detail::straight_line(from, u_from);
    const Scalar c = dot(g, h), a = dot(between, g), b = dot(between, h);
    const Scalar s = (c * b - a) / (Scalar(1) - c * c);
    return {n, X + s * g, Y + (s * c + b) * h};
  }
  if (straight(on.kind)) {
    const Vector g = detail::straight_line(on, u_on);
    X = X - dot(between, g) * g;
  } else if (straight(from.kind)) {
    const Vector h = detail::straight_line(from, u_from);
    Y = Y + dot(between, h) * h;
  }
  return {n, X, Y};
}

// The direction d that belongs to the normal `was`, turned with the normal to where it is now: by the least rotation;
// beyond a right angle, from the opposite normal, after half a turn about the tangent.
template <class Scalar>
Vector3<Scalar> turned_with_normal(const Vector3<Scalar>& was, const Vector3<Scalar>& tangent,
                                   const Vector3<Scalar>& now, Vector3<Scalar> d) {
  Vector3<Scalar> start = was;
  if (plain(dot(was, now)) < 0) {
    start = -was;
    d = (Scalar(2) * dot(tangent, d)) * tangent - d;
  }
  const Vector3<Scalar> v = cross(start, now), moved = cross(v, d);
  return d + moved + cross(v, moved) / (Scalar(1) + dot(start, now));
}

}  // namespace poinsot
