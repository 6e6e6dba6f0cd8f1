// Comparison of values up to rounding.
#pragma once

#include "problem/language/value.h"

namespace poinsot::problem {

// The largest magnitude in a value.
double size_of(const Value<double>& value);

// The items of a list of records; null for any other value.
const std::vector<Value<double>>* records_of(const Value<double>& value);

// Whether two values of one kind differ by no more than the tolerance (SI), item by item.
bool same(const Value<double>& a, const Value<double>& b, double tolerance);

// The dimension of a value; of a list, that of its first item.
Dimension dimension_of(const Value<double>& value);

bool has_vector(const Value<double>& value);

}  // namespace poinsot::problem
