// What rides in an accelerating frame: the acceleration that was taken for its weight against the way of the frame.
#include "problem/witness/riding_witness.h"

#include <gtest/gtest.h>

#include <random>

#include "problem/course/motion_support.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace riding_witness_test {

double misfit(const SolvedInstant& instant, const Situation& situation, const Vector3<double>& taken) {
  const MotionState now = instant.state();
  State<double> state;
  state.q = now.q;
  state.v = now.v;
  return riding_misfit(situation, instant.machine(), state, taken);
}

// Whatever frame carries another: each of its accelerations, lost or reversed, is seen, and one that is right is not.
TEST(RidingWitness, SeesAnAccelerationThatIsReversedOrLost) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(0.5, 4);
  for (int trial = 0; trial < 5; ++trial) {
    const Vector3<double> a{any(random), -any(random), any(random)};
    const Statement statement = read_statement(
        "title: t\npoints: {O: [0, 0, 0], P: [0, -0.5 m, 0.1 m]}\nframes: {cab: {velocity: [1 m/s, 2 m/s, 0], "
        "acceleration: [" +
            std::to_string(a.x) + " m/s^2, " + std::to_string(a.y) + " m/s^2, " + std::to_string(a.z) +
            " m/s^2]}}\nbodies: {bob: {particle: P, mass: 1 kg}}\njoints: {pin: {revolute: z, at: O, from: cab, to: "
            "bob, angle: q}}\ngravity: -y\nsteady: {frame: cab}\nask: {w: angular_velocity(bob)}\n",
        "test.yaml");
    const Situation& situation = statement.situations.front();
    const Settings none;
    const SolvedInstant instant(situation, none, When{}, OpenChoice{});
    const Vector3<double> stated{std::stod(std::to_string(a.x)), std::stod(std::to_string(a.y)),
                                 std::stod(std::to_string(a.z))};
    EXPECT_LT(misfit(instant, situation, stated), 1e-10);
    // A thousand times what is allowed of it, and more.
    EXPECT_GT(misfit(instant, situation, -1.0 * stated), 0.05);
    EXPECT_GT(misfit(instant, situation, {0, stated.y, stated.z}), 5e-3);
    EXPECT_GT(misfit(instant, situation, 1.001 * stated), 1e-5);
    EXPECT_EQ(misfit(instant, situation, {0, 0, 0}), 0);
  }
}

}  // namespace riding_witness_test
}  // namespace poinsot::problem
