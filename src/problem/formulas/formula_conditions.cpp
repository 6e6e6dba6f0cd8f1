#include "problem/formulas/formula_conditions.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/formula/formula_constant.h"
#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_search.h"
#include "problem/formulas/formula_words.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"
#include "problem/language/unit_table.h"
#include "problem/machine/data.h"
#include "problem/results/compare_values.h"

namespace poinsot::problem {

namespace {

// What has the sign of x, by the factors that have a part in it alone. Products of sines and cosines are written as
// those of the double angle over powers of two, so that multiples may be shorter.
std::vector<Formula> forms_of_sign(const Formula& x, bool keep_zeros) {
  const Formula part = sign_part_in_sines(x, keep_zeros);
  return {part, 2 * part, 4 * part, 8 * part, with_plain_numbers(part, standard_gravity_digits)};
}

// The shortest of the forms of a condition on a root.
std::string words_of_root(const Formula& not_negative) {
  std::string words = formula_words(not_negative);
  for (const Formula& one : forms_of_sign(not_negative, true))
    if (std::string own = formula_words(one); own.size() < words.size()) words = std::move(own);
  return words + " >= 0";
}

// An inequality that was read once. Its letters are numbers of SI units without dimension, since numbers in formulas
// have none; angles remain angles.
class ToldInequality {
 public:
  ToldInequality(const std::string& words, const std::vector<Letter>& letters) {
    situation_.letters = letters;
    for (Letter& letter : situation_.letters)
      if (letter.unit.dimension != dimensions::angle) letter.unit = Unit{};
    has_g_ = std::ranges::find(letters, "g", &Letter::name) != letters.end();
    if (!has_g_) situation_.letters.push_back({"g", Unit{}, Mark{}});
    try {
      expression_ = parse_expression(words, "", Mark{});
    } catch (const StatementError&) {
      // Words that are no inequality say nothing here.
    }
  }

  std::optional<bool> at(const LetterValues& values) const {
    if (!expression_ || !(*expression_).as<Comparison>()) return std::nullopt;
    Settings settings;
    for (const Letter& letter : situation_.letters)
      if (const auto value = values.find(letter.name); value != values.end())
        settings[letter.name] = Value<double>::of_number(value->second, letter.unit.dimension);
    if (!has_g_) settings["g"] = Value<double>::of_number(standard_gravity, dimensions::none);
    DataScope<double> data(situation_, settings);
    try {
      const Value<double> truth = data.value(*expression_);
      return truth.is_boolean() ? std::optional(truth.truth) : std::nullopt;
    } catch (const StatementError&) {
      return std::nullopt;
    }
  }

 private:
  Situation situation_;
  bool has_g_ = false;
  std::optional<Expression> expression_;
};

}  // namespace

std::vector<Formula> formulas_in(const Value<Formula>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<Formula> all;
  for (const Value<Formula>& item : value.items)
    for (Formula& one : formulas_in(item)) all.push_back(std::move(one));
  return all;
}

std::vector<Formula> domain_of(const Value<Formula>& value) {
  std::vector<Formula> all;
  for (const Formula& x : formulas_in(value))
    for (Formula& not_negative : not_negative_in_domain(x)) all.push_back(std::move(not_negative));
  return all;
}

std::vector<Formula> assumed_roots_of(const Value<Formula>& value) {
  std::vector<Formula> all;
  for (const Formula& x : formulas_in(value))
    for (Formula& not_negative : assumed_not_negative(x))
      if (seen_sign(not_negative).sign <= 0) all.push_back(std::move(not_negative));
  return all;
}

std::vector<std::string> root_conditions_of(const Value<Formula>& value, const std::vector<Formula>& told) {
  std::vector<std::string> all;
  const auto follows = [&](const Formula& not_negative) {
    return std::ranges::any_of(told, [&](const Formula& positive) {
      return not_negative == positive || seen_sign(not_negative - positive).sign > 0;
    });
  };
  for (const std::vector<Formula>& roots : {assumed_roots_of(value), domain_of(value)})
    for (const Formula& not_negative : roots) {
      if (follows(not_negative)) continue;
      if (std::string words = words_of_root(not_negative); std::ranges::find(all, words) == all.end())
        all.push_back(std::move(words));
    }
  return all;
}

std::vector<std::string> assumptions_of(const Value<Formula>& value) {
  std::vector<std::string> all;
  for (const Formula& x : formulas_in(value)) {
    const std::vector<std::string> roots = x.root_assumptions();
    for (std::string& words : x.assumptions())
      if (std::ranges::find(roots, words) == roots.end()) all.push_back(std::move(words));
  }
  for (const Formula& not_negative : assumed_roots_of(value)) all.push_back(words_of_root(not_negative));
  return all;
}

bool is_implied(const HeldCondition& condition, const std::vector<HeldCondition>& conditions) {
  return std::ranges::any_of(conditions, [&](const HeldCondition& other) {
    if (&other == &condition || !other.needed || !std::ranges::all_of(condition.asks, [&](std::size_t i) {
          return std::ranges::find(other.asks, i) != other.asks.end();
        }))
      return false;
    if (&other < &condition && condition.positive == other.positive) return true;
    const auto seen = [](const Formula& x) { return seen_sign(x).sign > 0; };
    return !(condition.positive == other.positive) &&
           (seen(condition.positive - other.positive) ||
            (&other < &condition && seen(condition.positive / other.positive)));
  });
}

std::string condition_words(const Formula& positive, const std::vector<Letter>& open) {
  const auto tried = [](const Formula& x, Formula& best, std::string& words) {
    std::string own = formula_words(x);
    if (own.size() >= words.size()) return;
    words = std::move(own);
    best = x;
  };
  Formula best = positive;
  std::string words = formula_words(best);
  // No factor makes a line of a page, and each form of what is as long takes up to a second to write.
  constexpr std::size_t readable = 500;
  if (words.size() > readable) return words + " > 0";
  const Formula gravity = Formula::number(std::string(standard_gravity_digits));
  tried(with_plain_numbers(positive, standard_gravity_digits), best, words);
  for (const Formula& factor : {gravity, Formula(1) / gravity}) tried(Formula(best) * factor, best, words);
  for (const Formula& one : forms_of_sign(positive, false)) tried(one, best, words);
  for (const Letter& letter : open) {
    if (letter.either_sign || is_angle(letter)) continue;
    const Formula factor = formula_of(letter).number, start = best;
    for (const int power : {-3, -2, -1, 1, 2}) tried(start * pow(factor, power), best, words);
  }
  const Formula start = best;
  for (int number = 2; number <= 12; ++number)
    for (const Formula& factor : {Formula(number), Formula(1) / Formula(number)}) tried(start * factor, best, words);
  const std::string opposite = formula_words(-best);
  return opposite.size() < words.size() ? opposite + " < 0" : words + " > 0";
}

std::vector<std::pair<std::string, Formula>> not_zero_conditions(const Formula& x, const std::vector<Letter>& open) {
  std::vector<std::pair<std::string, Formula>> all;
  // Factors come in tangents of half angles, of which several together are a cosine.
  Formula of_angles(1);
  for (const Formula& factor : vanishing_factors(x)) {
    const std::vector<std::string> letters = factor.letters();
    if (std::ranges::any_of(open, [&](const Letter& letter) {
          return is_angle(letter) && std::ranges::find(letters, letter.name) != letters.end();
        }))
      of_angles *= factor;
    else
      all.emplace_back(formula_words(factor) + " != 0", factor);
  }
  if (of_angles.is_number()) return all;
  std::string words = formula_words(of_angles);
  const std::vector<std::string> letters = of_angles.letters();
  for (const Letter& letter : open) {
    if (!is_angle(letter) || std::ranges::find(letters, letter.name) == letters.end()) continue;
    const Formula half = (1 + cos(formula_of(letter).number)) / 2;
    for (const Formula& one : {of_angles * half, -of_angles * half, of_angles * half * half})
      if (std::string own = formula_words(one); own.size() < words.size()) words = std::move(own);
  }
  all.emplace_back(words + " != 0", of_angles);
  return all;
}

std::optional<bool> holds_as_told(const std::string& inequality, const std::vector<Letter>& letters,
                                  const LetterValues& values) {
  return ToldInequality(inequality, letters).at(values);
}

void hold_conditions_as_told(const std::vector<Letter>& letters, const LetterValues& found_at,
                             const std::vector<LetterValues>& others, Solution& solution) {
  const auto take_back = [&](SolvedAsk& ask) {
    if (!ask.formula) return;
    ask.formula.reset();
    ask.formula_road.clear();
    ask.regimes.clear();
    ask.no_formula = "the condition of the formula found, as it is told, does not agree with numbers";
    ask.state = AskState::needs_letters;
    if (ask.letters.empty())
      for (const Letter& letter : letters) ask.letters.push_back(letter.name);
  };
  for (const FormulaCondition& condition : solution.grounds) {
    if (condition.inequality.empty()) continue;
    const ToldInequality told(condition.inequality, letters);
    const auto differs_at = [&](const LetterValues& at) {
      const std::optional<bool> holds = told.at(at);
      const double positive = value_at(condition.positive, at);
      return holds && std::isfinite(positive) && positive != 0 && *holds != (positive > 0);
    };
    if (told.at(found_at) != false && !differs_at(found_at) && std::ranges::none_of(others, differs_at)) continue;
    for (std::size_t i = 0; i < solution.asks.size(); ++i)
      if (condition.asks.empty() || std::ranges::count(condition.asks, i) > 0) take_back(solution.asks[i]);
  }
  constexpr double same_branch = 1e-6;  // relative difference of numbers on one branch
  for (SolvedAsk& ask : solution.asks) {
    const std::vector<RegimeFormula> regimes = ask.regimes;
    for (std::size_t k = 0; k < regimes.size(); ++k) {
      const auto is = [&](bool wanted) {
        return [&, wanted](const std::string& words) { return holds_as_told(words, letters, found_at) == wanted; };
      };
      const bool first = k == 0, claimed = std::ranges::all_of(regimes[k].where, is(true));
      if (first ? std::ranges::any_of(regimes[k].where, is(false))
                : claimed && !(misfit_of(regimes[k].formula, ask.value, found_at, size_of(ask.value)) <= same_branch))
        take_back(ask);
    }
  }
}

std::optional<Formula> inside_behind(const Formula& sign, const std::vector<UnknownFormula>& unknowns) {
  for (const UnknownFormula& unknown : unknowns)
    for (const Formula& inside : domain_of(unknown.value))
      if (const SeenSign ratio = seen_sign(sign / inside); ratio.sign > 0 && ratio.strict) return inside;
  return std::nullopt;
}

}  // namespace poinsot::problem
