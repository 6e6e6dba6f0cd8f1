#include "problem/results/compare_values.h"

#include <algorithm>
#include <cmath>

namespace poinsot::problem {

double size_of(const Value<double>& value) {
  if (value.is_number()) return std::abs(value.number);
  if (value.is_vector())
    return std::max({std::abs(value.vector.x), std::abs(value.vector.y), std::abs(value.vector.z)});
  double largest = 0;
  for (const Value<double>& item : value.items) largest = std::max(largest, size_of(item));
  return largest;
}

bool same(const Value<double>& a, const Value<double>& b, double tolerance) {
  if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
  if (a.is_number()) return std::abs(a.number - b.number) <= tolerance;
  if (a.is_vector()) return norm(a.vector - b.vector) <= tolerance;
  if (a.is_boolean()) return a.truth == b.truth;
  if (a.is_text()) return a.text == b.text;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(a.items[i], b.items[i], tolerance)) return false;
  return true;
}

Dimension dimension_of(const Value<double>& value) {
  return value.is_list() && !value.items.empty() ? dimension_of(value.items.front()) : value.dimension;
}

bool has_vector(const Value<double>& value) {
  return value.is_vector() || std::any_of(value.items.begin(), value.items.end(), has_vector);
}

}  // namespace poinsot::problem
