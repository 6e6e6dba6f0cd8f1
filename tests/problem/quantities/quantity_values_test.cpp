// Quantities where what they are usually formed of vanishes; what is said of one whose value stands nowhere.
#include "problem/quantities/quantity_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/answers/solve_statement.h"

namespace poinsot::problem {
namespace quantity_values_test {

TEST(QuantityValues, ARowWithoutAValueIsNamedAndGetsNoOther) {
  EXPECT_NO_THROW(require_one_of("sliding", {"sticking", "sliding", "parting"}));
  try {
    require_one_of("virial", {"kinetic_energy"});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "the quantity 'virial' has a row in its table and no value");
  }
}

// w = (p, 0, q): a slender rod along z turns about its momentum p J along x, and about itself.
TEST(QuantityValues, ASlenderRodSpinsThoughItHasNoMomentAboutItself) {
  const Solution rod = solve_statement(read_statement(R"(points: {A: [0, 0, -1 m], B: [0, 0, 1 m]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
gravity: none
facts: {'angular_velocity(rod)': [2 rad/s, 0, 3 rad/s], 'velocity(rod)': 0}
ask: {s: spin_rate(rod about z), n: precession_rate(rod), b: body_cone(rod)}
)",
                                                      "test.yaml"),
                                       {})
                           .solutions.at(0);
  const double values[] = {3, 2, std::atan(2.0 / 3)};
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(rod.asks[k].state, AskState::found) << k << rod.asks[k].reason;
    EXPECT_NEAR(rod.asks[k].value.number, values[k], 1e-12) << k;
  }
}

// However nearly spherical a planet is, its axis wanders if it does not turn about it.
TEST(QuantityValues, ThePolhodeOfANearlySphericalBodyIsNoPointBesideItsAxis) {
  for (const char* I : {"1.01", "1.0001", "1.000001", "1.0000001"})
    for (const char* p : {"1e-3", "1e-2", "0"}) {
      const Solution planet = solve_statement(read_statement(std::string("given: {I: ") + I + " kg*m^2, p: " + p +
                                                                 R"( rad/s}
points: {G: [0, 0, 0]}
bodies: {b: {mass: 1 kg, center: G, inertia: {axis: z, axial: I, transverse: 1 kg*m^2}}}
gravity: none
facts: {'angular_velocity(b)': [p, 0, 1 rad/s], 'velocity(b)': 0}
ask: {course: polhode(b)}
)",
                                                             "test.yaml"),
                                              {})
                                  .solutions.at(0);
      EXPECT_EQ(planet.asks[0].value.text, std::string(p) == "0" ? "a point: the rotation about a principal axis"
                                                                 : "around the axis of the largest moment")
          << I << " " << p;
    }
}

}  // namespace quantity_values_test
}  // namespace poinsot::problem
