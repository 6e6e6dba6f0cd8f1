// Derivatives that are recorded, against dual numbers and closed forms.
#include "poinsot/engine/math/trace/traced_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/math/trace/random_computation.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/trace/straight_line.h"

namespace poinsot {
namespace traced_derivative_test {

TEST(TracedDerivative, IsThatOfDualNumbers) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> size(0.2, 1.5), rate(-1, 1);
  std::size_t changing = 0;
  for (int run = 0; run < 300; ++run) {
    const random_computation::Plan plan = random_computation::random_plan(random);
    Trace trace;
    const TraceScope scope(trace);
    std::vector<Traced> inputs, rates;
    std::vector<double> at;
    std::vector<Dual<1>> dual;
    for (int k = 0; k < plan.inputs; ++k) {
      inputs.push_back(trace.input(size(random)));
      at.push_back(size(random));
      // The last input stays, and no rate says so.
      const double speed = k + 1 < plan.inputs ? rate(random) : 0;
      if (k + 1 < plan.inputs) rates.emplace_back(speed);
      dual.push_back(Dual<1>(at.back(), {speed}));
    }
    const std::vector<Traced> found = traced_derivative(trace, random_computation::computed(plan, inputs), rates);
    const std::vector<Dual<1>> expected = random_computation::computed(plan, dual);
    const StraightLine program(trace, found);
    std::vector<double> numbers(found.size());
    program.evaluate(at, numbers);
    ASSERT_EQ(expected.size(), numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      EXPECT_NEAR(numbers[k], expected[k].partial[0], 1e-7 * (1 + std::abs(expected[k].partial[0]))) << run;
      changing += static_cast<std::size_t>(expected[k].partial[0] != 0);
    }
  }
  EXPECT_GT(changing, 300U);
}

TEST(TracedDerivative, OfEveryFunction) {
  const double x = 0.3, y = 0.7;
  Trace trace;
  const TraceScope scope(trace);
  const Traced a = trace.input(x), b = trace.input(y);
  const std::vector<Traced> functions{asin(a), acos(a), atan(a),        atan2(a, b), abs(a - b),
                                      sqrt(a), sin(a),  cos(a + b) * b, a / b,       b};
  const StraightLine program(trace, traced_derivative(trace, functions, {Traced(2)}));
  std::vector<double> found(functions.size());
  program.evaluate(std::vector{x, y}, found);
  const double root = std::sqrt(1 - x * x);
  const std::vector<double> slopes{1 / root,
                                   -1 / root,
                                   1 / (1 + x * x),
                                   y / (x * x + y * y),
                                   -1,
                                   0.5 / std::sqrt(x),
                                   std::cos(x),
                                   -std::sin(x + y) * y,
                                   1 / y,
                                   0};
  for (std::size_t k = 0; k < slopes.size(); ++k) EXPECT_NEAR(found[k], 2 * slopes[k], 1e-15) << k;
}

}  // namespace traced_derivative_test
}  // namespace poinsot
