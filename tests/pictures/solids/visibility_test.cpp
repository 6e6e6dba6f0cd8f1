// What is seen of segments, against rays cast at many of their points.
#include "pictures/solids/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace poinsot {
namespace visibility_test {

using namespace pictures;

// How far the triangles of all solids reach before a point of the segment, by a ray to the viewer: below zero if none
// does.
double before(const std::vector<Solid>& solids, const Projection& projection, Point2 at, double depth) {
  double most = -1e9;
  for (const Solid& solid : solids)
    for (const auto& t : solid.triangles) {
      const Point2 a = projection(solid.vertices[t[0]]), b = projection(solid.vertices[t[1]]),
                   c = projection(solid.vertices[t[2]]);
      const double area = cross(b - a, c - a);
      const double u = cross(c - b, at - b) / area, v = cross(a - c, at - c) / area, w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const double z = u * projection.depth(solid.vertices[t[0]]) + v * projection.depth(solid.vertices[t[1]]) +
                       w * projection.depth(solid.vertices[t[2]]);
      most = std::max(most, z - depth);
    }
  return most;
}

TEST(Visibility, segments_are_seen_where_rays_reach_the_viewer) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto vector = [&] { return Vector{place(random), place(random), place(random)}; };
  std::size_t seen_points = 0, hidden_points = 0;
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<Solid> solids;
    for (int i = 0; i < 3; ++i) {
      Solid solid{.body = i, .extent = scene::Extent::surface};
      for (std::uint32_t k = 0; k < 12; k += 3) {
        for (int corner = 0; corner < 3; ++corner) solid.vertices.push_back(vector());
        solid.triangles.push_back({k, k + 1, k + 2});
      }
      solids.push_back(solid);
    }
    const Projection projection(view_from(vector(), {0, 0, 1}), 100);
    const Visibility visibility(solids, projection);
    for (int s = 0; s < 20; ++s) {
      const Vector from = vector(), to = vector();
      const DeepPoint a{projection(from), projection.depth(from)}, b{projection(to), projection.depth(to)};
      const std::vector<Interval> seen = visibility.seen(a, b);
      for (int i = 0; i < 50; ++i) {
        const double t = (i + 0.5) / 50;
        bool says = false, near_end = false;
        for (const Interval& part : seen) {
          says = says || (t >= part.first && t <= part.second);
          near_end = near_end || std::abs(t - part.first) < 3e-3 || std::abs(t - part.second) < 3e-3;
        }
        const double reach = before(solids, projection, a.at + t * (b.at - a.at), a.depth + t * (b.depth - a.depth));
        if (near_end || std::abs(reach) < 0.2) continue;
        EXPECT_EQ(says, reach < 0) << scene << " " << s << " " << t;
        ++(says ? seen_points : hidden_points);
      }
    }
  }
  EXPECT_GT(seen_points, 3000U);
  EXPECT_GT(hidden_points, 3000U);
}

TEST(Visibility, a_hole_in_a_plate_lets_see_what_is_behind) {
  const auto square = [](double half, bool hole) {
    Solid solid{.extent = scene::Extent::surface, .hole = hole, .plate = hole ? 0 : -1};
    solid.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    solid.triangles = {{0, 1, 2}, {0, 2, 3}};
    return solid;
  };
  const Projection projection(view_from({0, 0, 1}, {0, 1, 0}), 100);
  const Visibility visibility({square(1, false), square(0.5, true)}, projection);
  const std::vector<Interval> seen = visibility.seen({{-150, 10}, -20}, {{150, 10}, -20});
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_NEAR(seen[0].second, 50.0 / 300, 1e-9);
  EXPECT_NEAR(seen[1].first, 100.0 / 300, 1e-9);
  EXPECT_NEAR(seen[1].second, 200.0 / 300, 1e-9);
  EXPECT_NEAR(seen[2].first, 250.0 / 300, 1e-9);
}

}  // namespace visibility_test
}  // namespace poinsot
