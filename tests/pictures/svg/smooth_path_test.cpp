// Curves through points, against the curves that the points are of.
#include "pictures/svg/smooth_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace poinsot {
namespace smooth_path_test {

using namespace pictures;

// Points of the path, some of each of its pieces; how many pieces are straight.
struct Walked {
  std::vector<Point2> points;
  std::size_t straight = 0, bent = 0;
};
Walked walked(const std::string& path) {
  Walked result;
  std::istringstream in(path);
  Point2 at;
  char sign = 0;
  while (in >> sign) {
    if (sign == 'Z') continue;
    Point2 p[3];
    const int count = sign == 'C' ? 3 : 1;
    for (int i = 0; i < count; ++i) in >> p[i].x >> p[i].y;
    for (int k = 1; k <= 8; ++k) {
      const double t = k / 8.0, s = 1 - t;
      if (sign == 'L') result.points.push_back(at + t * (p[0] - at));
      if (sign == 'C')
        result.points.push_back(s * s * s * at + 3 * s * s * t * p[0] + 3 * s * t * t * p[1] + t * t * t * p[2]);
    }
    result.straight += sign == 'L' ? 1 : 0;
    result.bent += sign == 'C' ? 1 : 0;
    at = p[count - 1];
  }
  return result;
}

TEST(SmoothPath, runs_along_the_ellipse_that_its_points_are_of) {
  for (const double flatness : {1.0, 0.6, 0.3})
    for (const bool closed : {true, false}) {
      std::vector<Point2> points;
      constexpr int count = 48;
      for (int i = 0; i < (closed ? count : 30); ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        points.push_back({100 * std::cos(angle), flatness * 100 * std::sin(angle)});
      }
      const Walked path = walked(smooth_path(points, closed));
      EXPECT_EQ(path.bent, closed ? 48U : 29U);
      EXPECT_EQ(path.straight, 0U);
      // Chords are 0.21 off.
      for (const Point2& p : path.points) EXPECT_NEAR(std::hypot(p.x, p.y / flatness), 100, 0.08) << flatness;
    }
}

TEST(SmoothPath, keeps_corners_and_sides) {
  EXPECT_EQ(smooth_path({{0, 0}, {20, 0}, {20, 10}, {0, 10}}, true), "M0 0L20 0L20 10L0 10Z");
  // Half a disk: its diameter stays straight.
  std::vector<Point2> half;
  for (int i = 0; i <= 24; ++i)
    half.push_back({50 * std::cos(std::numbers::pi * i / 24), 50 * std::sin(std::numbers::pi * i / 24)});
  const Walked path = walked(smooth_path(half, true) + "L50 0");
  EXPECT_EQ(path.bent, 24U);
  for (const Point2& p : path.points)
    if (p.y > 1) {
      EXPECT_NEAR(norm(p), 50, 0.03);
    }
}

}  // namespace smooth_path_test
}  // namespace poinsot
