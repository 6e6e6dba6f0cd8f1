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
#include "pictures/solids/projection.h"
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

// The areas of one role, as their corners.
std::vector<std::vector<Point2>> areas(const Drawing& drawing, Role role) {
  std::vector<std::vector<Point2>> found;
  for (const Mark& mark : drawing.marks)
    if (const auto* fill = std::get_if<Fill>(&mark); fill != nullptr && fill->role == role)
      found.insert(found.end(), fill->loops.begin(), fill->loops.end());
  return found;
}

TEST(Details, a_tension_that_is_asked_for_pulls_both_ends_of_its_cord) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int round = 0; round < 8; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    const Vector from{draw(random), draw(random), 0}, to{from.x + 2 + draw(random), draw(random), 0};
    scene.bodies = {{.name = "weight", .mass = 1, .center = from},
                    {.name = "hook", .mass = 1, .center = {from.x - 1, -2, 0}}};
    scene.links = {{.name = "cord", .from = {0, from}, .to = {scene::ground, to}, .symbol = "T_{1}"},
                   {.name = "other", .from = {1, scene.bodies[1].center}, .to = {scene::ground, to}}};
    const FigureName model{FigureKind::model, "model", "", scene::ground};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
    const auto heads = areas(drawing, Role::link);
    ASSERT_EQ(heads.size(), 2U);
    // The cord, as it is drawn: its direction on the paper, y downward.
    const Point2 along = direction(Point2{to.x - from.x, from.y - to.y});
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<Point2>& head = heads[k];
      ASSERT_EQ(head.size(), 3U);
      // From the middle of its base to its tip a head points away from the end at which it stands.
      const Point2 middle = 0.5 * (head[1] + head[2]);
      EXPECT_NEAR(dot(direction(head[0] - middle), along), k == 0 ? 1 : -1, 1e-6);
    }
    // Both stand on the cord: one line goes through the tips.
    EXPECT_NEAR(std::abs(dot(direction(heads[1][0] - heads[0][0]), along)), 1, 1e-6);
    EXPECT_GT(dot(heads[1][0] - heads[0][0], along), 0);
  }
}

// A box on an orbit: where the center that pulls is, how far and how large.
scene::Scene on_orbit(double way, double size) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.length = way;
  scene.bodies = {{.name = "satellite",
                   .mass = 1,
                   .shapes = {pictures_test::box_shape({-size, -size / 2, -size / 4}, {size, size / 2, size / 4})}}};
  scene.bodies[0].pose.p = {way, 0, 0};
  scene.curves = {{scene::CurveKind::attractor, "gravity", scene::ground, false, {{0, 0, 0}}}};
  scene.points = {{"A", {0, {size, 0, 0}}}, {"G", {0, {0, 0, 0}}}};
  return scene;
}

double width_of_bodies(const Drawing& drawing) {
  Box box;
  for (const auto& loop : areas(drawing, Role::body))
    for (const Point2& p : loop) box.include(p);
  return box.empty() ? 0 : std::max(box.width(), box.height());
}

TEST(Details, what_is_lost_beside_its_way_is_drawn_larger_and_that_is_said) {
  const FigureName model{FigureKind::model, "model", "", scene::ground};
  const Looks front{.view = view_from({0, 0, 1}, {0, 1, 0})};
  for (const double size : {1e-6, 1e-4, 5e-3}) {
    const Drawing drawing = figure(on_orbit(7e6, size * 7e6), model, "", front);
    EXPECT_GT(width_of_bodies(drawing), 30) << size;
    EXPECT_TRUE(tells(drawing, "larger")) << size;
    // Its points are apart and named.
    EXPECT_TRUE(tells(drawing, "A"));
    EXPECT_TRUE(tells(drawing, "G"));
  }
  // What can be seen at its size is drawn so.
  const Drawing near = figure(on_orbit(10, 2), model, "", front);
  EXPECT_FALSE(tells(near, "larger"));
  // So is what something holds beside its center.
  scene::Scene held = on_orbit(7e6, 7);
  held.links = {{.name = "tether", .from = {0, {7, 0, 0}}, .to = {scene::ground, {0, 0, 0}}}};
  EXPECT_FALSE(tells(figure(held, model, "", front), "larger"));
}

// A bollard between a ship and the hand that holds its hawser, far apart.
TEST(Details, a_post_that_is_lost_beside_its_cord_is_drawn_larger) {
  const FigureName model{FigureKind::model, "model", "", scene::ground};
  for (const double radius : {0.15, 2.0}) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.length = 16;
    const Vector ship{-12, radius, 0}, hand{6, radius, 0}, top{0, radius, 0};
    scene.bodies = {{.name = "ship", .mass = 1, .center = ship}, {.name = "hand", .mass = 1, .center = hand}};
    scene.links = {{.name = "hawser", .from = {0, ship}, .to = {scene::ground, top}},
                   {.name = "hawser", .from = {scene::ground, top}, .to = {1, hand}}};
    scene::Curve post{scene::CurveKind::post, "", scene::ground, true, {}};
    for (int i = 0; i < 36; ++i) {
      const double angle = 2 * std::numbers::pi * i / 36;
      post.points.push_back({radius * std::sin(angle), radius * std::cos(angle), 0});
    }
    scene.curves = {post};
    scene.points = {{"O", {scene::ground, {0, 0, 0}}}};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
    EXPECT_EQ(tells(drawing, "larger"), radius < 1);
    // The cord comes to its rim and does not pass over it.
    Box rim, cord;
    for (const Mark& mark : drawing.marks) {
      const auto* stroke = std::get_if<Stroke>(&mark);
      if (stroke == nullptr) continue;
      for (const Point2& p : stroke->points) {
        if (stroke->closed && stroke->role == Role::symbol && stroke->points.size() == 36) rim.include(p);
        if (stroke->role == Role::link && stroke->points.size() == 2 && stroke->width == 1.4) cord.include(p);
      }
    }
    EXPECT_GT(rim.width(), 30) << radius;
    EXPECT_NEAR(cord.top, rim.top, 0.5) << radius;
  }
}

// A spring of 100 m of which a piece is drawn: its length would be read from the piece.
TEST(Details, a_length_along_what_is_cut_off_is_not_told) {
  const FigureName model{FigureKind::model, "model", "", scene::ground};
  for (const bool far : {false, true}) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "block", .mass = 1, .shapes = {pictures_test::box_shape({-1, 0, -1}, {1, 1, 1})}}};
    scene.links = {
        {.kind = scene::LinkKind::spring, .name = "s", .from = {0, {0, 0, 0}}, .to = {scene::ground, {0, -2, 0}}}};
    scene.links[0].far = far;
    scene::Dimension height;
    height.name = "h";
    height.text = "h = 100 m";
    height.from = {0, {0, 0, 0}};
    height.to = {scene::ground, {0, -2, 0}};
    scene.dimensions = {height};
    EXPECT_EQ(tells(figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})}), "100"), !far);
  }
}

// An axle of which the frame turns about the middle of a curve.
scene::Scene on_curve(double radius, double size) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.length = radius;
  scene.bodies = {{.name = "frame", .massless = true},
                  {.name = "axle",
                   .mass = 1,
                   .center = {radius, 0, 0},
                   .shapes = {pictures_test::box_shape({radius - size, -size / 2, -size / 4},
                                                       {radius + size, size / 2, size / 4})}}};
  scene.symbols = {
      {.kind = scene::SymbolKind::revolute, .name = "turn", .to = 0, .place = {0, {0, 0, 0}}, .axis = {0, 1, 0}},
      {.kind = scene::SymbolKind::revolute,
       .name = "bearing",
       .from = 0,
       .to = 1,
       .place = {1, {radius, 0, 0}},
       .axis = {1, 0, 0}}};
  scene.points = {
      {"O", {scene::ground, {0, 0, 0}}}, {"A", {1, {radius - size, 0, 0}}}, {"B", {1, {radius + size, 0, 0}}}};
  return scene;
}

TEST(Details, what_is_joined_from_far_away_is_drawn_nearer_and_that_is_said) {
  const FigureName model{FigureKind::model, "model", "", scene::ground};
  const Looks front{.view = view_from({0, 0, 1}, {0, 1, 0})};
  for (const double radius : {100.0, 300.0, 1e6}) {
    const Drawing drawing = figure(on_curve(radius, 1), model, "", front);
    EXPECT_TRUE(tells(drawing, "nearer")) << radius;
    EXPECT_FALSE(tells(drawing, "larger")) << radius;
    EXPECT_GT(width_of_bodies(drawing), 80) << radius;
    // It stands beside the middle on the side on which it is.
    double left = 1e300;
    for (const auto& loop : areas(drawing, Role::body))
      for (const Point2& p : loop) left = std::min(left, p.x);
    EXPECT_GT(left, drawing.paper.left + 80) << radius;
  }
  EXPECT_FALSE(tells(figure(on_curve(12, 1), model, "", front), "nearer"));
  EXPECT_FALSE(tells(figure(on_orbit(7e6, 7), model, "", front), "nearer"));
}

// On a curve nothing holds the axle at the middle: the frame in which all is steady turns there.
scene::Scene in_frame_on_curve(double radius) {
  scene::Scene scene = on_curve(radius, 1);
  scene.symbols.erase(scene.symbols.begin());
  scene.bodies.push_back({.name = "curve", .frame = true, .massless = true});
  scene::Arrow turning;
  turning.quantity = scene::Quantity::angular_velocity;
  turning.name = turning.symbol = turning.text = "W";
  turning.body = 2;
  turning.at = {2, {0, 0, 0}};
  turning.vector = {0, 1, 0};
  scene::Diagram model;
  model.kind = scene::DiagramKind::model;
  model.arrows = {turning};
  scene.diagrams = {model};
  return scene;
}

TEST(Details, what_a_frame_carries_far_from_its_axis_is_drawn_nearer) {
  const FigureName model{FigureKind::model, "model", "", scene::ground};
  const Looks front{.view = view_from({0, 0, 1}, {0, 1, 0})};
  const Drawing drawing = figure(in_frame_on_curve(300), model, "", front);
  EXPECT_TRUE(tells(drawing, "nearer"));
  EXPECT_FALSE(tells(drawing, "larger"));
  EXPECT_GT(width_of_bodies(drawing), 80);
  // What goes round a center that pulls is not.
  scene::Scene orbit = in_frame_on_curve(300);
  orbit.curves = {{scene::CurveKind::attractor, "gravity", scene::ground, false, {{0, 0, 0}}}};
  EXPECT_FALSE(tells(figure(orbit, model, "", front), "nearer"));
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
