// The answers of a statement with letters left open, as formulas.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "problem/formulas/formula_instant.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Bounds on the search for the formulas of one file.
inline constexpr std::size_t most_formula_terms = 20000;
inline constexpr double most_formula_seconds = 5;

// Why `find` cannot come to a formula, also where it takes too long; nothing if it can.
template <class Find>
std::optional<std::string> why_no_formula(const Find& find) {
  try {
    find();
    return std::nullopt;
  } catch (const NoFormula& reason) {
    return reason.what();
  } catch (const std::domain_error& reason) {
    return reason.what();
  } catch (const FormulaTooLarge& reason) {
    return reason.what();
  }
}

// What stands for a letter in formulas. Lengths, masses, durations and what is made of them are positive, angles real.
Value<Formula> formula_of(const Letter& letter);

// The value of `--set NAME=TEXT`, exactly; read_setting has understood it before.
Value<Formula> exact_setting(const Situation& situation, const std::string& name, const std::string& text);

// The letters of unknowns whose squares are neglected; values: of unknowns as letters.
std::vector<std::string> neglected_letters(const Situation& situation, const FormulaValues& values);

// The pull of a cord or the push of a contact at an instant, and what is assumed where it is positive, in words.
struct OneSidedForce {
  Sample::Home home;
  std::string action;
  std::string assumption;
  Formula value;
};
// "the cord 'c' stays taut".
std::string holding_words(const std::string& action, bool cord);

// All formulas of one root.
class FormulaAnswers {
 public:
  // values: of each situation, for letters, data from outside and unknowns. numbers: the same at values of the letters.
  // All arguments must outlive it.
  FormulaAnswers(const Statement& statement, const std::vector<FormulaValues>& values, Sample& numbers)
      : statement_(statement), values_(values), numbers_(numbers) {}

  // Throws NoFormula with the reason.
  Value<Formula> value(const Ask& ask);
  // Those of the instants that were solved with their forces.
  std::vector<OneSidedForce> one_sided_forces() const;
  // Solves everything that the situations state, for the remainders.
  void solve_all();
  // What must vanish if the facts hold, of all instants that were needed; without the squares that are neglected.
  std::vector<Formula> remainders() const;

 private:
  FormulaInstant& instant(const Sample::Home& home);
  Value<Formula> at_home(const Sample::Home& home, const Expression& expression, const std::optional<Expression>& axes);

  const Statement& statement_;
  const std::vector<FormulaValues>& values_;
  Sample& numbers_;
  std::map<Sample::Home, std::unique_ptr<FormulaInstant>> instants_;
  std::map<Sample::Home, std::string> no_instant_;  // why there are no formulas, once that was tried
};

// Whether a formula has the given value at values of the letters: to `tolerance`, relative, and `natural` times a small
// part of the tolerance where all cancels.
bool agrees(const Value<Formula>& formula, const Value<double>& value, const LetterValues& letters, double tolerance,
            double natural);

// The same formula with others in place of letters.
Value<Formula> substituted(const Value<Formula>& formula, const std::map<std::string, Formula>& letters);

// The letters in it.
std::vector<std::string> letters_in(const Value<Formula>& formula);

}  // namespace poinsot::problem
