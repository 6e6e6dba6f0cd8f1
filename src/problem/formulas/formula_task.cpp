#include "problem/formulas/formula_task.h"

#include <algorithm>
#include <stdexcept>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/entries/drawn_letters.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/quantities/quantity_functions.h"
#include "problem/unknowns/asked_value.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
bool confirmed_by_particles(Sample& sample) {
  return std::ranges::all_of(sample.instants(), [](const auto& item) { return confirmed_by_particles(*item.second); });
}

bool is_assumed(const Statement& statement, const AllSettings& settings) {
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const Situation& situation = statement.situations[s];
    DataScope<double> data(situation, settings[s]);
    for (const Expression& expression : situation.assume) try {
        const Value<double> truth = data.value(expression);
        if (truth.is_boolean() && !truth.truth) return false;
      } catch (const StatementError&) {
        // The assumption is about more than letters.
      }
  }
  return true;
}

bool is_at_instant(const FormulaTask& task, const Ask& ask) {
  if (ask.table || ask.when || ask.extremum) return false;
  if (task.sample.motions().empty()) return true;
  if (std::ranges::any_of(ask.of, asks_motion_feature)) return false;
  try {
    Sample alone(task.statement, task.settings, OpenChoice{});
    asked_value(alone, ask);
    return alone.motions().empty();
  } catch (const StatementError&) {
    return false;
  }
}

bool FormulaTask::has_friction() const { return std::ranges::any_of(statement.situations, &Situation::has_friction); }

double FormulaTask::drawn(const Letter& letter, std::mt19937_64& random) const {
  return unknowns.empty() && !has_friction() ? drawn_letter(letter, random)
                                             : drawn_near(settings.front().at(letter.name).number, random);
}

bool speaks_of_no_letter(const FormulaTask& task, const Ask& ask) {
  return ask.extremum &&
         std::ranges::all_of(task.open, [&](const Letter& letter) { return letter.name == ask.extremum->name; });
}

void withhold_formulas(const FormulaTask& task, Solution& solution, const std::string& reason) {
  for (std::size_t i = 0; i < solution.asks.size(); ++i) {
    SolvedAsk& ask = solution.asks[i];
    if (ask.state != AskState::found && ask.state != AskState::needs_letters) continue;
    if (ask.state == AskState::found && speaks_of_no_letter(task, task.statement.asks[i])) continue;
    ask.formula.reset();
    ask.formula_road.clear();
    ask.no_formula = reason;
    ask.state = AskState::needs_letters;
    ask.letters.clear();
    for (const Letter& letter : task.open) ask.letters.push_back(letter.name);
  }
}

std::vector<Formula> stated_bounds(const FormulaTask& task, const std::vector<SolvedUnknown>& unknowns) {
  std::vector<Formula> bounds;
  const auto add = [&](const Formula& positive) {
    const Formula bound = bound_without_inverse(positive);
    if (!bound.is_number() && seen_sign(bound).sign <= 0 && std::ranges::find(bounds, bound) == bounds.end())
      bounds.push_back(bound);
  };
  for (std::size_t i = 0; i < task.statement.situations.size(); ++i) {
    const Situation& situation = task.statement.situations[i];
    const Settings none;
    DataScope<Formula> data(situation, none);
    for (const Letter& letter : task.open) data.vary(letter.name, formula_of(letter));
    for (const auto& [name, value] : task.given) data.vary(name, value);
    for (const SolvedUnknown& unknown : unknowns)
      if (unknown.formula && unknown.is_of(i)) data.vary(unknown.own_name, *unknown.formula);
    for (const Expression& condition : situation.where) {
      const Comparison* comparison = condition.as<Comparison>();
      for (std::size_t k = 0; comparison && k < comparison->relations.size(); ++k) try {
          const Formula rise =
              data.value(comparison->operands[k + 1]).number - data.value(comparison->operands[k]).number;
          const Relation relation = comparison->relations[k];
          add(relation == Relation::less || relation == Relation::less_equal ? rise : -rise);
        } catch (const StatementError&) {
          // It is about what has no formula, or about a quantity of the motion.
        } catch (const std::domain_error&) {
        }
    }
  }
  return bounds;
}

bool acts_on_one_side(const Statement& statement) {
  return std::ranges::any_of(statement.situations, [](const Situation& situation) {
    return !situation.contacts.empty() || !situation.cords.empty() || !situation.belts.empty();
  });
}

bool is_word(const Value<double>& value) {
  if (value.is_list()) return !value.items.empty() && std::ranges::all_of(value.items, is_word);
  return value.is_text();
}

}  // namespace poinsot::problem
