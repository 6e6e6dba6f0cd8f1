// What is left of the answers when the caller's budget ends, and what is kept.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"
#include "problem/answers/solve_statement.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {
namespace ended_answers_test {

// A double pendulum whose energy is known at once, and whose motion over so long a time takes many minutes.
const std::string pendulum = R"(title: a double pendulum, for long
gravity: -y
points: {O: [0, 0, 0], A: [0, -1 m, 0], B: [0, -2 m, 0]}
bodies:
  one: {particle: A, mass: 1 kg}
  two: {particle: B, mass: 1 kg}
joints:
  upper: {revolute: z, at: O, to: one, angle: a}
  lower: {revolute: z, at: A, from: one, to: two, angle: b}
instants:
  start: {a: 90 deg, b: 30 deg, "a'": 3 rad/s, "b'": -1 rad/s}
ask:
  now: kinetic_energy(one) @ start
  later: kinetic_energy(one) @ 100000 s
  after: mass(one)
)";

// A clock that goes as the work does, so that the test is the same on every machine.
Budget by_work(std::chrono::nanoseconds most) {
  return Budget()
      .by_clock(
          [begin = work_done()] { return Budget::Clock::time_point{} + std::chrono::nanoseconds(work_done() - begin); })
      .end_after(most);
}

SolvedStatement solved(const std::string& text) { return solve_statement(read_statement(text, "test.yaml"), {}); }

TEST(EndedAnswers, what_was_found_is_kept_and_the_rest_says_why_not) {
  const BudgetScope scope(by_work(std::chrono::milliseconds(500)));
  const SolvedStatement result = solved(pendulum);
  EXPECT_EQ(result.ended, BudgetEnd::deadline);
  ASSERT_EQ(result.solutions.size(), 1U);
  const std::vector<SolvedAsk>& asks = result.solutions[0].asks;
  ASSERT_EQ(asks.size(), 3U);
  EXPECT_EQ(asks[0].state, AskState::found);
  EXPECT_NEAR(asks[0].value.number, 4.5, 1e-12);
  EXPECT_FALSE(asks[0].ended);
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(asks[i].state, AskState::undetermined);
    EXPECT_EQ(asks[i].ended, BudgetEnd::deadline);
    EXPECT_EQ(asks[i].reason, "ended by the deadline");
    EXPECT_FALSE(asks[i].words.empty());
  }
}

TEST(EndedAnswers, an_interruption_before_anything_was_found_leaves_every_question_open) {
  const std::atomic<bool> flag = true;
  const BudgetScope scope(Budget().end_when(&flag));
  const SolvedStatement result = solved(pendulum);
  EXPECT_EQ(result.ended, BudgetEnd::interrupted);
  ASSERT_EQ(result.solutions.size(), 1U);
  ASSERT_EQ(result.solutions[0].asks.size(), 3U);
  for (const SolvedAsk& ask : result.solutions[0].asks) {
    EXPECT_EQ(ask.state, AskState::undetermined);
    EXPECT_EQ(ask.reason, "interrupted");
  }
}

// At whatever point the work is ended: no answer is given that the full run does not give.
TEST(EndedAnswers, what_is_given_is_what_would_have_been_given) {
  const std::string text = R"yaml(title: letters, an unknown and a claim
letters: {m: kg, r: m}
find: {w: rad/s}
bodies: {disk: {disk: {center: [0, 0, 0], normal: y, radius: r}, mass: m}}
joints: {shaft: {revolute: y, at: [0, 0, 0], to: disk, rate: w}}
facts: {kinetic_energy(disk): m*r^2*(4 rad^2/s^2)}
ask: {H: "angular_momentum(disk about [0, 0, 0])", m: mass(disk)}
claim: {light: {claim: "kinetic_energy(disk) >= 0 J"}}
)yaml";
  const Work begin = work_done();
  const SolvedStatement whole = solved(text);
  const Work all = work_done() - begin;
  ASSERT_FALSE(whole.ended);
  ASSERT_FALSE(whole.solutions.empty());
  std::size_t ended = 0, kept = 0;
  for (Work part = 1; part <= 16; ++part) {
    const BudgetScope scope(by_work(std::chrono::nanoseconds(all * part / 16)));
    const SolvedStatement cut = solved(text);
    ended += cut.ended.has_value();
    for (std::size_t s = 0; s < cut.solutions.size(); ++s) {
      for (std::size_t i = 0; i < cut.solutions[s].asks.size(); ++i) {
        const SolvedAsk& ask = cut.solutions[s].asks[i];
        if (ask.ended) continue;
        ++kept;
        EXPECT_EQ(ask.state, whole.solutions.at(s).asks[i].state);
        EXPECT_EQ(ask.formula.has_value(), whole.solutions.at(s).asks[i].formula.has_value());
      }
      for (const SolvedClaim& claim : cut.solutions[s].claims) EXPECT_TRUE(claim.ended || claim.holds);
    }
  }
  EXPECT_GT(ended, 4U);
  EXPECT_GT(kept, 0U);
}

}  // namespace ended_answers_test
}  // namespace poinsot::problem
