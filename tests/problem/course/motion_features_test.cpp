// Extremes, zeros and periods of numbers that are known, along motions that follow nothing.
#include "problem/course/motion_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace poinsot::problem {
namespace motion_features_test {

using std::numbers::pi;

// A motion of steps of equal length.
class EvenSteps : public FollowedMotion {
 public:
  explicit EvenSteps(std::optional<double> end, double farthest = 1e4) : end_(end), farthest_(farthest) {}
  std::vector<double> nodes(double from, double to) override {
    std::vector<double> times{from};
    for (double k = std::floor(from / step) + 1; k * step < to; ++k) times.push_back(k * step);
    times.push_back(to);
    reached_ = std::max(reached_, to);
    return times;
  }
  std::optional<double> end() override { return end_; }
  double reached() const override { return reached_; }
  double pace_time() const override { return 1; }
  double turning_time(double /*until*/) override { return turning_time_; }
  bool followed_by_many_steps(double until) const override { return until > farthest_; }
  bool followed_enough(double until) const override { return until > farthest_; }
  bool dissipates() const override { return dissipates_; }
  bool has_springs() const override { return true; }
  void dissipate() { dissipates_ = true; }
  void turn_in(double time) { turning_time_ = time; }

 private:
  static constexpr double step = 0.25;
  std::optional<double> end_;
  double farthest_, reached_ = 0, turning_time_ = 1;
  bool dissipates_ = false;
};

MotionFeatures features_of(EvenSteps& motion, std::function<double(double)> number) {
  return {motion, {std::move(number), {}, 1}, "x", "f", {1, 1}};
}

TEST(MotionFeatures, AreThoseOfASineWithoutEnd) {
  EvenSteps motion({});
  const MotionFeatures sine = features_of(motion, [](double t) { return 3 * std::sin(t + 0.4) + 1; });
  EXPECT_NEAR(sine.largest().value, 4, 1e-12);
  EXPECT_NEAR(sine.largest().time, pi / 2 - 0.4, 1e-5);
  EXPECT_NEAR(sine.smallest().value, -2, 1e-12);
  EXPECT_NEAR(sine.period(), 2 * pi, 1e-8);
}

TEST(MotionFeatures, WhatIsApproachedForEverIsALimit) {
  EvenSteps motion({});
  motion.dissipate();
  // What is followed keeps some rounding.
  const auto comes_close = [](double t) { return std::tanh(t) + 1e-13 * std::sin(40 * t); };
  const ExtremeFound last_speed = features_of(motion, comes_close).largest();
  EXPECT_NEAR(last_speed.value, 1, 1e-7);
  EXPECT_TRUE(last_speed.approached);
  const auto arrives = [](double t) { return (t < 3 ? 1 - std::pow(1 - t / 3, 4) : 1) + 1e-13 * std::sin(40 * t); };
  EXPECT_FALSE(features_of(motion, arrives).largest().approached);
  EXPECT_FALSE(features_of(motion, [](double t) { return std::sin(t); }).largest().approached);
  EXPECT_FALSE(features_of(motion, [](double t) { return std::exp(-t) * std::cos(3 * t); }).largest().approached);
}

TEST(MotionFeatures, FindZerosInTheSenseThatIsAsked) {
  EvenSteps motion(10.0);
  const MotionFeatures sine = features_of(motion, [](double t) { return std::cos(t); });
  const std::vector<double> falling = sine.zeros(0.5, 10, -1), all = sine.zeros(0.5, 10, 0);
  ASSERT_EQ(falling.size(), 2u);
  EXPECT_NEAR(falling[0], pi / 2, 1e-12);
  EXPECT_NEAR(falling[1], 5 * pi / 2, 1e-12);
  EXPECT_EQ(all.size(), 3u);
  EXPECT_NEAR(sine.zeros(0.5, {}, 0).front(), pi / 2, 1e-12);
}

// A corner has no slope that vanishes; the end of a motion counts as an extreme.
TEST(MotionFeatures, MeetCornersAndEnds) {
  EvenSteps motion(3.0);
  EXPECT_NEAR(features_of(motion, [](double t) { return 2 - std::abs(t - 1.3); }).largest().value, 2, 1e-9);
  const ExtremeFound last = features_of(motion, [](double t) { return t * t; }).largest();
  EXPECT_DOUBLE_EQ(last.value, 9);
  EXPECT_DOUBLE_EQ(last.time, 3);
}

// Turns much nearer to the beginning, to something sudden or to the end than the samples are.
TEST(MotionFeatures, TurnJustBesideSomethingSudden) {
  class Struck : public EvenSteps {
   public:
    using EvenSteps::EvenSteps;
    std::vector<double> breaks(double from, double to) override { return {from, 5, to}; }
  };
  Struck motion(10.0);
  for (const double v : {1e-2, 1e-4, 1e-6}) {
    const auto hop = [v](double t) { return v * t - 5 * t * t; };
    const double height = v * v / 20;
    const MotionFeatures first = features_of(motion, hop);
    EXPECT_NEAR(first.largest().value, height, 1e-9 * height);
    EXPECT_NEAR(first.zeros(0, {}, -1).front(), v / 5, 1e-9 * v);
    const MotionFeatures last = features_of(motion, [&](double t) { return hop(10 - t); });
    EXPECT_NEAR(last.largest().value, height, 1e-7 * height);
    const MotionFeatures middle = features_of(motion, [&](double t) { return t < 5 ? 0 : hop(t - 5); });
    EXPECT_NEAR(middle.largest().value, height, 1e-7 * height);
  }
  // What hardly changes has no turns but those of rounding.
  EXPECT_EQ(features_of(motion, [](double t) { return 5 - t * t; }).times_of_extreme(true, 0, 10).size(), 1U);
}

TEST(MotionFeatures, OfAMotionThatComesToRestAreToldFromItsBeginning) {
  EvenSteps motion({});
  motion.dissipate();
  const ExtremeFound highest = features_of(motion, [](double t) { return std::exp(-0.1 * t) * std::sin(t); }).largest();
  const double time = std::atan(10.0);
  EXPECT_NEAR(highest.value, std::exp(-0.1 * time) * std::sin(time), 1e-9);
  EXPECT_GT(highest.settled, 0);
}

// What is constant for thousands of pace times may only wait for a disturbance to grow, if the motion turns more
// slowly.
TEST(MotionFeatures, OfASlowTurningWaitForADisturbanceToGrow) {
  const auto later = [](double t) { return t < 3000 ? 8 : 6 + 2 * std::cos(0.2 * (t - 3000)); };
  EvenSteps motion({});
  EXPECT_NEAR(features_of(motion, later).smallest().value, 8, 1e-12);
  EvenSteps slow({});
  slow.turn_in(100);
  EXPECT_NEAR(features_of(slow, later).smallest().value, 4, 1e-9);
}

TEST(MotionFeatures, SayWhatDoesNotRepeatOrHappen) {
  EvenSteps motion(20.0);
  const auto message = [](const auto& ask) {
    try {
      ask();
    } catch (const UnansweredError& error) {
      return error.diagnostics().front().message;
    }
    return std::string("answered");
  };
  const MotionFeatures growing = features_of(motion, [](double t) { return t; });
  EXPECT_EQ(message([&] { growing.period(); }), "'x' does not repeat: it has no period");
  EXPECT_EQ(message([&] { growing.zeros(1, {}, 0); }), "'x' does not happen up to 20 s");
  const MotionFeatures still = features_of(motion, [](double) { return 5.0; });
  EXPECT_EQ(message([&] { still.period(); }), "'x' does not change: it has no period");
}

}  // namespace motion_features_test
}  // namespace poinsot::problem
