// Every figure of every example: no label over another, over an arrow or over an outline; nothing beside the paper.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "example_files.h"
#include "pictures/figure/figure.h"
#include "poinsot/problem.h"

namespace poinsot {
namespace all_figures_test {

using namespace pictures;

bool is_line(Role role) {
  return role == Role::outline || role == Role::arrow || role == Role::arrowhead || role == Role::rod ||
         role == Role::symbol || role == Role::axis;
}

std::string text_of(const Label& label) {
  std::string text;
  for (const pictures::Run& run : label.runs) text += run.text;
  return text;
}

// What is wrong with the places of a drawing's labels.
std::vector<std::string> faults(const Drawing& drawing) {
  std::vector<std::string> found;
  std::vector<const Label*> labels;
  for (const Mark& mark : drawing.marks)
    if (const auto* label = std::get_if<Label>(&mark)) labels.push_back(label);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (labels[i]->placed().overlaps(labels[k]->placed()))
        found.push_back(fmt::format("'{}' over '{}'", text_of(*labels[i]), text_of(*labels[k])));
  const auto check_line = [&](const std::vector<Point2>& points, bool closed, const char* what) {
    for (std::size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i)
      for (const Label* label : labels)
        if (meets(label->placed(), points[i], points[(i + 1) % points.size()]))
          found.push_back(fmt::format("'{}' over {}", text_of(*label), what));
  };
  for (const Mark& mark : drawing.marks) {
    if (const auto* stroke = std::get_if<Stroke>(&mark)) {
      if (is_line(stroke->role)) check_line(stroke->points, stroke->closed, "a line");
    } else if (const auto* fill = std::get_if<Fill>(&mark)) {
      if (fill->role == Role::arrowhead)
        for (const auto& loop : fill->loops) check_line(loop, true, "an arrowhead");
    }
  }
  const Box all = extent(drawing.marks);
  if (!(std::isfinite(all.left) && std::isfinite(all.top) && std::isfinite(all.right) && std::isfinite(all.bottom)))
    found.emplace_back("a place that is not finite");
  const Box& paper = drawing.paper;
  if (all.left < paper.left || all.top < paper.top || all.right > paper.right || all.bottom > paper.bottom)
    found.emplace_back("a mark beside the paper");
  return found;
}

struct Counts {
  int figures = 0, labels = 0;
  std::vector<std::pair<double, std::string>> milliseconds{};  // of the processor, for each figure
};

void check_scene(const scene::Scene& scene, const std::string& where, Counts& counts) {
  for (const FigureName& name : figures_of(scene))
    for (const bool values : {false, true}) {
      const std::clock_t begin = std::clock();
      const Drawing drawing = figure(scene, name, where, {.values = values});
      counts.milliseconds.emplace_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC,
                                       where + " " + name.name);
      EXPECT_EQ(faults(drawing), std::vector<std::string>{})
          << where << " " << scene.situation << ", " << name.name << (values ? " with values" : "");
      ++counts.figures;
      for (const Mark& mark : drawing.marks) counts.labels += std::holds_alternative<Label>(mark) ? 1 : 0;
    }
}

// Those that take longer to solve than a test may are left out, and counted.
void check_folder(const char* folder, int least_figures) {
  Counts counts;
  std::size_t left_out = 0;
  for (const std::filesystem::path& file : testing::example_files(folder)) {
    constexpr std::chrono::milliseconds most(15000);
    const Document document = Problem::from_file(file.string()).illustrate({}, Budget().end_after(most));
    left_out += document.ended ? 1 : 0;
    if (document.solutions.empty() || !document.solutions.front().scene) continue;
    const Solution& solution = document.solutions.front();
    check_scene(*solution.scene, file.filename().string(), counts);
    for (const auto& other : solution.other_scenes) check_scene(*other, file.filename().string(), counts);
  }
  EXPECT_GT(counts.figures, least_figures);
  EXPECT_GT(counts.labels, 3 * counts.figures);
  EXPECT_LE(left_out, 4U);
  std::ranges::sort(counts.milliseconds);
  const auto part = [&](double of_all) {
    const double last = static_cast<double>(counts.milliseconds.size() - 1);
    return counts.milliseconds[static_cast<std::size_t>(of_all * last)].first;
  };
  ::testing::Test::RecordProperty("median_ms", fmt::format("{:.1f}", part(0.5)));
  ::testing::Test::RecordProperty("longest_ms", fmt::format("{:.1f}", part(1)));
  fmt::print("a figure takes {:.1f} ms, nine of ten less than {:.1f} ms, the longest {:.1f} ms ({})\n", part(0.5),
             part(0.9), part(1), counts.milliseconds.back().second);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(part(0.99), 50);
#endif
}

TEST(AllFigures, of_the_textbook_have_labels_in_free_places) { check_folder("textbook", testing::at_least(300)); }
TEST(AllFigures, of_published_results_have_labels_in_free_places) { check_folder("published", testing::at_least(80)); }
TEST(AllFigures, of_mechanisms_have_labels_in_free_places) { check_folder("mechanisms", testing::at_least(20)); }

TEST(AllFigures, a_label_over_another_is_noticed) {
  Drawing drawing;
  drawing.paper = {-20, -20, 20, 20};
  drawing.marks = {Label{.runs = {}, .box = {0, 0, 10, 10}}, Label{.runs = {}, .at = {5, 5}, .box = {0, 0, 10, 10}}};
  EXPECT_EQ(faults(drawing).size(), 1U);
  drawing.marks = {Label{.runs = {}, .box = {0, 0, 10, 10}}, Stroke{.points = {{-5, 5}, {15, 5}}, .role = Role::arrow}};
  EXPECT_EQ(faults(drawing).size(), 1U);
  drawing.marks = {Label{.runs = {}, .box = {15, 0, 25, 10}}};
  EXPECT_EQ(faults(drawing).size(), 1U);
}

}  // namespace all_figures_test
}  // namespace poinsot
