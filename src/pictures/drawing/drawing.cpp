#include "pictures/drawing/drawing.h"

#include <numbers>
#include <utility>

namespace poinsot::pictures {

Drawing moved(Drawing drawing, Point2 by) {
  drawing.paper = drawing.paper.moved(by);
  for (Mark& mark : drawing.marks) {
    if (auto* stroke = std::get_if<Stroke>(&mark)) {
      for (Point2& point : stroke->points) point = point + by;
    } else if (auto* fill = std::get_if<Fill>(&mark)) {
      for (auto& loop : fill->loops)
        for (Point2& point : loop) point = point + by;
    } else {
      auto& label = std::get<Label>(mark);
      label.at = label.at + by;
    }
  }
  return drawing;
}

Box extent(const std::vector<Mark>& marks) {
  Box box;
  for (const Mark& mark : marks) {
    if (const auto* stroke = std::get_if<Stroke>(&mark)) {
      Box own;
      for (const Point2& point : stroke->points) own.include(point);
      if (!own.empty()) box.include(own.grown(stroke->width / 2));
    } else if (const auto* fill = std::get_if<Fill>(&mark)) {
      for (const auto& loop : fill->loops)
        for (const Point2& point : loop) box.include(point);
    } else {
      box.include(std::get<Label>(mark).placed());
    }
  }
  return box;
}

std::vector<Point2> arc(Point2 center, double radius, double from, double to) {
  // Chords that stay within a twentieth of a unit of the circle.
  const double step = 2 * std::acos(1 - std::min(0.5, 0.05 / std::max(radius, 0.05)));
  const int count = std::clamp(static_cast<int>(std::ceil(std::abs(to - from) / step)), 2, 200);
  std::vector<Point2> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.push_back(center + radius * Point2{std::cos(angle), -std::sin(angle)});
  }
  return points;
}

std::vector<Point2> circle(Point2 center, double radius) {
  std::vector<Point2> points = arc(center, radius, 0, 2 * std::numbers::pi);
  points.pop_back();
  return points;
}

std::vector<Point2> hull(std::vector<Point2> points) {
  std::ranges::sort(points, [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Point2> loop;
  const auto extend = [&](Point2 p, std::size_t least) {
    while (loop.size() >= least + 2 && cross(loop.back() - loop[loop.size() - 2], p - loop.back()) <= 0)
      loop.pop_back();
    loop.push_back(p);
  };
  // The upper side from left to right, then the lower one back.
  for (const Point2 p : points) extend(p, 0);
  const std::size_t turn = loop.size() - 1;
  for (auto it = points.rbegin(); it != points.rend(); ++it) extend(*it, turn);
  if (loop.size() > 1) loop.pop_back();
  return loop;
}

}  // namespace poinsot::pictures
