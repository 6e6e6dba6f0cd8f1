#include "problem/machine/straight_sides.h"

#include <cmath>
#include <optional>
#include <string>

#include "problem/language/exact_numbers.h"
#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;

// A side by its corners: two for a rod, at least three for a flat side.
using Side = std::vector<Vector>;

constexpr double at_place = 1e-6;  // distance up to which a place is on a side, as a part of the size of the side

std::vector<Side> box_sides(const Vector& center, const Vector& a, const Vector& b, const Vector& c) {
  std::vector<Side> sides;
  const Vector half[3] = {0.5 * a, 0.5 * b, 0.5 * c};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      const Vector middle = center + sign * half[i], u = half[(i + 1) % 3], v = half[(i + 2) % 3];
      sides.push_back({middle - u - v, middle + u - v, middle + u + v, middle - u + v});
    }
  return sides;
}

std::vector<Side> box_between(const Vector& A, const Vector& B) {
  const Vector d = B - A;
  return box_sides(0.5 * (A + B), {d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z});
}

template <class Scalar>
std::vector<Side> sides_of(const Part& part, DataScope<Scalar>& data) {
  const ShapeArguments<Scalar> a(part.shape, data, part.name, false);
  const std::string& kind = part.shape.kind;
  const auto places = [&](const char* name) {
    Side points;
    for (const Vector3<Scalar>& point : a.places(name)) points.push_back(plain(point));
    return points;
  };
  const auto place = [&](const char* name) { return plain(a.place(name)); };
  if (kind == "rod" || kind == "triangle" || kind == "polygon") return {places("points")};
  if (kind == "wire") {
    const Side points = places("points");
    std::vector<Side> bars;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) bars.push_back({points[i], points[i + 1]});
    return bars;
  }
  if (kind == "rectangle" && a.has("sides")) {
    const Vector center = place("center");
    const Side s = places("sides");
    return {{center - 0.5 * (s[0] + s[1]), center + 0.5 * (s[0] - s[1]), center + 0.5 * (s[0] + s[1]),
             center - 0.5 * (s[0] - s[1])}};
  }
  if (kind == "rectangle") {
    const Side c = places("corners");
    return {{c[0], c[1], c[2], c[0] + c[2] - c[1]}};
  }
  if (kind == "box" && a.has("sides")) {
    const Side s = places("sides");
    return box_sides(place("center"), s[0], s[1], s[2]);
  }
  if (kind == "box" || kind == "box_shell") {
    const Side c = places("corners");
    return box_between(c[0], c[1]);
  }
  if (kind == "cube" && a.has("center")) {
    const double side = plain(a.length("side"));
    return box_sides(place("center"), {side, 0, 0}, {0, side, 0}, {0, 0, side});
  }
  if (kind == "tetrahedron") {
    const Side P = places("points");
    return {{P[0], P[1], P[2]}, {P[0], P[1], P[3]}, {P[0], P[2], P[3]}, {P[1], P[2], P[3]}};
  }
  if (kind == "semicircle") return {places("diameter")};
  if (kind == "sector") {
    const Vector center = place("center"), normal = plain(a.direction("normal"));
    const Vector middle = plain(a.toward("middle", a.place("center")));
    const double r = plain(a.length("radius")), half = 0.5 * plain(a.angle("angle"));
    std::vector<Side> ends;
    for (const double sign : {-1.0, 1.0})
      ends.push_back({center, center + r * (std::cos(half) * middle + sign * std::sin(half) * cross(normal, middle))});
    return ends;
  }
  return {};
}

// The directions in which a side goes on from a place in it; nothing if the place is not on the side.
std::optional<std::vector<Vector>> directions_on(const Side& side, const Vector& C) {
  double size = 0;
  for (const Vector& corner : side) size = std::max(size, norm(corner - side.front()));
  const double tolerance = at_place * size;
  for (const Vector& corner : side)
    if (norm(C - corner) <= tolerance) return std::vector<Vector>{};
  for (std::size_t i = 0; i < (side.size() == 2 ? 1 : side.size()); ++i) {
    const Vector A = side[i], AB = side[(i + 1) % side.size()] - A;
    if (!(norm(AB) > 0)) continue;
    const Vector e = normalized(AB);
    const double along = dot(C - A, e);
    if (along > 0 && along < norm(AB) && norm(C - A - along * e) <= tolerance) return std::vector<Vector>{e};
  }
  if (side.size() < 3) return std::nullopt;
  // The place is inside if the angles that the edges subtend add up to full turns (one turn for a simple polygon).
  Vector area = Vector::zero();
  for (std::size_t i = 0; i < side.size(); ++i) area = area + cross(side[i], side[(i + 1) % side.size()]);
  if (!(norm(area) > 0)) return std::nullopt;
  const Vector normal = normalized(area);
  if (std::abs(dot(C - side.front(), normal)) > tolerance) return std::nullopt;
  double turn = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const Vector a = side[i] - C, b = side[(i + 1) % side.size()] - C;
    turn += std::atan2(dot(cross(a, b), normal), dot(a, b));
  }
  if (std::abs(turn) < 1) return std::nullopt;
  const Vector e = normalized(side[1] - side[0]);
  return std::vector<Vector>{e, cross(normal, e)};
}

}  // namespace

template <class Scalar>
std::vector<Vector3<double>> straight_directions(const Body& body, DataScope<Scalar>& data, const Vector3<double>& C,
                                                 const Vector3<double>& n) {
  constexpr double across = 1e-6;
  std::optional<std::vector<Vector>> fewest;
  for (const auto* list : {&body.parts, &body.added})
    for (const Part& part : *list) {
      if (part.shape.kind == "particle") {
        const Vector P = plain(data.place(shape_argument(part.shape, "points", data.situation().file)));
        if (norm(C - P) <= at_place * (norm(C) + norm(P))) return {};
        continue;
      }
      if (part.hole) continue;
      for (const Side& side : sides_of(part, data))
        if (const auto found = directions_on(side, C); found && (!fewest || found->size() < fewest->size()))
          fewest = found;
    }
  if (!fewest) return {};
  // If a direction is not perpendicular to the normal, the body does not lie on the surface but stands on it, as the
  // end of a bar does.
  for (const Vector& direction : *fewest)
    if (std::abs(dot(direction, n)) > across) return {};
  return *fewest;
}

template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<double>&, const Vector3<double>&,
                                                          const Vector3<double>&);
template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<Dual<1>>&, const Vector3<double>&,
                                                          const Vector3<double>&);
template std::vector<Vector3<double>> straight_directions(const Body&, DataScope<Formula>&, const Vector3<double>&,
                                                          const Vector3<double>&);

}  // namespace poinsot::problem
