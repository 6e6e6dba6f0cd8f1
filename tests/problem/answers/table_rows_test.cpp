// Rows of tables over a datum, each a problem of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace table_rows_test {

Solution solution(const std::string& rows) {
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
      .solutions.at(0);
}
SolvedAsk asked(const std::string& rows) { return solution(rows).asks.at(0); }

// At 5 rad/s, which the datum has, the pendulum does not come to the top.
TEST(TableRows, what_happens_in_the_rows_need_not_happen_at_the_value_of_the_datum) {
  const SolvedAsk both = asked("[9 rad/s, 10 rad/s]");
  ASSERT_EQ(both.state, AskState::found) << both.reason;
  ASSERT_EQ(both.columns.size(), 1U);
  EXPECT_NEAR(both.columns[0].values.at(0), 0.696225, 1e-6);
  EXPECT_NEAR(both.columns[0].values.at(1), 0.444686, 1e-6);
}

// At 6 rad/s it does not come to the top, and at 9 and 10 rad/s it does.
TEST(TableRows, a_row_without_answer_is_left_out_and_told) {
  const Solution solved = solution("[9 rad/s, 6 rad/s, 10 rad/s]");
  const SolvedAsk& some = solved.asks.at(0);
  ASSERT_EQ(some.state, AskState::found) << some.reason;
  EXPECT_EQ(some.over->values, (std::vector<double>{9, 10}));
  EXPECT_NEAR(some.columns[0].values.at(1), 0.444686, 1e-6);
  EXPECT_TRUE(std::ranges::any_of(solved.notes, [](const std::string& note) {
    return note.starts_with("t: the row w = 6 rad/s has no answer and is left out: 'q == 180 deg' does not happen");
  }));
}

TEST(TableRows, a_table_of_which_no_row_has_an_answer_has_none) {
  const SolvedAsk low = asked("[6 rad/s, 5 rad/s]");
  EXPECT_EQ(low.state, AskState::undetermined);
  EXPECT_TRUE(low.reason.starts_with("in the row w = 6 rad/s: 'q == 180 deg' does not happen")) << low.reason;
}

// What makes one row impossible makes the file no other file.
TEST(TableRows, a_row_that_contradicts_the_file_is_left_out) {
  const Solution solved =
      solve_statement(read_statement("given: {h: 1 m}\npoints: {O: [0, 0, 0], H: [0, h, 0]}\n"
                                     "bodies: {b: {particle: H, mass: 1 kg}}\ngravity: -y\n"
                                     "contacts: {floor: {of: b, at: H, surface: O, normal: y, open: true}}\n"
                                     "instants: {start: rest, lands: {first_time: touching(floor)}}\n"
                                     "ask: {t: {table: {t: time @ lands}, over: {h: [0 m, 1 m, -2 m, 4 m]}}}\n",
                                     "rows.yaml"),
                      {})
          .solutions.at(0);
  const SolvedAsk& falls = solved.asks.at(0);
  ASSERT_EQ(falls.state, AskState::found) << falls.reason;
  EXPECT_EQ(falls.over->values, (std::vector<double>{1, 4}));
  EXPECT_NEAR(falls.columns[0].values.at(1), std::sqrt(8 / 9.80665), 1e-9);
  const auto told = [&](const std::string& words) {
    return std::ranges::any_of(solved.notes, [&](const std::string& note) { return note.starts_with(words); });
  };
  EXPECT_TRUE(told("t: the row h = 0 m has no answer and is left out: contact 'floor' is open"));
  EXPECT_TRUE(told("t: the row h = -2 m has no answer and is left out: contact 'floor' is open"));
}

// A bead that is pulled ever harder is gone after 1.3 s: that is found once, not for each row.
TEST(TableRows, a_motion_that_cannot_be_followed_is_tried_once) {
  const auto work_of = [](const std::string& end) {
    const Work before = work_done();
    const Solution solved =
        solve_statement(read_statement("points: {O: [0, 0, 0]}\nbodies: {b: {particle: O, mass: 1 kg}}\n"
                                       "joints: {rail: {prismatic: x, at: O, to: b, displacement: s}}\n"
                                       "loads: {pull: {force: 1 N*(1 + (s/(1 m))^2)^2, along: x, body: b}}\n"
                                       "gravity: none\ninstants: {start: {s: 0, s': 1 m/s}}\n"
                                       "ask: {t: {table: {s: s}, over: {time: 0 s .. " +
                                           end + " by 0.5 s}}}\n",
                                       "rows.yaml"),
                        {})
            .solutions.at(0);
    EXPECT_EQ(solved.asks.at(0).state, AskState::found) << solved.asks.at(0).reason;
    EXPECT_EQ(solved.asks.at(0).over->values, (std::vector<double>{0, 0.5, 1}));
    return work_done() - before;
  };
  EXPECT_LT(static_cast<double>(work_of("40 s")), 1.5 * static_cast<double>(work_of("1.5 s")));
}

}  // namespace table_rows_test
}  // namespace poinsot::problem
