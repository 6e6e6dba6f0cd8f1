// Rings of gimbals.
#include "pictures/solids/gimbals.h"

#include <gtest/gtest.h>

#include <random>

#include "pictures/figure/scenes.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot::pictures {
namespace gimbals_test {

// A disk in two rings: it turns about x in the inner one, which turns about y in the outer one, which turns about z.
scene::Scene gyroscope() {
  scene::Scene scene;
  scene.length = 2;
  scene.bodies = {{.name = "outer", .massless = true},
                  {.name = "inner", .massless = true},
                  {.name = "disk", .mass = 1, .shapes = {pictures_test::cylinder_shape(1, -0.1, 0.1)}}};
  const auto hinge = [](const char* name, int from, int to, const Vector& axis) {
    return scene::Symbol{
        .kind = scene::SymbolKind::revolute, .name = name, .from = from, .to = to, .place = {to, {}}, .axis = axis};
  };
  scene.symbols = {hinge("vertical", scene::ground, 0, {0, 0, 1}), hinge("trunnions", 0, 1, {0, 1, 0}),
                   hinge("axle", 1, 2, {1, 0, 0})};
  return scene;
}

TEST(Gimbals, are_around_what_they_carry_and_hold_its_bearings) {
  std::mt19937 random(3);
  std::normal_distribution<double> draw;
  for (int round = 0; round < 20; ++round) {
    scene::Scene scene = gyroscope();
    const Matrix3<double> R =
        rotation_about(normalized(Vector{draw(random), draw(random), draw(random)}), draw(random));
    for (scene::Body& body : scene.bodies) body.pose = {R, {draw(random) * 0, 1, 2}};
    const std::vector<scene::Pose> poses = shown_poses(scene);
    const auto gimbals = gimbals_of(scene, poses);
    ASSERT_EQ(gimbals.size(), 3U);
    ASSERT_TRUE(gimbals[0] && gimbals[1]);
    EXPECT_FALSE(gimbals[2]);
    const double reach = std::hypot(1, 0.1);
    EXPECT_GT(gimbals[1]->radius, reach);
    EXPECT_GT(gimbals[0]->radius, gimbals[1]->radius);
    for (std::size_t i = 0; i < 3; ++i) {
      const scene::Symbol& symbol = scene.symbols[i];
      const std::vector<Vector> bearings = bearings_of(scene, symbol, gimbals, poses);
      ASSERT_EQ(bearings.size(), 2U);
      const Gimbal& ring = *gimbals[i == 0 ? 0 : i - 1];
      for (const Vector& at : bearings) {
        EXPECT_NEAR(norm(at - ring.center), ring.radius, 1e-12);
        EXPECT_LT(norm(cross(at - ring.center, R * symbol.axis)), 1e-12);
        // It is on the ring.
        EXPECT_NEAR(dot(at - ring.center, cross(ring.first, ring.second)), 0, 1e-12);
      }
    }
  }
}

TEST(Gimbals, are_not_drawn_around_what_swings_aside) {
  scene::Scene scene = gyroscope();
  scene.bodies[2].center = {0, 0, -1};
  EXPECT_FALSE(gimbals_of(scene, shown_poses(scene))[1]);
}

}  // namespace gimbals_test
}  // namespace poinsot::pictures
