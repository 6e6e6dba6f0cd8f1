// Straight-line programs: made short, they compute what was traced.
#include "poinsot/math/straight_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace poinsot {
namespace {

// What a random computation does, on any scalar.
struct Plan {
  struct Step {
    int kind, first, second;
  };
  int inputs = 0;
  std::vector<Step> steps;
  std::vector<int> outputs;
};

Plan random_plan(std::mt19937_64& random) {
  const auto among = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  Plan plan;
  plan.inputs = among(2, 5);
  const int count = among(5, 40);
  for (int i = 0; i < count; ++i) {
    const int known = plan.inputs + i;
    plan.steps.push_back({among(0, 11), among(0, known - 1), among(std::max(0, known - 8), known - 1)});
  }
  for (int k = among(1, 4); k > 0; --k) plan.outputs.push_back(among(plan.inputs, plan.inputs + count - 1));
  return plan;
}

template <class Scalar>
std::vector<Scalar> computed(const Plan& plan, std::vector<Scalar> values) {
  using std::cos, std::sin, std::sqrt;
  for (const Plan::Step& step : plan.steps) {
    const Scalar x = values[static_cast<std::size_t>(step.first)], y = values[static_cast<std::size_t>(step.second)];
    switch (step.kind) {
      case 0:
      case 1:
        values.push_back(x + y);
        break;
      case 2:
      case 3:
        values.push_back(x - y);
        break;
      case 4:
      case 5:
      case 6:
        values.push_back(x * y);
        break;
      case 7:
        values.push_back(sin(x));
        break;
      case 8:
        values.push_back(cos(x));
        break;
      case 9:
        values.push_back(sin(x) * y * sin(x) + cos(x) * cos(x) * y);
        break;
      case 10:
        values.push_back(x / (Scalar(2) + y * y));
        break;
      default:
        values.push_back(sqrt(x * x + Scalar(1)));
    }
  }
  std::vector<Scalar> outputs;
  for (const int output : plan.outputs) outputs.push_back(values[static_cast<std::size_t>(output)]);
  return outputs;
}

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
std::size_t operations_of(int inputs, const std::function<std::vector<Traced>(const std::vector<Traced>&)>& compute) {
  Trace trace;
  const TraceScope scope(trace);
  std::vector<Traced> x;
  for (int k = 0; k < inputs; ++k) x.push_back(trace.input(0.3 + 0.21 * k));
  return StraightLine(trace, compute(x)).operations();
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

}  // namespace
}  // namespace poinsot
