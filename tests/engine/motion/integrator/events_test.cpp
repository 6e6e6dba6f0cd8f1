// Events against closed forms: times of the pendulum by elliptic integrals, several zeros in one step, grazing ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/motion/integrator/event_search.h"
#include "engine/motion/integrator/motion_examples.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {
namespace events_test {

using Numbers = std::vector<double>;

Event at_angle(double angle, Crossing crossing = Crossing::any, bool terminal = false) {
  Event event;
  event.name = "angle";
  event.value = [angle](double, std::span<const double> q, std::span<const double>) { return q[0] - angle; };
  event.crossing = crossing;
  event.terminal = terminal;
  return event;
}

// From rest at q0, w = 1: the time until the angle q is first reached is F(pi/2) - F(phi), sin phi =
// sin(q/2)/sin(q0/2).
double time_to_fall(double q0, double q) {
  const double k = std::sin(0.5 * q0);
  return boost::math::ellint_1(k) - boost::math::ellint_1(k, std::asin(std::sin(0.5 * q) / k));
}

TEST(Events, pendulum_times_are_those_of_the_elliptic_integral) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 100; ++i) {
    const double q0 = 0.2 + 2.8 * unit(random);
    const double q = q0 * (1.9 * unit(random) - 0.95);
    const double tolerance = i % 2 == 0 ? 1e-11 : 1e-7;
    IntegrationOptions options;
    options.tolerance = tolerance;
    const std::vector<Event> events{at_angle(q)};
    const double period = 4.0 * boost::math::ellint_1(std::sin(0.5 * q0));
    const double end = 2.2 * period;
    const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{q0}, Numbers{0.0}, end, options, events);
    const double first = time_to_fall(q0, q);
    Numbers expected;
    for (int turn = 0; turn < 3; ++turn) {
      expected.push_back(turn * period + first);
      expected.push_back((turn + 1) * period - first);
    }
    std::erase_if(expected, [&](double t) { return t > end; });
    ASSERT_EQ(result.hits.size(), expected.size()) << q0 << " " << q;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(result.hits[k].time, expected[k], 100.0 * tolerance * period / std::fabs(result.hits[k].v[0]));
      EXPECT_EQ(result.hits[k].direction, k % 2 == 0 ? -1 : 1);
      EXPECT_NEAR(result.hits[k].q[0], q, 1e-12);
    }
  }
}

TEST(Events, a_terminal_event_ends_the_motion_at_its_instant) {
  IntegrationOptions options;
  options.tolerance = 1e-11;
  const std::vector<Event> events{at_angle(0.5, Crossing::any), at_angle(0.1, Crossing::falling, true)};
  const IntegrationResult result = integrate(pendulum(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 50.0, options, events);
  EXPECT_EQ(result.ending, Ending::terminal_event);
  EXPECT_TRUE(result.complete());
  ASSERT_EQ(result.hits.size(), 2U);
  EXPECT_EQ(result.hits[0].event, 0U);
  EXPECT_EQ(result.hits[1].event, 1U);
  EXPECT_NEAR(result.time, time_to_fall(1.0, 0.1), 1e-10);
  EXPECT_EQ(result.time, result.hits[1].time);
  EXPECT_EQ(result.q, result.hits[1].q);
  EXPECT_NEAR(result.q[0], 0.1, 1e-10);
  EXPECT_EQ(result.trajectory.end_time(), result.time);
  EXPECT_THROW(result.trajectory.state(result.time + 0.01), std::out_of_range);
  EXPECT_NEAR(result.trajectory.state(result.time).q[0], 0.1, 1e-10);
}

TEST(Events, directions_are_told_apart) {
  const std::vector<Event> events{at_angle(0.0, Crossing::rising), at_angle(0.0, Crossing::falling)};
  const IntegrationResult result = integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, 20.0, {}, events);
  int k = 0;
  for (const EventHit& hit : result.hits) {
    EXPECT_NEAR(hit.time, (k + 0.5) * std::numbers::pi, 1e-9);
    EXPECT_EQ(hit.event, k % 2 == 0 ? 1U : 0U);
    ++k;
  }
  EXPECT_EQ(k, 6);
}

TEST(Events, an_event_that_holds_at_the_start_counts_from_when_it_has_left_zero) {
  // Thrown upwards from the floor: it comes back after 2 v/g.
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 1;
  equations.accelerations = [](double, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = -10.0;
  };
  const std::vector<Event> events{at_angle(0.0, Crossing::any, true)};
  double v = 5.0;
  double t = 0.0;
  Numbers q{0.0};
  // A ball that bounces, each time with half its speed, from the very states that the event gave.
  for (int bounce = 0; bounce < 20; ++bounce) {
    const IntegrationResult result = integrate(equations, t, q, Numbers{v}, t + 10.0, {}, events);
    ASSERT_EQ(result.ending, Ending::terminal_event) << bounce;
    ASSERT_EQ(result.hits.size(), 1U);
    EXPECT_NEAR(result.time - t, 0.2 * v, 1e-9) << bounce;
    t = result.time;
    q = result.q;
    v = -0.5 * result.v[0];
  }
  EXPECT_NEAR(t, 2.0, 1e-5);
}

TEST(Events, backwards_in_time_events_come_in_the_order_of_the_run) {
  const std::vector<Event> events{at_angle(0.0)};
  const IntegrationResult result = integrate(oscillator(1.0), 0.0, Numbers{1.0}, Numbers{0.0}, -10.0, {}, events);
  ASSERT_EQ(result.hits.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(result.hits[k].time, -(static_cast<double>(k) + 0.5) * std::numbers::pi, 1e-9);
    EXPECT_EQ(result.hits[k].direction, k % 2 == 0 ? -1 : 1);
  }
}

TEST(Events, a_fast_value_crosses_many_times_in_one_step) {
  // Uniform motion: one long step. The value is zero whenever 40 q is a multiple of pi.
  MotionEquations equations;
  equations.position_size = equations.velocity_size = 1;
  equations.accelerations = [](double, std::span<const double>, std::span<const double>, std::span<double> a) {
    a[0] = 0.0;
  };
  Event event;
  event.value = [](double, std::span<const double> q, std::span<const double>) { return std::sin(40.0 * q[0] + 0.3); };
  const std::vector<Event> events{event};
  const IntegrationResult result = integrate(equations, 0.0, Numbers{0.0}, Numbers{1.0}, 10.0, {}, events);
  EXPECT_LT(result.statistics.steps, 20);
  ASSERT_EQ(result.hits.size(), 127U);
  for (std::size_t k = 0; k < result.hits.size(); ++k)
    EXPECT_NEAR(result.hits[k].time, (static_cast<double>(k + 1) * std::numbers::pi - 0.3) / 40.0, 1e-12);
}

TEST(Events, touching_zero_is_found_where_it_is_wanted) {
  // cos t - 1 touches zero at 2 pi, 4 pi, ...; cos t - (1 - d) crosses twice there.
  for (const double d : {0.0, 1e-6, 1e-9}) {
    Event event = at_angle(1.0 - d);
    event.touching = true;
    const std::vector<Event> events{event};
    IntegrationOptions options;
    options.tolerance = 1e-12;
    const IntegrationResult result = integrate(oscillator(1.0), 0.0, Numbers{0.0}, Numbers{1.0}, 14.0, options, events);
    const double half = std::acos(1.0 - d);
    if (d == 0.0) {
      // Touched or, by the error of the integration, crossed twice at nearly the same time.
      ASSERT_GE(result.hits.size(), 2U);
      for (const EventHit& hit : result.hits)
        EXPECT_LT(std::fabs(std::remainder(hit.time - 0.5 * std::numbers::pi, 2.0 * std::numbers::pi)), 1e-5);
    } else {
      ASSERT_EQ(result.hits.size(), 4U) << d;
      EXPECT_NEAR(result.hits[0].time, 0.5 * std::numbers::pi - half, 1e-10 / half);
      EXPECT_NEAR(result.hits[1].time, 0.5 * std::numbers::pi + half, 1e-10 / half);
    }
  }
}

// All zeros of random trigonometric sums, against a dense scan.
TEST(ZeroSearchTest, finds_every_crossing_that_a_dense_scan_finds) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    Numbers amplitude(5);
    Numbers phase(5);
    for (int k = 0; k < 5; ++k) {
      amplitude[k] = unit(random);
      phase[k] = 3.0 * unit(random);
    }
    const auto value = [&](double t) {
      double sum = 0.0;
      for (int k = 0; k < 5; ++k) sum += amplitude[k] * std::cos(1.3 * k * t + phase[k]);
      return sum;
    };
    const std::vector<Zero> zeros = find_zeros({value, 0.0, 3.0, 0.0, false, 1e-9});
    Numbers scanned;
    constexpr int points = 3000;
    double last = value(0.0);
    for (int k = 1; k <= points; ++k) {
      const double now = value(3.0 * k / points);
      if (last * now < 0.0) scanned.push_back(3.0 * (k - 0.5) / points);
      last = now;
    }
    ASSERT_GE(zeros.size(), scanned.size());
    std::size_t found = 0;
    for (const double t : scanned) {
      while (found < zeros.size() && zeros[found].time < t - 0.6e-3) ++found;
      ASSERT_LT(found, zeros.size());
      EXPECT_NEAR(zeros[found].time, t, 0.6e-3);
    }
    for (const Zero& zero : zeros) {
      EXPECT_NEAR(value(zero.time), 0.0, 1e-12);
      const double slope = value(zero.time + 1e-7) - value(zero.time - 1e-7);
      if (std::fabs(slope) > 1e-9) {
        EXPECT_EQ(zero.direction, slope > 0.0 ? 1 : -1);
      }
    }
  }
}

// A value that dips below zero for a moment between two samples: both crossings, however short the dip.
TEST(ZeroSearchTest, finds_both_crossings_of_a_short_dip) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const double width : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    for (int i = 0; i < 200; ++i) {
      const double at = 0.1 + 0.8 * unit(random), fast = 1.0 + 5.0 * unit(random), bend = unit(random) - 0.5;
      // Least at `at`, and there as far below zero as it then rises within half the width.
      const auto bowl = [&](double t) {
        const double s = std::sin(0.5 * fast * (t - at));
        return s * s * (1.0 + bend * std::sin(fast * (t - at)));
      };
      const double depth = bowl(at + 0.5 * width);
      const std::vector<Zero> zeros =
          find_zeros({[&](double t) { return bowl(t) - depth; }, 0.0, 1.0, 0.0, false, 1e-12});
      std::vector<Zero> near;
      for (const Zero& zero : zeros)
        if (std::fabs(zero.time - at) < width) near.push_back(zero);
      ASSERT_EQ(near.size(), 2U) << width << " " << at << " " << fast;
      EXPECT_EQ(near[0].direction, -1);
      EXPECT_EQ(near[1].direction, 1);
      EXPECT_NEAR(near[1].time, at + 0.5 * width, 1e-3 * width);
    }
}

// Of sin: its zeros, and its extremes in the order of time's run, to the digits of the sine.
TEST(ZeroSearchTest, finds_where_corners_may_be) {
  const auto sine = [](double t) { return std::sin(t); };
  Numbers looks;
  for (int k = 0; k <= 40; ++k) looks.push_back(0.1 + 0.25 * k);
  const Numbers zeros = corners_between(sine, false, looks), extremes = corners_between(sine, true, looks);
  ASSERT_EQ(zeros.size(), 3U);
  ASSERT_EQ(extremes.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(zeros[k], (k + 1) * std::numbers::pi, 1e-14);
    EXPECT_NEAR(extremes[k], (k + 0.5) * std::numbers::pi, 1e-10);
  }
  // The square of a distance that nearly vanishes, and a peak.
  const auto near = [](double t) { return 1e-18 + (t - 1.2345678) * (t - 1.2345678); };
  EXPECT_NEAR(corners_between(near, true, looks).at(0), 1.2345678, 1e-12);
  const auto peak = [](double t) { return 3 - std::fabs(t - 1.2345678); };
  EXPECT_NEAR(corners_between(peak, true, looks).at(0), 1.2345678, 1e-7);
  std::ranges::reverse(looks);
  EXPECT_NEAR(corners_between(sine, false, looks).front(), 3 * std::numbers::pi, 1e-14);
}

// A notch of a millionth of the swing in a value that is constant beside it.
TEST(Events, a_notch_between_corners_is_not_stepped_over) {
  const double q0 = 1.2;
  for (const double c : {0.9, 0.31, -0.123, -0.777}) {
    constexpr double near = 1e-6, flat = 0.01;
    Event notch = at_angle(0);
    notch.value = [=](double, std::span<const double> q, std::span<const double>) {
      return std::min(std::fabs(q[0] - c), flat) - near;
    };
    const auto off = [=](double, std::span<const double> q, std::span<const double>) { return q[0] - c; };
    const auto beside = [=](double, std::span<const double> q, std::span<const double>) {
      return std::fabs(q[0] - c) - flat;
    };
    notch.corners = {{off, false}, {beside, false}};
    notch.crossing = Crossing::falling;
    const std::vector<Event> events{notch};
    const IntegrationResult result =
        integrate(pendulum(1.0), 0.0, Numbers{q0}, Numbers{0.0}, 3.0, IntegrationOptions{}, events);
    ASSERT_FALSE(result.hits.empty()) << c;
    EXPECT_NEAR(result.hits[0].time, time_to_fall(q0, c + near), 1e-8) << c;
  }
}

TEST(ZeroSearchTest, a_zero_at_the_end_counts_and_one_at_the_start_does_not) {
  const auto line = [](double t) { return t - 1.0; };
  EXPECT_EQ(find_zeros({line, 0.0, 1.0, 0.0, false, 1e-9}).size(), 1U);
  EXPECT_EQ(find_zeros({line, 1.0, 2.0, 0.0, true, 1e-9}).size(), 0U);
  EXPECT_EQ(find_zeros({line, 2.0, 3.0, 0.0, false, 1e-9}).size(), 0U);
  const std::vector<Zero> both = find_zeros({[](double t) { return t * (t - 0.5); }, 0.0, 1.0, 0.0, true, 1e-9});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_NEAR(both[0].time, 0.5, 1e-15);
}

TEST(ZeroSearchTest, touching) {
  const auto parabola = [](double t) { return (t - 0.3) * (t - 0.3); };
  EXPECT_TRUE(find_zeros({parabola, 0.0, 1.0, 0.0, false, 1e-9}).empty());
  const std::vector<Zero> touch = find_zeros({parabola, 0.0, 1.0, 1e-12, false, 1e-9});
  ASSERT_EQ(touch.size(), 1U);
  EXPECT_NEAR(touch[0].time, 0.3, 1e-6);
  EXPECT_EQ(touch[0].direction, 0);
}

}  // namespace events_test
}  // namespace poinsot
