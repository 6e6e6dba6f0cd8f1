#include "problem/language/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <type_traits>

namespace poinsot::problem {
namespace diagnostic_test {

TEST(Diagnostic, TextHasFilePlaceMessageAndHint) {
  EXPECT_STREQ(StatementError("a.yaml", {3, 7}, "no unit", "write 5 kg").what(),
               "a.yaml:3:7: error: no unit (write 5 kg)");
  EXPECT_STREQ(StatementError("a.yaml", {3, 7}, "no unit").what(), "a.yaml:3:7: error: no unit");
}

TEST(Diagnostic, WithoutPlaceTheLineIsLeftOut) {
  EXPECT_STREQ(StatementError("--set m", {}, "no unit").what(), "--set m: error: no unit");
}

TEST(Diagnostic, SeveralComeOnePerLine) {
  const StatementError error({{"a", {1, 2}, "first", ""}, {"a", {3, 4}, "second", "repair"}});
  EXPECT_STREQ(error.what(), "a:1:2: error: first\na:3:4: error: second (repair)");
  EXPECT_EQ(error.diagnostics().size(), 2U);
  EXPECT_THROW(StatementError(std::vector<Diagnostic>{}), std::invalid_argument);
}

TEST(Diagnostic, ADomainErrorIsAStatementError) {
  static_assert(std::is_base_of_v<StatementError, DomainError>);
  EXPECT_STREQ(DomainError("f", Mark{1, 1}, "division by zero").what(), "f:1:1: error: division by zero");
}

TEST(EditDistance, CountsSlips) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("weight", "weight"), 0);
  EXPECT_EQ(edit_distance("wieght", "weight"), 1) << "an exchange of neighbours is one slip";
  EXPECT_EQ(edit_distance("weigt", "weight"), 1);
  EXPECT_EQ(edit_distance("weighht", "weight"), 1);
  EXPECT_EQ(edit_distance("waight", "weight"), 1);
  EXPECT_EQ(edit_distance("Weight", "weight"), 0.5) << "a letter in the other case is half a slip";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetricAndBoundedByTheLongerWord) {
  std::mt19937_64 random(1);
  const auto word = [&] {
    std::string text(random() % 9, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 3);
    return text;
  };
  for (int i = 0; i < 1000; ++i) {
    const std::string a = word(), b = word();
    EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
    EXPECT_LE(edit_distance(a, b), static_cast<double>(std::max(a.size(), b.size())));
    EXPECT_EQ(edit_distance(a, b) == 0, a == b);
  }
}

TEST(Nearest, FindsTheNearestName) {
  const std::vector<std::string> names{"weight", "height", "mass", "center", "x"};
  EXPECT_EQ(nearest("wieght", names), "weight");
  EXPECT_EQ(nearest("centre", names), "center");
  EXPECT_EQ(nearest("MASS", names), "mass");
  EXPECT_EQ(nearest("X", names), "x");
  EXPECT_EQ(did_you_mean("mas", names), "did you mean 'mass'?");
}

TEST(Nearest, IsSilentWhenNothingIsNear) {
  const std::vector<std::string> names{"weight", "mass", "x"};
  EXPECT_EQ(nearest("density", names), "");
  EXPECT_EQ(nearest("y", names), "");
  EXPECT_EQ(nearest("", names), "");
  EXPECT_EQ(nearest("mass", {"mass"}), "") << "a word is no suggestion for itself";
  EXPECT_EQ(nearest(std::string(100'000, 'a'), names), "");
  EXPECT_EQ(did_you_mean("density", names), "");
}

}  // namespace diagnostic_test
}  // namespace poinsot::problem
