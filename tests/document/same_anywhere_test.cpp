// The same file gives the same bytes: whatever the clock says, in any locale, in any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>
#include <thread>
#include <vector>

#include "poinsot/engine/work/budget.h"
#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace same_anywhere_test {

namespace fs = std::filesystem;

// A few problems of every kind: formulas, unknowns, claims, motions.
const std::vector<std::string>& problems() {
  static const std::vector<std::string> paths = [] {
    std::vector<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(POINSOT_SOURCE_DIR) / "examples/textbook"))
      if (entry.path().extension() == ".yaml") all.push_back(entry.path().string());
    std::ranges::sort(all);
    std::vector<std::string> some;
    for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(all.size() / 12, 1)) some.push_back(all[i]);
    return some;
  }();
  return paths;
}

std::vector<std::string> documents() {
  std::vector<std::string> texts;
  for (const std::string& path : problems()) texts.push_back(to_json(Problem::from_file(path).solve()));
  return texts;
}

const std::vector<std::string>& plain_documents() {
  static const std::vector<std::string> texts = documents();
  return texts;
}

TEST(SameAnywhere, the_clock_does_not_matter) {
  ASSERT_GT(problems().size(), 5U);
  for (const double pace : {1e-3, 1e3}) {
    const auto clock = [pace, begin = Budget::Clock::now()] {
      const std::chrono::duration<double> passed = Budget::Clock::now() - begin;
      return Budget::Clock::time_point{} + std::chrono::duration_cast<Budget::Clock::duration>(pace * passed);
    };
    const BudgetScope scope(Budget().by_clock(clock).end_after(std::chrono::hours(1000)));
    EXPECT_EQ(documents(), plain_documents());
  }
}

struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(SameAnywhere, the_locale_of_streams_does_not_matter) {
  const std::vector<std::string>& plain = plain_documents();
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const std::vector<std::string> there = documents();
  std::locale::global(before);
  EXPECT_EQ(there, plain);
}

// Sets a locale of the C library in which the decimal sign is a comma: an installed one, or one that is made here of
// the sources that most systems have. Returns "" if there is neither.
std::string set_locale_with_commas() {
  const std::vector<std::string> names{"de_DE.UTF-8", "de_DE.utf8",  "fr_FR.UTF-8",
                                       "fr_FR.utf8",  "nl_NL.UTF-8", "de_DE"};
  const auto set_one = [&]() -> std::string {
    for (const std::string& name : names)
      if (std::setlocale(LC_ALL, name.c_str()) != nullptr && std::string(std::localeconv()->decimal_point) == ",")
        return name;
    return "";
  };
  if (const std::string installed = set_one(); !installed.empty()) return installed;
  const fs::path folder = fs::path(::testing::TempDir()) / "poinsot_locales";
  fs::create_directories(folder);
  const std::string make = "localedef -i de_DE -f UTF-8 '" + (folder / "de_DE.UTF-8").string() + "' 2>/dev/null";
  if (std::system(make.c_str()) != 0 || setenv("LOCPATH", folder.c_str(), 1) != 0) return "";
  return set_one();
}

TEST(SameAnywhere, the_locale_of_the_c_library_does_not_matter) {
  const std::vector<std::string>& plain = plain_documents();
  const Document one = Problem::from_file(problems().front()).explain();
  const std::string worked = to_markdown(one), shown = to_terminal(one);
  const std::string name = set_locale_with_commas();
  if (name.empty()) GTEST_SKIP() << "no locale with a decimal comma is installed, and localedef cannot make one";
  char text[20];
  std::snprintf(text, sizeof text, "%.1f", 0.5);
  const std::vector<std::string> there = documents();
  const Document again = Problem::from_file(problems().front()).explain();
  const std::string worked_there = to_markdown(again), shown_there = to_terminal(again);
  std::setlocale(LC_ALL, "C");
  EXPECT_STREQ(text, "0,5") << name;
  EXPECT_EQ(there, plain);
  EXPECT_EQ(worked_there, worked);
  EXPECT_EQ(shown_there, shown);
}

TEST(SameAnywhere, threads_do_not_matter) {
  const std::vector<std::string>& plain = plain_documents();
  std::vector<std::vector<std::string>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<std::string>& texts : found) threads.emplace_back([&texts] { texts = documents(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<std::string>& texts : found) EXPECT_EQ(texts, plain);
}

// What was solved before in this process leaves nothing behind.
TEST(SameAnywhere, what_was_solved_before_does_not_matter) { EXPECT_EQ(documents(), plain_documents()); }

}  // namespace same_anywhere_test
}  // namespace poinsot
