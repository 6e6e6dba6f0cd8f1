// Couples and forces at freedoms that are to be found, against the motion that follows where they are stated.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace sought_efforts_test {

// An arm with a turning and a sliding joint, inclined and moving.
std::string arm(const std::string& couple, const std::string& force, const std::string& facts,
                const std::string& asks) {
  return "title: t\npoints: {O: [0, 0, 0], A: [0.5 m, 0.2 m, 0], P: [0.9 m, 0.7 m, 0.1 m]}\nbodies: {one: {rod: [O, "
         "A], "
         "mass: 2 kg}, two: {rod: [A, P], mass: 3 kg}}\njoints: {turn: {revolute: z, at: O, to: one, rate: 1.5 rad/s, "
         "couple: " +
         couple + "}, slide: {prismatic: [1, 2, 0], at: A, from: one, to: two, rate: 0.4 m/s, force: " + force +
         "}}\ngravity: -y\n" + facts + "ask: {" + asks + "}\n";
}

TEST(SoughtEfforts, BringTheStatedAccelerations) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-4, 4);
  int tried = 0;
  for (; tried < 8; ++tried) {
    const double x = any(random), y = any(random);
    const SolvedText sought(
        arm("any", "any",
            fmt::format("instants: {{now: {{acceleration(P of two).x: {:.17g} m/s^2, acceleration(P of "
                        "two).y: {:.17g} m/s^2}}}}\n",
                        x, y),
            "M: drive(turn).z, F: drive(slide)"));
    const Vector3<double> force = sought.vector("F");
    const double along = dot(force, normalized(Vector3<double>{1, 2, 0}));
    const SolvedText driven(arm(fmt::format("{:.17g} N*m", sought.number("M")), fmt::format("{:.17g} N", along), "",
                                "a: acceleration(P of two)"));
    EXPECT_NEAR(driven.vector("a").x, x, 1e-10 * (1 + std::abs(x)));
    EXPECT_NEAR(driven.vector("a").y, y, 1e-10 * (1 + std::abs(y)));
  }
  EXPECT_EQ(tried, 8);
}

TEST(SoughtEfforts, AreNamedWhereNothingFixesThem) {
  const SolvedText open(arm("any", "0", "", "M: drive(turn).z"));
  EXPECT_NE(open.reason("M").find("not"), std::string::npos) << open.reason("M");
}

TEST(SoughtEfforts, AreProposedWhereNothingDrivesWhatIsStated) {
  std::string text =
      arm("any", "any", "instants: {now: {acceleration(P of two).x: 1 m/s^2, acceleration(P of two).y: 0}}\n",
          "M: drive(turn).z");
  for (const std::string& stated : {std::string(", couple: any"), std::string(", force: any")})
    text.erase(text.find(stated), stated.size());
  const std::string told = failure_of_text(text);
  EXPECT_NE(told.find("if motors make it move so, write couple: any at joint 'turn', force: any at joint 'slide')"),
            std::string::npos)
      << told;
}

TEST(SoughtEfforts, AreNotKnownAlongTheMotion) {
  const std::string facts = "instants: {start: {angular_acceleration(one).z: 2 rad/s^2}}\n";
  const SolvedText later(arm("any", "0", facts, "w: angular_velocity(one).z @ 1 s"));
  EXPECT_NE(later.reason("w").find("is not known along the motion"), std::string::npos) << later.reason("w");
}

TEST(SoughtEfforts, AreSoughtAlone) {
  const auto refused = [](const std::string& at_joint) {
    return failure_of_text(
        "title: t\npoints: {O: [0, 0, 0]}\nbodies: {w: {disk: {center: O, normal: z, radius: 1 m}, mass: 1 "
        "kg}}\njoints: {pin: "
        "{revolute: z, at: O, to: w, couple: any, " +
        at_joint + "}}\ngravity: none\nask: {M: drive(pin)}\n");
  };
  EXPECT_NE(refused("rate: 1 rad/s, damping: 2 N*m*s").find("together with its spring, damping and friction"),
            std::string::npos);
  EXPECT_NE(refused("rate: 1 rad/s + 2 rad/s^2 * time").find("from its stated acceleration already"),
            std::string::npos);
  EXPECT_NE(refused("rate: 1 rad/s, accel: 0").find("one too many"), std::string::npos);
}

}  // namespace sought_efforts_test
}  // namespace poinsot::problem
