// Where symbols of joints and contacts stand, and from where problems are seen that lie in a plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"
#include "pictures/figure/view_choice.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace symbols_test {

using namespace pictures;
using pictures_test::points_of;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

Vector random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> part;
  return normalized(Vector{part(random), part(random), part(random)});
}

scene::Symbol pin(const Vector& at, const Vector& axis) {
  return {.kind = scene::SymbolKind::revolute, .name = "pin", .to = 0, .place = {0, at}, .axis = axis};
}

scene::Scene scene_with(scene::Shape shape, std::vector<scene::Symbol> symbols) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "body", .mass = 1, .shapes = {std::move(shape)}}};
  scene.symbols = std::move(symbols);
  return scene;
}

bool inside(const std::vector<Point2>& loop, Point2 p) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (cross(loop[(i + 1) % loop.size()] - loop[i], p - loop[i]) < 0) return false;
  return true;
}

std::vector<Point2> body_on_paper(const Drawing& drawing) {
  std::vector<Point2> rim = hull(points_of(drawing, Role::outline));
  double area = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) area += cross(rim[i], rim[(i + 1) % rim.size()]);
  if (area < 0) std::ranges::reverse(rim);
  return rim;
}

TEST(Symbols, a_bearing_behind_a_body_is_drawn_before_it_and_covered) {
  for (const double side : {-1.0, 1.0}) {
    const scene::Scene scene = scene_with(pictures_test::plate_shape(1, 1), {pin({0.2, 0, 0.2 * side}, {1, 0, 0})});
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0.2, 0.3, 1}, scene.up)});
    std::size_t area = 0, symbol = 0;
    for (std::size_t i = 0; i < drawing.marks.size(); ++i) {
      if (const auto* fill = std::get_if<Fill>(&drawing.marks[i]); fill != nullptr && fill->bordered) area = i;
      if (const auto* stroke = std::get_if<Stroke>(&drawing.marks[i]);
          stroke != nullptr && stroke->role == Role::symbol)
        symbol = i;
    }
    EXPECT_EQ(symbol > area, side > 0);
  }
}

TEST(Symbols, the_bracket_of_a_bearing_before_a_body_is_hidden_where_it_stands_behind) {
  // A level strip with a wall at its far edge, seen from above: what holds it from below is behind it.
  scene::Shape strip = pictures_test::plate_shape(4, 4), wall = strip;
  for (Vector& vertex : strip.vertices) vertex = {vertex.x, 0, vertex.y};
  for (Vector& vertex : wall.vertices) vertex = {vertex.x, vertex.y + 2, -2};
  for (const bool far : {true, false}) {
    scene::Scene scene = scene_with(strip, {pin({0, 0, far ? -1.6 : 2.4}, {1, 0, 0})});
    scene.bodies[0].shapes.push_back(wall);
    scene.symbols[0].kind = scene::SymbolKind::journal;
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0.3, 0.7, 1}, scene.up)});
    std::size_t first_area = drawing.marks.size(), last_area = 0, bracket = 0, sleeve = 0;
    for (std::size_t i = 0; i < drawing.marks.size(); ++i) {
      if (const auto* fill = std::get_if<Fill>(&drawing.marks[i]); fill != nullptr && fill->bordered) {
        first_area = std::min(first_area, i);
        last_area = i;
      }
      const auto* stroke = std::get_if<Stroke>(&drawing.marks[i]);
      if (stroke == nullptr || stroke->role != Role::symbol) continue;
      if (stroke->width > 2.9) bracket = i;
      if (stroke->closed) sleeve = i;
    }
    EXPECT_GT(sleeve, last_area);
    if (far) {
      EXPECT_LT(bracket, first_area);
    } else {
      EXPECT_GT(bracket, last_area);
    }
  }
}

TEST(Symbols, the_axis_of_a_hinge_between_bodies_is_drawn_to_their_centers) {
  std::mt19937_64 random(12);
  for (int round = 0; round < 10; ++round) {
    const Vector axis = random_direction(random), side = normalized(Vector(cross(axis, random_direction(random))));
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.length = 3;
    scene.bodies = {{.name = "frame", .mass = 1, .center = 2.0 * axis + 0.5 * side},
                    {.name = "fork", .mass = 1, .center = 1.0 * axis - 0.5 * side}};
    scene.symbols = {
        {.kind = scene::SymbolKind::revolute, .name = "head", .from = 0, .to = 1, .place = {1, {}}, .axis = axis}};
    const View view = view_from(cross(axis, side), scene.up);
    const Drawing drawing = figure(scene, model, "", {.view = view});
    // From the place to the farther center, in the scale that the centers show.
    double line = 0, between = 0;
    for (const Mark& mark : drawing.marks) {
      if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->dash == Dash::chain)
        line = norm(stroke->points.back() - stroke->points.front());
    }
    std::vector<Point2> rods = points_of(drawing, Role::rod);
    for (const Point2& p : rods)
      for (const Point2& q : rods) between = std::max(between, norm(p - q));
    EXPECT_NEAR(line / between, 2 / norm(2.0 * axis + 0.5 * side), 0.02) << round;
  }
}

TEST(Symbols, the_ground_that_holds_a_body_is_where_the_body_is_not) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int round = 0; round < 30; ++round) {
    // The body hangs, stands or is held at its side, by a bearing or a ball.
    const Vector low = std::vector<Vector>{{-0.5, -1, 0}, {-0.5, 0, 0}, {0, -0.5, 0}, {-1, -0.5, 0}}[round % 4];
    scene::Scene scene = scene_with(pictures_test::box_shape(low, low + Vector{1, 1, 0.02}), {pin({}, {0, 0, 1})});
    if (round % 8 < 4) scene.symbols[0].kind = scene::SymbolKind::ball;
    // The axes of the ground begin elsewhere.
    scene.bodies[0].pose.p = {3, 2, 1};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0.2 * draw(random), 0.2, 1}, scene.up)});
    const std::vector<Point2> rim = body_on_paper(drawing);
    std::size_t over = 0, all = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && stroke->role == Role::symbol && stroke->width < 0.75)
        for (const Point2& p : stroke->points) {
          over += inside(rim, p) ? 1 : 0;
          ++all;
        }
    EXPECT_GE(all, 4U);
    EXPECT_LE(over, all / 4) << round;
  }
}

TEST(Symbols, a_fixed_axis_is_drawn_through_all_of_the_body_and_beyond) {
  std::mt19937_64 random(9);
  for (int round = 0; round < 20; ++round) {
    const Vector axis = random_direction(random);
    const scene::Scene scene = scene_with(pictures_test::box_shape({-1, -1, -1}, {1, 1, 1}), {pin({}, axis)});
    const View view = view_from(random_direction(random), scene.up);
    if (norm(Projection(view, 1).direction_of(axis)) < 0.4) continue;
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const std::vector<Point2> rim = body_on_paper(drawing);
    Box body, unscaled_body, symbols;
    for (const Point2& p : rim) body.include(p);
    const Projection unscaled(view, 1);
    double reach = 0;
    for (const Vector& v : scene.bodies[0].shapes[0].vertices) {
      unscaled_body.include(unscaled(v));
      reach = std::max(reach, dot(v, axis));
    }
    std::vector<Point2> line;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && (stroke->dash == Dash::chain || stroke->dash == Dash::hidden))
        line.insert(line.end(), stroke->points.begin(), stroke->points.end());
    double length = 0;
    for (const Point2& p : line)
      for (const Point2& q : line) length = std::max(length, norm(p - q));
    const double scale = body.width() / unscaled_body.width(), foreshortened = norm(unscaled.direction_of(axis));
    EXPECT_GT(length, 2 * (reach * scale + 10) * foreshortened) << round;
    // What holds the body inside is shown where the axis leaves it, on both sides.
    for (const Point2& p : points_of(drawing, Role::symbol)) symbols.include(p);
    EXPECT_GT(norm(Point2{symbols.width(), symbols.height()}), 2 * scale * foreshortened) << round;
  }
}

TEST(Symbols, the_ground_under_a_body_lies_around_the_place_that_it_touches) {
  std::mt19937_64 random(2);
  std::size_t seen = 0;
  for (int round = 0; round < 30; ++round) {
    scene::Scene scene =
        scene_with(pictures_test::cylinder_shape(1, -0.1, 0.1), {{.kind = scene::SymbolKind::rolling_contact,
                                                                  .name = "floor",
                                                                  .to = 0,
                                                                  .place = {0, {0, -1, 0}},
                                                                  .axis = {0, 1, 0}}});
    const View view = view_from(random_direction(random), scene.up);
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const Projection unscaled(view, 1);
    for (const Mark& mark : drawing.marks)
      if (const auto* fill = std::get_if<Fill>(&mark); fill != nullptr && fill->role == Role::paper) {
        Box body, expected;
        for (const Point2& p : points_of(drawing, Role::outline)) body.include(p);
        for (const Vector& v : scene.bodies[0].shapes[0].vertices) expected.include(unscaled(v));
        const double scale = (body.width() + body.height()) / (expected.width() + expected.height());
        const Point2 place = body.center() + scale * (unscaled(Vector{0, -1, 0}) - expected.center());
        std::vector<Point2> piece = fill->loops[0];
        if (cross(piece[1] - piece[0], piece[2] - piece[1]) < 0) std::ranges::reverse(piece);
        EXPECT_TRUE(inside(piece, place)) << round;
        ++seen;
      }
  }
  EXPECT_GT(seen, 8U);
}

TEST(Symbols, the_ground_does_not_turn_with_what_rolls_on_it) {
  scene::Scene scene =
      scene_with(pictures_test::cylinder_shape(1, -0.1, 0.1), {{.kind = scene::SymbolKind::rolling_contact,
                                                                .name = "floor",
                                                                .to = 0,
                                                                .place = {0, {0, -1, 0}},
                                                                .axis = {0, 1, 0}}});
  scene.motion.emplace();
  for (const double angle : {0.0, 1.0, 2.0}) {
    scene.motion->times.push_back(angle);
    scene.motion->poses.push_back({{.R = rotation_about(Vector{0, 0, 1}, -angle), .p = {angle, 0, 0}}});
  }
  const FigureName name{FigureKind::motion, "motion", "The motion", scene::ground};
  const Drawing drawing = figure(scene, name, "", {.view = view_from({0, 0, 1}, scene.up)});
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark);
        stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3) {
      EXPECT_NEAR(stroke->points.front().y, stroke->points.back().y, 1e-9);
      Box body;
      for (const Point2& p : points_of(drawing, Role::outline)) body.include(p);
      EXPECT_NEAR(stroke->points.front().y, body.bottom, 1);
    }
}

TEST(Symbols, a_problem_that_lies_in_a_plane_is_seen_straight_on) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 20; ++round) {
    const Matrix3<double> turn = rotation_about(random_direction(random), 2.0);
    scene::Scene scene = scene_with(pictures_test::box_shape({-1, 0, -0.5}, {1, 3, 0.5}), {});
    scene.bodies[0].pose.R = turn;
    scene.up = turn * Vector{0, 1, 0};
    scene.gravity = true;
    for (const double x : {-1.0, 1.0})
      scene.symbols.push_back(
          {.kind = scene::SymbolKind::contact, .name = "floor", .to = 0, .place = {0, {x, 0, 0}}, .axis = {0, 1, 0}});
    std::vector<scene::Arrow> arrows{
        pictures_test::arrow(scene::Quantity::force, 0, {1, 2, 0}, turn * Vector{1, 0, 0}, "P")};
    const auto straight_on = [&] {
      const View view = chosen_view(scene, {0}, arrows, shown_poses(scene));
      return norm(cross(view.viewer, turn * Vector{0, 0, 1})) < 1e-9;
    };
    EXPECT_TRUE(straight_on());
    // A push out of the plane makes a problem in space of it, and so does a ball.
    arrows[0].vector = turn * Vector{1, 0, 0.5};
    EXPECT_FALSE(straight_on());
    arrows[0].vector = turn * Vector{1, 0, 0};
    scene.bodies[0].shapes = {pictures_test::cylinder_shape(1, 0, 3)};
    scene.bodies[0].pose.R = turn * rotation_about(Vector{1, 0, 0}, 0.5);
    EXPECT_FALSE(straight_on());
  }
}

TEST(Symbols, the_plane_of_a_marked_angle_is_not_seen_askew) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 30; ++round) {
    const Vector arm = random_direction(random);
    scene::Scene scene = scene_with(pictures_test::wire_shape({{}, arm}), {});
    scene.dimensions = {{.name = "b", .text = "b", .angle = true, .from = {scene::ground, {0, 1, 0}}, .to = {0, arm}}};
    const Vector face = cross(Vector{0, 1, 0}, arm);
    if (norm(face) < 0.2) continue;
    const View view = chosen_view(scene, {0}, {}, shown_poses(scene));
    EXPECT_GT(std::abs(dot(normalized(face), view.viewer)), 0.45) << round;
  }
}

}  // namespace symbols_test
}  // namespace poinsot
