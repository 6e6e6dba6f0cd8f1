// Arms that run along axes and across them, and forks around what turns in them.
#include "pictures/solids/bent_arms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pictures/figure/scenes.h"
#include "pictures/solids/solid.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot::pictures {
namespace bent_arms_test {

Vector random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> draw;
  return {draw(random), draw(random), draw(random)};
}

TEST(BentArms, between_axes_at_right_angles_an_arm_runs_along_them_and_across) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 50; ++round) {
    const Matrix3<double> turn = rotation_about(normalized(random_vector(random)), 1.0 + round);
    const Vector first = turn * Vector{1, 0, 0}, second = turn * Vector{0, 1, 0};
    const Vector from = random_vector(random), d = random_vector(random);
    const std::vector<Vector> way = bent_way({from, first}, {from + turn * d, second}, {}, 1e-6);
    ASSERT_EQ(way.size(), 4U);
    EXPECT_LT(norm(way.front() - from) + norm(way.back() - from - turn * d), 1e-12);
    EXPECT_LT(norm(way[1] - way[0] - d.x * first), 1e-12);
    EXPECT_LT(norm(way[3] - way[2] - d.y * second), 1e-12);
    // Axes that are askew have a straight arm.
    const Vector askew = normalized(first + 0.3 * second);
    EXPECT_EQ(bent_way({from, askew}, {from + turn * d, second}, {}, 1e-6).size(), 2U);
    EXPECT_EQ(bent_way({from, {}}, {from + turn * d, {}}, {}, 1e-6).size(), 2U);
  }
}

TEST(BentArms, an_arm_leaves_its_axis_before_what_turns) {
  // A plate turns about z where the first axis, y, leads to.
  const Sweep sweep = sweep_of({0, 0, 0}, {0, 0, 1}, {{1, 0, -1}, {-1, 0, 1}, {0, 1, 0}});
  EXPECT_DOUBLE_EQ(sweep.radius, 1);
  EXPECT_TRUE(sweep.takes({0, -0.5, 0}));
  EXPECT_FALSE(sweep.takes({0, -1.5, 0}));
  EXPECT_FALSE(sweep.takes({0, -0.5, 1.2}));
  const std::vector<Vector> way = bent_way({{0, -3, 0}, {0, 1, 0}}, {{0, 0, -1}, {0, 0, 1}}, {sweep}, 1e-6);
  ASSERT_EQ(way.size(), 4U);
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    for (int k = 0; k <= 50; ++k) EXPECT_FALSE(sweep.takes(way[i] + (k / 50.0) * (way[i + 1] - way[i])));
  EXPECT_EQ(bent_way({{0, -3, 0}, {0, 1, 0}}, {{0, 0, -1}, {0, 0, 1}}, {}, 1e-6).size(), 3U);
}

scene::Scene frame_with_panel(const Vector& stem) {
  scene::Scene scene;
  scene.length = 4;
  scene.bodies = {{.name = "frame", .massless = true},
                  {.name = "panel", .mass = 1, .shapes = {pictures_test::box_shape({-1, -0.01, -1}, {1, 0.01, 1})}}};
  scene.symbols = {
      {.kind = scene::SymbolKind::revolute, .name = "column", .to = 0, .place = {0, stem}, .axis = {0, 1, 0}}};
  for (const double z : {-1.0, 1.0})
    scene.symbols.push_back({.kind = scene::SymbolKind::revolute,
                             .name = "bearings",
                             .from = 0,
                             .to = 1,
                             .place = {1, {0, 0, z}},
                             .axis = {0, 0, 1}});
  return scene;
}

TEST(BentArms, a_frame_holds_what_turns_in_it_by_a_fork) {
  const auto arms = arms_of(frame_with_panel({0, -3, 0}), 0);
  ASSERT_EQ(arms.size(), 4U);
  const Sweep sweep = sweep_of({}, {0, 0, 1}, {{1, 0, -1}, {1, 0, 1}});
  double length = 0;
  for (const auto& arm : arms) {
    length += norm(arm[1] - arm[0]);
    for (int k = 0; k <= 50; ++k) EXPECT_FALSE(sweep.takes(arm[0] + (k / 50.0) * (arm[1] - arm[0])));
  }
  EXPECT_NEAR(length, 2 * 1.15 + 2 + 3 - 1.15, 0.02);
  // Nearer than the panel turns there is no room for one.
  EXPECT_EQ(arms_of(frame_with_panel({0, -0.5, 0}), 0).size(), 2U);
}

}  // namespace bent_arms_test
}  // namespace poinsot::pictures
