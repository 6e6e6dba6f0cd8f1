#include "problem/formulas/formula_conditions.h"

#include <algorithm>

#include "poinsot/engine/math/formula/formula_constant.h"
#include "poinsot/engine/math/formula/formula_domain.h"
#include "poinsot/engine/math/formula/formula_sign.h"
#include "problem/formulas/formula_answers.h"
#include "problem/formulas/formula_words.h"
#include "problem/language/unit_table.h"

namespace poinsot::problem {

namespace {

// The shortest of the forms of a condition on a root.
std::string words_of_root(const Formula& not_negative) {
  std::string words = formula_words(not_negative);
  // With the factors that have a part in the sign alone.
  const Formula part = sign_part(not_negative, true);
  for (const Formula& one : {part, with_plain_numbers(part, standard_gravity_digits)})
    if (std::string own = formula_words(one); own.size() < words.size()) words = std::move(own);
  return words + " >= 0";
}

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

std::vector<std::string> root_conditions_of(const Value<Formula>& value) {
  std::vector<std::string> all;
  for (const std::vector<Formula>& roots : {assumed_roots_of(value), domain_of(value)})
    for (const Formula& not_negative : roots) all.push_back(words_of_root(not_negative));
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
  const std::vector<std::string> letters = positive.letters();
  const bool turns = std::ranges::any_of(open, [&](const Letter& letter) {
    return is_angle(letter) && std::ranges::find(letters, letter.name) != letters.end();
  });
  const Formula gravity = Formula::number(std::string(standard_gravity_digits));
  tried(with_plain_numbers(positive, standard_gravity_digits), best, words);
  for (const Formula& factor : {gravity, Formula(1) / gravity}) tried(Formula(best) * factor, best, words);
  // Tangents of half angles, in which formulas are factored, are for sums only.
  if (!turns) tried(sign_part(positive, false), best, words);
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

}  // namespace poinsot::problem
