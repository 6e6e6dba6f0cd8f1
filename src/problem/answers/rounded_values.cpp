#include "problem/answers/rounded_values.h"

#include <algorithm>
#include <cfenv>
#include <cmath>

#include "problem/language/exact_numbers.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

constexpr double last_digit = 4e-16;  // the rounding of a single operation
constexpr double another = 0.3;       // a number that changes by more than this part of itself is not real

class RoundingScope {
 public:
  explicit RoundingScope(int direction) : before_(std::fegetround()) { std::fesetround(direction); }
  ~RoundingScope() { std::fesetround(before_); }
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

 private:
  int before_;
};

// Calls visit(number, size of its vector, the same number in `others`) for every number of a value.
template <class Visit>
void for_each_number(Value<double>& value, const std::vector<const Value<double>*>& others, const Visit& visit) {
  std::vector<double> there(others.size());
  if (value.is_number()) {
    for (std::size_t i = 0; i < others.size(); ++i) there[i] = others[i]->number;
    visit(value.number, std::abs(value.number), there);
  }
  if (value.is_vector()) {
    const double size = size_of(value);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < others.size(); ++i) there[i] = others[i]->vector[k];
      visit(value.vector[k], size, there);
    }
  }
  for (std::size_t k = 0; k < value.items.size(); ++k) {
    std::vector<const Value<double>*> items;
    items.reserve(others.size());
    for (const Value<double>* other : others) items.push_back(&other->items[k]);
    for_each_number(value.items[k], items, visit);
  }
}

bool same_shape(const Value<double>& a, const Value<double>& b) {
  if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same_shape(a.items[i], b.items[i])) return false;
  return true;
}

std::vector<const Value<double>*> of_same_shape(const Value<double>& value, const std::vector<Value<double>>& others) {
  std::vector<const Value<double>*> found;
  for (const Value<double>& other : others)
    if (same_shape(value, other)) found.push_back(&other);
  return found;
}

// What was found or came from outside the file is known to its last digit, like what stands in it.
AllSettings as_rounded_now(AllSettings settings) {
  for (Settings& of_situation : settings)
    for (auto& [name, value] : of_situation) value.number = rounded_datum(value.number);
  return settings;
}

}  // namespace

const std::vector<Value<double>>& RoundedValues::of(const Ask& ask) {
  const auto [entry, fresh] = known_.try_emplace(ask.name);
  if (!fresh) return entry->second;
  for (const int direction : {FE_UPWARD, FE_DOWNWARD}) {
    const RoundingScope scope(direction);
    try {
      Sample sample(statement_, as_rounded_now(settings_), OpenChoice{});
      entry->second.push_back(asked_value(sample, ask));
    } catch (const StatementError&) {
      // Rounded this way the ask has no value. Rounded the other way it may have one.
    }
  }
  return entry->second;
}

double RoundedValues::spread(const Ask& ask, const Value<double>& value) {
  double largest = 0;
  Value<double> own = value;
  for_each_number(own, of_same_shape(value, of(ask)), [&](double x, double /*size*/, const std::vector<double>& there) {
    for (const double other : there) largest = std::max(largest, std::abs(other - x));
  });
  return largest;
}

void drop_noise(Value<double>& value, double size, double asked_size, const std::vector<Value<double>>& rounded,
                double noise) {
  for_each_number(value, of_same_shape(value, rounded), [&](double& x, double own, const std::vector<double>& there) {
    if (!(std::abs(x) < noise * size)) return;
    const bool moved = std::any_of(there.begin(), there.end(),
                                   [&](double other) { return !(std::abs(other - x) <= another * std::abs(x)); });
    if (moved || std::abs(x) < (there.empty() ? noise * std::max(own, asked_size) : last_digit * own)) x = 0;
  });
}

}  // namespace poinsot::problem
