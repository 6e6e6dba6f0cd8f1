// What decides an answer that jumps.
//
// Whether an energy is above a bound, or the larger of two masses, may be the same at some places that are tried and
// another at the next. Such an answer is determined only if what it is decided by does not change at all.
#pragma once

#include "statement/sample.h"

namespace poinsot::statement {

// The value of an ask; where it is decided by others, a list of it and of these, which is_watched(). They are: both
// sides of an inequality, the numbers of which the least or largest is asked, growth rate and frequencies for
// stability, the tension of a cord and the force of a contact that is asked to hold, rate and moments of inertia of a
// free body whose precession is told in words. Throws StatementError where the ask has no value.
Value<double> watched_value(const Statement& statement, Sample& sample, const Ask& ask);
bool is_watched(const Value<double>& value);

}  // namespace poinsot::statement
