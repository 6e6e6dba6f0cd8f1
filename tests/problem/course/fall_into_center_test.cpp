// Extremes of what falls straight into the center that pulls it, beside the conservation of energy.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace fall_into_center_test {

Solution solved(const std::string& velocity, const std::string& ask) {
  return solve_statement(read_statement("given: {K: 398600 km^3/s^2, R: 6371 km, v: 5 km/s}\n"
                                        "points: {O: [0, 0, 0], A: [R, 0, 0]}\n"
                                        "bodies: {stone: {particle: A, mass: 1 kg}}\n"
                                        "gravity: {toward: O, parameter: K}\n"
                                        "instants: {start: {velocity(stone): " +
                                            velocity + "}}\nask: {x: " + ask + "}\n",
                                        "stone.yaml"),
                         {})
      .solutions.at(0);
}

constexpr double K = 3.986e14, R = 6.371e6, v = 5e3, top = 2 * K * R / (2 * K - R * v * v);

TEST(FallIntoCenter, the_height_of_what_is_thrown_up_is_that_of_its_energy) {
  const Solution up = solved("[v, 0, 0]", "max(norm(position(stone)))");
  ASSERT_EQ(up.asks[0].state, AskState::found) << up.asks[0].reason;
  EXPECT_NEAR(up.asks[0].value.number / top, 1, 1e-10);
  EXPECT_NE(up.notes.size(), 0U);
  const Solution along = solved("[v, 0, 0]", "max(position(stone).x)");
  ASSERT_EQ(along.asks[0].state, AskState::found) << along.asks[0].reason;
  EXPECT_NEAR(along.asks[0].value.number / top, 1, 1e-10);
}

TEST(FallIntoCenter, what_the_end_alone_would_tell_is_not_told) {
  for (const char* ask : {"max(norm(velocity(stone)))", "min(norm(position(stone)))", "max(kinetic_energy(stone))",
                          "max(norm(position(stone)) + 1 s*norm(velocity(stone)))", "min(1 m^2/norm(position(stone)))"})
    EXPECT_EQ(solved("[v, 0, 0]", ask).asks[0].state, AskState::undetermined) << ask;
}

TEST(FallIntoCenter, what_passes_the_center_goes_on) {
  const Solution orbit = solved("[v, 300 m/s, 0]", "max(norm(position(stone)))");
  ASSERT_EQ(orbit.asks[0].state, AskState::found) << orbit.asks[0].reason;
  // r v^2/2 ... : the larger root of E r^2 + K r - h^2/2 = 0.
  const double E = (v * v + 9e4) / 2 - K / R, h = 300 * R;
  EXPECT_NEAR(orbit.asks[0].value.number / ((-K - std::sqrt(K * K + 2 * E * h * h)) / (2 * E)), 1, 1e-9);
}

}  // namespace fall_into_center_test
}  // namespace poinsot::problem
