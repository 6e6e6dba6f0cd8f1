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

// Two rods that lean: what stands in the middle of a side of the box around one is far from it.
TEST(Names, a_slanting_rod_has_its_name_beside_it) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> draw(0.3, 0.7);
  for (int round = 0; round < 20; ++round) {
    const double foot = draw(random);
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.length = 1;
    const auto rod = [&](const std::string& name, double side) {
      return scene::Body{
          .name = name, .mass = 1, .shapes = {pictures_test::wire_shape({{0, 1, 0}, {side * foot, 0, 0}})}};
    };
    scene.bodies = {rod("left", -1), rod("right", 1)};
    // Lengths beside them take the places that are nearest.
    for (const int body : {0, 1})
      scene.dimensions.push_back(
          {.name = "L", .text = "L", .from = {body, {0, 1, 0}}, .to = {body, {body == 0 ? -foot : foot, 0, 0}}});
    const Drawing drawing = figure(scene, {FigureKind::model, "model", "The figure", scene::ground}, "",
                                   {.view = view_from({0, 0, 1}, scene.up)});
    std::size_t found = 0;
    for (const Mark& mark : drawing.marks) {
      const auto* label = std::get_if<Label>(&mark);
      if (label == nullptr || (label->runs.front().text != "left" && label->runs.front().text != "right")) continue;
      ++found;
      const Box box = label->placed();
      double away = 1e9;
      for (const Mark& other : drawing.marks)
        if (const auto* stroke = std::get_if<Stroke>(&other); stroke != nullptr && stroke->role == Role::rod)
          for (std::size_t i = 0; i + 1 < stroke->points.size(); ++i)
            away = std::min(away, distance(box.center(), stroke->points[i], stroke->points[i + 1]));
      EXPECT_LT(away, box.width() / 2 + 16) << round;
    }
    EXPECT_EQ(found, 2U) << round;
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
