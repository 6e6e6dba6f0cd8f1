// Numbers that the state of a motion tells by itself, against the same said of the bodies.
#include <gtest/gtest.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace state_scope_test {

constexpr const char* pendulum = R"(
given: {L: 0.7 m, m: 2 kg, theta0: 50 deg}
gravity: -z
points: {O: [0, 0, 0], E: [0, 0, -L]}
bodies:
  bob: {particle: E, mass: m}
joints:
  pin: {revolute: y, at: O, to: bob, angle: theta}
instants:
  start: {theta: theta0, theta': 0.3 rad/s}
)";

// The x of the bob is -L sin(theta), its speed L |theta'|.
TEST(NumbersOfTheState, AgreeWithThoseOfTheBodies) {
  const SolvedText solved(std::string(pendulum) + R"(
ask:
  speed: max(L*abs(theta'))
  speed_of_body: max(norm(velocity(bob)))
  least: min(-L*sin(theta))
  least_of_body: min(center(bob).x)
  highest: max(L*(1 - cos(theta))/2 + 0.1 m)
  highest_of_body: max((L + center(bob).z)/2 + 0.1 m)
  crossed: {first_time: abs(theta) == 10 deg}
  crossed_by_body: {first_time: abs(center(bob).x) == L*sin(10 deg)}
)");
  for (const std::string name : {"speed", "least", "highest"})
    EXPECT_NEAR(solved.number(name), solved.number(name + "_of_body"), 1e-9) << name;
  EXPECT_GT(solved.number("speed"), 1);
  EXPECT_NEAR(solved.number("crossed"), solved.number("crossed_by_body"), 1e-10);
}

}  // namespace state_scope_test
}  // namespace poinsot::problem
