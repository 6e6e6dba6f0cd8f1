// Stability in frames that accelerate steadily, against closed forms and motions that are followed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace accelerated_frame_test {

constexpr double g = 9.81;

// A bar on a pin in a frame that moves as stated, drawn so that it hangs along the apparent gravity.
std::string hanging(double a, double b, const std::string& more) {
  const double G = std::hypot(a, g + b), x = -a / G, y = -(g + b) / G;
  return fmt::format(
             "title: t\npoints: {{O: [0, 0, 0], P: [{:.17g} m, {:.17g} m, 0]}}\nframes: {{cab: {{velocity: [2 m/s, -1 "
             "m/s, 0], "
             "acceleration: [{:.17g} m/s^2, {:.17g} m/s^2, 0]}}}}\nbodies: {{bar: {{rod: [O, P], mass: 2 "
             "kg}}}}\njoints: {{pin: "
             "{{revolute: z, at: O, from: cab, to: bar, angle: q}}}}\ngravity: [0, {} m/s^2, 0]\n",
             x, y, a, b, -g) +
         more;
}

// f^2 = 3 |g - a|/(2 L), and the motion that is followed in the frame as it is, swinging a little, has that period.
TEST(AcceleratedFrame, SwingsUnderTheApparentGravity) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-5, 5);
  int tried = 0;
  for (; tried < 6; ++tried) {
    const double a = any(random), b = any(random);
    const double expected = std::sqrt(1.5 * std::hypot(a, g + b));
    const SolvedText near(hanging(a, b, "steady: {frame: cab}\nask: {f: frequencies(bar), s: stable(bar)}\n"));
    EXPECT_NEAR(near.found("f").value.items.at(0).number, expected, 1e-9 * expected);
    EXPECT_TRUE(near.found("s").value.truth);
    const SolvedText swinging(hanging(a, b, "instants: {start: {q: 0.001 rad, q': 0}}\nask: {T: period(q)}\n"));
    EXPECT_NEAR(2 * std::numbers::pi / swinging.number("T"), expected, 1e-6 * expected);
  }
  EXPECT_EQ(tried, 6);
}

TEST(AcceleratedFrame, RefusesWhatReachesInFromOutside) {
  const std::string asked = "steady: {frame: cab}\nask: {f: frequencies(bar)}\n";
  const auto reason = [&](const std::string& more) { return SolvedText(hanging(0, 2, more + asked)).reason("f"); };
  EXPECT_NE(reason("springs: {tie: {at: [0, -5 m, 0], to: bar, end: P, stiffness: 3 N/m, free_length: 1 m}}\n")
                .find("'tie' joins what rides in the accelerated frame to what does not"),
            std::string::npos);
  EXPECT_NE(reason("loads: {air: {force: '-(1 kg/s) * velocity(bar)', body: bar}}\n").find("depends on the motion"),
            std::string::npos);
}

// A frame that is carried by a driven body, which turns nothing.
TEST(AcceleratedFrame, MayBeABodyThatIsDriven) {
  const SolvedText car(
      "title: t\npoints: {O: [0, 0, 0], P: [-0.6 m, -0.8 m, 0]}\nbodies: {car: {particle: O, mass: 9 kg}, bob: "
      "{particle: P, "
      "mass: 2 kg}}\njoints: {rail: {prismatic: x, to: car, rate: 5 m/s, accel: 7.5 m/s^2}, pin: {revolute: z, at: O, "
      "from: "
      "car, to: bob, angle: q}}\ngravity: [0, -10 m/s^2, 0]\nsteady: {frame: car}\nask: {f: frequencies(bob)}\n");
  EXPECT_NEAR(car.found("f").value.items.at(0).number, std::sqrt(12.5), 1e-9);
}

}  // namespace accelerated_frame_test
}  // namespace poinsot::problem
