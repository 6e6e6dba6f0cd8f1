// What decides an answer that jumps.
//
// Whether an energy is above a bound, or the larger of two masses, may be the same at some places that are tried and
// another at the next. Such an answer is determined only if what it is decided by does not change at all.
#pragma once

#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// The value of an ask with what decides it where it jumps: both sides of an inequality, the numbers of which the least
// or largest is asked, growth rate and frequencies for stability, the tension of a cord and the force of a contact that
// is asked to hold, rate and moments of inertia of a free body whose precession is told in words.
struct WatchedValue {
  Value<double> answer;
  std::vector<Value<double>> deciding;
};

// Throws StatementError where the ask has no value.
WatchedValue watched_value(const Statement& statement, Sample& sample, const Ask& ask);

}  // namespace poinsot::problem
