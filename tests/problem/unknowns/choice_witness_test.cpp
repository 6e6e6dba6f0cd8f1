// The second road to what is chosen confirms right choices and refuses wrong ones.
#include "problem/unknowns/choice_witness.h"

#include <gtest/gtest.h>

namespace poinsot::problem {
namespace choice_witness_test {

// x + z = 2 and y + z = 3. Of two amounts x and y do, and y and z; x and z do not, as x would be negative. The total,
// 5 - z, is least where z is 2.
std::optional<std::vector<double>> left(const std::vector<double>& x) {
  return std::vector{x[0] + x[2] - 2, x[1] + x[2] - 3};
}
using Numbers = std::vector<double>;
const Numbers first{2, 3, 0}, second{0, 1, 2};

std::optional<std::string> doubt(const std::vector<Numbers>& solutions, std::optional<int> exactly) {
  return choice_doubt(left, 3, {{0}, {1}, {2}}, {solutions, exactly});
}

TEST(ChoiceWitness, confirms_what_is_right) {
  EXPECT_FALSE(doubt({first, second}, 2));
  EXPECT_FALSE(doubt({second, first}, 2));
  EXPECT_FALSE(doubt({second}, std::nullopt));
}

TEST(ChoiceWitness, sees_a_choice_that_was_missed) {
  for (const Numbers& alone : {first, second}) {
    const auto told = doubt({alone}, 2);
    ASSERT_TRUE(told);
    EXPECT_EQ(*told, "another choice fulfils all conditions as well, as a linear program tells");
  }
}

TEST(ChoiceWitness, sees_amounts_that_are_wrong) {
  for (const double off : {1e-3, -0.2})
    for (std::size_t k = 0; k < 2; ++k) {
      Numbers wrong = first;
      wrong[k] += off;
      EXPECT_TRUE(doubt({wrong, second}, 2)) << off << " of " << k;
    }
}

TEST(ChoiceWitness, sees_a_total_that_is_not_the_least) {
  for (const Numbers& wrong : {first, Numbers{1, 2, 1}, Numbers{0.01, 1.01, 1.99}}) {
    const auto told = doubt({wrong}, std::nullopt);
    ASSERT_TRUE(told) << wrong[0];
    EXPECT_EQ(*told, "another choice has a smaller total, as a linear program tells");
  }
}

// An amount may have several unknowns, as the components of a push.
TEST(ChoiceWitness, sees_what_was_missed_of_amounts_in_several_parts) {
  const std::vector<std::vector<std::size_t>> amounts{{0, 2}, {1}};
  EXPECT_FALSE(choice_doubt(left, 3, amounts, {{first, second}, 2}));
  const auto one_left = [](const Numbers& x) -> std::optional<Numbers> { return Numbers{x[0] - 2, x[1] + x[2] - 3}; };
  EXPECT_FALSE(choice_doubt(one_left, 3, amounts, {{{2, 0, 3}}, 1}));
  EXPECT_TRUE(choice_doubt(one_left, 3, amounts, {{{2, 0, 2.9}}, 1}));
}

TEST(ChoiceWitness, says_nothing_of_conditions_that_are_not_linear) {
  const auto square = [](const Numbers& x) -> std::optional<Numbers> { return Numbers{x[0] * x[0] - 4, x[1] - 1}; };
  EXPECT_FALSE(choice_doubt(square, 2, {{0}, {1}}, {{{1, 1}}, 2}));
  EXPECT_FALSE(choice_doubt([](const Numbers&) { return std::optional<Numbers>(); }, 2, {{0}, {1}}, {{{1, 1}}, 2}));
}

}  // namespace choice_witness_test
}  // namespace poinsot::problem
