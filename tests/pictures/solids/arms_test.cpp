// The arms by which figures join the shapes of a body with what holds it.
#include <gtest/gtest.h>

#include <random>

#include "pictures/figure/scenes.h"
#include "pictures/solids/solid.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot::pictures {
namespace arms_test {

using pictures_test::cylinder_shape;

scene::Symbol bearing(const Vector& at) {
  return {.kind = scene::SymbolKind::journal, .name = "A", .to = 0, .place = {0, at}, .axis = {0, 0, 1}};
}

// A wheel far out on its shaft: the arm runs along the axis of the bearing to the wheel's middle, on the body's axes,
// in whatever way the body is turned and moved.
TEST(Arms, a_shaft_runs_along_its_axis_to_the_middle_of_its_wheel) {
  std::mt19937 random(5);
  std::normal_distribution<double> draw;
  for (int i = 0; i < 20; ++i) {
    scene::Scene scene;
    scene.length = 3;
    scene::Body body{.name = "wheel", .mass = 1};
    body.shapes.push_back(cylinder_shape(1, 1.9, 2.1));
    body.pose.R = rotation_about(normalized(Vector{draw(random), draw(random), draw(random)}), draw(random));
    body.pose.p = {draw(random), draw(random), draw(random)};
    scene.bodies.push_back(body);
    scene.symbols.push_back(bearing({0, 0, 0}));
    const auto arms = arms_of(scene, 0);
    ASSERT_EQ(arms.size(), 1u);
    EXPECT_LT(norm(arms[0][0]), 1e-12);
    EXPECT_LT(norm(arms[0][1] - Vector{0, 0, 2}), 0.25) << "turned boxes hold the wheel with some play";
    EXPECT_LT(std::hypot(arms[0][1].x, arms[0][1].y), 1e-12);
  }
}

TEST(Arms, a_wheel_that_is_held_in_its_middle_has_none) {
  scene::Scene scene;
  scene.length = 2;
  scene::Body body{.name = "wheel", .mass = 1};
  body.shapes.push_back(cylinder_shape(1, -0.1, 0.1));
  scene.bodies.push_back(body);
  scene.symbols.push_back(bearing({0, 0, 0}));
  EXPECT_TRUE(arms_of(scene, 0).empty());
}

// Wheels and bearing of a small frame that stands far from the origin, to which no arm goes.
TEST(Arms, of_a_frame_with_places_near_each_other_stay_among_them) {
  scene::Scene scene;
  scene.length = 300;
  scene.bodies = {{.name = "frame", .massless = true}};
  const Vector middle{300, 0, 0};
  for (const double x : {-0.75, 0.75})
    scene.symbols.push_back({.kind = scene::SymbolKind::contact,
                             .name = "wheel",
                             .to = 0,
                             .place = {0, middle + Vector{x, 0, 0}},
                             .axis = {0, 1, 0}});
  scene.symbols.push_back(bearing(middle + Vector{0, 0.45, 0}));
  for (const auto& arm : arms_of(scene, 0))
    for (const Vector& end : arm) EXPECT_LT(norm(end - middle), 1);
}

// A frame between its head and its axle, with the rider above both.
TEST(Arms, a_body_held_at_two_places_beside_its_center_is_a_frame_of_three_corners) {
  for (const double height : {1.0, 0.05}) {
    scene::Scene scene;
    scene.length = 2;
    scene.bodies = {{.name = "frame", .mass = 1, .center = {0, height, 0}}};
    scene.symbols = {bearing({-1, 0, 0}), bearing({1, 0, 0})};
    const auto arms = arms_of(scene, 0);
    ASSERT_EQ(arms.size(), height > 0.3 ? 3U : 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(norm(arms[i][0] - Vector{0, height, 0}), 1e-12);
    if (arms.size() == 3) {
      EXPECT_NEAR(norm(arms[2][1] - arms[2][0]), 2, 1e-12);
      EXPECT_NEAR(arms[2][0].y, 0, 1e-12);
    }
  }
}

TEST(Arms, what_stands_for_a_shape_reaches_to_points_that_are_well_outside_and_a_known_shape_does_not) {
  std::mt19937 random(3);
  std::normal_distribution<double> draw;
  for (const bool stand_in : {true, false})
    for (const double away : {3.0, 1.05}) {
      scene::Scene scene;
      scene.length = 3;
      scene::Body body{.name = "probe", .mass = 1};
      body.shapes.push_back(cylinder_shape(1, -0.5, 0.5));
      body.shapes[0].stand_in = stand_in;
      const Vector point = away * normalized(Vector{draw(random), draw(random), 0});
      scene.bodies.push_back(body);
      scene.points = {{"A", {0, point}}};
      const auto arms = arms_of(scene, 0);
      EXPECT_EQ(arms.size(), stand_in && away > 2 ? 1U : 0U);
      for (const auto& arm : arms) {
        EXPECT_LT(norm(arm[0] - point), 1e-12);
        EXPECT_NEAR(norm(arm[1] - point), 2, 0.3);
      }
    }
}

// A massless arm that is held by a support with listed forces is bent as one in a bearing.
TEST(Arms, from_a_listed_support_an_arm_runs_along_the_axis_first) {
  for (const auto kind : {scene::SymbolKind::listed_support, scene::SymbolKind::revolute, scene::SymbolKind::ball}) {
    scene::Scene scene;
    scene.length = 3;
    scene.bodies = {{.name = "arm", .massless = true},
                    {.name = "disk", .mass = 1, .shapes = {cylinder_shape(0.5, -0.01, 0.01)}}};
    scene.bodies[1].pose.p = {2, 1, 0};
    scene.symbols = {
        {.kind = kind, .name = "A", .to = 0, .place = {0, {}}, .axis = {0, 1, 0}},
        {.kind = scene::SymbolKind::revolute, .name = "spin", .from = 0, .to = 1, .place = {1, {}}, .axis = {0, 0, 1}}};
    const auto arms = arms_of(scene, 0);
    if (kind == scene::SymbolKind::ball) {
      EXPECT_EQ(arms.size(), 1U);
      continue;
    }
    ASSERT_EQ(arms.size(), 2U);
    EXPECT_LT(norm(arms[0][1] - Vector{0, 1, 0}), 1e-12);
  }
}

}  // namespace arms_test
}  // namespace poinsot::pictures
