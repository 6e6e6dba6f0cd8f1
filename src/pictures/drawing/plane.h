// Points and boxes of the paper: x to the right and y downward, in the units of the drawing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace poinsot::pictures {

struct Point2 {
  double x = 0, y = 0;

  friend Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Point2 operator-(Point2 a) { return {-a.x, -a.y}; }
  friend Point2 operator*(double s, Point2 a) { return {s * a.x, s * a.y}; }
  friend Point2 operator/(Point2 a, double s) { return {a.x / s, a.y / s}; }
};

inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Point2 a) { return std::hypot(a.x, a.y); }
inline Point2 turned_left(Point2 a) { return {a.y, -a.x}; }  // as seen on paper, where y goes down
// The unit vector, or `otherwise` for one that is next to nothing.
inline Point2 direction(Point2 a, Point2 otherwise = {1, 0}) {
  const double length = norm(a);
  return length > 1e-9 ? a / length : otherwise;
}

struct Box {
  double left = std::numeric_limits<double>::infinity(), top = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity(), bottom = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(left <= right && top <= bottom); }
  double width() const { return empty() ? 0 : right - left; }
  double height() const { return empty() ? 0 : bottom - top; }
  Point2 center() const { return {(left + right) / 2, (top + bottom) / 2}; }
  void include(Point2 p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  void include(const Box& other) {
    if (other.empty()) return;
    include(Point2{other.left, other.top});
    include(Point2{other.right, other.bottom});
  }
  Box grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
  Box moved(Point2 by) const { return {left + by.x, top + by.y, right + by.x, bottom + by.y}; }
  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool contains(Point2 p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }
};

// How much of the segment lies within the box, as a length.
inline double length_within(const Box& box, Point2 a, Point2 b) {
  double begin = 0, end = 1;
  const Point2 d = b - a;
  const auto cut = [&](double from, double step, double low, double high) {
    if (std::abs(step) < 1e-12) {
      if (from <= low || from >= high) end = begin;
      return;
    }
    const double s = (low - from) / step, t = (high - from) / step;
    begin = std::max(begin, std::min(s, t));
    end = std::min(end, std::max(s, t));
  };
  cut(a.x, d.x, box.left, box.right);
  cut(a.y, d.y, box.top, box.bottom);
  return begin < end ? (end - begin) * norm(d) : 0;
}

// Whether some of the segment lies within the box.
inline bool meets(const Box& box, Point2 a, Point2 b) {
  return length_within(box, a, b) > 0 || (box.contains(a) && norm(b - a) == 0);
}

// The distance of a point from a segment.
inline double distance(Point2 p, Point2 a, Point2 b) {
  const Point2 d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return norm(p - (a + t * d));
}

}  // namespace poinsot::pictures
