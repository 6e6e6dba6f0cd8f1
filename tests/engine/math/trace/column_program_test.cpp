// Straight-line programs for many cases compute each as if it were alone.
#include "poinsot/engine/math/trace/column_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

#include "engine/math/trace/random_computation.h"

namespace poinsot {
namespace column_program_test {

using Columns = std::vector<std::vector<double>>;

// The outputs of rows [first, last) of the inputs.
Columns evaluated(const ColumnProgram& program, const Columns& inputs, std::size_t first, std::size_t last) {
  std::vector<const double*> from;
  for (const std::vector<double>& column : inputs) from.push_back(column.data() + first);
  Columns outputs(program.output_count(), std::vector<double>(last - first));
  std::vector<double*> to;
  for (std::vector<double>& column : outputs) to.push_back(column.data());
  program.evaluate(from, last - first, to);
  return outputs;
}

TEST(ColumnProgram, ComputesEachCaseAsIfItWereAlone) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> size(0.2, 1.5);
  std::size_t compared = 0;
  for (int run = 0; run < 300; ++run) {
    const random_computation::Plan plan = random_computation::random_plan(random);
    Trace trace;
    const TraceScope scope(trace);
    std::vector<Traced> traced;
    for (int k = 0; k < plan.inputs; ++k) traced.push_back(trace.input(size(random)));
    const ColumnProgram program(StraightLine(trace, random_computation::computed(plan, traced)));
    const std::size_t rows = std::uniform_int_distribution<std::size_t>(1, 400)(random);
    Columns inputs(traced.size(), std::vector<double>(rows));
    for (std::vector<double>& column : inputs)
      for (double& number : column) number = size(random);

    const Columns all = evaluated(program, inputs, 0, rows);
    for (std::size_t row = 0; row < rows; row += 7) {
      std::vector<double> at;
      for (const std::vector<double>& column : inputs) at.push_back(column[row]);
      const std::vector<double> expected = random_computation::computed(plan, at);
      const Columns alone = evaluated(program, inputs, row, row + 1);
      for (std::size_t k = 0; k < expected.size(); ++k, ++compared) {
        EXPECT_NEAR(all[k][row], expected[k], 1e-7 * (1 + std::abs(expected[k]))) << run;
        EXPECT_EQ(std::memcmp(&all[k][row], &alone[k][0], sizeof(double)), 0) << "other bits alone, in run " << run;
      }
    }
  }
  EXPECT_GT(compared, 10'000U);
}

// Every function and every sign, one at a time, at numbers beyond the kernel of sines too.
TEST(ColumnProgram, EveryFunction) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced x = trace.input(0.3), y = trace.input(0.4);
  const ColumnProgram program(StraightLine(
      trace, {x + y, x - y, -x - y, x * y, -(x * y), x / y, -x / y, sqrt(x * x + 1), sin(x), cos(y), asin(sin(x) / 2),
              acos(-cos(y)), atan(-x), atan2(x, -y), abs(x - y), -x, Traced(2), sqrt(y)}));
  const Columns inputs{{0.3, -2.5, 1e7, -0.0}, {0.4, 7, -3e8, 2}};
  const Columns found = evaluated(program, inputs, 0, 4);
  for (std::size_t row = 0; row < 4; ++row) {
    const double a = inputs[0][row], b = inputs[1][row];
    const std::vector<double> expected{a + b,
                                       a - b,
                                       -a - b,
                                       a * b,
                                       -(a * b),
                                       a / b,
                                       -a / b,
                                       std::sqrt(a * a + 1),
                                       std::sin(a),
                                       std::cos(b),
                                       std::asin(std::sin(a) / 2),
                                       std::acos(-std::cos(b)),
                                       std::atan(-a),
                                       std::atan2(a, -b),
                                       std::abs(a - b),
                                       -a,
                                       2,
                                       std::sqrt(b)};
    for (std::size_t k = 0; k < expected.size(); ++k)
      if (std::isnan(expected[k]))
        EXPECT_TRUE(std::isnan(found[k][row])) << k;
      else
        EXPECT_NEAR(found[k][row], expected[k], 4e-16 * (1 + std::abs(expected[k]))) << k << " at " << row;
  }
}

// A case is valid where all results are finite and all conditions positive, for every number of these and of cases.
TEST(ColumnProgram, TellsWhichCasesAreValid) {
  std::mt19937_64 random(9);
  const double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> kinds{0.3, 1.2, -0.7, 0, -0.0, infinity, -infinity, none, 1e300, 1e-310};
  std::size_t valid_cases = 0, others = 0;
  for (int run = 0; run < 200; ++run) {
    Trace trace;
    const TraceScope scope(trace);
    const Traced x = trace.input(0.3), y = trace.input(0.4);
    const std::vector<Traced> numbers{x * y, x / y, sqrt(x), -x, Traced(2), x - y, y, -(x * x), sqrt(y) + x};
    std::vector<Traced> outputs;
    auto several = std::uniform_int_distribution<std::size_t>(0, 4);
    const std::size_t results = several(random), conditions = several(random);
    for (std::size_t k = 0; k < results + conditions; ++k)
      outputs.push_back(numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random)]);
    const ColumnProgram program(StraightLine(trace, outputs));
    const std::size_t rows = std::uniform_int_distribution<std::size_t>(1, 300)(random);
    Columns inputs(program.input_count(), std::vector<double>(rows));
    for (std::vector<double>& column : inputs)
      for (double& number : column) {
        const std::size_t kind = std::uniform_int_distribution<std::size_t>(0, 4 * kinds.size())(random);
        number = kind < kinds.size() ? kinds[kind] : std::uniform_real_distribution<double>(0.1, 2)(random);
      }
    const Columns expected = evaluated(program, inputs, 0, rows);
    Columns found(results, std::vector<double>(rows));
    std::vector<const double*> from;
    for (const std::vector<double>& column : inputs) from.push_back(column.data());
    std::vector<double*> to;
    for (std::vector<double>& column : found) to.push_back(column.data());
    const std::vector<char> valid = program.evaluate_where_valid(from, rows, to);
    ASSERT_EQ(valid.size(), rows);
    for (std::size_t row = 0; row < rows; ++row) {
      bool holds = true;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        holds = holds && (k < results ? std::isfinite(expected[k][row]) : expected[k][row] > 0);
        if (k < results) {
          EXPECT_EQ(std::memcmp(&found[k][row], &expected[k][row], sizeof(double)), 0) << run;
        }
      }
      EXPECT_EQ(valid[row] != 0, holds) << run << ", case " << row;
      (holds ? valid_cases : others) += 1;
    }
  }
  EXPECT_GT(valid_cases, 1000U);
  EXPECT_GT(others, 1000U);
}

TEST(ColumnProgram, ColumnsThatDoNotFitAreRefused) {
  Trace trace;
  const TraceScope scope(trace);
  const Traced x = trace.input(1);
  const ColumnProgram program(StraightLine(trace, {x * x}));
  EXPECT_THROW(program.evaluate({}, 3, {}), std::invalid_argument);
  EXPECT_THROW(program.evaluate_where_valid({}, 3, {}), std::invalid_argument);
}

}  // namespace column_program_test
}  // namespace poinsot
