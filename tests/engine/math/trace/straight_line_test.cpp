// Straight-line programs: made short, they compute what was traced.
#include "poinsot/engine/math/trace/straight_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "engine/math/formula/residue.h"
#include "engine/math/trace/random_computation.h"

namespace poinsot {
namespace straight_line_test {

using random_computation::computed, random_computation::Plan, random_computation::random_plan;

TEST(StraightLine, ComputesWhatWasTraced) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> size(0.2, 1.5);
  for (int run = 0; run < 600; ++run) {
    const Plan plan = random_plan(random);
    Trace trace;
    const TraceScope scope(trace);
    std::vector<Traced> inputs;
    for (int k = 0; k < plan.inputs; ++k) inputs.push_back(trace.input(size(random)));
    const std::vector<Traced> outputs = computed(plan, inputs);
    const bool quick = run % 2 == 0;
    const StraightLine program(trace, outputs,
                               quick ? StraightLine::Shortening::quick : StraightLine::Shortening::thorough);
    for (int k = 0; k < 5; ++k) {
      std::vector<double> at;
      for (int i = 0; i < plan.inputs; ++i) at.push_back(size(random));
      const std::vector<double> expected = computed(plan, at);
      std::vector<double> found(expected.size());
      program.evaluate(at, found);
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-7 * (1 + std::abs(expected[i]))) << run;
    }
  }
}

// Traces a computation of some inputs and counts what is left of it.
std::size_t operations_of(int inputs, const std::function<std::vector<Traced>(const std::vector<Traced>&)>& compute,
                          StraightLine::Shortening shortening = StraightLine::Shortening::thorough) {
  Trace trace;
  const TraceScope scope(trace);
  std::vector<Traced> x;
  for (int k = 0; k < inputs; ++k) x.push_back(trace.input(0.3 + 0.21 * k));
  return StraightLine(trace, compute(x), shortening).operations();
}

TEST(StraightLine, FindsShorterWays) {
  // (a sin)^2 + (a cos)^2 = a^2, where a^2 is computed nowhere else.
  EXPECT_EQ(operations_of(2,
                          [](const std::vector<Traced>& x) {
                            const Traced s = x[0] * sin(x[1]), c = x[0] * cos(x[1]);
                            return std::vector<Traced>{s * s + c * c};
                          }),
            1U);
  // A rotation to and fro.
  EXPECT_EQ(operations_of(3,
                          [](const std::vector<Traced>& x) {
                            const Traced s = sin(x[0]), c = cos(x[0]);
                            const Traced u = c * x[1] - s * x[2], v = s * x[1] + c * x[2];
                            return std::vector<Traced>{c * (u * u + v * v) + s};
                          }),
            7U);
  // a c + a d + b c + b d
  EXPECT_EQ(operations_of(4,
                          [](const std::vector<Traced>& x) {
                            return std::vector<Traced>{x[0] * x[2] + x[0] * x[3] + x[1] * x[2] + x[1] * x[3]};
                          }),
            3U);
}

// By two operations at most, once; or by more.
TEST(StraightLine, FindsLessWhenItIsQuick) {
  using Shortening = StraightLine::Shortening;
  // (x s + y c)^2 + (x c - y s)^2 + z is x^2 + y^2 + z: five operations of two squares.
  const auto turned = [](const std::vector<Traced>& x) {
    const Traced s = sin(x[3]), c = cos(x[3]);
    const Traced u = x[0] * s + x[1] * c, v = x[0] * c - x[1] * s;
    return std::vector<Traced>{u * u + v * v + x[2]};
  };
  EXPECT_EQ(operations_of(4, turned, Shortening::thorough), 4U);
  EXPECT_GT(operations_of(4, turned, Shortening::quick), 4U);
  // Where roots leave the smaller field: (r s)^2 + (r c)^2 with r = sqrt(x - y).
  const auto roots = [](const std::vector<Traced>& x) {
    const Traced r = sqrt(x[1] - x[0]), s = r * sin(x[2]), c = r * cos(x[2]);
    return std::vector<Traced>{s * s + c * c};
  };
  for (const Shortening shortening : {Shortening::quick, Shortening::thorough})
    EXPECT_EQ(operations_of(3, roots, shortening), 1U);
}

TEST(Residue, HashesAlikeWithEitherSign) {
  using symbolic::Residue;
  int vanish_at_one = 0;
  for (std::uint64_t i = 0; i < 20; ++i)
    for (std::uint64_t j = 0; j < 20; ++j) {
      const Residue x = Residue::random(i), y = Residue::random(100 + j);
      const Residue sum = *square_root(x) * *square_root(y) + *square_root(x * y);
      const Residue difference = *square_root(x) * *square_root(y) - *square_root(x * y);
      for (const Residue& r : {x, sum, difference}) {
        EXPECT_EQ(r.hash_up_to_sign(), (-r).hash_up_to_sign());
        vanish_at_one += !r.is_zero() && !r.is_unit();
      }
    }
  EXPECT_GT(vanish_at_one, 0);
}

// Two products of roots that are opposite in the field and alike at the sample do not cancel.
TEST(StraightLine, OppositeResiduesOfEqualValuesDoNotCancel) {
  for (int first = 0; first < 6; ++first)
    for (int second = 0; second < 6; ++second) {
      if (first == second) continue;
      Trace trace;
      const TraceScope scope(trace);
      std::vector<Traced> x;
      for (int k = 0; k < 6; ++k) x.push_back(trace.input(k % 2 == 0 ? 0.4 + 0.1 * k : -0.4 - 0.1 * k));
      const auto positive = [&](int k) {
        return k % 2 == 0 ? x[static_cast<std::size_t>(k)] : -x[static_cast<std::size_t>(k)];
      };
      const Traced a = positive(first), b = positive(second);
      const Traced whole = sqrt(a * b), parts = sqrt(a) * sqrt(b);
      const double expected = 2 * std::sqrt(plain(a) * plain(b));
      EXPECT_NEAR(plain(whole + parts), expected, 1e-12) << first << ' ' << second;
      EXPECT_NEAR(plain(parts + whole), expected, 1e-12) << first << ' ' << second;
    }
}

// The field knows roots up to their sign only.
TEST(StraightLine, TakesNoRootForItsNegative) {
  for (const double sign : {1.0, -1.0}) {
    Trace trace;
    const TraceScope scope(trace);
    const Traced x = trace.input(0.7 * sign), y = trace.input(0.4);
    const Traced size = sign > 0 ? x : -x;
    const std::vector<Traced> outputs{sqrt(x * x) * y + x, sqrt(x * x * y * y), sqrt(size * y) * sqrt(size) * sqrt(y),
                                      sqrt(size) * sqrt(y) + sqrt(size * y), sqrt(size) * sqrt(y) - x};
    const StraightLine program(trace, outputs);
    std::vector<double> found(outputs.size());
    for (const auto& [a, b] : {std::pair{0.9, 0.6}, {0.1, 2.0}, {3.0, 0.2}}) {
      program.evaluate(std::vector<double>{sign * a, b}, found);
      EXPECT_NEAR(found[0], a * b + sign * a, 1e-14);
      EXPECT_NEAR(found[1], a * b, 1e-14);
      EXPECT_NEAR(found[2], a * b, 1e-14);
      EXPECT_NEAR(found[3], 2 * std::sqrt(a * b), 1e-14);
      EXPECT_NEAR(found[4], std::sqrt(a * b) - sign * a, 1e-14);
    }
  }
}

}  // namespace straight_line_test
}  // namespace poinsot
