#include "problem/formulas/formula_words.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/formula/formula_constant.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_task.h"
#include "problem/formulas/scaling_trials.h"
#include "problem/language/unit_table.h"
#include "problem/language/units.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {

namespace {

std::vector<Formula> formulas_in(const Value<Formula>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<Formula> all;
  for (const Value<Formula>& item : value.items)
    for (const Formula& one : formulas_in(item)) all.push_back(one);
  return all;
}

// Whether a formula is another one where letters and value have other units, but for standard gravity that is written.
bool hides_units(const Formula& x, const Dimension& dimension, const std::vector<Letter>& letters,
                 const LetterValues& base) {
  constexpr double scale = 1.37, rounding = 1e-9;
  const bool has_gravity = text(x) != formula_words(x);
  const double here = value_at(x, base);
  const auto changes = [&](Units units) {
    LetterValues scaled = base;
    for (const Letter& letter : letters)
      scaled[letter.name] *= std::pow(scale, exponent_of(letter.unit.dimension, units));
    const double expected = here * std::pow(scale, exponent_of(dimension, units));
    return std::abs(value_at(x, scaled) - expected) > rounding * std::abs(expected);
  };
  return has_gravity ? changes(Units::mass) || changes(Units::fall)
                     : changes(Units::mass) || changes(Units::length) || changes(Units::time);
}

}  // namespace

std::string formula_words(const Formula& x) { return text_with_constant(x, standard_gravity_digits); }

void tell_units(const FormulaTask& task, Solution& solution) {
  const Statement& statement = task.statement;
  const std::vector<Letter>& letters = task.open;
  LetterValues base;
  for (const Letter& letter : letters) base[letter.name] = task.settings.front().at(letter.name).number;
  std::vector<std::string> asks, units;
  bool other_units = statement.situations.front().habits.customary();
  for (std::size_t i = 0; i < solution.asks.size(); ++i) {
    const SolvedAsk& ask = solution.asks[i];
    if (!ask.formula) continue;
    const Dimension dimension = dimension_of(ask.value);
    const std::vector<Formula> numbers = formulas_in(*ask.formula);
    if (std::ranges::none_of(numbers, [&](const Formula& x) { return hides_units(x, dimension, letters, base); }))
      continue;
    asks.push_back("'" + statement.asks[i].name + "'");
    for (const Letter& letter : letters) {
      if (std::ranges::none_of(numbers, [&](const Formula& x) { return std::ranges::count(x.letters(), letter.name); }))
        continue;
      other_units = other_units || letter.unit.factor != 1;
      const std::string words = letter.name + " in " + format_unit(letter.unit.dimension);
      if (!format_unit(letter.unit.dimension).empty() && !std::ranges::count(units, words)) units.push_back(words);
    }
  }
  if (asks.empty() || !other_units || units.empty()) return;
  solution.notes.push_back((asks.size() > 1 ? "the formulas of " : "the formula of ") + listed(asks) +
                           (asks.size() > 1 ? " hold" : " holds") + " for numbers in SI units: " + joined(units));
}

std::string values_in_words(const std::vector<Letter>& letters, const LetterValues& values) {
  std::string all;
  for (const Letter& letter : letters)
    all += (all.empty() ? "" : ", ") + letter.name + " = " +
           with_digits(values.at(letter.name) / letter.unit.factor, 3) +
           (letter.unit.text.empty() ? "" : " " + letter.unit.text);
  return all;
}

}  // namespace poinsot::problem
