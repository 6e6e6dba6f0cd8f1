// Bodies that land on several rough contacts at once, against the laws of momentum and of friction for the blow as a
// whole.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace landing_test {

constexpr double g = 9.80665, a = 0.3, h = 0.4, H = 0.2;

// A crate that falls flat on a floor H below it as it moves along. contact: what its contacts state besides.
std::string crate(double speed, double friction, const std::string& contact, const std::string& asks) {
  const auto foot = [&](const char* corner) {
    return fmt::format("{{of: crate, corner: {}, normal: y, open: true, surface: O, friction: {:.17g}{}}}", corner,
                       friction, contact);
  };
  return fmt::format(
      "plane: [x, y]\ngiven: {{a: {} m, h: {} m, H: {} m, u: {:.17g} m/s}}\n"
      "points: {{A: [-a, 0], B: [a, 0], G: [0, h/2], O: [0, -H]}}\n"
      "bodies: {{crate: {{rectangle: {{center: G, sides: [[2*a, 0], [0, h]]}}, mass: 20 kg}}}}\n"
      "contacts: {{left: {}, right: {}}}\n"
      "gravity: -y\nfacts: {{velocity(crate): [u, 0], angular_velocity(crate): 0}}\nask: {{{}}}\n",
      a, h, H, speed, foot("A"), foot("B"), asks);
}

// Both feet press: the friction, at most mu times the whole push, is less than would tip it.
TEST(Landing, ACrateKeepsWhatFrictionLeaves) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> speed(-2, 2), friction(0.05, 0.6);
  const double fall = std::sqrt(2 * g * H), t = fall / g;
  int stopped = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const double u = speed(random), mu = friction(random);
    const SolvedText solved(crate(u, mu, "", "v: velocity(crate).x @ 0.21 s, w: angular_velocity(crate) @ 0.21 s"));
    const double left = std::max(0.0, std::abs(u) - mu * fall), later = std::max(0.0, left - mu * g * (0.21 - t));
    stopped += left == 0;
    EXPECT_NEAR(solved.number("v"), std::copysign(later, u), 1e-9) << u << " " << mu;
    EXPECT_NEAR(solved.number("w"), 0, 1e-9);
    EXPECT_TRUE(std::ranges::any_of(solved.notes(), [](const std::string& note) {
      return note.find("are struck together without rebound") != std::string::npos;
    }));
  }
  EXPECT_GT(stopped, 0);
  EXPECT_LT(stopped, 8);
}

// A slender crate that friction stops tips over its front foot, about which its moment of momentum is kept:
// (I + m (a^2 + h^2/4)) w = m (a fall - h/2 u), and then swings about it.
TEST(Landing, ASlenderCrateTips) {
  std::string text = crate(2.5, 0.9, "", "w: angular_velocity(crate) @ 0.205 s");
  text.replace(text.find("h: 0.4 m"), 8, "h: 1.6 m");
  const double tall = 1.6, u = 2.5, fall = std::sqrt(2 * g * H), arm = a * a + tall * tall / 4,
               I = (4 * a * a + tall * tall) / 12 + arm, w = (a * fall - tall / 2 * u) / I;
  ASSERT_LT(w, 0);
  // By small steps of the swing, the tilt counted forwards.
  double tilt = 0, rate = -w;
  const int steps = 20000;
  const double dt = (0.205 - fall / g) / steps, corner = std::atan2(a, tall / 2);
  for (int i = 0; i < steps; ++i) {
    const auto pull = [&](double there) { return -g * std::sqrt(arm) * std::sin(corner - there) / I; };
    const double half = rate + dt / 2 * pull(tilt);
    tilt += dt * half;
    rate = half + dt / 2 * pull(tilt);
  }
  EXPECT_NEAR(SolvedText(text).number("w"), -rate, 1e-8);
}

TEST(Landing, WithRestitutionItIsOpenWhichIsFirst) {
  const SolvedText solved(crate(1, 0.3, ", restitution: 0.5", "v: velocity(crate).x @ 1 s"));
  EXPECT_NE(solved.reason("v").find("which is struck first"), std::string::npos);
}

// What lands beside a contact that has less friction while it slides than at rest: a block that rocks.
TEST(Landing, InABlowThereIsOneCoefficient) {
  const SolvedText solved(
      "plane: [x, y]\ngiven: {b: 0.8 m, h: 0.4 m}\npoints: {O: [0, 0], E: [b, 0], G: [b/2, h/2]}\n"
      "bodies: {block: {rectangle: {center: G, sides: [[b, 0], [0, h]]}, mass: 100 kg}}\n"
      "contacts: {left: {of: block, corner: O, normal: y, friction: {static: 0.9, kinetic: 0.8}}, "
      "right: {of: block, corner: E, normal: y, friction: 0.9, open: true}}\ngravity: -y\n"
      "facts: {angular_velocity(block): 0.5 rad/s, velocity(O of block): [0, 0]}\nask: {w: angular_velocity(block) @ 1 "
      "s}\n");
  EXPECT_NE(solved.reason("w").find("there is one coefficient"), std::string::npos) << solved.reason("w");
}

}  // namespace landing_test
}  // namespace poinsot::problem
