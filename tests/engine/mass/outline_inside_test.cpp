// Points within and on outlines, against the shapes themselves.
#include "poinsot/engine/mass/outline_inside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poinsot {
namespace outline_inside_test {

using Vector = Vector3<double>;

Vector random_point(std::mt19937_64& random, double reach) {
  std::uniform_real_distribution<double> along(-reach, reach);
  return {along(random), along(random), along(random)};
}

TEST(OutlineInside, tells_where_points_are_to_solids) {
  std::mt19937_64 random(11);
  const Vector O = Vector::zero(), z = Vector::unit(2);
  const Outline ball = outlines::sphere(O, 1), torus = outlines::torus(O, z, 1, 0.4),
                box = outlines::box(O, Vector{2, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 0.5});
  for (int i = 0; i < 300; ++i) {
    const Vector p = random_point(random, 1.5);
    const double from_middle = norm(p);
    if (std::abs(from_middle - 1) > 1e-2) {
      EXPECT_EQ(lies_within(ball, p), from_middle < 1) << i;
    }
    const double from_ring = std::hypot(std::hypot(p.x, p.y) - 1, p.z);
    if (std::abs(from_ring - 0.4) > 1e-2) {
      EXPECT_EQ(lies_within(torus, p), from_ring < 0.4) << i;
    }
    const bool in_box = std::abs(p.x) < 1 && std::abs(p.y) < 0.5 && std::abs(p.z) < 0.25;
    EXPECT_EQ(lies_within(box, p), in_box) << i;
  }
}

TEST(OutlineInside, tells_how_near_points_are_to_surfaces) {
  std::mt19937_64 random(12);
  const Outline plate = outlines::rectangle(Vector::zero(), Vector{2, 0, 0}, Vector{0, 1, 0});
  for (int i = 0; i < 300; ++i) {
    const Vector p = random_point(random, 1.5);
    const double beyond_x = std::max(std::abs(p.x) - 1, 0.0), beyond_y = std::max(std::abs(p.y) - 0.5, 0.0);
    const double distance = std::hypot(beyond_x, beyond_y, p.z);
    EXPECT_TRUE(lies_on(plate, p, distance + 1e-9)) << i;
    EXPECT_FALSE(lies_on(plate, p, distance - 1e-9)) << i;
  }
}

TEST(OutlineInside, tells_how_large_it_is) {
  EXPECT_NEAR(size_of(outlines::rectangle(Vector{5, 5, 5}, Vector{3, 0, 0}, Vector{0, 4, 0})), 5, 1e-12);
  EXPECT_EQ(size_of(Outline{}), 0);
}

}  // namespace outline_inside_test
}  // namespace poinsot
