// Edges of boxes as they are drawn, against rays that are cast from many of their points towards the viewer.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "pictures/figure/figure.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"

namespace poinsot {
namespace hidden_edges_test {

using namespace pictures;
using pictures_test::length_of;

const FigureName model{FigureKind::model, "model", "The figure", scene::ground};

// Whether a ray from a point of a box's surface leaves through the box: it does if it enters the inside.
bool hidden_by_box(const Vector& from, const Vector& toward, const Vector& low, const Vector& high) {
  const Vector inside = from + 1e-6 * toward;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(inside[i] > low[i] && inside[i] < high[i])) return false;
  return true;
}

// Four corners of a square on the paper tell its scale: here the picture is as wide as its widest places.
double scale_of(const Drawing& drawing, const View& view, const std::array<Vector, 8>& corners) {
  Box drawn, true_size;
  for (const Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->role == Role::outline)
      for (const Point2& p : stroke->points) drawn.include(p);
  const Projection unscaled(view, 1);
  for (const Vector& corner : corners) true_size.include(unscaled(corner));
  return drawn.width() / true_size.width();
}

TEST(HiddenEdges, are_dashed_at_named_points_behind_a_box_and_left_out_elsewhere) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> size(0.3, 1.5), part(-1, 1);
  std::size_t behind = 0, before = 0;
  for (int round = 0; round < 60; ++round) {
    const Vector high{size(random), size(random), size(random)}, low = -high;
    scene::Scene scene;
    scene.up = {0, 0, 1};
    scene.length = 2 * norm(high);
    scene.bodies = {{.name = "box", .mass = 1, .shapes = {pictures_test::box_shape(low, high)}}};
    std::array<Vector, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
      corners[i] = {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z};
    const std::size_t named = random() % 8;
    scene.points = {{"A", {0, corners[named]}}};
    const View view = view_from({part(random), part(random), part(random)}, scene.up);
    const Projection unscaled(view, 1);
    double seen = 0, dashed = 0;
    bool named_hidden = true;
    constexpr int samples = 40;
    for (std::size_t i = 0; i < 8; ++i)
      for (const std::size_t bit : {1U, 2U, 4U}) {
        const std::size_t k = i | bit;
        if (k == i) continue;
        const double length = norm(unscaled(corners[k]) - unscaled(corners[i]));
        for (int s = 0; s < samples; ++s) {
          const Vector at = corners[i] + ((s + 0.5) / samples) * (corners[k] - corners[i]);
          const bool hidden = hidden_by_box(at, view.viewer, low, high);
          if (!hidden) seen += length / samples;
          if (hidden && (i == named || k == named)) dashed += length / samples;
          if (!hidden && (i == named || k == named)) named_hidden = false;
        }
      }
    const Drawing drawing = figure(scene, model, "", {.view = view});
    const double scale = scale_of(drawing, view, corners);
    EXPECT_NEAR(length_of(drawing, Role::outline), scale * seen, 0.02 * scale * seen) << round;
    // Axes of the ground pass through the box, too, and are drawn as fine lines inside.
    double edges = 0;
    for (const Mark& mark : drawing.marks)
      if (const auto* stroke = std::get_if<Stroke>(&mark);
          stroke != nullptr && stroke->role == Role::hidden && stroke->dash == Dash::hidden)
        for (std::size_t i = 0; i + 1 < stroke->points.size(); ++i)
          edges += norm(stroke->points[i + 1] - stroke->points[i]);
    EXPECT_NEAR(edges, named_hidden ? scale * dashed : 0, 0.02 * scale * (dashed + 0.1)) << round;
    ++(named_hidden ? behind : before);
  }
  EXPECT_GT(behind, 4U);
  EXPECT_GT(before, 20U);
}

TEST(HiddenEdges, of_a_body_that_another_hides_are_dashed_and_of_one_that_is_seen_are_not) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int round = 0; round < 10; ++round) {
    scene::Scene scene;
    scene.up = {0, 1, 0};
    scene.bodies = {{.name = "casing", .mass = 1, .shapes = {pictures_test::box_shape({-1, -1, -1}, {1, 1, 1})}},
                    {.name = "drum", .mass = 1, .shapes = {pictures_test::cylinder_shape(0.4, -0.3, 0.3)}}};
    const Vector viewer{2 + draw(random), 1.5 + 0.5 * draw(random), 3 + draw(random)};
    const auto dashed = [&] {
      double sum = 0;
      for (const Mark& mark : figure(scene, model, "", {.view = view_from(viewer, scene.up)}).marks)
        if (const auto* stroke = std::get_if<Stroke>(&mark); stroke != nullptr && stroke->dash == Dash::hidden)
          for (std::size_t i = 0; i + 1 < stroke->points.size() + (stroke->closed ? 1 : 0); ++i)
            sum += norm(stroke->points[(i + 1) % stroke->points.size()] - stroke->points[i]);
      return sum;
    };
    // All of the drum is within: both its rims are drawn, and its sides.
    EXPECT_GT(dashed(), 200) << round;
    scene.bodies[1].pose.p = {4, 0, 0};
    EXPECT_EQ(dashed(), 0) << round;
  }
}

}  // namespace hidden_edges_test
}  // namespace poinsot
