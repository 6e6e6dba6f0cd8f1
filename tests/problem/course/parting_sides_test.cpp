// When a comparison of sides that are equal at first comes to hold.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace parting_sides_test {

SolvedAsk asked(const std::string& load, const std::string& stages, const std::string& condition) {
  const std::string text =
      "points: {O: [0, 0, 0]}\n"
      "bodies: {c: {box: {center: O, sides: [[1 m, 0, 0], [0, 1 m, 0], [0, 0, 1 m]]}, mass: 2 kg}}\n"
      "joints: {s: {prismatic: x, to: c, displacement: u}}\ngravity: none\n"
      "instants: {start: {u: 0 m, \"u'\": 0 m/s}}\nloads: {pull: {force: [\"" +
      load + "\", 0, 0], at: O, body: c}}\n" + stages + "ask: {t: {first_time: \"" + condition + "\"}}\n";
  return solve_statement(read_statement(text, "test.yaml"), {}).solutions.at(0).asks.at(0);
}

double time_of(const std::string& load, const std::string& stages, const std::string& condition) {
  const SolvedAsk ask = asked(load, stages, condition);
  EXPECT_EQ(ask.state, AskState::found) << ask.reason;
  return ask.value.number;
}

const std::string from_one_second_on = "stages: {rests: {lasts: 1 s, loads: []}, moves: {loads: [pull]}}\n";

TEST(PartingSides, of_what_a_load_moves_from_a_stage_on_part_when_it_begins) {
  for (const char* condition : {"u > 0 m", "u' > 0 m/s", "0 m < u", "u^2 > 0 m^2"})
    EXPECT_NEAR(time_of("4 N", from_one_second_on, condition), 1, 1e-12) << condition;
  EXPECT_NEAR(time_of("-4 N", from_one_second_on, "u < 0 m"), 1, 1e-12);
  EXPECT_NEAR(time_of("4 N", from_one_second_on, "u > 1 m"), 2, 1e-9);
}

TEST(PartingSides, of_what_starts_from_rest_part_at_the_start) {
  for (const char* load : {"4 N", "(4 N/s) * time", "(4 N/s^2) * time^2", "(4 N/s^4) * time^4"})
    for (const char* condition : {"u > 0 m", "u' > 0 m/s", "0 m/s < u'"})
      EXPECT_EQ(time_of(load, "", condition), 0) << load;
}

TEST(PartingSides, that_part_the_other_way_are_looked_at_farther_on) {
  // u'' = 2 m/s^2 (t/s - 1): u = t^3/3 - t^2 comes back to zero after three seconds.
  EXPECT_NEAR(time_of("(4 N/s) * (time - 1 s)", "", "u > 0 m"), 3, 1e-9);
  EXPECT_EQ(time_of("(4 N/s) * (time - 1 s)", "", "u < 0 m"), 0);
}

TEST(PartingSides, part_at_a_corner_of_what_is_asked) {
  // u = t^2.
  EXPECT_NEAR(time_of("4 N", "", "max(u with 0.5 m) > 0.5 m"), std::sqrt(0.5), 1e-9);
}

TEST(PartingSides, that_stay_equal_are_told_of) {
  const SolvedAsk never = asked("0 N", "stages: {all: {lasts: 3 s}}\n", "u > 0 m");
  EXPECT_NE(never.state, AskState::found);
  EXPECT_NE(never.reason.find("stay equal"), std::string::npos) << never.reason;
}

}  // namespace parting_sides_test
}  // namespace poinsot::problem
