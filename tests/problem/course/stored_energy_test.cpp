// The potential energy of the system with its springs: constant with the kinetic energy, and less by the work of a
// damper.
#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace stored_energy_test {

const std::string sprung =
    "title: t\ngiven: {k: 60 N/m, K: 4 N*m/rad}\n"
    "points: {O: [0, 0, 0], A: [0.4 m, 0, 0], B: [0.7 m, -0.2 m, 0], W: [0.2 m, 0.5 m, 0.1 m]}\n"
    "bodies:\n  arm: {rod: [O, A], mass: 2 kg}\n  bob: {rod: [A, B], mass: 3 kg}\n"
    "joints:\n  hinge: {revolute: z, at: O, to: arm, angle: a, rate: 2 rad/s, spring: {stiffness: K, free_angle: 30 "
    "deg}}\n"
    "  elbow: {revolute: z, at: A, from: arm, to: bob, angle: b, rate: -3 rad/s}\n"
    "gravity: -y\n";
const std::string springs =
    "  pull: {at: W, to: bob, end: B, stiffness: k, free_length: 0.3 m}\n"
    "  twist: {from: arm, to: bob, about: z, stiffness: 2 N*m/rad, free_angle: 10 deg}\n";

TEST(StoredEnergy, OfTheSystemIsThatOfItsWeightsAndSprings) {
  const SolvedText solved(sprung + "springs:\n" + springs +
                          "ask: {V: potential_energy(system) @ 0.3 s, arm: potential_energy(arm) @ 0.3 s, "
                          "bob: potential_energy(bob) @ 0.3 s, pull: potential_energy(pull) @ 0.3 s, "
                          "twist: potential_energy(twist) @ 0.3 s, hinge: potential_energy(hinge) @ 0.3 s}\n");
  double sum = 0;
  for (const char* part : {"arm", "bob", "pull", "twist", "hinge"}) {
    EXPECT_GT(std::abs(solved.number(part)), 1e-3) << part;
    sum += solved.number(part);
  }
  EXPECT_NEAR(solved.number("V"), sum, 1e-12 * std::abs(sum));
}

TEST(StoredEnergy, GoesIntoTheMotionAndComesBack) {
  const SolvedText solved(sprung + "springs:\n" + springs +
                          "define: {E: kinetic_energy(system) + potential_energy(system)}\n"
                          "ask: {start: E, later: E @ 0.8 s, rate: E', T: kinetic_energy(system), "
                          "U: kinetic_energy(system) @ 0.8 s}\n");
  EXPECT_NEAR(solved.number("later"), solved.number("start"), 1e-9 * std::abs(solved.number("start")));
  EXPECT_NEAR(solved.number("rate"), 0, 1e-9);
  EXPECT_GT(std::abs(solved.number("U") - solved.number("T")), 0.1);
}

// The pull of a damper times the rate of its length, from the velocities of its end.
TEST(StoredEnergy, IsLessByWhatADamperTakes) {
  const SolvedText solved(sprung + "springs:\n" + springs +
                          "  brake: {at: W, to: bob, end: B, damping: 5 N*s/m}\n"
                          "define: {E: kinetic_energy(system) + potential_energy(system)}\n"
                          "ask: {rate: E', F: force(brake on bob), v: velocity(B of bob)}\n");
  const double taken = dot(solved.vector("F"), solved.vector("v"));
  EXPECT_LT(taken, -1e-3);
  EXPECT_NEAR(solved.number("rate"), taken, 1e-9 * std::abs(taken));
}

// Let go at the height of the origin with its spring relaxed, an arm has no energy at all, and none of motion when it
// turns back: the size of what drifts is that on the way.
TEST(StoredEnergy, IsKeptBetweenTwoStatesOfRest) {
  constexpr double m = 3, length = 1, k = 4, g = 9.80665, inertia = m * length * length / 3;
  const SolvedText solved(
      "title: t\npoints: {O: [0, 0, 0], A: [1 m, 0, 0]}\nbodies: {arm: {rod: [O, A], mass: 3 kg}}\n"
      "joints: {pin: {revolute: z, at: O, to: arm, angle: q, spring: {stiffness: 4 N*m/rad}}}\n"
      "gravity: -y\ninstants: {start: {q: 0, q': 0}}\nstages: {swing: {until: q' == 0}}\n"
      "ask: {fast: max(abs(q'))}\n");
  double most = 0;
  for (double q = 0; q < 3; q += 1e-4) most = std::max(most, m * g * length / 2 * std::sin(q) - k * q * q / 2);
  EXPECT_NEAR(solved.number("fast"), std::sqrt(2 * most / inertia), 1e-7);
}

TEST(SteadyData, AreRefusedWhereTheyFollowTime) {
  const std::string rail =
      "title: t\ngiven: {k: 10 N/m*(1 + sin(3 rad/s * time)), m: 1 kg}\n"
      "points: {A: [0, 0, 0], B: [1 m, 0, 0]}\n";
  const auto failure = [&](const std::string& mass, const std::string& joint, const std::string& stiffness) {
    return failure_of_text(rail + "bodies: {b: {particle: B, mass: " + mass +
                           "}}\njoints: {rail: {prismatic: x, to: b, " + "displacement: s, rate: 0 m/s" + joint +
                           "}}\nsprings: {cord: {at: A, to: b, end: B, " + "stiffness: " + stiffness +
                           ", free_length: 0.5 m}}\ngravity: none\nask: {x: s @ 1 s}\n");
  };
  const std::string repair =
      " is stated with data that change with time (loads, and what is stated of the freedoms of joints and of frames, "
      "may follow time; other data may not)";
  EXPECT_EQ(failure("m", "", "k"), "test.yaml:6:51: error: 'cord' under springs:" + repair);
  EXPECT_EQ(failure("m*(2 + k/(10 N/m))", "", "10 N/m"), "test.yaml:4:34: error: body 'b'" + repair);
  EXPECT_EQ(failure("m", ", damping: k*(1 s)", "10 N/m"), "test.yaml:5:78: error: joint 'rail'" + repair);
  EXPECT_EQ(failure("m", ", force: k*(0.1 m)", "10 N/m"), "no error");
}

}  // namespace stored_energy_test
}  // namespace poinsot::problem
