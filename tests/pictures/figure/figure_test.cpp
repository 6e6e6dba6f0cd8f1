// Figures of scenes built by hand, by their geometry.
#include "pictures/figure/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"

namespace poinsot {
namespace figure_test {

using namespace pictures;
using pictures_test::arrow;
using pictures_test::length_of;
using pictures_test::points_of;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

Matrix3<double> turn(const Vector& axis, double angle) {
  const Vector a = normalized(axis);
  const Matrix3<double> k = cross_matrix(a);
  return Matrix3<double>::identity() + std::sin(angle) * k + (1 - std::cos(angle)) * (k * k);
}

// The scene with everything turned about the origin.
scene::Scene turned(scene::Scene scene, const Matrix3<double>& R) {
  const auto place = [&](scene::Place& p) {
    if (p.body < 0) p.at = R * p.at;
  };
  scene.up = R * scene.up;
  for (scene::Body& body : scene.bodies) body.pose = {R * body.pose.R, R * body.pose.p};
  for (scene::Point& point : scene.points) place(point.place);
  for (scene::Symbol& symbol : scene.symbols) place(symbol.place);
  for (scene::Link& link : scene.links) {
    place(link.from);
    place(link.to);
  }
  for (scene::Diagram& diagram : scene.diagrams)
    for (scene::Arrow& own : diagram.arrows) {
      place(own.at);
      own.vector = R * own.vector;
    }
  return scene;
}

// The strokes of a kind, as lengths in their order: what of a drawing does not depend on where its labels went.
TEST(Figure, turns_with_its_scene) {
  scene::Scene scene = pictures_test::plate_scene();
  scene.dimensions.clear();
  const Matrix3<double> R = turn({0.3, -0.7, 0.5}, 1.1);
  const View view = view_from({0.5, 0.4, 0.8}, scene.up);
  const View turned_view{R * view.right, R * view.up, R * view.viewer};
  const Drawing before = figure(scene, model, "", {.view = view});
  const Drawing after = figure(turned(scene, R), model, "", {.view = turned_view});
  for (const Role role : {Role::outline, Role::rod, Role::link}) {
    const double length = length_of(before, role);
    EXPECT_GT(length, 50);
    EXPECT_NEAR(length_of(after, role), length, 1e-3 * length) << static_cast<int>(role);
  }
  const std::vector<Point2> first = points_of(before, Role::arrow), second = points_of(after, Role::arrow);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_FALSE(first.empty());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_LT(norm(first[i] - second[i]), 0.05);
}

TEST(Figure, arrows_stand_at_their_points_and_point_as_they_should) {
  scene::Scene scene;
  scene.up = {0, 0, 1};
  scene.bodies = {{.name = "box", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})}}};
  std::size_t checked = 0;
  for (const Vector& vector : {Vector{3, 0, 0}, Vector{0, -2, 0}, Vector{1, 1, 4}, Vector{-2, 3, 1}}) {
    scene::Diagram diagram{.kind = scene::DiagramKind::model, .title = "", .bodies = {0}};
    diagram.arrows = {arrow(scene::Quantity::force, 0, {1, 1, 1}, vector, "P")};
    scene.diagrams = {diagram};
    const View view = view_from({2, 1, 1.5}, scene.up);
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const Projection unscaled(view, 1);
    const Point2 seen = direction(unscaled.direction_of(normalized(vector)));
    const std::vector<Point2> shaft = points_of(drawing, Role::arrow);
    ASSERT_EQ(shaft.size(), 2U);
    EXPECT_NEAR(dot(direction(shaft[1] - shaft[0]), seen), 1, 1e-9);
    for (const Mark& mark : drawing.marks)
      if (const auto* fill = std::get_if<Fill>(&mark); fill != nullptr && fill->role == Role::arrowhead) {
        const Point2 tip = fill->loops[0][0];
        EXPECT_NEAR(dot(direction(tip - shaft[1]), seen), 1, 1e-9);
        // The corner at which it acts is on the outline: either end of the arrow is there.
        double nearest = 1e9;
        for (const Point2& p : points_of(drawing, Role::outline))
          nearest = std::min({nearest, norm(p - tip), norm(p - shaft[0])});
        EXPECT_LT(nearest, 1e-6);
        ++checked;
      }
  }
  EXPECT_EQ(checked, 4U);
}

TEST(Figure, lengths_of_arrows_are_as_the_vectors) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "bar", .mass = 1, .shapes = {pictures_test::wire_shape({{-1, 0, 0}, {1, 0, 0}})}}};
  scene::Diagram diagram{.kind = scene::DiagramKind::model, .title = "", .bodies = {0}};
  diagram.arrows = {arrow(scene::Quantity::force, 0, {-1, 0, 0}, {0, 10, 0}, "P"),
                    arrow(scene::Quantity::force, 0, {1, 0, 0}, {0, 5, 0}, "Q"),
                    arrow(scene::Quantity::force, 0, {0, 0, 0}, {0, 0.1, 0}, "R")};
  scene.diagrams = {diagram};
  const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
  std::vector<double> tips;
  for (const Mark& mark : drawing.marks)
    if (const auto* fill = std::get_if<Fill>(&mark); fill != nullptr && fill->role == Role::arrowhead)
      tips.push_back(-fill->loops[0][0].y);
  ASSERT_EQ(tips.size(), 3U);
  EXPECT_NEAR(tips[0], 2 * tips[1], 1e-9);
  // The third has the least length, and is marked.
  EXPECT_GT(tips[2], 20);
  bool says = false;
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark))
      for (const pictures::Run& run : label->runs) says = says || run.text.find("not to scale") != std::string::npos;
  EXPECT_TRUE(says);
}

TEST(Figure, a_cube_shows_three_faces) {
  scene::Scene scene;
  scene.up = {0, 0, 1};
  scene.bodies = {{.name = "box", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})}}};
  const View view = view_from({1, 1, 1}, scene.up);
  const Drawing drawing = figure(scene, model, "", {.view = view});
  // Nine edges are seen from a corner, each sqrt(2/3) of its length; the picture is 300 high.
  const double side = 300 / 2.0 / (2 * std::sqrt(2.0 / 3)) * 2;
  EXPECT_NEAR(length_of(drawing, Role::outline), 9 * side * std::sqrt(2.0 / 3), 1);
}

TEST(Figure, equations_stand_side_by_side) {
  const scene::Scene scene = pictures_test::shaft_scene();
  std::vector<std::string> names;
  for (const FigureName& name : figures_of(scene)) names.push_back(name.name);
  EXPECT_EQ(names, (std::vector<std::string>{"model", "free-body", "disk", "shaft"}));
  const Drawing drawing = figure(scene, figures_of(scene)[1], "", {});
  std::size_t equals = 0;
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark))
      for (const pictures::Run& run : label->runs) equals += run.text == "=" ? 1 : 0;
  EXPECT_EQ(equals, 1U);
}

TEST(Figure, a_plane_problem_is_seen_face_on) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "bar", .mass = 1, .shapes = {pictures_test::wire_shape({{0, 0, 0}, {1, 1, 0}})}}};
  scene.symbols = {{.kind = scene::SymbolKind::revolute, .name = "pin", .to = 0, .place = {0, {}}, .axis = {0, 0, 1}}};
  const Drawing drawing = figure(scene, model, "", {});
  const std::vector<Point2> rod = points_of(drawing, Role::rod);
  ASSERT_EQ(rod.size(), 2U);
  const Point2 d = rod[1] - rod[0];
  EXPECT_NEAR(std::abs(d.x), std::abs(d.y), 1e-6);
}

}  // namespace figure_test
}  // namespace poinsot
