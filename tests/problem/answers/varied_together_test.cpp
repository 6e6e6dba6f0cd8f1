// What is left open is varied once more, all of it together: each by itself may leave an answer as it is.
#include <gtest/gtest.h>

#include <cstdio>

#include "problem/answers/solve_statement.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace varied_together_test {

SolvedAsk asked(const std::string& text) {
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0).asks.at(0);
}

TEST(VariedTogether, a_product_of_two_velocities_that_nothing_fixes) {
  const SolvedAsk ask = asked(R"(title: t
points: {A: [0, 0, 0], B: [1 m, 0, 0]}
bodies: {a: {particle: A, mass: 2 kg}, b: {particle: B, mass: 3 kg}}
gravity: none
ask: {p: velocity(a).x*velocity(b).x}
)");
  EXPECT_EQ(ask.state, AskState::undetermined);
  EXPECT_EQ(ask.reason, "it depends on several things that are left open: velocities");
}

// An answer that is the same at the one value that is tried first.
TEST(VariedTogether, a_single_velocity_is_varied_twice) {
  const auto text = [](const std::string& speed) {
    return "title: t\npoints: {A: [0, 0, 0]}\nbodies: {a: {particle: A, mass: 2 kg}}\n"
           "joints: {rail: {prismatic: x, at: A, to: a}}\ngravity: none\n"
           "ask: {p: velocity(a).x*(velocity(a).x - (" +
           speed + " m/s))}\n";
  };
  const Statement statement = read_statement(text("1"), "test.yaml");
  Sample sample(statement, AllSettings(1), {.seed = 13, .velocities = true, .direction = 0});
  const double tried = sample.value_in(0, parse_expression("velocity(a).x", "")).number;
  ASSERT_NE(tried, 0);
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", tried);
  EXPECT_EQ(asked(text(digits)).state, AskState::undetermined);
}

}  // namespace varied_together_test
}  // namespace poinsot::problem
