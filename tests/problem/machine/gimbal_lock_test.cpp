#include "problem/machine/gimbal_lock.h"

#include <gtest/gtest.h>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace gimbal_lock_test {

std::string top(const std::string& start, const std::string& rest) {
  return "title: t\npoints: {O: [0, 0, 0], G: [0, 0, 0.5 m]}\n"
         "bodies: {top: {mass: 2 kg, center: G, inertia: {about: G, x: 0.1 kg*m^2, y: 0.2 kg*m^2, z: 0.15 kg*m^2}}}\n"
         "joints: {tip: {ball: O, to: top, angles: [phi: z, theta: x, psi: z]}}\ngravity: -z\n"
         "instants: {start: {" +
         start + "}}\n" + rest;
}

const char* const upright = "theta: 0 deg, phi: 0 deg, psi: 0 deg, theta': 1 rad/s, phi': 1 rad/s, psi': 0";
const char* const locked = "the angles 'phi' and 'psi' of joint 'tip' turn about the same line (gimbal lock)";

TEST(GimbalLock, IsNamedWhereTheMotionCannotBeToldInItsAngles) {
  const SolvedText solved(top(upright, "ask: {a: theta'', H: angular_momentum(top about O), later: theta @ 1 s}\n"));
  EXPECT_EQ(solved.reason("a"), std::string(locked) +
                                    ": there they cannot follow the motion: leave the angles of the joint out, or take "
                                    "other axes for them, or another pose");
  // What does not need them is answered all the same.
  EXPECT_NEAR(solved.vector("H").z, 0.15, 1e-12);
  EXPECT_EQ(solved.ask("later").state, AskState::found);
}

TEST(GimbalLock, IsNamedWhereAccelerationsAreOpen) {
  const SolvedText solved(
      top("theta: 0 deg, phi: 0 deg, psi: 0 deg, theta': 1 rad/s, phi': 0, psi': 0", "ask: {a: phi''}\n"));
  EXPECT_NE(solved.reason("a").find(locked), std::string::npos) << solved.reason("a");
}

TEST(GimbalLock, IsNamedWhereAMotionRunsIntoIt) {
  const SolvedText solved(top("theta: 10 deg, phi: 0 deg, psi: 0 deg, theta': -1 rad/s, phi': 1e-12 rad/s, psi': 0",
                              "loads: {p: {force: [0, 0.1 N, 0], at: G, body: top}}\nask: {a: theta @ 1 s}\n"));
  const std::string reason = solved.reason("a");
  EXPECT_NE(reason.find("comes at 0.2142"), std::string::npos) << reason;
  EXPECT_NE(reason.find(locked), std::string::npos) << reason;
}

TEST(GimbalLock, IsNotSeenElsewhere) {
  const SolvedText solved(top("theta: 20 deg, phi: 0 deg, psi: 0 deg, theta': 1 rad/s, phi': 1 rad/s, psi': 0",
                              "ask: {a: theta'', b: phi''}\n"));
  EXPECT_EQ(solved.ask("a").state, AskState::found);
  EXPECT_EQ(solved.ask("b").state, AskState::found);
}

}  // namespace gimbal_lock_test
}  // namespace poinsot::problem
