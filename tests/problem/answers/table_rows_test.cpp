// Rows of tables over a datum, each a problem of its own.
#include <gtest/gtest.h>

#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace table_rows_test {

SolvedAsk asked(const std::string& rows) {
  return solve_statement(read_statement("given: {L: 0.5 m, w: 5 rad/s}\n"
                                        "points: {O: [0, 0, 0], P: [0, -L, 0]}\n"
                                        "bodies: {bob: {particle: P, mass: 1 kg}}\n"
                                        "joints: {pin: {revolute: z, at: O, to: bob, angle: q}}\n"
                                        "gravity: -y\n"
                                        "instants: {start: {q: 0, q': w}, top: {first_time: q == 180 deg}}\n"
                                        "ask: {t: {table: {t: time @ top}, over: {w: " +
                                            rows + "}}}\n",
                                        "rows.yaml"),
                         {})
      .solutions.at(0)
      .asks.at(0);
}

// At 5 rad/s, which the datum has, the pendulum does not come to the top.
TEST(TableRows, what_happens_in_the_rows_need_not_happen_at_the_value_of_the_datum) {
  const SolvedAsk both = asked("[9 rad/s, 10 rad/s]");
  ASSERT_EQ(both.state, AskState::found) << both.reason;
  ASSERT_EQ(both.columns.size(), 1U);
  EXPECT_NEAR(both.columns[0].values.at(0), 0.696225, 1e-6);
  EXPECT_NEAR(both.columns[0].values.at(1), 0.444686, 1e-6);
}

TEST(TableRows, a_row_without_answer_is_named) {
  const SolvedAsk low = asked("[9 rad/s, 6 rad/s, 10 rad/s]");
  EXPECT_EQ(low.state, AskState::undetermined);
  EXPECT_EQ(low.reason.rfind("in the row w = 6 rad/s: 'q == 180 deg' does not happen", 0), 0U) << low.reason;
}

}  // namespace table_rows_test
}  // namespace poinsot::problem
