#include "problem/results/compare_values.h"

#include <algorithm>
#include <cmath>

#include "problem/language/evaluate_support.h"

namespace poinsot::problem {

double size_of(const Value<double>& value) {
  if (value.is_number()) return std::abs(value.number);
  if (value.is_vector())
    return std::max({std::abs(value.vector.x), std::abs(value.vector.y), std::abs(value.vector.z)});
  double largest = 0;
  for (const Value<double>& item : value.items) largest = std::max(largest, size_of(item));
  return largest;
}

const std::vector<Value<double>>* records_of(const Value<double>& value) {
  const bool records = value.is_list() && !value.items.empty() && std::ranges::all_of(value.items, is_record<double>);
  return records ? &value.items : nullptr;
}

namespace {

// The numbers of records are of several kinds: each is compared by the size of its own kind, to the same part of it.
bool same_records(const std::vector<Value<double>>& a, const std::vector<Value<double>>& b, double part) {
  const std::size_t columns = a.front().items.size();
  for (std::size_t c = 0; c < columns; ++c) {
    double size = 0;
    for (std::size_t row = 0; row < a.size(); ++row) {
      if (names_in(a[row]) != names_in(a.front()) || names_in(b[row]) != names_in(a.front())) return false;
      size = std::max({size, size_of(a[row].items[c]), size_of(b[row].items[c])});
    }
    for (std::size_t row = 0; row < a.size(); ++row)
      if (!same(a[row].items[c], b[row].items[c], part * size)) return false;
  }
  return true;
}

}  // namespace

bool same(const Value<double>& a, const Value<double>& b, double tolerance) {
  if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
  if (is_record(a) && is_record(b)) return same(Value<double>::of_list({a}), Value<double>::of_list({b}), tolerance);
  if (const auto* rows = records_of(a), *others = records_of(b); rows && others)
    return same_records(*rows, *others, tolerance / std::max({size_of(a), size_of(b), 1e-300}));
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
