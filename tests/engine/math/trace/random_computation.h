// Random computations, on any scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace poinsot::random_computation {

// What a random computation does, on any scalar.
struct Plan {
  struct Step {
    int kind, first, second;
  };
  int inputs = 0;
  std::vector<Step> steps;
  std::vector<int> outputs;
};

inline Plan random_plan(std::mt19937_64& random) {
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

}  // namespace poinsot::random_computation
