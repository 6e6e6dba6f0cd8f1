// What would be in the way keeps clear: arrows of bearings and rods, dimensions of bodies, points of what was left
// behind; what matters is seen: how a body without edges leans, where a motion goes, the invariable plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/herpolhode.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"
#include "pictures/figure/view_choice.h"
#include "poinsot/engine/mass/outlines.h"

namespace poinsot {
namespace clear_figures_test {

using namespace pictures;
using pictures_test::arrow;
using pictures_test::points_of;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

std::string text_of(const Label& label) {
  std::string text;
  for (const pictures::Run& run : label.runs) text += run.text;
  return text;
}

const Label* label_of(const Drawing& drawing, const std::string& text) {
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark); label != nullptr && text_of(*label) == text) return label;
  return nullptr;
}

std::vector<const Stroke*> shafts(const Drawing& drawing) {
  std::vector<const Stroke*> strokes;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark);
        stroke != nullptr && stroke->role == Role::arrow && !stroke->hint.empty())
      strokes.push_back(stroke);
  return strokes;
}

Vector random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> part;
  return normalized(Vector{part(random), part(random), part(random)});
}

scene::Shape ellipsoid_shape(const Vector& semi_axes) {
  const Outline outline = outlines::ellipsoid({}, {semi_axes.x, 0, 0}, {0, semi_axes.y, 0}, {0, 0, semi_axes.z});
  return {.kind = "ellipsoid",
          .part = "",
          .vertices = outline.vertices,
          .triangles = outline.triangles,
          .normals = outline.normals};
}

scene::Scene rod_scene(const Vector& from, const Vector& to) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "rod", .mass = 1, .shapes = {pictures_test::wire_shape({from, to})}}};
  return scene;
}

TEST(ClearFigures, what_pushes_along_a_rod_stands_before_its_end) {
  std::mt19937_64 random(3);
  std::size_t looked_at = 0;
  for (int round = 0; round < 40; ++round) {
    const Vector end = random_direction(random);
    scene::Scene scene = rod_scene(-end, end);
    const double sense = round % 2 == 0 ? 1 : -1;
    scene.diagrams = {{.kind = scene::DiagramKind::model,
                       .title = "",
                       .bodies = {0},
                       .arrows = {arrow(scene::Quantity::force, 0, end, 0.9 * sense * end, "P")}}};
    const View view = view_from(random_direction(random), scene.up);
    if (norm(Projection(view, 1).direction_of(end)) < 0.3) continue;
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const std::vector<Point2> rod = points_of(drawing, Role::rod);
    for (const Stroke* shaft : shafts(drawing)) {
      const Point2 middle = 0.5 * (shaft->points.front() + shaft->points.back());
      EXPECT_GT(distance(middle, rod.front(), rod.back()), 10) << round;
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 20U);
}

TEST(ClearFigures, what_a_particle_brings_ends_where_it_hits) {
  std::mt19937_64 random(8);
  for (const bool known : {true, false})
    for (int round = 0; round < 10; ++round) {
      const Vector end = random_direction(random);
      scene::Scene scene = rod_scene({}, end);
      const Vector way = normalized(Vector(cross(end, random_direction(random))));
      scene.diagrams = {{.kind = scene::DiagramKind::model,
                         .title = "",
                         .bodies = {0},
                         .arrows = {arrow(scene::Quantity::linear_momentum, 0, end, way, "p")}}};
      scene.diagrams[0].arrows[0].known = known;
      const View view = view_from(cross(end, way), scene.up);
      const Drawing drawing = figure(scene, model, "", {.view = view});
      const std::vector<Point2> rod = points_of(drawing, Role::rod);
      const Point2 direction_on_paper = Projection(view, 1).direction_of(end);
      const Point2 place = dot(rod.front() - rod.back(), direction_on_paper) > 0 ? rod.front() : rod.back();
      for (const Stroke* shaft : shafts(drawing)) {
        const double from_tail = norm(shaft->points.front() - place), from_tip = norm(shaft->points.back() - place);
        EXPECT_EQ(from_tip < from_tail, known) << round;
      }
    }
}

TEST(ClearFigures, a_mass_center_without_name_has_the_one_of_its_momentum) {
  scene::Scene scene = rod_scene({}, {1, 0, 0});
  scene.bodies[0].center = {0.5, 0, 0};
  scene.diagrams = {{.kind = scene::DiagramKind::kinetic,
                     .title = "Kinetic diagram",
                     .group = 1,
                     .bodies = {0},
                     .arrows = {arrow(scene::Quantity::rate_of_angular_momentum, 0, {0.5, 0, 0}, {0, 5, 0}, "H")}}};
  scene.diagrams[0].arrows[0].symbol = "\\dot{\\mathbf{H}}_{G}";
  const FigureName cut{FigureKind::free_body, "free-body", "", scene::ground};
  EXPECT_NE(label_of(figure(scene, cut, "", {}), "G"), nullptr);
  scene.diagrams[0].arrows[0].symbol = "\\mathbf{H}'_{G}";
  EXPECT_NE(label_of(figure(scene, cut, "", {}), "G"), nullptr);
  scene.diagrams[0].arrows[0].symbol = "\\mathbf{H}'_{G_{\\mathrm{one}}}";
  EXPECT_NE(label_of(figure(scene, cut, "", {}), "Gone"), nullptr);  // the index in a run of its own
  scene.diagrams[0].arrows[0].symbol = "\\mathbf{H}'_{G}";
  // It has it in all diagrams of the equation.
  scene.diagrams.insert(scene.diagrams.begin(),
                        {.kind = scene::DiagramKind::free_body,
                         .title = "Free-body diagram",
                         .group = 1,
                         .bodies = {0},
                         .arrows = {arrow(scene::Quantity::weight, 0, {0.5, 0, 0}, {0, -5, 0}, "W")}});
  const Drawing both = figure(scene, cut, "", {});
  EXPECT_EQ(std::ranges::count_if(both.marks,
                                  [](const Mark& mark) {
                                    const auto* label = std::get_if<Label>(&mark);
                                    return label != nullptr && label->runs.size() == 1 && label->runs[0].text == "G";
                                  }),
            2);
  scene.points = {{"S", {0, {0.5, 0, 0}}}};
  EXPECT_EQ(label_of(figure(scene, cut, "", {}), "G"), nullptr);
}

TEST(ClearFigures, forces_that_are_open_are_told_below_what_is_cut_free) {
  scene::Scene scene = rod_scene({}, {1, 0, 0});
  scene.diagrams = {{.kind = scene::DiagramKind::free_body,
                     .title = "Free-body diagram",
                     .bodies = {0},
                     .arrows = {arrow(scene::Quantity::force, 0, {}, {0, 5, 0}, "T")}}};
  const FigureName cut{FigureKind::free_body, "free-body", "", scene::ground};
  const auto tells = [&](const FigureName& name) {
    const Drawing drawing = figure(scene, name, "", {.values = true});
    return std::ranges::any_of(drawing.marks, [](const Mark& mark) {
      const auto* label = std::get_if<Label>(&mark);
      return label != nullptr && !label->runs.empty() && label->runs[0].text.starts_with("Arrows with one stroke");
    });
  };
  const auto length = [&] { return pictures_test::length_of(figure(scene, cut, "", {}), Role::arrow); };
  EXPECT_FALSE(tells(cut));
  const double known = length();
  // Its vector tells the sense alone: the arrow is as long whatever the sizes of the others are.
  scene.diagrams[0].arrows.push_back(arrow(scene::Quantity::force, 0, {1, 0, 0}, {0, 1, 0}, "N"));
  scene.diagrams[0].arrows.back().open = true;
  EXPECT_TRUE(tells(cut));
  EXPECT_FALSE(tells(model));
  const double both = length();
  EXPECT_GT(both, known + 30);
  scene.diagrams[0].arrows[0].vector = {0, 5000, 0};
  EXPECT_NEAR(length(), both, 1e-6);
  scene.diagrams[0].arrows[0].vector = {0, 5e-4, 0};
  EXPECT_NEAR(length(), both, 1e-6);
}

TEST(ClearFigures, a_far_point_of_an_axis_is_not_drawn_beside_what_is_cut_free) {
  scene::Scene scene = rod_scene({}, {1, 0, 0});
  scene.points = {{"A", {0, {0.3, 0, 0}}}, {"Far", {0, {0, 8, 0}}}};
  scene.diagrams = {{.kind = scene::DiagramKind::free_body,
                     .title = "Free-body diagram",
                     .bodies = {0},
                     .arrows = {arrow(scene::Quantity::force, 0, {}, {0, 5, 0}, "T")}}};
  const FigureName cut{FigureKind::free_body, "free-body", "", scene::ground};
  const Drawing drawing = figure(scene, cut, "", {});
  EXPECT_NE(label_of(drawing, "A"), nullptr);
  EXPECT_EQ(label_of(drawing, "Far"), nullptr);
  // Where something acts there, it is.
  scene.diagrams[0].arrows.push_back(arrow(scene::Quantity::force, 0, {0, 8, 0}, {5, 0, 0}, "P"));
  EXPECT_NE(label_of(figure(scene, cut, "", {}), "Far"), nullptr);
}

TEST(ClearFigures, a_weight_over_a_floor_comes_from_above) {
  scene::Scene scene = rod_scene({}, {1, 0.2, 0});
  scene.symbols = {{.kind = scene::SymbolKind::contact, .name = "floor", .to = 0, .place = {0, {}}, .axis = {0, 1, 0}}};
  for (const double place : {0.02, 0.9}) {
    scene.diagrams = {{.kind = scene::DiagramKind::model,
                       .title = "",
                       .bodies = {0},
                       .arrows = {arrow(scene::Quantity::force, 0, {place, 0.2 * place, 0}, {0, -5, 0}, "P")}}};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, scene.up)});
    const double floor = points_of(drawing, Role::symbol).front().y;
    ASSERT_EQ(shafts(drawing).size(), 1U);
    if (place < 0.5) {
      EXPECT_LT(shafts(drawing)[0]->points.back().y, floor + 1);
    } else {
      EXPECT_GT(shafts(drawing)[0]->points.back().y, floor - 30);
    }
  }
}

TEST(ClearFigures, turning_arrows_do_not_stand_on_bearings) {
  std::mt19937_64 random(6);
  std::size_t looked_at = 0;
  for (int round = 0; round < 40; ++round) {
    const Vector axis = random_direction(random);
    scene::Scene scene = rod_scene({}, axis);
    scene.symbols = {{.kind = scene::SymbolKind::revolute, .name = "pin", .to = 0, .place = {0, {}}, .axis = axis}};
    scene.diagrams = {{.kind = scene::DiagramKind::model,
                       .title = "",
                       .bodies = {0},
                       .arrows = {arrow(scene::Quantity::angular_velocity, 0, {}, axis, "w")}}};
    const View view = view_from(random_direction(random), scene.up);
    if (norm(Projection(view, 1).direction_of(axis)) < 0.4) continue;
    const Drawing drawing = figure(scene, model, "", {.view = view});
    for (const Stroke* shaft : shafts(drawing))
      for (const Point2& p : points_of(drawing, Role::symbol)) {
        EXPECT_GT(distance(p, shaft->points.front(), shaft->points.back()), 1) << round;
        ++looked_at;
      }
  }
  EXPECT_GT(looked_at, 200U);
}

TEST(ClearFigures, a_length_beside_a_wide_body_is_told_outside_of_it) {
  for (const double radius : {0.2, 0.5, 0.8}) {
    scene::Scene scene = rod_scene({-1, 0, 0}, {1, 0, 0});
    scene::Body disk{.name = "disk", .mass = 1, .shapes = {pictures_test::cylinder_shape(radius, -0.02, 0.02)}};
    disk.pose.R = Matrix3<double>::from_columns({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
    scene.bodies.push_back(disk);
    scene.dimensions = {
        {.name = "L", .text = "L = 2 m", .from = {scene::ground, {-1, 0, 0}}, .to = {scene::ground, {1, 0, 0}}}};
    const Drawing drawing = figure(scene, model, "", {.view = view_from({0.4, 0.3, 1}, scene.up)});
    std::vector<Point2> rim = hull(points_of(drawing, Role::outline));
    std::size_t heads = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && stroke->role == Role::dimension && stroke->width > 0.65)
        for (std::size_t i = 0; i < rim.size(); ++i) {
          const Point2 a = stroke->points.front(), b = stroke->points.back(), c = rim[i], d = rim[(i + 1) % rim.size()];
          EXPECT_FALSE(cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0)
              << radius;
          ++heads;
        }
    EXPECT_GT(heads, 20U);
  }
}

TEST(ClearFigures, what_is_cut_free_leaves_behind_where_its_cord_was_held) {
  scene::Scene scene = rod_scene({}, {1, 0, 0});
  scene.points = {{"A", {0, {}}}, {"Far", {scene::ground, {0, 30, 0}}}};
  scene.links = {{.name = "cord", .from = {0, {}}, .to = {scene::ground, {0, 30, 0}}}};
  scene.diagrams = {{.kind = scene::DiagramKind::free_body,
                     .title = "Free-body diagram",
                     .bodies = {0},
                     .arrows = {arrow(scene::Quantity::force, 0, {}, {0, 5, 0}, "T")}}};
  const FigureName cut{FigureKind::free_body, "free-body", "", scene::ground};
  const Drawing drawing = figure(scene, cut, "", {});
  EXPECT_NE(label_of(drawing, "A"), nullptr);
  EXPECT_EQ(label_of(drawing, "Far"), nullptr);
  EXPECT_NE(label_of(figure(scene, model, "", {}), "Far"), nullptr);
}

TEST(ClearFigures, a_turning_alone_is_not_looked_at_along_its_axis) {
  for (std::size_t k = 0; k < 3; ++k) {
    scene::Scene scene;
    scene.bodies = {{.name = "football", .mass = 1}};
    const std::vector<scene::Arrow> arrows{arrow(scene::Quantity::angular_velocity, 0, {}, Vector::unit(k), "w")};
    const View view = chosen_view(scene, {0}, arrows, shown_poses(scene));
    EXPECT_GT(norm(Projection(view, 1).direction_of(Vector::unit(k))), 1.0 / 3);
  }
}

// A wheel on an upright shaft, and what moves on a screw; a wheel on a level shaft is looked at along it.
TEST(ClearFigures, upright_shafts_and_screws_are_seen_from_the_side) {
  for (const scene::SymbolKind kind : {scene::SymbolKind::revolute, scene::SymbolKind::screw})
    for (std::size_t k = 0; k < 3; ++k)
      for (const bool upright : {true, false}) {
        scene::Scene scene;
        scene.gravity = true;
        scene.up = Vector::unit(upright ? k : (k + 1) % 3);
        scene.length = 1;
        const Vector axis = Vector::unit(k);
        const Outline wheel = outlines::cylinder(-0.1 * axis, 0.1 * axis, 1);
        scene.bodies = {{.name = "wheel",
                         .mass = 1,
                         .shapes = {{.kind = "cylinder",
                                     .part = "",
                                     .vertices = wheel.vertices,
                                     .triangles = wheel.triangles,
                                     .normals = wheel.normals,
                                     .edges = wheel.edges}}}};
        scene.symbols = {{.kind = kind, .name = "shaft", .to = 0, .place = {0, {}}, .axis = axis}};
        const std::vector<scene::Arrow> arrows{arrow(scene::Quantity::couple, 0, {}, axis, "C")};
        const double seen = norm(Projection(chosen_view(scene, {0}, arrows, shown_poses(scene)), 1).direction_of(axis));
        if (upright || kind == scene::SymbolKind::screw)
          EXPECT_GT(seen, 1.0 / 3) << k;
        else
          EXPECT_LT(seen, 1e-6) << k;
      }
}

// Its rims lie behind each other.
TEST(ClearFigures, a_shell_that_is_seen_along_its_axis_is_one_round_line) {
  const Outline shell = outlines::cylinder_shell({0, 0, -0.5}, {0, 0, 0.5}, 1);
  scene::Scene scene;
  scene.bodies = {{.name = "bowl",
                   .mass = 1,
                   .shapes = {{.kind = "cylinder_shell",
                               .part = "",
                               .extent = scene::Extent::surface,
                               .vertices = shell.vertices,
                               .triangles = shell.triangles,
                               .normals = shell.normals,
                               .edges = shell.edges}}}};
  const Drawing drawing = figure(scene, model, "", {.view = view_from({0, 0, 1}, {0, 1, 0})});
  std::size_t outlines = 0;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->role == Role::outline) {
      EXPECT_TRUE(stroke->closed);
      ++outlines;
    }
  EXPECT_GE(outlines, 1U);
  EXPECT_LE(outlines, 2U);
}

TEST(ClearFigures, an_egg_is_seen_as_long_as_it_is) {
  std::mt19937_64 random(9);
  for (int round = 0; round < 30; ++round) {
    scene::Scene scene;
    scene.up = {0, 0, 1};
    scene.bodies = {{.name = "egg", .mass = 1, .shapes = {ellipsoid_shape({0.6, 0.6, 1})}}};
    const Vector axis = random_direction(random), side = normalized(Vector(cross(axis, random_direction(random))));
    scene.bodies[0].pose.R = Matrix3<double>::from_columns(side, cross(axis, side), axis);
    const View view = chosen_view(scene, {0}, {}, shown_poses(scene));
    EXPECT_GT(norm(Projection(view, 1).direction_of(axis)), 0.8) << round;
  }
}

TEST(ClearFigures, outlines_of_round_bodies_bend_everywhere_to_the_same_side) {
  std::mt19937_64 random(14);
  for (int round = 0; round < 20; ++round) {
    scene::Scene scene;
    scene.bodies = {{.name = "ball", .mass = 1, .shapes = {ellipsoid_shape({1, 1, 1})}}};
    const Drawing drawing = figure(scene, model, "", {.view = view_from(random_direction(random), scene.up)});
    std::size_t corners = 0;
    for (const Mark& mark : drawing.marks) {
      const auto* stroke = std::get_if<Stroke>(&mark);
      if (stroke == nullptr || stroke->role != Role::outline) continue;
      ASSERT_TRUE(stroke->closed) << round;
      const auto& p = stroke->points;
      double sense = 0;
      for (std::size_t i = 0; i < p.size(); ++i, ++corners) {
        const Point2 before = p[(i + 1) % p.size()] - p[i], after = p[(i + 2) % p.size()] - p[(i + 1) % p.size()];
        const double turn = std::atan2(cross(before, after), dot(before, after));
        sense = sense == 0 ? turn : sense;
        EXPECT_GT(turn * sense, 0) << round;
        EXPECT_LT(std::abs(turn), 0.35) << round;
      }
      // As round as is seen.
      Box box;
      for (const Point2& q : p) box.include(q);
      const double radius = (box.width() + box.height()) / 4;
      for (const Point2& q : p) EXPECT_NEAR(norm(q - box.center()), radius, 0.006 * radius) << round;
    }
    EXPECT_GT(corners, 12U);
  }
}

TEST(ClearFigures, the_front_of_the_ground_under_a_ball_is_seen_below_it) {
  for (const double rise : {0.0, 0.2, 0.36, 0.58, 0.87}) {
    scene::Scene scene;
    scene.up = {0, 0, 1};
    scene.bodies = {{.name = "ball", .mass = 1, .shapes = {ellipsoid_shape({1, 1, 1})}}};
    scene.symbols = {
        {.kind = scene::SymbolKind::contact, .name = "floor", .to = 0, .place = {0, {0, 0, -1}}, .axis = {0, 0, 1}}};
    const Drawing drawing =
        figure(scene, model, "", {.view = view_from({std::cos(rise), 0, std::sin(rise)}, scene.up)});
    Box ball;
    for (const Point2& p : points_of(drawing, Role::outline)) ball.include(p);
    double highest = 1e9;
    for (const Point2& p : points_of(drawing, Role::symbol)) highest = std::min(highest, p.y);
    EXPECT_GT(highest, ball.bottom - 1) << rise;
    EXPECT_LT(highest, ball.bottom + 0.2 * ball.height()) << rise;
  }
}

// A body that goes a long way along a direction without turning.
scene::Scene travelling(const Vector& way, double size) {
  scene::Scene scene;
  scene.up = {0, 0, 1};
  scene.bodies = {
      {.name = "cart", .mass = 1, .shapes = {pictures_test::box_shape({-size, -size, -size}, {size, size, size})}},
      {.name = "load", .mass = 1, .shapes = {pictures_test::box_shape({-size, -size, size}, {size, size, 2 * size})}}};
  scene.points = {{"A", {0, {size, size, size}}}};
  scene::Motion motion;
  scene::Curve path{scene::CurveKind::path, "cart", scene::ground, false, {}};
  for (int i = 0; i <= 20; ++i) {
    motion.times.push_back(i);
    const Vector at = i / 20.0 * way;
    motion.poses.push_back({{.p = at}, {.p = at}});
    path.points.push_back(at);
  }
  scene.motion = motion;
  scene.curves = {path};
  return scene;
}

TEST(ClearFigures, a_long_way_is_seen_at_its_length_and_small_bodies_have_no_names) {
  std::mt19937_64 random(21);
  for (int round = 0; round < 20; ++round) {
    const double angle = 2 * std::numbers::pi * round / 20;
    const Vector way = 7.0 * Vector{std::cos(angle), std::sin(angle), 0};
    const scene::Scene scene = travelling(way, 0.3);
    const View view = chosen_view_of_motion(scene, {0, 1}, scene.motion->poses.back());
    EXPECT_GT(norm(Projection(view, 1).direction_of(normalized(way))), 0.75) << round;
    const FigureName motion{FigureKind::motion, "motion", "", scene::ground};
    const Drawing drawing = figure(scene, motion, "", {});
    EXPECT_EQ(label_of(drawing, "A"), nullptr);
    EXPECT_EQ(label_of(drawing, "cart"), nullptr);
    EXPECT_NE(label_of(figure(travelling(0.15 * way, 0.3), motion, "", {}), "A"), nullptr);
  }
}

TEST(ClearFigures, a_motion_is_drawn_only_where_something_that_is_drawn_moves) {
  scene::Scene scene;
  scene.bodies = {{.name = "asteroid", .mass = 1}};
  scene.motion = scene::Motion{
      .times = {0, 1}, .poses = {{{}}, {{.R = Matrix3<double>::from_columns({0, 1, 0}, {-1, 0, 0}, {0, 0, 1})}}}};
  const auto has_motion = [&] {
    return std::ranges::any_of(figures_of(scene), [](const FigureName& f) { return f.kind == FigureKind::motion; });
  };
  EXPECT_FALSE(has_motion());
  scene.motion->poses[1][0].p = {0.5, 0, 0};
  EXPECT_TRUE(has_motion());
  scene.motion->poses[1][0].p = {};
  scene.bodies[0].shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})};
  EXPECT_TRUE(has_motion());
}

TEST(ClearFigures, a_herpolhode_is_drawn_with_its_plane_and_both_directions) {
  std::mt19937_64 random(17);
  for (int round = 0; round < 20; ++round) {
    const Vector H = random_direction(random), side = normalized(Vector(cross(H, random_direction(random))));
    const Vector other = cross(H, side), center = random_direction(random);
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {
        {.name = "box", .mass = 1, .center = center, .shapes = {pictures_test::box_shape({-1, -2, -3}, {1, 2, 3})}}};
    scene::Curve polhode{scene::CurveKind::polhode, "polhode", 0, true, {}};
    scene::Curve herpolhode{scene::CurveKind::herpolhode, "herpolhode", scene::ground, false, {}};
    for (int i = 0; i <= 200; ++i) {
      const double angle = 0.15 * i, radius = 0.2 + 0.05 * std::cos(3.7 * angle);
      const Vector aside = radius * (std::cos(angle) * side + std::sin(angle) * other);
      herpolhode.points.push_back(center + 0.8 * H + aside);
      polhode.points.push_back(center + 0.8 * H + aside);
    }
    scene.curves = {polhode, herpolhode};
    const Vector across_plane = direction_across(herpolhode, center);
    EXPECT_NEAR(norm(across_plane - H), 0, 1e-9);
    const auto names = figures_of(scene);
    const auto cones = std::ranges::find(names, FigureKind::cones, &FigureName::kind);
    ASSERT_NE(cones, names.end());
    const Drawing drawing = figure(scene, *cones, "", {});
    for (const char* name : {"polhode", "herpolhode", "invariable plane"})
      EXPECT_NE(label_of(drawing, name), nullptr) << name;
    std::vector<const Stroke*> arrows, curves;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr) {
        if (stroke->role == Role::arrow) arrows.push_back(stroke);
        if (stroke->role == Role::curve && stroke->ink == Ink::motion) curves.push_back(stroke);
      }
    ASSERT_EQ(arrows.size(), 2U);
    ASSERT_EQ(curves.size(), 2U);
    // The angular velocity ends where both curves begin; three turns are drawn, not five.
    for (const Stroke* curve : curves) EXPECT_LT(norm(arrows[1]->points.back() - curve->points.front()), 1e-9) << round;
    EXPECT_LT(curves[1]->points.size(), 130U);
    EXPECT_GT(curves[1]->points.size(), 120U);
  }
}

}  // namespace clear_figures_test
}  // namespace poinsot
