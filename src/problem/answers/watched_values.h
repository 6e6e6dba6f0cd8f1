// Records the values that decide an answer that can jump.
//
// Whether an energy is above a bound, or which of two masses is larger, may be the same at some choices that are
// tried and different at the next. Such an answer is determined only if the values that decide it do not change at
// all.
#pragma once

#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// The value of an ask together with the values that decide it: both sides of an inequality, the numbers whose minimum
// or maximum is asked for, growth rate and frequencies for stability, the tension of a cord and the force of a
// contact that is asked to hold, and the rate and moments of inertia of a free body whose precession is described in
// words.
struct WatchedValue {
  Value<double> answer;
  std::vector<Value<double>> deciding;
};

// Throws StatementError if the ask has no value.
WatchedValue watched_value(const Statement& statement, Sample& sample, const Ask& ask);

}  // namespace poinsot::problem
