// Root problems from plain functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// The size of the terms of a function is that of its value, at least one.
inline RootEquations equations_from(std::vector<double> values) {
  RootEquations equations;
  equations.size = 1;
  for (double value : values) equations.size = std::max(equations.size, std::abs(value));
  equations.values = std::move(values);
  return equations;
}

inline RootProblem of_one(double lower, double upper, std::function<double(double)> f) {
  RootProblem problem;
  problem.ranges = {{lower, upper, 1}};
  problem.equations = [f = std::move(f)](const std::vector<double>& x) { return equations_from({f(x[0])}); };
  return problem;
}

inline RootProblem of_two(const RootRange& first, const RootRange& second,
                          std::function<std::vector<double>(double, double)> f) {
  RootProblem problem;
  problem.ranges = {first, second};
  problem.equations = [f = std::move(f)](const std::vector<double>& x) { return equations_from(f(x[0], x[1])); };
  return problem;
}

}  // namespace poinsot::solve
