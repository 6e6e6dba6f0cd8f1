// Where the names of bodies stand.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"

namespace poinsot {
namespace names_test {

using namespace pictures;

TEST(Names, a_wheel_at_the_end_of_its_axle_has_its_name_at_the_wheel) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> draw(3, 12);
  for (int round = 0; round < 10; ++round) {
    const double away = draw(random);
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.length = away;
    scene.bodies = {{.name = "gear", .mass = 1, .shapes = {pictures_test::cylinder_shape(1, away - 0.1, away + 0.1)}},
                    {.name = "base", .mass = 1, .shapes = {pictures_test::box_shape({-1, -3, -1}, {1, -2, 0})}}};
    scene.symbols = {
        {.kind = scene::SymbolKind::revolute, .name = "axle", .to = 0, .place = {0, {}}, .axis = {0, 0, 1}}};
    const Drawing drawing = figure(scene, {FigureKind::model, "model", "The figure", scene::ground}, "",
                                   {.view = view_from({1, 0.2, 0.1}, scene.up)});
    Box rods;
    for (const Point2& p : pictures_test::points_of(drawing, Role::rod)) rods.include(p);
    std::size_t found = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* label = std::get_if<Label>(&mark); label != nullptr && label->runs.front().text == "gear") {
        // The axle leads to the wheel at the left end of the paper.
        EXPECT_LT(label->placed().center().x, rods.left + 0.5 * rods.width()) << round;
        ++found;
      }
    EXPECT_EQ(found, 1U) << round;
  }
}

}  // namespace names_test
}  // namespace poinsot
