// What stands on surfaces and slides along rails: blocks, floors, coefficients of friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"
#include "pictures/figure/view_choice.h"

namespace poinsot {
namespace surfaces_test {

using namespace pictures;
using pictures_test::points_of;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

scene::Shape particle_shape() {
  return {.kind = "particle", .part = "", .extent = scene::Extent::point, .vertices = {{0, 0, 0}}};
}

scene::Symbol contact(const Vector& normal) {
  return {.kind = scene::SymbolKind::contact, .name = "floor", .to = 0, .place = {0, {}}, .axis = normal};
}

scene::Scene particle_on(const Vector& normal) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.gravity = true;
  scene.bodies = {{.name = "block", .mass = 1, .shapes = {particle_shape()}}};
  scene.points = {{"C", {0, {}}}};
  scene.symbols = {contact(normal)};
  return scene;
}

TEST(Surfaces, a_particle_on_a_surface_is_a_block_that_stands_on_it) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> draw(0, 6.28);
  for (int round = 0; round < 20; ++round) {
    const double angle = draw(random);
    const Vector normal{std::cos(angle), std::sin(angle), 0};
    const Drawing drawing = figure(particle_on(normal), model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
    const std::vector<Point2> block = points_of(drawing, Role::outline);
    ASSERT_EQ(block.size(), 4U);
    const Point2 up{normal.x, -normal.y};
    // The surface is the thick line of the hatched ground.
    double surface = 0;
    std::size_t lines = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3) {
        surface = dot(stroke->points.front(), up);
        ++lines;
        // It reaches farther than the block.
        EXPECT_GT(norm(stroke->points.back() - stroke->points.front()), norm(block[1] - block[0]));
      }
    ASSERT_EQ(lines, 1U);
    double low = 1e9, high = -1e9;
    for (const Point2& p : block) {
      low = std::min(low, dot(p, up));
      high = std::max(high, dot(p, up));
    }
    EXPECT_NEAR(low, surface, 1e-9);
    EXPECT_GT(high, surface + 10);
  }
}

TEST(Surfaces, a_particle_at_a_joint_is_larger_than_its_symbol_and_else_a_dot) {
  const auto largest_disk = [](const scene::Scene& scene) {
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
    double width = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* fill = std::get_if<Fill>(&mark); fill != nullptr && fill->role == Role::point) {
        Box box;
        for (const Point2& p : fill->loops[0]) box.include(p);
        width = std::max(width, box.width());
      }
    return width;
  };
  scene::Scene scene = particle_on({0, 1, 0});
  scene.symbols = {{.kind = scene::SymbolKind::revolute, .name = "pin", .to = 0, .place = {0, {}}, .axis = {0, 0, 1}}};
  EXPECT_GT(largest_disk(scene), 16);
  scene.symbols.clear();
  EXPECT_LT(largest_disk(scene), 10);
}

TEST(Surfaces, a_coefficient_of_friction_stands_on_the_side_of_what_is_touched) {
  for (int round = 0; round < 12; ++round) {
    const double angle = 0.3 + round * 0.5;
    const Vector normal{std::cos(angle), std::sin(angle), 0};
    scene::Scene scene = particle_on(normal);
    scene.dimensions = {{.name = "mu", .text = "mu = 0.3", .from = {0, {}}, .to = {0, {}}}};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
    const Point2 up{normal.x, -normal.y};
    const std::vector<Point2> block = points_of(drawing, Role::outline);
    double low = 1e9;
    for (const Point2& p : block) low = std::min(low, dot(p, up));
    std::size_t found = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* label = std::get_if<Label>(&mark); label != nullptr) {
        std::string text;
        for (const pictures::Run& run : label->runs) text += run.text;
        if (text.find("0.3") == std::string::npos) continue;
        EXPECT_LT(dot(label->placed().center(), up), low) << round;
        EXPECT_LT(norm(label->placed().center() - block[0]), 90) << round;
        ++found;
      }
    EXPECT_EQ(found, 1U) << round;
  }
}

TEST(Surfaces, what_weight_presses_on_a_level_slide_lies_on_one_rail_below_it) {
  for (const bool gravity : {true, false})
    for (const double lean : {0.0, 0.4}) {
      scene::Scene scene;
      scene.up = {0, 1, 0};
      scene.gravity = gravity;
      scene.bodies = {
          {.name = "cart", .mass = 1, .shapes = {pictures_test::box_shape({-1, -0.5, -0.5}, {1, 0.5, 0.5})}}};
      const Vector way{std::cos(lean), std::sin(lean), 0};
      scene.symbols = {{.kind = scene::SymbolKind::prismatic, .name = "rails", .to = 0, .place = {0, {}}, .axis = way}};
      const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
      Box body;
      for (const Point2& p : points_of(drawing, Role::outline)) body.include(p);
      std::size_t rails = 0;
      for (const Mark& mark : drawing.marks)
        if (const auto* stroke = std::get_if<Stroke>(&mark);
            stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3) {
          ++rails;
          if (!gravity || lean > 0) continue;
          EXPECT_NEAR(stroke->points.front().y, body.bottom, 2);
          EXPECT_GT(std::abs(stroke->points.back().x - stroke->points.front().x), body.width());
        }
      EXPECT_EQ(rails, gravity && lean == 0 ? 1U : 2U);
    }
}

TEST(Surfaces, a_plate_that_slides_on_its_edge_lies_on_a_rail_and_has_no_shaft) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.gravity = true;
  scene.bodies = {{.name = "wedge", .mass = 1, .shapes = {pictures_test::plate_shape(2, 1)}}};
  scene.symbols = {{.kind = scene::SymbolKind::prismatic,
                    .name = "rails",
                    .to = 0,
                    .place = {0, {-0.7, -0.5, 0}},
                    .axis = {1, 0, 0}}};
  const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
  EXPECT_TRUE(points_of(drawing, Role::rod).empty());
  Box body;
  for (const Point2& p : points_of(drawing, Role::outline)) body.include(p);
  std::size_t rails = 0;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark);
        stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3) {
      ++rails;
      EXPECT_NEAR(stroke->points.front().y, body.bottom, 2);
      const auto [left, right] = std::minmax(stroke->points.front().x, stroke->points.back().x);
      EXPECT_LT(left, body.left);
      EXPECT_GT(right, body.right);
    }
  EXPECT_EQ(rails, 1U);
}

TEST(Surfaces, a_plane_of_motion_that_is_seen_askew_is_a_piece_of_ground_below_what_moves_in_it) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int round = 0; round < 20; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "sleigh", .mass = 1, .shapes = {pictures_test::box_shape({-1, 0, -1}, {1, 0.5, 1})}}};
    scene.symbols = {
        {.kind = scene::SymbolKind::planar, .name = "floor", .to = 0, .place = {0, {}}, .axis = {0, 1, 0}}};
    const Drawing drawing =
        figure(scene, model, "", {.view = view_from({part(random), 0.4 + 0.3 * part(random), 1}, scene.up)});
    Box body;
    for (const Point2& p : points_of(drawing, Role::outline)) body.include(p);
    const double middle = body.center().y;
    const std::vector<Point2> ground = points_of(drawing, Role::symbol);
    EXPECT_FALSE(ground.empty());
    // Level lines and short strokes of hatching, and no wall beside the body.
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3) {
        EXPECT_NEAR(stroke->points.front().y, stroke->points.back().y, 1e-9);
        EXPECT_GT(stroke->points.front().y, middle);
      }
  }
}

TEST(Surfaces, particles_that_slide_along_a_line_are_seen_from_the_side) {
  for (const bool on_floor : {true, false})
    for (const double lean : {0.0, 0.5}) {
      scene::Scene scene;
      scene.up = {0, 1, 0};
      scene.gravity = on_floor;
      const Vector way{std::cos(lean), std::sin(lean), 0}, out{-std::sin(lean), std::cos(lean), 0};
      scene.bodies = {{.name = "block", .mass = 1, .shapes = {particle_shape()}}};
      scene.symbols = {{.kind = on_floor ? scene::SymbolKind::contact : scene::SymbolKind::prismatic,
                        .name = "floor",
                        .to = 0,
                        .place = {0, {}},
                        .axis = on_floor ? out : way}};
      const auto seen = [&] { return chosen_view(scene, {0}, {}, shown_poses(scene)).viewer; };
      EXPECT_LT(norm(cross(seen(), Vector{0, 0, 1})), 1e-9);
      scene.links = {
          {.kind = scene::LinkKind::spring, .name = "spring", .from = {scene::ground, -2.0 * way}, .to = {0, {}}}};
      EXPECT_LT(norm(cross(seen(), Vector{0, 0, 1})), 1e-9);
      // A spring that pulls across makes it no problem of a plane, nor does a joint that turns.
      scene.links[0].from.at = {-1, 0.3, 1};
      scene.links.push_back(
          {.kind = scene::LinkKind::spring, .name = "other", .from = {scene::ground, {2, 0, 0.1}}, .to = {0, {}}});
      EXPECT_GT(norm(cross(seen(), Vector{0, 0, 1})), 0.1);
    }
}

TEST(Surfaces, a_plane_that_is_the_paper_has_no_rails_and_a_slide_seen_along_its_way_is_a_square) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "block", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})}}};
  scene.symbols = {{.kind = scene::SymbolKind::planar, .name = "guide", .to = 0, .place = {0, {}}, .axis = {0, 0, 1}}};
  const Looks straight_on{.view = view_from({0, 0, 1}, scene.up)};
  EXPECT_TRUE(points_of(figure(scene, model, "", straight_on), Role::symbol).empty());
  scene.symbols[0].kind = scene::SymbolKind::prismatic;
  EXPECT_EQ(points_of(figure(scene, model, "", straight_on), Role::symbol).size(), 4U);
}

TEST(Surfaces, what_only_carries_a_block_is_seen_straight_on_too) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.gravity = true;
  scene.bodies = {{.name = "wedge", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 0, 1})}},
                  {.name = "block", .mass = 1, .shapes = {particle_shape()}}};
  const double c = std::cos(0.5), s = std::sin(0.5);
  scene.bodies[0].pose.R = Matrix3<double>::from_columns({c, -s, 0}, {s, c, 0}, {0, 0, 1});
  scene.symbols = {
      {.kind = scene::SymbolKind::contact, .name = "slope", .from = 0, .to = 1, .place = {1, {}}, .axis = {s, c, 0}}};
  const std::vector<scene::Arrow> arrows{pictures_test::arrow(scene::Quantity::force, 0, {}, {-s, -c, 0}, "N")};
  const View view = chosen_view(scene, {0}, arrows, shown_poses(scene));
  EXPECT_LT(norm(cross(view.viewer, Vector{0, 0, 1})), 1e-9);
}

TEST(Surfaces, what_pushes_a_block_acts_at_its_middle_and_its_surface_at_the_surface) {
  scene::Scene scene = particle_on({0, 1, 0});
  const Looks front{.view = view_from({0, 0, 1}, {0, 1, 0})};
  const auto tail = [&](const char* name, const Vector& vector) {
    scene::Arrow one = pictures_test::arrow(scene::Quantity::force, 0, {}, vector, "P");
    one.name = name;
    scene.diagrams = {{.kind = scene::DiagramKind::model, .title = "", .bodies = {0}, .arrows = {one}}};
    const std::vector<Point2> shaft = points_of(figure(scene, model, "", front), Role::arrow);
    return shaft.front();
  };
  const std::vector<Point2> block = points_of(figure(scene, model, "", front), Role::outline);
  ASSERT_EQ(block.size(), 4U);
  const double middle = 0.5 * (block[0].y + block[2].y), surface = std::max(block[0].y, block[2].y);
  EXPECT_NEAR(tail("push", {5, 0, 0}).y, middle, 1e-9);
  EXPECT_NEAR(tail("floor", {0, 5, 0}).y, surface, 1e-9);
}

TEST(Surfaces, the_name_of_a_block_does_not_stand_in_the_body_below_it) {
  scene::Scene scene = particle_on({0, 1, 0});
  scene.symbols[0].from = 1;
  scene.bodies.push_back({.name = "low", .mass = 5, .shapes = {pictures_test::box_shape({-1, -1, -0.5}, {1, 0, 0.5})}});
  const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
  Box low;
  for (const Point2& point : points_of(drawing, Role::outline)) low.include(point);
  std::size_t found = 0;
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark);
        label != nullptr && !label->runs.empty() && label->runs[0].text == "block") {
      ++found;
      // The block stands on the top of the other: what is higher than that is free.
      EXPECT_LT(label->placed().center().y, low.top + 18 + 1) << low.top << " " << low.bottom;
    }
  EXPECT_EQ(found, 1U);
}

TEST(Surfaces, a_large_post_is_hatched_along_its_rim_and_has_room_within) {
  for (const double radius : {1.0, 0.06}) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "a", .mass = 1, .shapes = {particle_shape()}},
                    {.name = "b", .mass = 1, .shapes = {particle_shape()}}};
    scene.bodies[0].pose.p = {-1, -2, 0};
    scene.bodies[1].pose.p = {1, -2, 0};
    scene::Curve post{.kind = scene::CurveKind::post, .name = "post", .closed = true};
    for (int i = 0; i < 48; ++i)
      post.points.push_back(
          {radius * std::cos(i * 2 * 3.14159265358979 / 48), radius * std::sin(i * 2 * 3.14159265358979 / 48), 0});
    scene.curves = {post};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
    Box rim;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->closed && stroke->width == 1.4)
        for (const Point2& point : stroke->points) rim.include(point);
    std::size_t strokes = 0, through = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->width == 0.6) {
        ++strokes;
        const Point2 middle = 0.5 * (stroke->points.front() + stroke->points.back());
        if (norm(middle - rim.center()) < 0.25 * rim.width()) ++through;
      }
    EXPECT_GT(strokes, 0U);
    EXPECT_EQ(through > 0, radius < 0.5);
  }
}

TEST(Surfaces, a_floor_ends_at_the_wall_that_stands_on_it) {
  scene::Scene scene = particle_on({0, 1, 0});
  scene.bodies[0].pose.p = {-1, 1, 0};
  scene.symbols.clear();
  for (const Vector& normal : {Vector{0, 1, 0}, Vector{-1, 0, 0}})
    scene.symbols.push_back({.kind = scene::SymbolKind::contact, .name = "corner", .place = {}, .axis = normal});
  const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
  std::vector<Stroke> lines;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark);
        stroke != nullptr && stroke->role == Role::symbol && stroke->width > 1.3)
      lines.push_back(*stroke);
  ASSERT_EQ(lines.size(), 2U);
  // To the left and upwards of the corner, which both have in common.
  Box floor, wall;
  for (const Point2& point : lines[0].points) floor.include(point);
  for (const Point2& point : lines[1].points) wall.include(point);
  EXPECT_GT(floor.width(), 10);
  EXPECT_GT(wall.height(), 10);
  EXPECT_NEAR(floor.right, wall.left, 1e-9);
  EXPECT_NEAR(floor.top, wall.bottom, 1e-9);
}

}  // namespace surfaces_test
}  // namespace poinsot
