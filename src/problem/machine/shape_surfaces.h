// The surfaces of the shapes from their arguments, and their pictures: the columns `round`, `sides` and `picture` of
// the table in shapes.cpp.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "problem/entries/read_meshes.h"
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
  const auto [A, B] = a.ends();
  return FrustumSurface<Scalar>{A, a.length("radius"), B, a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> cone(const ShapeArguments<Scalar>& a) {
  return FrustumSurface<Scalar>{a.place("apex"), Scalar(0), a.place("base"), a.length("radius")};
}

template <class Scalar>
RoundSurface<Scalar> frustum(const ShapeArguments<Scalar>& a) {
  return FrustumSurface<Scalar>{a.place("base"), a.length("base_radius"), a.place("top"), a.length("top_radius")};
}

template <class Scalar>
RoundSurface<Scalar> ellipsoid(const ShapeArguments<Scalar>& a) {
  const auto s = a.lengths("semi_axes", 3);
  using Vector = Vector3<Scalar>;
  std::vector<Vector> axes{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  if (a.has("axes")) axes = a.directions("axes", 3);
  return EllipsoidSurface<Scalar>{a.place("center"), {s[0] * axes[0], s[1] * axes[1], s[2] * axes[2]}};
}

template <class Scalar>
RoundSurface<Scalar> torus(const ShapeArguments<Scalar>& a) {
  return TorusSurface<Scalar>{a.place("center"), a.direction("normal"), a.length("radius"), a.length("tube_radius")};
}

template <class Scalar>
RoundSurface<Scalar> half_cylinder(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  const Scalar r = a.length("radius");
  const Vector3<Scalar> axis = normalized(B - A), side = a.toward("toward", a.place("center"));
  return HalfCylinderSurface<Scalar>{{A, r, B, r}, normalized(side - dot(side, axis) * axis)};
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

// Both bases and the sides between them.
template <class Scalar>
std::vector<Side> prism(const ShapeArguments<Scalar>& a) {
  const Side low = plain_places(a, "base");
  const Vector3<double> edge = plain(a.place("along"));
  std::vector<Side> sides;
  Side high;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const Vector3<double>&P = low[i], &Q = low[(i + 1) % low.size()];
    sides.push_back({P, Q, Q + edge, P + edge});
    high.push_back(P + edge);
  }
  sides.push_back(low);
  sides.push_back(std::move(high));
  return sides;
}

template <class Scalar>
std::vector<Side> half_cylinder_face(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  const Vector3<double> from = plain(A), to = plain(B);
  const Vector3<double> across =
      plain(a.length("radius")) * normalized(cross(to - from, plain(a.toward("toward", a.place("center")))));
  return {{from - across, from + across, to + across, to - across}};
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

// What is drawn of a shape whose arguments have been checked.
namespace poinsot::problem::pictures {

template <class Scalar>
Outline particle(const ShapeArguments<Scalar>& a) {
  return outlines::particle(plain(a.place("points")));
}

template <class Scalar>
Outline rod(const ShapeArguments<Scalar>& a) {
  return outlines::polyline(surfaces::plain_places(a, "points"));
}

template <class Scalar>
Outline wire(const ShapeArguments<Scalar>& a) {
  return outlines::polyline(surfaces::plain_places(a, "points"));
}

template <class Scalar>
Outline arc(const ShapeArguments<Scalar>& a) {
  if (!a.has("diameter"))
    return outlines::arc_from_point(plain(a.place("center")), plain(a.direction("normal")), plain(a.place("start")),
                                    plain(a.angle("angle")));
  const auto ends = a.places("diameter", 2);
  return outlines::semicircular_arc(plain(ends[0]), plain(ends[1]),
                                    plain(a.toward("toward", Scalar(0.5) * (ends[0] + ends[1]))));
}

template <class Scalar>
Outline ring(const ShapeArguments<Scalar>& a) {
  return outlines::ring(plain(a.place("center")), plain(a.direction("normal")), plain(a.length("radius")));
}

template <class Scalar>
Outline rectangle(const ShapeArguments<Scalar>& a) {
  return outlines::polygon(surfaces::rectangle(a).front());
}

template <class Scalar>
Outline triangle(const ShapeArguments<Scalar>& a) {
  return outlines::polygon(surfaces::plain_places(a, "points"));
}

template <class Scalar>
Outline polygon(const ShapeArguments<Scalar>& a) {
  return outlines::polygon(surfaces::plain_places(a, "points"));
}

template <class Scalar>
Outline semicircle(const ShapeArguments<Scalar>& a) {
  const auto ends = a.places("diameter", 2);
  return outlines::semicircle(plain(ends[0]), plain(ends[1]),
                              plain(a.toward("toward", Scalar(0.5) * (ends[0] + ends[1]))));
}

template <class Scalar>
Outline disk(const ShapeArguments<Scalar>& a) {
  return outlines::disk(plain(a.place("center")), plain(a.direction("normal")), plain(a.length("radius")));
}

template <class Scalar>
Outline annulus(const ShapeArguments<Scalar>& a) {
  return outlines::annulus(plain(a.place("center")), plain(a.direction("normal")), plain(a.length("radius")),
                           plain(a.length("inner_radius")));
}

template <class Scalar>
Outline sector(const ShapeArguments<Scalar>& a) {
  const auto center = a.place("center");
  return outlines::sector(plain(center), plain(a.direction("normal")), plain(a.length("radius")),
                          plain(a.toward("middle", center)), plain(a.angle("angle")));
}

template <class Scalar>
Outline thick_sector(const ShapeArguments<Scalar>& a) {
  const auto center = a.place("center");
  const double inner = a.has("inner_radius") ? plain(a.length("inner_radius")) : 0;
  const Vector3<double> normal = plain(a.direction("normal")), middle = plain(a.toward("middle", center));
  const double r = plain(a.length("radius")), angle = plain(a.angle("angle"));
  if (!a.has("thickness")) return outlines::annular_sector(plain(center), normal, r, inner, middle, angle);
  return outlines::thick_sector(plain(center), normal, r, inner, middle, angle, plain(a.length("thickness")));
}

template <class Scalar>
Outline box_shell(const ShapeArguments<Scalar>& a) {
  const auto corners = a.places("corners", 2);
  return outlines::box_shell_between(plain(corners[0]), plain(corners[1]));
}

template <class Scalar>
Outline sphere_shell(const ShapeArguments<Scalar>& a) {
  return outlines::sphere_shell(plain(a.place("center")), plain(a.length("radius")));
}

template <class Scalar>
Outline hemisphere_shell(const ShapeArguments<Scalar>& a) {
  const auto center = a.place("center");
  return outlines::hemisphere_shell(plain(center), plain(a.toward("toward", center)), plain(a.length("radius")));
}

template <class Scalar>
Outline cylinder_shell(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  return outlines::cylinder_shell(plain(A), plain(B), plain(a.length("radius")));
}

template <class Scalar>
Outline closed_cylinder_shell(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  return outlines::closed_cylinder_shell(plain(A), plain(B), plain(a.length("radius")));
}

template <class Scalar>
Outline cone_shell(const ShapeArguments<Scalar>& a) {
  return outlines::cone_shell(plain(a.place("apex")), plain(a.place("base")), plain(a.length("radius")));
}

template <class Scalar>
Outline box(const ShapeArguments<Scalar>& a) {
  if (a.has("sides")) {
    const Side s = surfaces::plain_places(a, "sides");
    return outlines::box(plain(a.place("center")), s[0], s[1], s[2]);
  }
  const Side c = surfaces::plain_places(a, "corners");
  return outlines::box_between(c[0], c[1]);
}

template <class Scalar>
Outline cube(const ShapeArguments<Scalar>& a) {
  if (a.has("center")) return outlines::cube(plain(a.place("center")), plain(a.length("side")));
  const Side ends = surfaces::plain_places(a, "diagonal");
  return outlines::cube_from_diagonal(ends[0], ends[1]);
}

template <class Scalar>
Outline sphere(const ShapeArguments<Scalar>& a) {
  return outlines::sphere(plain(a.place("center")), plain(a.length("radius")));
}

template <class Scalar>
Outline hemisphere(const ShapeArguments<Scalar>& a) {
  const auto center = a.place("center");
  return outlines::hemisphere(plain(center), plain(a.toward("toward", center)), plain(a.length("radius")));
}

template <class Scalar>
Outline cylinder(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  return outlines::cylinder(plain(A), plain(B), plain(a.length("radius")));
}

template <class Scalar>
Outline tube(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  return outlines::tube(plain(A), plain(B), plain(a.length("radius")), plain(a.length("inner_radius")));
}

template <class Scalar>
Outline cone(const ShapeArguments<Scalar>& a) {
  return outlines::cone(plain(a.place("apex")), plain(a.place("base")), plain(a.length("radius")));
}

template <class Scalar>
Outline frustum(const ShapeArguments<Scalar>& a) {
  return outlines::frustum(plain(a.place("base")), plain(a.length("base_radius")), plain(a.place("top")),
                           plain(a.length("top_radius")));
}

template <class Scalar>
Outline ellipsoid(const ShapeArguments<Scalar>& a) {
  const auto s = a.lengths("semi_axes", 3);
  using Vector = Vector3<double>;
  std::array<Vector, 3> axes{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  if (a.has("axes")) {
    const auto stated = a.directions("axes", 3);
    for (std::size_t k = 0; k < 3; ++k) axes[k] = plain(stated[k]);
  }
  return outlines::ellipsoid(plain(a.place("center")), plain(s[0]) * axes[0], plain(s[1]) * axes[1],
                             plain(s[2]) * axes[2]);
}

template <class Scalar>
Outline torus(const ShapeArguments<Scalar>& a) {
  return outlines::torus(plain(a.place("center")), plain(a.direction("normal")), plain(a.length("radius")),
                         plain(a.length("tube_radius")));
}

template <class Scalar>
Outline tetrahedron(const ShapeArguments<Scalar>& a) {
  const Side P = surfaces::plain_places(a, "points");
  return outlines::tetrahedron(P[0], P[1], P[2], P[3]);
}

template <class Scalar>
Outline prism(const ShapeArguments<Scalar>& a) {
  return outlines::prism(surfaces::plain_places(a, "base"), plain(a.place("along")));
}

template <class Scalar>
Outline half_cylinder(const ShapeArguments<Scalar>& a) {
  const auto [A, B] = a.ends();
  return outlines::half_cylinder(plain(A), plain(B), plain(a.length("radius")),
                                 plain(a.toward("toward", a.place("center"))));
}

template <class Scalar>
Outline paraboloid(const ShapeArguments<Scalar>& a) {
  return outlines::paraboloid(plain(a.place("apex")), plain(a.place("base")), plain(a.length("radius")));
}

template <class Scalar>
Outline mesh(const ShapeArguments<Scalar>& a) {
  const Vector3<double> at = a.has("at") ? plain(a.place("at")) : Vector3<double>::zero();
  const TriangleMesh<double>& surface = a.shape().mesh->mesh;
  constexpr std::size_t most_triangles = 50'000;  // more than a picture shows
  return surface.triangles.size() > most_triangles ? outlines::box_of_mesh(surface, at)
                                                   : outlines::solid_of_mesh(surface, at);
}

}  // namespace poinsot::problem::pictures
