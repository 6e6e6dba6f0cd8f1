// Loads and rates that act for a short while in a long motion, against what they do in closed form.
#include "problem/course/driving.h"

#include <fmt/format.h>

#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace driving_test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double size(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

 private:
  std::mt19937_64 random_;
};

std::string pushed(const std::string& force, double lasts) {
  return fmt::format(
      "title: a particle that is pushed\npoints: {{O: [0, 0, 0]}}\nbodies: {{p: {{particle: O, mass: 2 kg}}}}\n"
      "joints: {{s: {{prismatic: x, at: O, to: p, displacement: x1}}}}\n"
      "loads: {{f: {{force: ['{}', 0, 0], body: p}}}}\ngravity: none\ninstants: {{start: {{x1: 0, \"x1'\": 0}}}}\n"
      "ask: {{v: \"x1' @ {:.17g} s\", x: \"x1 @ {:.17g} s\", m: \"max(x1')\"}}\n"
      "stages: {{all: {{lasts: {:.17g} s}}}}\n",
      force, lasts, lasts, lasts);
}

TEST(Driving, AShortPulseIsNotSteppedOver) {
  Draw draw(61);
  for (int trial = 0; trial < 30; ++trial) {
    const double lasts = 10, width = draw.size(1e-5, 0.3), at = draw.uniform(width, lasts - width);
    const SolvedText solved(
        pushed(fmt::format("100 N * max([0, 1 - abs(time - {:.17g} s)/({:.17g} s)])", at, width), lasts));
    const double v = 100 * width / 2;
    EXPECT_NEAR(solved.number("v"), v, 1e-9 * v) << at << " " << width;
    EXPECT_NEAR(solved.number("x"), v * (lasts - at), 1e-9 * v * lasts) << at << " " << width;
    EXPECT_NEAR(solved.number("m"), v, 1e-9 * v) << at << " " << width;
  }
}

TEST(Driving, ARoundPulseIsSeenByItsExtreme) {
  Draw draw(62);
  for (int trial = 0; trial < 20; ++trial) {
    const double lasts = 10, width = draw.size(1e-4, 0.3), at = draw.uniform(width, lasts - width);
    const SolvedText solved(
        pushed(fmt::format("100 N * max(0 with 1 - ((time - {:.17g} s)/({:.17g} s))^2)", at, width), lasts));
    const double v = 100 * width * 4 / 3 / 2;
    EXPECT_NEAR(solved.number("v"), v, 1e-9 * v) << at << " " << width;
  }
}

TEST(Driving, ASmoothPulseIsLookedAtMoreClosely) {
  Draw draw(63);
  for (int trial = 0; trial < 20; ++trial) {
    const double lasts = 10, width = draw.size(1e-4, 0.1), at = draw.uniform(1, lasts - 1);
    const SolvedText solved(pushed(fmt::format("100 N / (1 + ((time - {:.17g} s)/({:.17g} s))^2)", at, width), lasts));
    const double v = 50 * width * (std::atan((lasts - at) / width) + std::atan(at / width));
    EXPECT_NEAR(solved.number("v"), v, 1e-7 * v) << at << " " << width;
  }
}

TEST(Driving, ALoadIsSwitchedOff) {
  Draw draw(64);
  for (int trial = 0; trial < 10; ++trial) {
    const double lasts = 10, at = draw.uniform(0.1, lasts - 0.1);
    const SolvedText solved(
        pushed(fmt::format("100 N * (1 - (time - {0:.17g} s)/abs(time - {0:.17g} s))/2", at), lasts));
    EXPECT_NEAR(solved.number("v"), 50 * at, 1e-9 * 50 * at) << at;
    EXPECT_NEAR(solved.number("x"), 50 * at * (lasts - at / 2), 1e-9 * 50 * at * lasts) << at;
  }
}

TEST(Driving, AShortRateCarriesAsFarAsItSays) {
  Draw draw(65);
  for (int trial = 0; trial < 20; ++trial) {
    const double width = draw.size(1e-4, 0.3), at = draw.uniform(width, 10 - width);
    const SolvedText solved(fmt::format(
        "title: a slide that is driven\npoints: {{O: [0, 0, 0]}}\nbodies: {{p: {{particle: O, mass: 2 kg}}}}\n"
        "joints: {{s: {{prismatic: x, at: O, to: p, displacement: x1, rate: '3 m/s * max([0, 1 - abs(time - {:.17g} "
        "s)/({:.17g} s)])'}}}}\ngravity: none\nask: {{x: \"x1 @ 10 s\"}}\n",
        at, width));
    EXPECT_NEAR(solved.number("x"), 3 * width, 1e-9 * 3 * width) << at << " " << width;
  }
}

}  // namespace driving_test
}  // namespace poinsot::problem
