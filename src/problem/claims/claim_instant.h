// What claims say, as formulas in the letters and in what the statement leaves open.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "problem/claims/claim_proof.h"
#include "problem/formulas/formula_instant.h"

namespace poinsot::problem {

// A comparison of a claim or an assumption: of numbers one, of vectors one for each component.
struct ClaimTerm {
  FormulaComparison comparison;
  // The same said by cosines, where both sides are angles between 0 and 180 deg.
  std::optional<FormulaComparison> by_cosines;
  Dimension dimension;
};

// What formulas rest on beside the laws: see DecisionScope.
struct Decisions {
  std::vector<Formula> signs;  // each has everywhere the sign that it has at the base
  bool zeros_by_digits = false;
  void add(const Decisions& other);
};

// One situation at its instant, and just before its blow, as formulas: for all claims made of it.
class ClaimFormulas {
 public:
  // numbers: the same at some values of the letters, with these settings. all_poses: coordinates without name are
  // letters too. Throws NoFormula, StatementError, std::domain_error, ExpressionTooLarge. All arguments must outlive
  // it.
  ClaimFormulas(const Situation& situation, const FormulaValues& values, const Settings& settings,
                const SolvedInstant& numbers, bool all_poses);

  struct Found {
    Value<Formula> value;
    Decisions decisions;  // that it took, those of the instant included
  };
  // On ground axes; found once for all claims.
  const Found& value(const Expression& expression, const std::optional<Expression>& axes);
  // Without squares of unknowns that are neglected, and with the unknowns as they are to this order.
  Formula reduced(const Formula& x) const;

  const Situation& situation() const { return situation_; }
  const FormulaInstant& instant() const { return *instant_; }
  const Decisions& decisions() const { return decisions_; }
  // What must vanish for the statement to hold.
  const std::vector<Formula>& remainders() const { return instant_->remainders(); }
  // Positions and velocities that are open; accelerations and forces that nothing fixes.
  const OpenLetters& open() const { return open_; }
  // The state, before the blow where there is one.
  const std::vector<Formula>& positions() const { return instant_->positions(); }
  const std::vector<Formula>& velocities() const { return velocities_; }

 private:
  Value<Formula> elsewhere(const At& at, const Mark& mark, const std::optional<Expression>& axes);
  ClaimFormulas& before();
  void neglect_squares();
  Value<Formula> reduced(Value<Formula> value) const;

  const Situation& situation_;
  const FormulaValues& values_;
  const Settings& settings_;
  const SolvedInstant& numbers_;
  OpenLetters open_;
  Decisions decisions_;
  std::unique_ptr<FormulaInstant> instant_;
  std::vector<Formula> velocities_;
  std::unique_ptr<SolvedInstant> before_numbers_;
  std::unique_ptr<ClaimFormulas> before_;
  std::map<std::string, Found> found_;
  std::vector<std::string> small_;           // letters of unknowns whose squares are neglected
  std::map<std::string, Formula> unknowns_;  // all unknowns then, to first order
};

class ClaimInstant {
 public:
  // Throws what ClaimFormulas does, which must outlive it.
  ClaimInstant(ClaimFormulas& formulas, const Claim& claim);

  const std::vector<ClaimTerm>& terms() const { return terms_; }
  // What is assumed, what is stated and leaves no room for all values of the letters included.
  const std::vector<FormulaComparison>& assumptions() const { return assumptions_; }
  const Decisions& decisions() const { return decisions_; }
  const std::vector<Letter>& open() const { return formulas_.open().made; }
  std::vector<std::string> unfixed() const;
  ClaimFormulas& formulas() const { return formulas_; }

 private:
  void add_terms(const Expression& expression, const std::optional<Expression>& axes, std::vector<ClaimTerm>& terms);

  ClaimFormulas& formulas_;
  std::vector<ClaimTerm> terms_;
  std::vector<FormulaComparison> assumptions_;
  Decisions decisions_;
};

}  // namespace poinsot::problem
