#include "problem/formulas/formula_task.h"

#include <algorithm>

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
