// Conventions of figures, by geometry: what is not to scale can be read, radii are seen, what stands for a shape hides
// nothing, cones are looked into.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/view_choice.h"

namespace poinsot {
namespace conventions_test {

using namespace pictures;
using pictures_test::arrow;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

std::vector<const Stroke*> strokes_of(const Drawing& drawing, Role role) {
  std::vector<const Stroke*> strokes;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->role == role)
      strokes.push_back(stroke);
  return strokes;
}

bool says(const Drawing& drawing, const std::string& words) {
  return std::ranges::any_of(drawing.marks, [&](const Mark& mark) {
    const auto* label = std::get_if<Label>(&mark);
    return label != nullptr && std::ranges::any_of(label->runs, [&](const pictures::Run& run) {
             return run.text.find(words) != std::string::npos;
           });
  });
}

Vector random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> part;
  return normalized(Vector{part(random), part(random), part(random)});
}

TEST(Conventions, a_small_couple_has_room_for_its_heads_however_it_is_seen) {
  std::mt19937_64 random(8);
  std::size_t seen = 0;
  for (int round = 0; round < 60; ++round) {
    scene::Scene scene;
    scene.bodies = {{.name = "bar", .mass = 1, .shapes = {pictures_test::wire_shape({{-1, 0, 0}, {1, 0, 0}})}}};
    scene::Diagram diagram{.kind = scene::DiagramKind::model, .title = "", .bodies = {0}};
    const Vector small = random_direction(random);
    diagram.arrows = {arrow(scene::Quantity::couple, 0, {1, 0, 0}, 0.05 * small, "M"),
                      arrow(scene::Quantity::couple, 0, {-1, 0, 0}, random_direction(random), "N")};
    scene.diagrams = {diagram};
    const View view = view_from(random_direction(random), scene.up);
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const Point2 along = Projection(view, 1).direction_of(small);
    constexpr double end_on = 0.12;
    if (norm(along) < end_on) continue;
    for (const Stroke* stroke : strokes_of(drawing, Role::arrow)) {
      if (stroke->hint.find('M') == std::string::npos) continue;
      // The shaft without the double head.
      EXPECT_GT(norm(stroke->points.back() - stroke->points.front()), 25);
      EXPECT_NEAR(dot(direction(stroke->points.back() - stroke->points.front()), direction(along)), 1, 1e-9);
      ++seen;
    }
    EXPECT_TRUE(says(drawing, "not to scale"));
  }
  EXPECT_GT(seen, 40U);
}

TEST(Conventions, a_radius_is_drawn_where_it_is_seen_nearly_at_its_length) {
  std::mt19937_64 random(5);
  std::size_t compared = 0;
  for (int round = 0; round < 60; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    const Vector normal = random_direction(random), arm = normalized(Vector(cross(normal, random_direction(random))));
    scene::Body disk{.name = "disk", .mass = 1, .shapes = {pictures_test::cylinder_shape(1, -0.01, 0.01)}};
    disk.pose.R = Matrix3<double>::from_columns(arm, cross(normal, arm), normal);
    scene.bodies = {disk};
    scene.dimensions = {{.name = "r", .text = "r = 1 m", .from = {0, {}}, .to = {0, {1, 0, 0}}, .axis = {0, 0, 1}}};
    const View view = view_from(random_direction(random), scene.up);
    const Drawing drawing = figure(scene, model, "", {.view = view});
    Box outline;
    for (const Stroke* stroke : strokes_of(drawing, Role::outline))
      for (const Point2& p : stroke->points) outline.include(p);
    double longest = 0;
    for (const Stroke* stroke : strokes_of(drawing, Role::outline))
      for (const Point2& p : stroke->points) longest = std::max(longest, norm(p - outline.center()));
    for (const Stroke* stroke : strokes_of(drawing, Role::dimension)) {
      const double length = norm(stroke->points.back() - stroke->points.front());
      EXPECT_GT(length, 0.75 * longest - 6);  // the head goes on
      EXPECT_LT(length, longest + 1);
      EXPECT_LT(norm(stroke->points.front() - outline.center()), 2);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 60U);
}

// A rod along the line of sight axis inside a cylinder.
scene::Scene rotor_on_rod(bool stand_in) {
  scene::Scene scene;
  scene.up = {0, 0, 1};
  scene::Body rotor{.name = "rotor", .mass = 1, .shapes = {pictures_test::cylinder_shape(0.5, -0.2, 0.2)}};
  rotor.shapes[0].stand_in = stand_in;
  scene::Body rod{.name = "rod", .mass = 1, .shapes = {pictures_test::wire_shape({{0, 0, -1}, {0, 0, 1}})}};
  scene.bodies = {rotor, rod};
  return scene;
}

TEST(Conventions, rods_shine_through_solids_that_stand_for_a_shape_and_through_no_others) {
  const View view = view_from({1, 0.3, 0.4}, {0, 0, 1});
  const auto length = [&](bool stand_in, bool pale) {
    const Drawing drawing = figure(rotor_on_rod(stand_in), model, "", {.view = view});
    double sum = 0;
    for (const Stroke* stroke : strokes_of(drawing, Role::rod))
      if ((stroke->opacity < 0.5) == pale)
        for (std::size_t i = 0; i + 1 < stroke->points.size(); ++i)
          sum += norm(stroke->points[i + 1] - stroke->points[i]);
    return sum;
  };
  EXPECT_GT(length(false, false), 50);
  EXPECT_EQ(length(false, true), 0);
  EXPECT_GT(length(true, true), 20);
  EXPECT_NEAR(length(true, false), length(false, false), 1e-6);
}

TEST(Conventions, cones_are_looked_into_and_seen_from_the_side) {
  std::mt19937_64 random(12);
  for (int round = 0; round < 40; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "satellite", .mass = 1, .shapes = {pictures_test::cylinder_shape(1, -1, 1)}}};
    const Vector H = random_direction(random), across_H = normalized(Vector(cross(H, random_direction(random))));
    const Vector w = std::cos(0.3) * H + std::sin(0.3) * across_H;
    const Vector axis = std::cos(0.8) * H + std::sin(0.8) * across_H;
    scene.cones = {{"body cone", 0, {}, axis, 0.5, w}, {"space cone", scene::ground, {}, H, 0.3, w}};
    const View view = chosen_view_of_cones(scene, {0}, shown_poses(scene));
    for (const Vector& one : {H, axis}) {
      EXPECT_GT(std::abs(dot(one, view.viewer)), 0.12) << round;
      EXPECT_GT(norm(Projection(view, 1).direction_of(one)), 0.3) << round;
    }
    const auto names = figures_of(scene);
    const auto cones = std::ranges::find(names, FigureKind::cones, &FigureName::kind);
    ASSERT_NE(cones, names.end());
    const Drawing drawing = figure(scene, *cones, "", {});
    // The two directions: of the angular velocity, in which the cones touch, and of the angular momentum.
    const std::vector<const Stroke*> arrows = strokes_of(drawing, Role::arrow);
    ASSERT_EQ(arrows.size(), 2U);
    const Projection unscaled(view, 1);
    for (std::size_t i = 0; i < 2; ++i) {
      const Point2 seen = unscaled.direction_of(i == 0 ? w : H);
      EXPECT_NEAR(dot(direction(arrows[i]->points.back() - arrows[i]->points.front()), direction(seen)), 1, 1e-9);
    }
  }
}

TEST(Conventions, what_turns_a_shaft_stands_beyond_its_end_and_not_on_it) {
  std::mt19937_64 random(2);
  std::size_t looked_at = 0;
  for (int round = 0; round < 40; ++round) {
    scene::Scene scene;
    const Vector axis = random_direction(random);
    scene.bodies = {{.name = "shaft", .mass = 1, .shapes = {pictures_test::wire_shape({{}, axis})}}};
    scene::Diagram diagram{.kind = scene::DiagramKind::model, .title = "", .bodies = {0}};
    diagram.arrows = {arrow(scene::Quantity::angular_velocity, 0, {}, round % 2 == 0 ? axis : -axis, "w")};
    scene.diagrams = {diagram};
    const View view = view_from(random_direction(random), scene.up);
    if (norm(Projection(view, 1).direction_of(axis)) < 0.3) continue;
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const std::vector<const Stroke*> rods = strokes_of(drawing, Role::rod);
    ASSERT_EQ(rods.size(), 1U);
    for (const Stroke* stroke : strokes_of(drawing, Role::arrow)) {
      if (stroke->hint.empty()) continue;
      const Point2 middle = 0.5 * (stroke->points.front() + stroke->points.back());
      EXPECT_GT(distance(middle, rods[0]->points.front(), rods[0]->points.back()), 5) << round;
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 25U);
}

TEST(Conventions, a_pin_that_is_seen_from_above_has_no_side_that_is_down) {
  scene::Scene scene;
  scene.up = {0, 0, 1};
  scene.bodies = {{.name = "bar", .mass = 1, .shapes = {pictures_test::wire_shape({{0, 0, 0}, {1, 1, 0}})}}};
  scene.symbols = {{.kind = scene::SymbolKind::revolute, .name = "pin", .to = 0, .place = {0, {}}, .axis = {0, 0, 1}}};
  const auto strokes = [&](const Vector& viewer, const Vector& axis) {
    scene.symbols[0].axis = axis;
    return strokes_of(figure(scene, model, "", {.view = view_from(viewer, scene.up)}), Role::symbol).size();
  };
  EXPECT_EQ(strokes({0, 0, 1}, {0, 0, 1}), 1U);
  EXPECT_GT(strokes({0, -1, 0}, {0, 1, 0}), 4U);
}

// The planes of a groove and of a corner end where they meet, and each alone goes on to both sides of its place.
TEST(Conventions, surfaces_that_meet_do_not_cross) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> slope(0.2, 1.3);
  for (int round = 0; round < 20; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "ball", .mass = 1, .center = {0, 2, 0}}};
    const double left = slope(random), right = slope(random);
    const Vector normals[2] = {{std::sin(left), std::cos(left), 0}, {-std::sin(right), std::cos(right), 0}};
    for (const Vector& normal : normals)
      scene.curves.push_back({.kind = scene::CurveKind::surface, .name = "side", .points = {{}, normal}});
    const auto lines = [&] {
      std::vector<const Stroke*> found;
      static Drawing drawing;
      drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
      for (const Stroke* stroke : strokes_of(drawing, Role::symbol))
        if (stroke->width > 1 && stroke->points.size() == 2) found.push_back(stroke);
      return found;
    };
    const std::vector<const Stroke*> both = lines();
    ASSERT_EQ(both.size(), 2U);
    // One end of each is where they meet, which is the lowest point of both.
    double nearest = 1e300;
    Point2 meets;
    for (const Point2& a : both[0]->points)
      for (const Point2& b : both[1]->points)
        if (norm(a - b) < nearest) {
          nearest = norm(a - b);
          meets = a;
        }
    EXPECT_LT(nearest, 1e-6);
    for (const Stroke* stroke : both)
      for (const Point2& point : stroke->points) EXPECT_LE(point.y, meets.y + 1e-6) << round;
    const double half = norm(both[0]->points[1] - both[0]->points[0]);
    scene.curves.pop_back();
    const std::vector<const Stroke*> alone = lines();
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_NEAR(norm(alone[0]->points[1] - alone[0]->points[0]), 2 * half, 1e-6);
  }
}

}  // namespace conventions_test
}  // namespace poinsot
