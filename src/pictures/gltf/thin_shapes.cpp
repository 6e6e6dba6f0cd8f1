#include "pictures/gltf/thin_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pictures/figure/arrows.h"

namespace poinsot::pictures {
namespace {

using Point = Vector3<double>;
using scene::LinkKind;
using scene::Quantity;

constexpr double whole_turn = 2 * std::numbers::pi;

Point on_circle(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

void add_line(ThinShape& shape, const std::vector<Point>& points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (const Point& end : {points[i], points[i + 1]}) shape.lines.push_back(end);
}

void add_circle(ThinShape& shape, double radius, double z) {
  constexpr int pieces = 24;
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(on_circle(radius, whole_turn * i / pieces, z));
  add_line(shape, points);
}

// A frustum between two circles about the line from one place to another; of a cone the second radius is zero.
void add_round(ThinShape& shape, const Point& from, const Point& to, double first, double second) {
  constexpr int sides = 10;
  const Point along = normalized(Point(to - from));
  const Point x = normalized(cross(along, std::abs(along.x) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0}));
  const Point y = cross(along, x);
  const auto rim = [&](const Point& center, double radius, int i) {
    const double angle = whole_turn * i / sides;
    return Point(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  };
  for (int i = 0; i < sides; ++i) {
    const Point a = rim(from, first, i), b = rim(from, first, i + 1), c = rim(to, second, i + 1),
                d = rim(to, second, i);
    for (const Point& corner : {a, b, c}) shape.triangles.push_back(corner);
    for (const Point& corner : {from, b, a}) shape.triangles.push_back(corner);
    if (second == 0) continue;
    for (const Point& corner : {a, c, d}) shape.triangles.push_back(corner);
    for (const Point& corner : {to, d, c}) shape.triangles.push_back(corner);
  }
}

bool is_inertial(Quantity quantity) {
  return quantity == Quantity::linear_momentum || quantity == Quantity::angular_momentum ||
         quantity == Quantity::rate_of_momentum || quantity == Quantity::rate_of_angular_momentum;
}

}  // namespace

ThinShape link_shape(LinkKind kind, double size) {
  ThinShape shape;
  const double radius = 0.025 * size;
  if (kind == LinkKind::cord) {
    add_line(shape, {{0, 0, 0}, {0, 0, 1}});
  } else if (kind == LinkKind::damper) {
    // A cylinder with its open end, and the piston's disk on its rod.
    constexpr double closed = 0.35, piston = 0.5, open = 0.65;
    add_line(shape, {{0, 0, 0}, {0, 0, closed}});
    add_line(shape, {{0, 0, piston}, {0, 0, 1}});
    for (const double z : {closed, open}) add_circle(shape, radius, z);
    add_circle(shape, 0.8 * radius, piston);
    for (int i = 0; i < 4; ++i) {
      const double angle = whole_turn * i / 4;
      add_line(shape, {{0, 0, closed}, on_circle(radius, angle, closed), on_circle(radius, angle, open)});
      add_line(shape, {{0, 0, piston}, on_circle(0.8 * radius, angle, piston)});
    }
  } else {
    constexpr int coils = 8, pieces = 16;
    constexpr double begin = 0.1, end = 0.9;
    std::vector<Point> points{{0, 0, 0}, {0, 0, begin}};
    for (int i = 0; i <= coils * pieces; ++i)
      points.push_back(on_circle(radius, whole_turn * i / pieces, begin + (end - begin) * i / (coils * pieces)));
    points.push_back({0, 0, end});
    points.push_back({0, 0, 1});
    add_line(shape, points);
  }
  return shape;
}

ThinShape arc_shape(double angle) {
  constexpr double step = 0.1;  // rad, which looks round
  const int pieces = std::max(2, static_cast<int>(std::ceil(angle / step)));
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(on_circle(1, angle * i / pieces, 0));
  ThinShape shape;
  add_line(shape, points);
  return shape;
}

ThinShape arrow_shape(Quantity quantity, bool swings, double length, double size) {
  ThinShape shape;
  const double thickness = 0.006 * size, cap = std::min(0.05 * size, 0.5 * length);
  const auto along = [](double z) { return Point{0, 0, z}; };
  const auto add_head = [&](double tip) { add_round(shape, along(tip - cap), along(tip), 2.6 * thickness, 0); };
  add_head(length);
  if (turns(quantity)) add_head(length - 0.8 * cap);
  const double shaft = length - cap * (turns(quantity) ? 1.7 : 0.9);
  const int dashes = is_inertial(quantity) ? 5 : 1;
  const double drawn = dashes == 1 ? 1 : 0.6;  // of each dash
  for (int i = 0; i < dashes; ++i)
    add_round(shape, along(shaft * i / dashes), along(shaft * (i + drawn) / dashes), thickness, thickness);
  if (turns(quantity)) {
    const double radius = 0.05 * size, height = 0.55 * shaft, end = 0.8 * whole_turn;
    for (const Point& point : arc_shape(end).lines) shape.lines.push_back({radius * point.x, radius * point.y, height});
    const Point tangent{-std::sin(end), std::cos(end), 0}, tail = on_circle(radius, end, height);
    add_round(shape, tail, tail + 0.03 * size * tangent, 1.6 * thickness, 0);
  }
  if (swings) add_round(shape, along(cap), along(0), 2.6 * thickness, 0);
  return shape;
}

}  // namespace poinsot::pictures
