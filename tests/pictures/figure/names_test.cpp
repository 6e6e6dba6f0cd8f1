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

// Two bars with a pin at B, a point of the first: cut free, the second has its name there as well, and not that of A.
TEST(Names, the_pin_of_a_joint_is_named_on_both_bodies_that_it_joins) {
  for (const int cut_free : {0, 1}) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.length = 4;
    scene.bodies = {{.name = "one", .mass = 1, .shapes = {pictures_test::box_shape({-2, -0.1, -0.1}, {0, 0.1, 0.1})}},
                    {.name = "two", .mass = 1, .shapes = {pictures_test::box_shape({0, -0.1, -0.1}, {2, 0.1, 0.1})}}};
    scene.symbols = {{.kind = scene::SymbolKind::revolute,
                      .name = "pin",
                      .from = 0,
                      .to = 1,
                      .place = {1, {0, 0, 0}},
                      .axis = {0, 0, 1}}};
    scene.points = {{"A", {0, {-2, 0, 0}}}, {"B", {0, {0, 0, 0}}}, {"C", {1, {2, 0, 0}}}};
    scene::Diagram diagram;
    diagram.kind = scene::DiagramKind::free_body;
    diagram.bodies = {cut_free};
    scene.diagrams = {diagram};
    const Drawing drawing = figure(scene, {FigureKind::free_body, "free-body", "What acts", scene::ground}, "",
                                   {.view = view_from({0, 0, 1}, scene.up)});
    std::string names;
    for (const Mark& mark : drawing.marks)
      if (const auto* label = std::get_if<Label>(&mark); label != nullptr && label->runs.front().text.size() == 1)
        names += label->runs.front().text;
    for (const auto& [name, body] : {std::pair('A', 0), std::pair('B', cut_free), std::pair('C', 1)})
      EXPECT_EQ(names.find(name) != std::string::npos, body == cut_free) << name << " on " << cut_free << ": " << names;
  }
}

}  // namespace names_test
}  // namespace poinsot
