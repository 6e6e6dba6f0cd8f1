#include "problem/answers/fact_check.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "problem/course/course.h"
#include "problem/language/diagnostic.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {
namespace {

class FactCheck {
 public:
  // before: tells the instant before the blow, if `instant` is the one after it.
  FactCheck(const Situation& situation, SolvedInstant& instant, std::function<const SolvedInstant*()> before,
            SolvedInstant::Elsewhere elsewhere)
      : situation_(situation), instant_(instant), before_(std::move(before)), elsewhere_(std::move(elsewhere)) {}

  std::optional<double> largest;

  void add(const Fact& fact) {
    const Level level = level_of(situation_, fact.quantity);
    if (level == Level::motion || (level == Level::force && !instant_.forces_solved())) return;
    if (is_any(fact.value)) return;
    const Value<double> quantity = at(fact.quantity);
    const List* list = fact.value.as<List>();
    if (quantity.is_number()) {
      compare(quantity.number, at(fact.value).number, std::abs(quantity.number), quantity.dimension);
    } else if (quantity.is_vector() && list && list->items.size() == 3) {
      for (std::size_t k = 0; k < 3; ++k)
        if (!is_any(list->items[k]))
          compare(quantity.vector[k], at(list->items[k]).number, size_of(quantity), quantity.dimension);
    } else if (quantity.is_vector()) {
      // The number 0 stands for the zero vector.
      const Value<double> value = at(fact.value);
      for (std::size_t k = 0; k < 3; ++k)
        compare(quantity.vector[k], value.is_vector() ? value.vector[k] : 0, size_of(quantity), quantity.dimension);
    } else if (list && list->items.size() == quantity.items.size()) {
      for (std::size_t k = 0; k < list->items.size(); ++k)
        if (!is_any(list->items[k]))
          compare(quantity.items[k].number, at(list->items[k]).number, size_of(quantity), quantity.items[k].dimension);
    }
  }

  void add_stated_rates() {
    const MotionState state = instant_.state();
    for (const StatedRate& rate : instant_.machine().rates)
      compare(state.v[static_cast<std::size_t>(rate.velocity)], rate.value, 0,
              (rate.turning ? dimensions::none : dimensions::length) / dimensions::time);
    if (!instant_.forces_solved()) return;
    for (const StatedRate& rate : instant_.machine().accelerations)
      compare(instant_.motion().value[static_cast<std::size_t>(rate.velocity)], rate.value, 0,
              (rate.turning ? dimensions::none : dimensions::length) / dimensions::time / dimensions::time);
  }

 private:
  Value<double> at(const Expression& expression) { return instant_.raw(expression, std::nullopt, elsewhere_); }

  void compare(double found, double stated, double size, const Dimension& dimension) {
    double beside = std::max({size, std::abs(found), std::abs(stated), instant_.natural_size(dimension)});
    if (const SolvedInstant* before = before_()) beside = std::max(beside, before->natural_size(dimension));
    // Where nothing moves, weighs or pushes, rates are zero without rounding.
    const double misfit = found == stated ? 0 : std::abs(found - stated) / beside;
    largest = std::max(largest.value_or(0), misfit);
  }

  const Situation& situation_;
  SolvedInstant& instant_;
  std::function<const SolvedInstant*()> before_;
  SolvedInstant::Elsewhere elsewhere_;
};

}  // namespace

std::optional<double> largest_fact_misfit(const Statement& statement, Sample& sample) {
  std::optional<double> largest;
  std::vector<std::pair<Sample::Home, SolvedInstant*>> solved;
  for (const auto& [home, instant] : sample.instants())
    if (!home.time && !home.ending) solved.emplace_back(home, instant.get());
  for (const auto& [home, instant] : solved) {
    const Situation& situation = statement.situations[home.situation];
    const bool after_blow = instant->after_blow();
    if (home.instant > 0 && !after_blow) continue;
    const auto before = [&sample, number = home.situation, after_blow]() -> const SolvedInstant* {
      return after_blow ? &sample.instant({number, 0, std::nullopt}) : nullptr;
    };
    FactCheck check(situation, *instant, before, [&sample](const At& past, const Mark& mark) {
      return sample.instant(sample.resolve(past, mark)).raw(past.expression, std::nullopt, nullptr);
    });
    if (after_blow) {
      for (const Instant& one : situation.instants)
        if (one.name == "after")
          for (const Fact& fact : one.facts) check.add(fact);
    } else {
      for (const Instant* one : instants_at_start(situation))
        for (const Fact& fact : one->facts) check.add(fact);
      check.add_stated_rates();
    }
    if (check.largest) largest = std::max(largest.value_or(0), *check.largest);
  }
  return largest;
}

void hold_later_facts(const Statement& statement, const Settings& settings) {
  for (const Situation& situation : statement.situations) {
    if (!has_later_facts(situation)) continue;
    for (const FactMisfit& misfit : later_misfits(situation, settings, OpenChoice{})) {
      // A motion is followed to about 1e-10; stated digits beyond the seventh are seldom meant.
      constexpr double followed = 1e-7;  // of the size of the stated quantity
      if (std::abs(misfit.value) <= followed) continue;
      const auto later =
          std::find_if(situation.instants.begin(), situation.instants.end(),
                       [&](const Instant& instant) { return is_later(situation, instant) && !instant.facts.empty(); });
      fail(situation.file, later != situation.instants.end() ? later->mark : situation.instants.front().mark,
           "what is stated of the motion after its start does not hold: it follows from the start and the loads",
           "correct it, or list under find: a datum that it fixes");
    }
  }
}

}  // namespace poinsot::problem
