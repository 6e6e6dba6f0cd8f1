#include "pictures/svg/smooth_path.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace poinsot::pictures {
namespace {

constexpr double sharpest = 0.5;      // radians between two chords: what turns more is a corner
constexpr double longest_chord = 40;  // units of the paper: what is longer is a side
constexpr double most_unlike = 4;     // how much longer than its neighbor the chord of a curve may be

using Tangent = std::optional<Point2>;

// Whether a curve runs from a through b to c.
bool bends(Point2 a, Point2 b, Point2 c) {
  const Point2 before = b - a, after = c - b;
  const double first = norm(before), second = norm(after);
  if (!(first > 0) || !(second > 0) || first > longest_chord || second > longest_chord) return false;
  if (first > most_unlike * second || second > most_unlike * first) return false;
  return std::abs(std::atan2(cross(before, after), dot(before, after))) < sharpest;
}

// That of the circle through three points at the one in the middle.
Point2 middle_tangent(Point2 a, Point2 b, Point2 c) {
  const Point2 before = b - a, after = c - b;
  const double first = norm(before), second = norm(after);
  return direction((second / first) * before + (first / second) * after);
}

// At the other end of a chord, if it is an arc of a circle.
Point2 mirrored(Point2 tangent, Point2 along) { return 2 * dot(tangent, along) * along - tangent; }

}  // namespace

std::string path_number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string straight_path(const std::vector<Point2>& points, bool closed) {
  std::string path;
  for (std::size_t i = 0; i < points.size(); ++i)
    path += fmt::format("{}{} {}", i == 0 ? "M" : "L", path_number(points[i].x), path_number(points[i].y));
  return closed ? path + "Z" : path;
}

std::string smooth_path(const std::vector<Point2>& points, bool closed) {
  const std::size_t count = points.size();
  if (count < 3) return straight_path(points, closed);
  std::vector<Tangent> tangents(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!closed && (i == 0 || i + 1 == count)) continue;
    const Point2 &a = points[(i + count - 1) % count], &b = points[i], &c = points[(i + 1) % count];
    if (bends(a, b, c)) tangents[i] = middle_tangent(a, b, c);
  }
  std::string path = fmt::format("M{} {}", path_number(points[0].x), path_number(points[0].y));
  for (std::size_t i = 0; i + 1 < count + (closed ? 1 : 0); ++i) {
    const std::size_t k = (i + 1) % count;
    const Point2 from = points[i], to = points[k];
    if (!tangents[i] && !tangents[k]) {
      if (k != 0) path += fmt::format("L{} {}", path_number(to.x), path_number(to.y));
      continue;
    }
    const Point2 along = direction(to - from);
    const Point2 leaves = tangents[i] ? *tangents[i] : mirrored(*tangents[k], along);
    const Point2 arrives = tangents[k] ? *tangents[k] : mirrored(*tangents[i], along);
    const double arm = norm(to - from) / 3;
    const Point2 first = from + arm * leaves, second = to - arm * arrives;
    path += fmt::format("C{} {} {} {} {} {}", path_number(first.x), path_number(first.y), path_number(second.x),
                        path_number(second.y), path_number(to.x), path_number(to.y));
  }
  return closed ? path + "Z" : path;
}

}  // namespace poinsot::pictures
