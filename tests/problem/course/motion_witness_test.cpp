// The second roads to motions confirm what is right and see faults that are planted.
#include "problem/course/motion_witness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace motion_witness_test {

// A swing q = sin(n t) with its rates. The faults are small, each of another kind.
struct Faults {
  double of_velocity = 0, of_rate = 0, of_acceleration = 0, jump = 0;
};
std::optional<WitnessedState> swing(double n, double time, const Faults& faults = {}) {
  const double q = std::sin(n * time) + (time > 0.1 ? faults.jump : 0), v = n * std::cos(n * time);
  return WitnessedState{{q},
                        {v * (1 + faults.of_velocity)},
                        {v * (1 + faults.of_rate)},
                        {-n * n * std::sin(n * time) * (1 + faults.of_acceleration)},
                        {true}};
}

double misfit(double n, double from, double to, const Faults& faults = {}) {
  return window_misfit([&](double time) { return swing(n, time, faults); }, from, to, {{1}, {1}}).value();
}

TEST(MotionWitness, confirms_a_motion_at_any_pace_and_sees_each_fault) {
  int tried = 0;
  for (const double n : {1e-6, 0.3, 7.0, 1e5}) {
    const double from = 0.05 / n, to = 0.35 / n;
    EXPECT_LT(misfit(n, from, to), 1e-10) << n;
    for (const double size : {1e-6, 1e-2, -1e-2}) {
      EXPECT_GT(misfit(n, from, to, {.of_rate = size}), 0.5 * std::abs(size)) << n;
      EXPECT_GT(misfit(n, from, to, {.of_velocity = size}), 0.5 * std::abs(size)) << n;
      EXPECT_GT(misfit(n, from, to, {.of_acceleration = size}), 0.5 * std::abs(size)) << n;
      ++tried;
    }
  }
  EXPECT_GT(misfit(1, 0.05, 0.35, {.jump = 1e-6}), 1e-6);
  EXPECT_EQ(tried, 12);
}

TEST(MotionWitness, a_velocity_that_moves_no_mass_has_no_rate_to_confirm) {
  const auto open = [](double time) {
    std::optional<WitnessedState> state = swing(2, time);
    state->v_rate = {17};
    state->rate_known = {false};
    return state;
  };
  EXPECT_LT(window_misfit(open, 0.1, 0.2, {{1}, {1}}).value(), 1e-10);
  EXPECT_FALSE(window_misfit([](double) { return std::optional<WitnessedState>(); }, 0, 1, {{1}, {1}}));
}

TEST(MotionWitness, looks_that_end_early_are_spread_over_all) {
  for (const std::size_t count : {5U, 24U, 100U}) {
    const std::vector<std::size_t> order = spread_order(count);
    std::vector<bool> seen(count), early(3);
    for (const std::size_t k : order) seen.at(k) = true;
    EXPECT_EQ(std::ranges::count(seen, true), static_cast<long>(count));
    for (std::size_t i = 0; i < 4; ++i) early[3 * order[i] / count] = true;
    EXPECT_EQ(std::ranges::count(early, true), 3) << count;
  }
}

const double turn = 2 * std::numbers::pi;
const std::function<double(double)> waves = [](double t) { return std::sin(t) + 0.3 * std::sin(2 * t + 1); };

// By a fine grid of its own.
ExtremeFound outermost_wave(bool largest) {
  ExtremeFound best{waves(0), 0};
  for (int i = 0; i <= 4'000'000; ++i)
    if (const double t = turn * i / 4e6; largest ? waves(t) > best.value : waves(t) < best.value) best = {waves(t), t};
  return best;
}

TEST(MotionWitness, extremes_are_taken_and_nowhere_exceeded) {
  const MotionScan scan(waves, 0, 3 * turn, 200);
  for (const bool largest : {true, false}) {
    const ExtremeFound right = outermost_wave(largest);
    EXPECT_LT(scan.of_extreme(right, largest).value, 1e-9);
    // A value that is exceeded elsewhere, one that is not taken, and the other extreme.
    const double sign = largest ? 1 : -1;
    EXPECT_GT(scan.of_extreme({waves(right.time + 0.5), right.time + 0.5}, largest).value, 0.02);
    EXPECT_GT(scan.of_extreme({right.value + sign * 1e-4, right.time}, largest).value, 1e-5);
    EXPECT_GT(scan.of_extreme(outermost_wave(!largest), largest).value, 0.9);
  }
}

TEST(MotionWitness, times_are_zeros_and_none_is_missed) {
  const std::function<double(double)> sine = [](double t) { return std::sin(t) + 1e-15; };
  const MotionScan scan(sine, 0.1, 2.9 * turn, 100);
  const auto all = [&](int sense) {
    std::vector<double> times;
    for (int k = 1; k <= 5; ++k)
      if (sense == 0 || (sense > 0) == (k % 2 == 0)) times.push_back(k * turn / 2);
    return times;
  };
  for (const int sense : {-1, 0, 1}) {
    const std::vector<double> right = all(sense);
    EXPECT_LT(scan.of_zeros(right, sense).value, 1e-12) << sense;
    for (std::size_t left_out = 0; left_out < right.size(); ++left_out) {
      std::vector<double> fewer = right;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
      EXPECT_GT(scan.of_zeros(fewer, sense).value, 1e-4) << sense << " without " << left_out;
      std::vector<double> moved = right;
      moved[left_out] += 1e-4;
      EXPECT_GT(scan.of_zeros(moved, sense).value, 1e-5) << sense << " moved " << left_out;
    }
  }
  // Of a first time the looks end there: it is wrong if another comes before.
  EXPECT_GT(MotionScan(sine, 0.1, turn, 60).of_zeros({turn}, 0).value, 1e-3);
}

TEST(MotionWitness, a_number_that_jumps_through_zero_is_zero_there) {
  const std::function<double(double)> lost = [](double t) { return t < 1 ? 5 - t : -1.0; };
  const MotionScan scan(lost, 0, 3, 60);
  EXPECT_LT(scan.of_zeros({1}, 0).value, 1e-12);
  EXPECT_GT(scan.of_zeros({}, 0).value, 0.1);
  EXPECT_GT(scan.of_zeros({0.5, 1}, 0).value, 0.1);
}

TEST(MotionWitness, a_period_is_the_least_after_which_all_returns) {
  const MotionScan scan(waves, 0, 6 * turn, 100);
  EXPECT_LT(scan.of_period(turn).value, 1e-12);
  for (const double wrong : {2 * turn, 3 * turn, 0.5 * turn, 1.0001 * turn})
    EXPECT_GT(scan.of_period(wrong).value, 1e-5) << wrong;
}

TEST(MotionWitness, what_has_no_value_at_some_times_is_held_at_the_others) {
  const std::function<double(double)> beside = [](double t) {
    if (t > 2 && t < 3) throw UnansweredError("", Mark{1, 1}, "no value", "");
    return waves(t);
  };
  const ExtremeFound right = outermost_wave(true);
  ASSERT_FALSE(right.time > 2 && right.time < 3);
  EXPECT_LT(MotionScan(beside, 0, turn, 100).of_extreme(right, true).value, 1e-9);
  EXPECT_GT(MotionScan(beside, 0, turn, 100).of_extreme({right.value - 0.1, right.time}, true).value, 0.01);
}

// What has come nearly to rest is measured by a thousandth of its first pace, so that a fault is seen long before: in a
// swing that has died out to a hundredth, a wrong rate is still a large part of what it makes.
TEST(MotionWitness, a_fault_is_seen_in_what_has_become_slow) {
  const auto dying = [](double fault) {
    return [fault](double t) {
      const double x = std::exp(-t);
      return std::optional(WitnessedState{{x}, {-x}, {-x}, {(1 + fault) * x}, {true}});
    };
  };
  const NaturalSizes sizes{{1}, {1}, 1};
  const double late = std::log(100.0);
  EXPECT_LT(window_misfit(dying(0), late, late + 0.3, sizes).value(), 1e-9);
  EXPECT_GT(window_misfit(dying(1e-3), late, late + 0.3, sizes).value(), 1e-4);
  EXPECT_GT(window_misfit(dying(1e-3), 0, 0.3, sizes).value(), 1e-4);
}

// A contact whose push falls to zero at one second, in a motion that lets go of it at some time or other.
MotionDoubt doubt_of_release(double told, const std::vector<bool>& then) {
  const std::vector<HeldStretch> stretches{{{true, true}, 0.1, told}, {then, 0.2, told + 1}};
  const auto doubt = doubt_before_giving_way(stretches, [](double time) {
    return std::optional(time > 1 ? MotionDoubt{1, "the contact would have to pull"} : MotionDoubt{});
  });
  return doubt.value_or(MotionDoubt{-1, "nothing gave way"});
}

TEST(MotionWitness, what_gives_way_pushes_until_it_does) {
  EXPECT_EQ(doubt_of_release(1, {true, false}).value, 0);
  EXPECT_EQ(doubt_of_release(0.9, {true, false}).value, 0);
  // Told too late by less than a hundredth of a step.
  EXPECT_EQ(doubt_of_release(1.001, {true, false}).value, 1);
  EXPECT_EQ(doubt_of_release(1.001, {false, true}).words, "the contact would have to pull");
  // What goes on acting is looked at elsewhere.
  EXPECT_EQ(doubt_of_release(1.001, {true, true}).value, -1);
  // An instant without state says nothing.
  EXPECT_FALSE(doubt_before_giving_way({{{true}, 0.1, 1}, {{false}, 0.1, 2}}, [](double) { return std::nullopt; }));
}

// Motions of all kinds are confirmed: followed in steps and in closed form.
TEST(MotionWitness, confirms_motions_of_all_kinds) {
  const std::vector<std::string> motions{// A double pendulum.
                                         R"(
points: {O: [0, 0, 0], A: [0.8 m, 0, 0], B: [1.5 m, 0.1 m, 0]}
bodies: {upper: {rod: [O, A], mass: 3 kg}, lower: {rod: [A, B], mass: 1 kg}}
joints:
  first: {revolute: z, at: O, to: upper, angle: a}
  second: {revolute: z, at: A, from: upper, to: lower, angle: b}
gravity: -y
instants: {start: {a: 20 deg, b: -30 deg, a': 1 rad/s, b': 0}}
stages: {run: {lasts: 4 s}}
ask: {high: max(a), low: 'min(reaction(first).y)', zeros: {times: a == 0, from: 0 s, to: 4 s}, then: b @ 3 s}
)",
                                         // A top with its period.
                                         R"(
points: {O: [0, 0, 0], G: [0, 0, 0.1 m]}
bodies: {top: {cylinder: {center: G, axis: z, radius: 60 mm, length: 40 mm}, mass: 0.5 kg}}
joints: {tip: {ball: O, to: top}}
gravity: -z
instants: {start: {'angular_velocity(top)': [0.5 rad/s, 0, 200 rad/s]}}
ask: {low: 'min(angular_velocity(top).z)', there: 'velocity(G of top) @ 0.7 s'}
)"};
  for (const std::string& text : motions) {
    SCOPED_TRACE(text);
    try {
      const SolvedText solved(text);
      const auto& checks = solved.solved().solutions.at(0).checks;
      for (const SolvedAsk& ask : solved.solved().solutions.at(0).asks)
        EXPECT_EQ(ask.state, AskState::found) << ask.reason;
      ASSERT_TRUE(checks.contains("course"));
      ASSERT_TRUE(checks.contains("scan"));
      EXPECT_LT(checks.at("course"), 2e-9);
      EXPECT_LT(checks.at("scan"), 2e-9);
    } catch (const StatementError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

}  // namespace motion_witness_test
}  // namespace poinsot::problem
