// Small bodies beside large ones: their numbers are no rounding, and what is open of them is told.
#include "problem/answers/rounded_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace rounded_values_test {

Solution solved(const std::string& text) {
  const SolvedStatement all = solve_statement(read_statement(text, "test.yaml"), {});
  EXPECT_EQ(all.solutions.size(), 1U);
  return all.solutions.at(0);
}

TEST(DropNoise, keeps_what_rounding_the_other_way_does_not_move) {
  const auto vector = [](double x, double y, double z) {
    return Value<double>::of_vector({x, y, z}, dimensions::force);
  };
  Value<double> value = vector(1e9, 1e-6, 3e-8);
  drop_noise(value, 1e9, 1e9, {vector(1e9, 1e-6, -2e-8), vector(1e9, 1.00001e-6, 3e-8)}, noise_of_instant);
  EXPECT_EQ(value.vector.x, 1e9);
  EXPECT_EQ(value.vector.y, 1e-6);
  EXPECT_EQ(value.vector.z, 0);
}

TEST(DropNoise, without_other_roundings_goes_by_the_size_of_what_is_asked) {
  Value<double> value = Value<double>::of_number(1e-9, dimensions::force);
  drop_noise(value, 1e9, 1, {}, noise_of_instant);
  EXPECT_EQ(value.number, 1e-9);
  drop_noise(value, 1e9, 1e6, {}, noise_of_instant);
  EXPECT_EQ(value.number, 0);
}

TEST(SmallBodies, a_satellite_beside_the_earth_has_momentum) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [7e6 m, 0, 0]}
bodies:
  earth: {sphere: {center: O, radius: 6.37e6 m}, mass: 5.97e24 kg}
  satellite: {cube: {center: A, side: 1 m}, mass: 100 kg}
instants:
  now:
    velocity(earth): [0, 0, 0]
    angular_velocity(earth): [0, 0, 7.29e-5 rad/s]
    velocity(satellite): [0, 7500 m/s, 0]
    angular_velocity(satellite): [0.1 rad/s, 0, 0.2 rad/s]
gravity: none
ask:
  p: momentum(satellite)
  H: angular_momentum(satellite about center(satellite))
  T: kinetic_energy(satellite)
)");
  EXPECT_NEAR(solution.asks[0].value.vector.y, 7.5e5, 1e-6);
  EXPECT_EQ(solution.asks[0].value.vector.x, 0);
  EXPECT_NEAR(solution.asks[1].value.vector.x, 10.0 / 6, 1e-9);
  EXPECT_NEAR(solution.asks[1].value.vector.z, 20.0 / 6, 1e-9);
  EXPECT_NEAR(solution.asks[2].value.number, 50 * 7500.0 * 7500 + 0.5 * 100 / 6 * 0.05, 1);
}

TEST(SmallBodies, a_gyroscope_in_a_ship_needs_its_couple) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [7 m, 0, 0]}
bodies:
  ship: {box: {center: O, sides: [200 m * x, 30 m * y, 30 m * z]}, mass: 4e7 kg}
  gyro: {disk: {center: A, normal: x, radius: 1 cm}, mass: 10 g}
joints:
  sea: {revolute: z, at: O, to: ship, rate: 0.01 rad/s, accel: 0}
  g: {revolute: x, at: A, from: ship, to: gyro, rate: 3000 rpm, accel: 0}
gravity: none
ask: {T: kinetic_energy(gyro), M: couple(g on gyro about A)}
)");
  const double spin = 3000 * 2 * 3.141592653589793 / 60, axial = 0.5 * 0.01 * 1e-4;
  // Koenig, with the mass center going round at 7 m.
  EXPECT_NEAR(solution.asks[0].value.number, 0.5 * axial * spin * spin + 0.5 * (axial / 2 + 0.01 * 49) * 1e-4, 1e-12);
  EXPECT_NEAR(solution.asks[1].value.vector.y, axial * spin * 0.01, 1e-14);
  EXPECT_EQ(solution.asks[1].value.vector.x, 0);
}

TEST(SmallBodies, what_is_open_of_them_is_not_told_as_zero) {
  const Solution solution = solved(R"(
points: {A: [0, 0, 0], B: [100 km, 0, 0]}
bodies:
  one: {cube: {center: A, side: 1 m}, mass: 100 kg}
  two: {cube: {center: B, side: 0.1 m}, mass: 1 kg}
facts:
  velocity(one): [0, 7500 m/s, 0]
  angular_velocity(one): [0.01 rad/s, 0, 0]
  velocity(two): [0, 7500 m/s, 0]
gravity: none
ask: {H: angular_momentum(two about center(two)), T: kinetic_energy(two about center(two)), p: momentum(two)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::undetermined);
  EXPECT_EQ(solution.asks[1].state, AskState::undetermined);
  EXPECT_EQ(solution.asks[2].state, AskState::found);
}

TEST(SmallBodies, the_weight_of_a_speck_beside_a_giant_is_not_told_without_gravity) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {big: {particle: O, mass: 1e24 kg}, small: {particle: A, mass: 1 mg}}
joints:
  b: {prismatic: x, at: O, to: big, rate: 3 m/s, accel: 2 m/s^2}
  s: {prismatic: x, at: A, to: small, rate: 2 m/s, accel: 5 m/s^2}
ask: {F: force(s on small)}
)");
  EXPECT_EQ(solution.asks[0].state, AskState::undetermined);
}

TEST(SmallBodies, rounding_stays_zero) {
  const Solution solution = solved(R"(
points: {O: [0, 0, 0], A: [0.3 m, 0.4 m, 0.7 m]}
directions: {u: '[cos(37 deg), sin(37 deg), 0]', w: '[-sin(37 deg), cos(37 deg), 0]'}
bodies: {p: {box: {center: A, sides: [1 m * u, 2 m * w, 3 m * z]}, mass: 7 kg}}
joints: {j: {revolute: w, at: A, to: p, rate: 3 rad/s, accel: 0}}
gravity: none
ask: {H: dot(angular_momentum(p about A) with u), M: couple(j on p about A)}
)");
  EXPECT_EQ(solution.asks[0].value.number, 0);
  EXPECT_EQ(solution.asks[1].value.vector.x, 0);
  EXPECT_EQ(solution.asks[1].value.vector.y, 0);
  EXPECT_EQ(solution.asks[1].value.vector.z, 0);
}

// What damps the axis of a planet is 1e-34 of the natural size of its couples, and no rounding: -c W.
TEST(SmallBodies, what_damps_a_planet_is_told) {
  const Solution solution = solved(R"(
given: {c: 1 N*m*s, W: 7.3e-5 rad/s}
points: {O: [0, 0, 0]}
bodies: {earth: {sphere: {center: O, radius: 6.37e6 m}, mass: 5.97e24 kg}}
joints: {axis: {revolute: z, at: O, to: earth, rate: W, damping: c}}
gravity: none
ask: {M: couple(axis on earth about O)}
)");
  EXPECT_NEAR(solution.asks[0].value.vector.z, -7.3e-5, 1e-19);
  EXPECT_EQ(solution.asks[0].value.vector.x, 0);
}

TEST(SmallBodies, a_grain_shifts_the_center_of_a_barge) {
  const Solution solution = solved(R"(
given: {e: 1 mm}
points: {O: [0, 0, 0], A: [e, 0, 0]}
bodies: {barge: {particle: O, mass: 4e5 kg}, grain: {particle: A, mass: 1e-9 kg}}
gravity: none
ask: {G: center(system), d: mass(system) - 4e5 kg}
)");
  EXPECT_NEAR(solution.asks[0].value.vector.x, 1e-3 * 1e-9 / 4e5, 1e-31);
  EXPECT_EQ(solution.asks[0].value.vector.y, 0);
  ASSERT_EQ(solution.notes.size(), 1U);
  EXPECT_EQ(solution.notes[0], "'d' is the small difference of large numbers: of its digits 1 is known");
}

// Decimals and degrees are no exact numbers of a computer, so that operations without any rounding leave some.
TEST(SmallBodies, the_rounding_of_what_is_written_stays_zero) {
  const Solution solution = solved(R"(
given: {a: 0.3 m, b: 0.1 m, c: 0.2 m, q: 90 deg}
points: {O: [0, 0, 0], A: [1 m, 0, 0]}
bodies: {p: {particle: A, mass: 1 kg}}
joints: {j: {revolute: z, at: O, to: p, rate: 2 rad/s, accel: 0}}
gravity: none
ask:
  left: mass(p)*(a - b - c)
  across: momentum(p).y*cos(q)
  half_turn: momentum(p).y*sin(pi)
)");
  for (const SolvedAsk& ask : solution.asks) EXPECT_EQ(ask.value.number, 0) << ask.words;
}

}  // namespace rounded_values_test
}  // namespace poinsot::problem
