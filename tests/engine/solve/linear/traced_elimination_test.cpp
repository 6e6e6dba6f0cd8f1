// Eliminations that are recorded, against the solution of each system by itself.
#include "poinsot/engine/solve/linear/traced_elimination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "poinsot/engine/math/trace/straight_line.h"
#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::solve {
namespace traced_elimination_test {

Traced nothing_is_open(std::size_t) { throw std::logic_error("something is open"); }

std::vector<double> evaluated(const Trace& trace, const std::vector<Traced>& outputs, const std::vector<double>& at) {
  std::vector<double> numbers(outputs.size());
  StraightLine(trace, outputs).evaluate(at, numbers);
  return numbers;
}

// Random sparse equations with entries of many sizes, each an input of the trace.
TEST(TracedElimination, SolvesOtherSystemsOfTheFamily) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> entry(0.5, 1.5), part(0, 1);
  for (int run = 0; run < 60; ++run) {
    const std::size_t n = std::uniform_int_distribution<std::size_t>(1, 9)(random);
    Trace trace;
    const TraceScope scope(trace);
    std::vector<double> at;
    const auto number = [&](double sample, double there) {
      at.push_back(there);
      return trace.input(sample);
    };
    std::vector<TracedEquation> equations(n);
    LinearSystem system;
    for (std::size_t k = 0; k < n; ++k) system.add_unknown("x");
    for (std::size_t i = 0; i < n; ++i) {
      const double row = std::pow(10, std::floor(8 * part(random)) - 4);
      system.add_equation("e", row);
      for (std::size_t k = 0; k < n; ++k) {
        if (k != i && part(random) < 0.5) continue;
        const double size = row * (k == i ? 5 : 1), there = size * entry(random);
        equations[i].coefficients[k] = number(size * entry(random), there);
        system.add(i, k, there);
      }
      const double right_side = row * entry(random);
      equations[i].right_side = number(row, right_side);
      system.add_right_side(i, right_side);
    }
    const TracedSolution found = eliminated(equations, n, nothing_is_open);
    EXPECT_TRUE(found.remainders.empty());
    const std::vector<double> expected = system.solve().value, values = evaluated(trace, found.value, at);
    double size = 0;
    for (const double x : expected) size = std::max(size, std::abs(x));
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(values[k], expected[k], 1e-11 * size) << run;
    for (const double sound : evaluated(trace, found.sound, at)) EXPECT_GT(sound, 0) << run;
  }
}

// a x + y = 1, x + y = b, which determine nothing where a is 1; and their sum, which follows from them.
TEST(TracedElimination, TellsWhereItsPivotsVanish) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(3), b = trace.input(2), c = trace.input(3);
  const TracedSolution found = eliminated({{{{0, a}, {1, Traced(1)}}, Traced(1)},
                                           {{{0, Traced(1)}, {1, Traced(1)}}, b},
                                           {{{0, a + Traced(1)}, {1, Traced(2)}}, c}},
                                          2, nothing_is_open);
  ASSERT_FALSE(found.sound.empty());
  const auto least = [&](double there) {
    const std::vector<double> sound = evaluated(trace, found.sound, {there, 2, 3});
    return *std::min_element(sound.begin(), sound.end());
  };
  EXPECT_GT(least(3), 0);
  EXPECT_GT(least(1.001), 0);
  EXPECT_LE(least(1), 0);
  EXPECT_LE(least(1 + 1e-12), 0);
  // The third equation holds if c is 1 + b.
  ASSERT_EQ(found.remainders.size(), 1U);
  EXPECT_NEAR(evaluated(trace, found.remainders, {4, 2.5, 3.5})[0], 0, 1e-15);
  EXPECT_GT(std::abs(evaluated(trace, found.remainders, {4, 2.5, 3.6})[0]), 0.01);
}

// x + a y = 1 leaves one of them open: it gets the value that is asked for.
TEST(TracedElimination, LeavesOpenWhatNothingDetermines) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(0.01), t = trace.input(1);
  std::vector<std::size_t> open;
  const TracedSolution found = eliminated({{{{0, Traced(1)}, {1, a}}, Traced(1)}}, 2, [&](std::size_t k) {
    open.push_back(k);
    return t;
  });
  ASSERT_EQ(open.size(), 1U);
  const std::vector<double> values = evaluated(trace, found.value, {0.02, 5});
  EXPECT_NEAR(values[0] + 0.02 * values[1], 1, 1e-15);
  EXPECT_EQ(values[open[0]], 5);
  // Two equations that are one at the sample alone.
  const Traced b = trace.input(2);
  EXPECT_THROW(eliminated({{{{0, Traced(1)}, {1, b}}, Traced(1)}, {{{0, Traced(1)}, {1, Traced(2)}}, Traced(1)}}, 2,
                          [&](std::size_t) { return t; }),
               std::domain_error);
}

}  // namespace traced_elimination_test
}  // namespace poinsot::solve
