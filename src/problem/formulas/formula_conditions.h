// The conditions under which formulas hold: which are needed, and in which words they are told.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/value.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// What is positive where formulas hold.
struct HeldCondition {
  Formula positive;
  std::vector<std::size_t> asks;  // whose formulas rest on it
  bool bound = false;             // of an unknown, so that there is no such solution beyond it
  bool domain = false;            // beyond it formulas have no value
  bool needed = false;
};

// Those of a number, of a vector and of all in a list.
std::vector<Formula> formulas_in(const Value<Formula>& value);

// What is assumed not to be negative under the roots of a value, which is told with it.
std::vector<Formula> assumed_roots_of(const Value<Formula>& value);

// What must not be negative where all numbers of a value have one.
std::vector<Formula> domain_of(const Value<Formula>& formula);

// What must not be negative where roots, acos and asin in a value have values: "k - m*w^2 >= 0". told: what
// is told to be positive besides, and what holds wherever it is so needs no words.
std::vector<std::string> root_conditions_of(const Value<Formula>& formula, const std::vector<Formula>& told = {});

// What was assumed when the numbers of a value were simplified: "m > 0".
std::vector<std::string> assumptions_of(const Value<Formula>& formula);

// Whether a condition holds wherever another one does that is told for at least the same answers. Of two that say the
// same the first is told. condition: one of them.
bool is_implied(const HeldCondition& condition, const std::vector<HeldCondition>& conditions);

// "5*g - 2*r*w^2 > 0": without the factors that have no part in the sign, as far as this is shorter. open: the letters.
std::string condition_words(const Formula& positive, const std::vector<Letter>& open);
// The factors of what must not vanish that may, with their words: "I - J != 0", "cos(b) != 0".
std::vector<std::pair<std::string, Formula>> not_zero_conditions(const Formula& x, const std::vector<Letter>& open);

// The second road to conditions: each is read back as it is told, by the reader of the language. A formula was found at
// some letters, so its conditions hold there; elsewhere they hold where what was found positive is so.
//
// Whether an inequality such as "M - Q > 0" holds at these letters, in SI units; nothing where it cannot be read so or
// has no value there.
std::optional<bool> holds_as_told(const std::string& inequality, const std::vector<Letter>& letters,
                                  const LetterValues& values);

// Takes back the formulas of a solution that was found at some letters, if a condition told of them does not hold
// there, or at one of the other letters otherwise than what was found positive, or if the condition of another formula
// of the same answer holds there which has another value. letters: those without value.
void hold_conditions_as_told(const std::vector<Letter>& letters, const LetterValues& found_at,
                             const std::vector<LetterValues>& others, Solution& solution);

inline bool is_angle(const Letter& letter) { return letter.unit.dimension == dimensions::angle; }

}  // namespace poinsot::problem
