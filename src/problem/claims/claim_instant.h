// The comparisons of claims as formulas in the letters and in what the statement leaves open.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "problem/claims/claim_proof.h"
#include "problem/formulas/formula_instant.h"

namespace poinsot::problem {

// A comparison of a claim or an assumption. One of vectors becomes three, one for each component.
struct ClaimTerm {
  FormulaComparison comparison;
  // The same comparison of cosines, if both sides are angles between 0 and 180 deg.
  std::optional<FormulaComparison> by_cosines;
  Dimension dimension;
  std::string of{};    // as `a < b`
  int component = -1;  // of vectors
};

// What formulas presume beside the laws of mechanics: see DecisionScope.
struct Decisions {
  std::vector<Formula> signs;  // each is presumed to have the sign everywhere that it has at the base point
  bool zeros_by_digits = false;
  void add(const Decisions& other);
};

// The instant of a situation as formulas, which all claims about it share; with a blow also the instant before it.
class ClaimFormulas {
 public:
  // numbers: the same instant solved at some values of the letters, with these settings. all_poses: whether
  // coordinates without name become letters too, for claims along the motion. Throws NoFormula, StatementError,
  // std::domain_error and FormulaTooLarge. All arguments must outlive the object.
  ClaimFormulas(const Situation& situation, const FormulaValues& values, const Settings& settings,
                const SolvedInstant& numbers, bool all_poses);

  struct Found {
    Value<Formula> value;
    Decisions decisions;  // those that it took, with those of the instant
  };
  // The value of an expression, by default on ground axes. It is computed once for all claims.
  const Found& value(const Expression& expression, const std::optional<Expression>& axes);
  // The formula without the squares that are neglected, and with the unknowns to that order.
  Formula reduced(const Formula& x) const;

  const Situation& situation() const { return situation_; }
  const FormulaInstant& instant() const { return *instant_; }
  const Decisions& decisions() const { return decisions_; }
  // What must vanish if the situation has a solution.
  const std::vector<Formula>& remainders() const { return instant_->remainders(); }
  // The letters made for positions and velocities that are open, and for accelerations and forces that nothing
  // determines.
  const OpenLetters& open() const { return open_; }
  // The state; if there is a blow, the one before it.
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
  std::vector<std::string> small_;           // letters of the unknowns whose squares are neglected
  std::map<std::string, Formula> unknowns_;  // if there are such, all unknowns to first order
};

class ClaimInstant {
 public:
  // Throws what the constructor of ClaimFormulas does. The formulas must outlive the object.
  ClaimInstant(ClaimFormulas& formulas, const Claim& claim);

  const std::vector<ClaimTerm>& terms() const { return terms_; }
  // The assumptions of the claim, together with what is stated and does not hold for all values of the letters.
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
