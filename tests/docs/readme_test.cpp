// What the README shows is what happens: the transcript of its problem, and its lines of C++.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "docs/fenced_blocks.h"
#include "poinsot/engine/dynamics/forward_dynamics.h"
#include "poinsot/engine/mass/shapes.h"
#include "poinsot/engine/model/builder.h"
#include "poinsot/pictures.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace readme_test {

std::vector<std::string> blocks_of(const std::string& kind) {
  std::vector<std::string> texts;
  for (const FencedBlock& block : fenced_blocks("README.md"))
    if (block.kind == kind) texts.push_back(block.text);
  return texts;
}

// Residuals are rounding, which differs from build to build.
std::string without_residuals(const std::string& text) {
  return std::regex_replace(
      text, std::regex("(energy|impulse|momentum|Newton-Euler|quantities|facts hold to|numbers to) [0-9]+(e-[0-9]+)?"),
      "$1 ...");
}

TEST(Readme, ShowsWhatTheProgramPrints) {
  const std::vector<std::string> problems = blocks_of("yaml"), transcripts = blocks_of("console");
  ASSERT_EQ(problems.size(), 2u);
  ASSERT_EQ(transcripts.size(), problems.size());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const std::filesystem::path file =
        std::filesystem::path(::testing::TempDir()) / ("poinsot-readme-" + std::to_string(getpid()) + ".yaml");
    std::ofstream(file) << problems[i];
    Document document = Problem::from_file(file.string()).solve();
    std::filesystem::remove(file);
    const std::string call = "$ poinsot solve ";
    ASSERT_TRUE(transcripts[i].starts_with(call));
    document.file = transcripts[i].substr(call.size(), transcripts[i].find('\n') - call.size());
    EXPECT_EQ(without_residuals(call + document.file + "\n" + to_terminal(document)),
              without_residuals(transcripts[i]));
  }
}

// The figures are those that the program draws of the first problem.
TEST(Readme, ShowsWhatTheProgramDraws) {
  const Document document = Problem::from_text(blocks_of("yaml").at(0), "askew.yaml").illustrate();
  EXPECT_EQ(to_svg(document, 0), text_of_page("docs/figures/askew.svg"));
  EXPECT_EQ(to_svg(document, 0, {.of = "free-body", .values = true}), text_of_page("docs/figures/askew-free-body.svg"));
}

// The lines of this file between two marks, without their indentation.
std::string own_lines(const std::string& subject) {
  const std::string source = text_of_page("tests/docs/readme_test.cpp");
  const std::string begin = "  // The README's lines of " + subject + ".\n";
  const std::size_t from = source.find(begin) + begin.size();
  std::istringstream lines(source.substr(from, source.find("  // Until here.\n", from) - from));
  std::string own;
  for (std::string line; std::getline(lines, line);) own += line.substr(2) + "\n";
  return own;
}

TEST(Readme, HasLinesOfCppThatDoWhatTheySay) {
  const std::string text = blocks_of("yaml").at(0);
  ::testing::internal::CaptureStdout();
  // The README's lines of problems.
  const Problem problem = Problem::from_text(text, "askew.yaml");
  const Document document = problem.solve({{"n", "3000 rpm"}}, Budget().end_after(std::chrono::seconds(10)));
  std::cout << to_terminal(document);
  for (const Answer& answer : document.solutions.at(0).answers)
    std::cout << answer.name << " in " << answer.unit << "\n";
  // Until here.
  std::cout.flush();
  const std::string shown = ::testing::internal::GetCapturedStdout();
  EXPECT_TRUE(shown.starts_with("Disk mounted askew on a shaft  (askew.yaml)\n")) << shown;
  EXPECT_TRUE(shown.ends_with("\nH in kg*m^2/s\nT in J\nA in N\nB in N\n")) << shown;
  // Reactions grow with the square of the rate, from those that the README shows at 1200 rpm.
  EXPECT_NE(shown.find("(0, -2854.83, 0) N"), std::string::npos) << shown;

  const std::vector<double> force{0};
  std::vector<double> acceleration{0};
  // The README's lines of the engine.
  ModelBuilder<double> builder;
  builder.add_body("bar", ground, Joint<double>::revolute({0, 0, 1}), SpatialTransform<double>::identity(),
                   of_mass(shapes::rod<double>({0, 0, 0}, {1, 0, 0}), 2.0));
  builder.set_gravity({0, -9.81, 0});
  const Model<double> model = builder.build();
  Workspace<double> workspace(model);
  forward_dynamics<double>(model, workspace, neutral_state(model), force, acceleration);
  // Until here.
  EXPECT_NEAR(acceleration[0], -1.5 * 9.81, 1e-12);

  EXPECT_EQ(blocks_of("cpp"), (std::vector<std::string>{own_lines("problems"), own_lines("the engine")}));
}

TEST(Readme, LinksToPagesThatExist) {
  for (const char* page : {"README.md", "docs/language.md", "docs/theory.md", "docs/architecture.md",
                           "docs/decisions.md", "docs/glossary.md"}) {
    const std::string text = text_of_page(page);
    const std::filesystem::path folder = (std::filesystem::path(POINSOT_SOURCE_DIR) / page).parent_path();
    const std::regex link("\\]\\(([^)#]+)\\)");
    for (std::sregex_iterator it(text.begin(), text.end(), link), none; it != none; ++it)
      EXPECT_TRUE(std::filesystem::exists(folder / (*it)[1].str())) << page << " links to " << (*it)[1];
  }
}

// Sources named in the manual, such as `engine/dynamics/momentum.h` or `answers/fact_check.cpp`, exist.
TEST(Pages, NameFilesThatExist) {
  const std::filesystem::path root(POINSOT_SOURCE_DIR);
  const std::regex name("`((?:[a-z_]+/)+[a-z_0-9]+\\.(?:h|cpp|py|sh|md|cmake|yaml))`");
  int count = 0;
  for (const char* page : {"README.md", "docs/theory.md", "docs/architecture.md", "docs/decisions.md"}) {
    const std::string text = text_of_page(page);
    for (std::sregex_iterator it(text.begin(), text.end(), name), none; it != none; ++it, ++count) {
      const std::string file = (*it)[1];
      const auto exists_in = [&](const char* folder) { return std::filesystem::exists(root / folder / file); };
      EXPECT_TRUE(exists_in("") || exists_in("include") || exists_in("include/poinsot") || exists_in("src") ||
                  exists_in("src/problem"))
          << page << " names " << file;
    }
  }
  EXPECT_GT(count, 30);
}

}  // namespace readme_test
}  // namespace poinsot
