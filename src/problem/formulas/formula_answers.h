// The answers of a statement as formulas in the letters without value.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/formula_instant.h"
#include "problem/instant/friction_conditions.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Bounds on the search for the formulas of one file.
inline constexpr std::size_t most_formula_terms = 20000;
inline constexpr Work most_formula_work = 5'000'000'000;

// Why `find` does not yield a formula, possibly because it takes too long; nothing if it yields one.
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

// The letter as a formula. Lengths, masses, durations and what is made of them are positive; angles may have either
// sign.
Value<Formula> formula_of(const Letter& letter);

// The exact value of `--set NAME=TEXT`. The text has been read as a value before.
Value<Formula> exact_setting(const Situation& situation, const std::string& name, const std::string& text);

// The letters of the unknowns whose squares are neglected. values: the unknowns, as letters.
std::vector<std::string> neglected_letters(const Situation& situation, const FormulaValues& values);

// What is positive while a cord pulls, a contact presses, one with friction stays in its state, or what strikes
// approaches at an instant, and the assumption under which it acts, in words.
struct OneSidedForce {
  Sample::Home home;
  std::string action;
  std::string assumption;
  Formula value;
  // Whether it is a condition for the state of a contact with friction, or of a blow, which is always told.
  bool of_state = false;
};
// An assumption in words: "the cord 'c' stays taut".
std::string holding_words(const std::string& action, Holding holding);

// A formula and what was decided on the way to it: each of these signs is taken to be everywhere what it is at the
// point of decisions.
struct DecidedFormula {
  Value<Formula> value;
  std::vector<Formula> signs;
};

// All formulas of one solution.
class FormulaAnswers {
 public:
  // values: of each situation, the letters, the data from outside and the unknowns as formulas. numbers: the
  // statement solved at some values of the letters. All of these must outlive the object. linear_solve: how linear
  // equations are solved, if not exactly.
  FormulaAnswers(const Statement& statement, const std::vector<FormulaValues>& values, Sample& numbers,
                 FormulaLinearSolve linear_solve = {})
      : statement_(statement), values_(values), numbers_(numbers), linear_solve_(std::move(linear_solve)) {}

  // Throws NoFormula with the reason.
  DecidedFormula value(const Ask& ask);
  // What is positive at the start of a situation as long as its contacts with friction stay in their states, the others
  // press and cords pull, and what was decided on the way to it. What is so for all letters may be left out. Throws
  // NoFormula where it is open how contacts share what they carry.
  std::vector<Formula> positive_in_states(std::size_t situation);
  // What was decided on the way to a truth or a word.
  std::vector<Formula> signs_of_word(const Ask& ask);
  // The sides of a comparison at the start of a situation, after its blow if it has one.
  DecidedFormula at_start(std::size_t situation, const Expression& expression);
  // What was decided on the way to all instants that were needed.
  std::vector<Formula> signs_of_instants() const;
  // The forces of all instants that were solved with their forces.
  std::vector<OneSidedForce> one_sided_forces() const;
  // How fast what strikes approaches at the instants solved so far, where this depends on letters.
  void add_approaches(std::vector<OneSidedForce>& forces) const;
  // Adds the conditions under which the contacts with friction stay in their states at the start of each situation.
  // Throws NoFormula where they have none.
  void add_state_conditions(std::vector<OneSidedForce>& forces);
  // Solves everything that the situations state, so that remainders() is complete.
  void solve_all();
  // What must vanish if the facts hold, for all instants that were needed, without the squares that are neglected.
  std::vector<Formula> remainders() const;

 private:
  StateCondition condition_of_leaving(std::size_t situation, const FormulaInstant& sliding);
  DecidedFormula decided(const Ask& ask);
  FormulaInstant& instant(const Sample::Home& home);
  Value<Formula> at_home(const Sample::Home& home, const Expression& expression, const std::optional<Expression>& axes);

  const Statement& statement_;
  const std::vector<FormulaValues>& values_;
  Sample& numbers_;
  FormulaLinearSolve linear_solve_;
  std::map<Sample::Home, std::unique_ptr<FormulaInstant>> instants_;
  std::map<Sample::Home, std::vector<Formula>> signs_;  // decided on the way to an instant
  std::map<Sample::Home, std::string> no_instant_;      // why an instant has no formulas, once this was tried
};

// How far a formula is from the given value at values of the letters: as a part of the value, or of a hundredth of
// `natural` where its terms cancel; infinite where the formula has no value.
double misfit_of(const Value<Formula>& formula, const Value<double>& value, const LetterValues& letters,
                 double natural);
// Whether that is no more than the tolerance.
bool agrees(const Value<Formula>& formula, const Value<double>& value, const LetterValues& letters, double tolerance,
            double natural);

// Gives a value what its formula, which has no letters, knows of its zeros: which numbers vanish exactly, and which
// were taken for rounding and do not vanish.
void take_zeros(const Value<Formula>& formula, Value<double>& value);

// The formula with other formulas in place of letters.
Value<Formula> substituted(const Value<Formula>& formula, const std::map<std::string, Formula>& letters);

// Numbers as formulas without letters.
Value<Formula> as_formula(const Value<double>& value);

// The letters that occur in it.
std::vector<std::string> letters_in(const Value<Formula>& formula);

}  // namespace poinsot::problem
