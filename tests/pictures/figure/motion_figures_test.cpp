// Poses of a motion on each other or beside each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pictures/figure/figure.h"
#include "pictures/figure/layout.h"
#include "pictures/figure/scenes.h"
#include "pictures/figure/strokes.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {
namespace motion_figures_test {

using namespace pictures;

const FigureName motion{FigureKind::motion, "motion", "The motion", scene::ground};

// A box that turns by an angle and goes along x in each of some steps.
scene::Scene moving(double turn, double step, bool traced) {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.bodies = {{.name = "box", .mass = 1, .shapes = {pictures_test::box_shape({-1, -0.5, -0.2}, {1, 0.5, 0.2})}}};
  scene.motion.emplace();
  scene::Curve path{scene::CurveKind::path, "A", scene::ground, false, {}};
  for (int i = 0; i <= 12; ++i) {
    scene.motion->times.push_back(i);
    scene.motion->poses.push_back({{.R = rotation_about(Vector{0, 0, 1}, turn * i), .p = {step * i, 0, 0}}});
    path.points.push_back(scene.motion->poses.back()[0].R * Vector{1, 0, 0} + scene.motion->poses.back()[0].p);
  }
  if (traced) scene.curves = {path};
  return scene;
}

std::size_t captions_of_times(const Drawing& drawing) {
  std::size_t count = 0;
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark))
      for (const pictures::Run& run : label->runs) count += run.text.starts_with("t\u00a0=") ? 1 : 0;
  return count;
}

// The boxes of what is drawn of bodies at full strength, apart from each other along x or y.
std::vector<Box> bodies_on_paper(const Drawing& drawing) {
  std::vector<Box> found;
  for (const Mark& mark : drawing.marks) {
    const auto* fill = std::get_if<Fill>(&mark);
    if (fill == nullptr || !fill->bordered || fill->opacity < 1) continue;
    Box box;
    for (const auto& loop : fill->loops)
      for (const Point2& p : loop) box.include(p);
    if (!found.empty() && found.back().grown(1).overlaps(box))
      found.back().include(box);
    else
      found.push_back(box);
  }
  return found;
}

TEST(MotionFigures, poses_that_would_lie_on_each_other_or_far_apart_stand_beside_each_other) {
  for (const double step : {0.0, 40.0}) {
    const Drawing drawing =
        figure(moving(0.5, step, step > 0), motion, "", {.view = view_from({0.2, 0.3, 1}, {0, 1, 0})});
    EXPECT_EQ(captions_of_times(drawing), 4U) << step;
    const std::vector<Box> bodies = bodies_on_paper(drawing);
    ASSERT_EQ(bodies.size(), 4U) << step;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      EXPECT_GT(std::max(bodies[i].width(), bodies[i].height()), 100) << step;
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(bodies[i].overlaps(bodies[k])) << step;
    }
  }
}

TEST(MotionFigures, poses_on_a_path_stay_on_it) {
  for (const double step : {0.0, 1.0}) {
    const Drawing drawing = figure(moving(0.2, step, true), motion, "", {.view = view_from({0.2, 0.3, 1}, {0, 1, 0})});
    EXPECT_EQ(captions_of_times(drawing), 0U) << step;
    EXPECT_FALSE(pictures_test::points_of(drawing, Role::curve).empty()) << step;
    // A circle marks where the path begins.
    const Point2 begin = pictures_test::points_of(drawing, Role::curve).front();
    EXPECT_TRUE(std::ranges::any_of(drawing.marks, [&](const Mark& mark) {
      const auto* stroke = std::get_if<Stroke>(&mark);
      if (stroke == nullptr || !stroke->closed || stroke->ink != Ink::motion) return false;
      return std::ranges::all_of(stroke->points, [&](const Point2& p) { return std::abs(norm(p - begin) - 3) < 1e-9; });
    })) << step;
  }
}

TEST(MotionFigures, what_stays_is_drawn_once) {
  scene::Scene scene = moving(0.2, 1, true);
  const auto paler = [](const Drawing& drawing) {
    return std::ranges::count_if(drawing.marks, [](const Mark& mark) {
      const auto* fill = std::get_if<Fill>(&mark);
      return fill != nullptr && fill->bordered && fill->opacity < 1;
    });
  };
  const Looks looks{.view = view_from({0.2, 0.3, 1}, {0, 1, 0})};
  const auto alone = paler(figure(scene, motion, "", looks));
  EXPECT_GT(alone, 0);
  scene.bodies.push_back(
      {.name = "wall", .mass = 1, .shapes = {pictures_test::box_shape({-1, -9, -0.2}, {1, -8, 0.2})}});
  for (std::vector<scene::Pose>& poses : scene.motion->poses) poses.emplace_back();
  const Drawing both = figure(scene, motion, "", looks);
  EXPECT_EQ(paler(both), alone);
  EXPECT_EQ(bodies_on_paper(both).size(), 2U);
}

TEST(MotionFigures, no_word_of_a_caption_stands_alone_below_the_others) {
  const std::string words = "From t = 0 to 0.3341 s, 6 poses; paths begin at small circles";
  for (double width = 120; width < 260; width += 7) {
    Drawing drawing;
    drawing.paper = {0, 0, width, 50};
    caption(drawing, words, width);
    double least = 1e300, most = 0;
    std::size_t letters = 0;
    for (const Mark& mark : drawing.marks) {
      const Label& label = std::get<Label>(mark);
      least = std::min(least, label.box.width());
      most = std::max(most, label.box.width());
      for (const pictures::Run& run : label.runs) letters += run.text.size();
    }
    EXPECT_LE(most, width + 1e-9);
    EXPECT_GT(least, 0.6 * most) << width;
    // All of the words, but for the blanks at the ends of lines.
    EXPECT_EQ(letters + drawing.marks.size() - 1, words.size());
  }
}

}  // namespace motion_figures_test
}  // namespace poinsot
