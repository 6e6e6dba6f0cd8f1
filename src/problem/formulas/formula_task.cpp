#include "problem/formulas/formula_task.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/entries/drawn_letters.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_conditions.h"
#include "problem/formulas/letter_scan.h"
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

namespace {

// Calls visit(rise, relation) with the right less the left side of each comparison that is about letters and unknowns.
template <class Visit>
void for_each_rise(const std::vector<Expression>& conditions, DataScope<Formula>& data, const Visit& visit) {
  for (const Expression& condition : conditions) {
    const Comparison* comparison = condition.as<Comparison>();
    for (std::size_t k = 0; comparison && k < comparison->relations.size(); ++k) try {
        visit(data.value(comparison->operands[k + 1]).number - data.value(comparison->operands[k]).number,
              comparison->relations[k]);
      } catch (const StatementError&) {
        // It is about what has no formula, or about a quantity of the motion.
      } catch (const std::domain_error&) {
      }
  }
}

}  // namespace

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
    for_each_rise(situation.where, data, [&](const Formula& rise, Relation relation) {
      add(relation == Relation::less || relation == Relation::less_equal ? rise : -rise);
    });
  }
  return bounds;
}

std::vector<Formula> assumed_positive(const FormulaTask& task) {
  std::vector<Formula> assumed;
  for (const Situation& situation : task.statement.situations) {
    const Settings none;
    DataScope<Formula> data(situation, none);
    for (const Letter& letter : task.open) data.vary(letter.name, formula_of(letter));
    for (const auto& [name, value] : task.given) data.vary(name, value);
    for_each_rise(situation.assume, data, [&](const Formula& rise, Relation relation) {
      if (relation == Relation::less) assumed.push_back(rise);
      if (relation == Relation::greater) assumed.push_back(-rise);
    });
  }
  return assumed;
}

bool is_assumed_positive(const Formula& x, const std::vector<Formula>& assumed, bool or_zero) {
  return std::ranges::any_of(assumed, [&](const Formula& positive) {
    if (positive.is_number()) return false;
    const SeenSign ratio = seen_sign(x / positive);
    return x == positive || (ratio.sign > 0 && (ratio.strict || or_zero)) || seen_sign(x - positive).sign > 0;
  });
}

Value<double> at_letters(const Value<Formula>& formula, Value<double> near, const LetterValues& letters) {
  if (formula.is_number()) {
    const double there = value_at(formula.number, letters), turn = 2 * std::numbers::pi;
    near.number = near.dimension == dimensions::angle ? near.number + std::remainder(there - near.number, turn) : there;
  }
  for (std::size_t k = 0; formula.is_vector() && k < 3; ++k) near.vector[k] = value_at(formula.vector[k], letters);
  return near;
}

AllSettings with_unknowns(AllSettings settings, const std::vector<SolvedUnknown>& unknowns,
                          const LetterValues& letters) {
  for (const SolvedUnknown& unknown : unknowns)
    for (std::size_t i = 0; i < settings.size(); ++i)
      if (unknown.formula && unknown.is_of(i))
        settings[i][unknown.own_name] = at_letters(*unknown.formula, unknown.value, letters);
  return settings;
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

bool is_decided_truth(const Ask& ask, const Value<double>& value) {
  const bool truths =
      value.is_list() ? std::ranges::all_of(value.items, &Value<double>::is_boolean) : value.is_boolean();
  return truths && !ask.table && !ask.when && !ask.extremum && std::ranges::all_of(ask.of, [](const Expression& one) {
           if (const Call* call = one.as<Call>()) return call->function == "stable";
           const Comparison* comparison = one.as<Comparison>();
           return comparison && std::ranges::count(comparison->relations, Relation::equal) == 0;
         });
}

namespace {

AllSettings settings_at(const FormulaTask& task, const LetterValues& letters) {
  AllSettings settings = task.settings;
  for (Settings& one : settings)
    for (const Letter& letter : task.open)
      one[letter.name] = Value<double>::of_number(letters.at(letter.name), letter.unit.dimension);
  return settings;
}

bool all_positive(const std::vector<Formula>& signs, const LetterValues& there) {
  return std::ranges::all_of(signs, [&](const Formula& sign) { return value_at(sign, there) > 0; });
}

// What turns a sign may be too narrow to be met by chance; it lies where what is assumed just holds.
bool positive_to_the_edges(const FormulaTask& task, const std::vector<Formula>& signs, const LetterValues& from) {
  constexpr int halvings = 40;
  for (const Letter& letter : task.open)
    for (const double factor : {1e-3, 1e3}) {
      LetterValues there = from;
      double& value = there.at(letter.name);
      double inside = value;
      double outside = is_angle(letter) ? value + (factor > 1 ? 1 : -1) : value * factor;
      for (int i = 0; i < halvings; ++i) {
        value = (inside + outside) / 2;
        (is_assumed(task.statement, settings_at(task, there)) ? inside : outside) = value;
      }
      value = inside;
      if (!all_positive(signs, there)) return false;
    }
  return true;
}

}  // namespace

bool positive_where_assumed(const FormulaTask& task, const std::vector<Formula>& signs, bool by_trial) {
  if (!by_trial) {
    const std::vector<Formula> known = assumed_positive(task);
    return std::ranges::all_of(signs, [&](const Formula& sign) { return is_assumed_positive(sign, known); });
  }
  constexpr std::size_t points = 20'000, enough = 300, most = 1000, led_to_edges = 30;
  LetterValues base;
  for (const Letter& letter : task.open) base[letter.name] = task.settings.front().at(letter.name).number;
  const LetterScan scan(task.open, base);
  std::size_t assumed = 0;
  for (std::size_t n = 0; n < points && assumed < most; ++n) {
    const LetterValues there = scan.point(n);
    if (!is_assumed(task.statement, settings_at(task, there))) continue;
    if (++assumed <= led_to_edges && !positive_to_the_edges(task, signs, there)) return false;
    if (!all_positive(signs, there)) return false;
  }
  return assumed >= enough;
}

}  // namespace poinsot::problem
