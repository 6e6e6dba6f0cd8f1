#include "outline_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poinsot::outlines {

Turn whole_turn(int per_turn) { return {0, 0, std::max(per_turn, 3)}; }

Turn part_of_turn(double from, double angle, int per_turn) {
  const double turns = std::abs(angle) / (2 * std::numbers::pi);
  if (turns >= 1) return whole_turn(per_turn);
  return {from, angle, std::max(2, static_cast<int>(std::ceil(per_turn * turns)))};
}

std::uint32_t OutlineBuilder::vertex(const Point& point) {
  outline_.vertices.push_back(point);
  return static_cast<std::uint32_t>(outline_.vertices.size() - 1);
}

void OutlineBuilder::triangle(const std::array<std::uint32_t, 3>& corners, const std::array<Point, 3>& normals) {
  const auto& [i, j, k] = corners;
  if (i == j || j == k || k == i) return;
  const std::vector<Point>& P = outline_.vertices;
  const bool turned_over = dot(cross(P[j] - P[i], P[k] - P[i]), normals[0] + normals[1] + normals[2]) < 0;
  if (turned_over) {
    outline_.triangles.push_back({i, k, j});
    outline_.normals.push_back({normals[0], normals[2], normals[1]});
  } else {
    outline_.triangles.push_back(corners);
    outline_.normals.push_back(normals);
  }
}

void OutlineBuilder::face(const std::vector<std::uint32_t>& corners, const Point& normal) {
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    triangle({corners[0], corners[k], corners[k + 1]}, {normal, normal, normal});
}

void OutlineBuilder::edge(std::vector<std::uint32_t> vertices) { outline_.edges.push_back(std::move(vertices)); }

std::vector<std::uint32_t> OutlineBuilder::circle(const Point& center, const Triad& triad, double radius,
                                                  const Turn& turn) {
  if (radius == 0) return {vertex(center)};
  std::vector<std::uint32_t> vertices;
  const double angle = turn.whole() ? 2 * std::numbers::pi : turn.angle;
  for (int k = 0; k < turn.segments + (turn.whole() ? 0 : 1); ++k)
    vertices.push_back(vertex(center + radius * triad.at_angle(turn.from + angle * k / turn.segments)));
  if (turn.whole()) vertices.push_back(vertices.front());
  return vertices;
}

void OutlineBuilder::turned(const Point& center, const Triad& triad, const std::vector<ProfilePart>& parts,
                            const std::vector<bool>& rims, const Turn& turn) {
  const double whole = turn.whole() ? 2 * std::numbers::pi : turn.angle;
  std::vector<Point> directions;
  for (int k = 0; k <= turn.segments; ++k) directions.push_back(triad.at_angle(turn.from + whole * k / turn.segments));
  const auto circle_at = [&](const ProfilePoint& point) {
    return circle(center + point.height * triad.third, triad, point.radius, turn);
  };
  const auto rim = [&](const std::vector<std::uint32_t>& circle) {
    if (circle.size() > 1) edge(circle);
  };
  const ProfilePoint& first = parts.front().points.front();
  const ProfilePoint& last = parts.back().points.back();
  const bool closed = first.radius == last.radius && first.height == last.height;
  const std::vector<std::uint32_t> start = circle_at(first);
  std::vector<std::uint32_t> below = start;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (rims[part]) rim(below);
    const auto& [points, normals] = parts[part];
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool back = closed && part + 1 == parts.size() && i + 1 == points.size();
      const std::vector<std::uint32_t> above = back ? start : circle_at(points[i]);
      const auto at = [](const std::vector<std::uint32_t>& circle, std::size_t k) {
        return circle.size() == 1 ? circle[0] : circle[k];
      };
      for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
        const auto normal = [&](const ProfilePoint& n, std::size_t place) {
          return n.radius * directions[place] + n.height * triad.third;
        };
        triangle({at(below, k), at(below, k + 1), at(above, k + 1)},
                 {normal(normals[i - 1], k), normal(normals[i - 1], k + 1), normal(normals[i], k + 1)});
        triangle({at(below, k), at(above, k + 1), at(above, k)},
                 {normal(normals[i - 1], k), normal(normals[i], k + 1), normal(normals[i], k)});
      }
      below = above;
    }
  }
  if (rims[parts.size()]) rim(below);
}

ProfilePart straight(const ProfilePoint& from, const ProfilePoint& to) {
  const double length = std::hypot(to.radius - from.radius, to.height - from.height);
  const ProfilePoint normal{(to.height - from.height) / length, (from.radius - to.radius) / length};
  return {{from, to}, {normal, normal}};
}

ProfilePart round(const ProfilePoint& center, double radius, double from, double to, int per_turn) {
  ProfilePart part;
  const int segments =
      std::max(1, static_cast<int>(std::lround(per_turn * std::abs(to - from) / (2 * std::numbers::pi))));
  const auto exact = [](double x) { return std::abs(x) < 1e-15 ? 0 : x; };  // so that a pole lies on the axis
  for (int k = 0; k <= segments; ++k) {
    const double angle = from + (to - from) * k / segments;
    const ProfilePoint normal{exact(std::cos(angle)), exact(std::sin(angle))};
    part.points.push_back({center.radius + radius * normal.radius, center.height + radius * normal.height});
    part.normals.push_back(normal);
  }
  if (std::abs(to - from) >= 2 * std::numbers::pi) part.points.back() = part.points.front();
  return part;
}

// Normals go by the inverse transpose, whose columns are cross products of the columns of the map.
Outline mapped(Outline outline, const Point& center, const Point& a, const Point& b, const Point& c) {
  for (Point& x : outline.vertices) x = center + x.x * a + x.y * b + x.z * c;
  const Point across_a = cross(b, c), across_b = cross(c, a), across_c = cross(a, b);
  const double volume = dot(a, across_a);
  for (std::size_t t = 0; t < outline.triangles.size(); ++t) {
    for (Point& n : outline.normals[t])
      n = normalized((n.x * across_a + n.y * across_b + n.z * across_c) * (volume < 0 ? -1.0 : 1.0));
    if (volume > 0) continue;
    std::swap(outline.triangles[t][1], outline.triangles[t][2]);
    std::swap(outline.normals[t][1], outline.normals[t][2]);
  }
  return outline;
}

}  // namespace poinsot::outlines
