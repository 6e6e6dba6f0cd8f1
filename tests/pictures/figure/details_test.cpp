// Enlarged details beside figures: needles of cones and small herpolhodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace details_test {

using namespace pictures;

std::string text_of(const Label& label) {
  std::string text;
  for (const pictures::Run& run : label.runs) text += run.text;
  return text;
}

bool tells(const Drawing& drawing, const std::string& words) {
  return std::ranges::any_of(drawing.marks, [&](const Mark& mark) {
    const auto* label = std::get_if<Label>(&mark);
    return label != nullptr && text_of(*label).find(words) != std::string::npos;
  });
}

// The radii of the closed curves that are as wide as high, largest first.
std::vector<double> circles(const Drawing& drawing) {
  std::vector<double> radii;
  for (const Mark& mark : drawing.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark);
    if (stroke == nullptr || stroke->role != Role::curve || !stroke->closed || stroke->points.size() < 40) continue;
    Box box;
    for (const Point2& p : stroke->points) box.include(p);
    if (std::abs(box.width() - box.height()) < 0.05 * box.width()) radii.push_back(box.width() / 2);
  }
  std::ranges::sort(radii, std::greater{});
  return radii;
}

// A body cone of the half angle `body` that rolls on a space cone of the half angle `space`.
Drawing cones(double body, double space, std::mt19937_64& random) {
  std::normal_distribution<double> draw;
  const Vector H = normalized(Vector{draw(random), draw(random), draw(random)});
  const Vector across_both = normalized(Vector(cross(H, Vector{draw(random), draw(random), draw(random)})));
  const Vector touching = rotation_about(across_both, space) * H, axis = rotation_about(across_both, body) * touching;
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "shell", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})}}};
  scene.cones = {{.name = "body cone", .body = 0, .axis = axis, .half_angle = body, .touching_line = touching},
                 {.name = "space cone", .axis = H, .half_angle = space, .touching_line = touching}};
  const auto names = figures_of(scene);
  const auto name = std::ranges::find(names, FigureKind::cones, &FigureName::kind);
  return figure(scene, *name, "", {});
}

TEST(Details, needles_of_cones_are_cut_across_the_angular_momentum) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 10; ++round) {
    const double body = 0.004 + 0.004 * round, space = 0.05;
    const Drawing drawing = cones(body, space, random);
    EXPECT_TRUE(tells(drawing, "Cut across the angular momentum")) << round;
    const std::vector<double> radii = circles(drawing);
    ASSERT_GE(radii.size(), 2U);
    // The cut of the space cone is a circle; that of a narrow cone nearly so.
    EXPECT_NEAR(radii[1] / radii[0], std::tan(body) / std::tan(space), 0.02) << round;
  }
  EXPECT_FALSE(tells(cones(0.4, 0.5, random), "Cut across"));
}

TEST(Details, a_small_herpolhode_is_shown_along_the_angular_momentum) {
  std::mt19937_64 random(4);
  for (const double size : {0.03, 0.6}) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "box", .mass = 1, .shapes = {pictures_test::box_shape({-1, -2, -3}, {1, 2, 3})}}};
    scene::Curve polhode{scene::CurveKind::polhode, "polhode", 0, true, {}};
    scene::Curve herpolhode{scene::CurveKind::herpolhode, "herpolhode", scene::ground, false, {}};
    for (int i = 0; i <= 200; ++i) {
      const double angle = 0.15 * i;
      herpolhode.points.push_back({size * std::cos(angle), 0.8, size * std::sin(angle)});
      polhode.points.push_back({size * std::cos(angle), 0.8, 2 * size * std::sin(angle)});
    }
    scene.curves = {polhode, herpolhode};
    const auto names = figures_of(scene);
    const Drawing drawing = figure(scene, *std::ranges::find(names, FigureKind::cones, &FigureName::kind), "", {});
    EXPECT_EQ(tells(drawing, "Seen along the angular momentum"), size < 0.1);
  }
}

}  // namespace details_test
}  // namespace poinsot
