// The surfaces of the shapes from their arguments: the columns `round` and `sides` of the table in shapes.cpp.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "problem/language/exact_numbers.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem::surfaces {

template <class Scalar>
RoundSurface<Scalar> sphere(const ShapeArguments<Scalar>& a) {
  return SphereSurface<Scalar>{a.place("center"), a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> hemisphere(const ShapeArguments<Scalar>& a) {
  const Vector3<Scalar> center = a.place("center");
  return HemisphereSurface<Scalar>{center, a.toward("toward", center), a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> circle(const ShapeArguments<Scalar>& a) {
  return CircleSurface<Scalar>{a.place("center"), a.direction("normal"), a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> cylinder(const ShapeArguments<Scalar>& a) {
  const Vector3<Scalar> center = a.place("center"), half = Scalar(0.5) * a.length("length") * a.direction("axis");
  return FrustumSurface<Scalar>{center - half, a.length("radius"), center + half, a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> cone(const ShapeArguments<Scalar>& a) {
  return FrustumSurface<Scalar>{a.place("apex"), Scalar(0), a.place("base"), a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> frustum(const ShapeArguments<Scalar>& a) {
  return FrustumSurface<Scalar>{a.place("base"), a.length("base_radius"), a.place("top"), a.length("top_radius")};
}

// Of an arc, a semicircle or a sector.
template <class Scalar>
RoundSurface<Scalar> arc(const ShapeArguments<Scalar>& a) {
  using std::cos, std::sin;
  using Vector = Vector3<Scalar>;
  if (a.has("diameter")) {
    const auto ends = a.places("diameter", 2);
    const Vector center = Scalar(0.5) * (ends[0] + ends[1]), across = normalized(ends[1] - ends[0]);
    const Vector side = a.toward("toward", center), middle = normalized(side - dot(side, across) * across);
    return ArcSurface<Scalar>{center, cross(across, middle), Scalar(0.5) * norm(ends[1] - ends[0]), middle,
                              0.5 * std::numbers::pi};
  }
  const Vector center = a.place("center"), axis = a.direction("normal");
  const Scalar half = Scalar(0.5) * a.angle("angle");
  if (!a.has("start"))
    return ArcSurface<Scalar>{center, axis, a.length("radius"), a.toward("middle", center), plain(half)};
  const Vector start = a.place("start") - center;
  const Vector middle = normalized(cos(half) * start + sin(half) * cross(axis, start));
  return ArcSurface<Scalar>{center, axis, norm(start), middle, std::abs(plain(half))};
}

template <class Scalar>
Side plain_places(const ShapeArguments<Scalar>& a, const char* name) {
  Side points;
  for (const Vector3<Scalar>& point : a.places(name)) points.push_back(plain(point));
  return points;
}

// A block by its center and three edges.
inline std::vector<Side> block_sides(const Vector3<double>& center, const Vector3<double>& a, const Vector3<double>& b,
                                     const Vector3<double>& c) {
  using Vector = Vector3<double>;
  std::vector<Side> sides;
  const Vector half[3] = {0.5 * a, 0.5 * b, 0.5 * c};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      const Vector middle = center + sign * half[i], u = half[(i + 1) % 3], v = half[(i + 2) % 3];
      sides.push_back({middle - u - v, middle + u - v, middle + u + v, middle - u + v});
    }
  return sides;
}

template <class Scalar>
std::vector<Side> particle(const ShapeArguments<Scalar>& a) {
  return {Side{plain(a.place("points"))}};
}

// Of a rod, a triangle, a polygon: its points.
template <class Scalar>
std::vector<Side> points(const ShapeArguments<Scalar>& a) {
  return {Side(plain_places(a, "points"))};
}

template <class Scalar>
std::vector<Side> wire(const ShapeArguments<Scalar>& a) {
  const Side points = plain_places(a, "points");
  std::vector<Side> bars;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) bars.push_back({points[i], points[i + 1]});
  return bars;
}

template <class Scalar>
std::vector<Side> rectangle(const ShapeArguments<Scalar>& a) {
  if (a.has("sides")) {
    const Vector3<double> center = plain(a.place("center"));
    const Side s = plain_places(a, "sides");
    return {{center - 0.5 * (s[0] + s[1]), center + 0.5 * (s[0] - s[1]), center + 0.5 * (s[0] + s[1]),
             center - 0.5 * (s[0] - s[1])}};
  }
  const Side c = plain_places(a, "corners");
  return {{c[0], c[1], c[2], c[0] + c[2] - c[1]}};
}

template <class Scalar>
std::vector<Side> box(const ShapeArguments<Scalar>& a) {
  if (a.has("sides")) {
    const Side s = plain_places(a, "sides");
    return block_sides(plain(a.place("center")), s[0], s[1], s[2]);
  }
  const Side c = plain_places(a, "corners");
  const Vector3<double> d = c[1] - c[0];
  return block_sides(0.5 * (c[0] + c[1]), {d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z});
}

// A cube by its diagonal lies in no known way about it.
template <class Scalar>
std::vector<Side> cube(const ShapeArguments<Scalar>& a) {
  if (!a.has("center")) return {};
  const double side = plain(a.length("side"));
  return block_sides(plain(a.place("center")), {side, 0, 0}, {0, side, 0}, {0, 0, side});
}

template <class Scalar>
std::vector<Side> tetrahedron(const ShapeArguments<Scalar>& a) {
  const Side P = plain_places(a, "points");
  return {{P[0], P[1], P[2]}, {P[0], P[1], P[3]}, {P[0], P[2], P[3]}, {P[1], P[2], P[3]}};
}

template <class Scalar>
std::vector<Side> semicircle(const ShapeArguments<Scalar>& a) {
  return {Side(plain_places(a, "diameter"))};
}

// The two radii at its ends.
template <class Scalar>
std::vector<Side> sector(const ShapeArguments<Scalar>& a) {
  using Vector = Vector3<double>;
  const Vector center = plain(a.place("center")), normal = plain(a.direction("normal"));
  const Vector middle = plain(a.toward("middle", a.place("center")));
  const double r = plain(a.length("radius")), half = 0.5 * plain(a.angle("angle"));
  std::vector<Side> ends;
  for (const double sign : {-1.0, 1.0})
    ends.push_back({center, center + r * (std::cos(half) * middle + sign * std::sin(half) * cross(normal, middle))});
  return ends;
}

}  // namespace poinsot::problem::surfaces
