// What a claim says, as formulas in the letters and in what the statement leaves open.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "statement/claim_proof.h"
#include "statement/formula_instant.h"

namespace poinsot::statement {

// A comparison of a claim or an assumption: of numbers one, of vectors one for each component.
struct ClaimTerm {
  FormulaComparison comparison;
  // The same said by cosines, where both sides are angles between 0 and 180 deg.
  std::optional<FormulaComparison> by_cosines;
  Dimension dimension;
};

// A problem for claims: what is given as `any`, and gravity of which nothing is said, are letters.
Problem with_letters_for_any(const Problem& problem);

// Whether a claim says of a rate that it is zero, or on which side of zero: then it is meant along the motion, in any
// pose, else in the pose as drawn.
bool is_along_motion(const Problem& problem, const Claim& claim);

// Whether what is stated tells of accelerations or forces, so that it may leave no room for all values of the letters.
bool states_forces(const Problem& problem);

// Whether it calls derivative(X by letter), which has no numbers.
bool takes_derivatives(const Problem& problem, const Claim& claim);

class ClaimInstant {
 public:
  // Throws NoFormula, StatementError, std::domain_error, ExpressionTooLarge. All arguments must outlive it.
  ClaimInstant(const Problem& problem, const Claim& claim, const FormulaValues& values, const SolvedInstant& numbers);

  const std::vector<ClaimTerm>& terms() const { return terms_; }
  // What is assumed, what is stated and leaves no room for all values of the letters included.
  const std::vector<FormulaComparison>& assumptions() const { return assumptions_; }
  // Positions and velocities that are open; accelerations and forces that nothing fixes, where the claim needs them.
  const std::vector<Letter>& open() const { return open_.made; }
  std::vector<std::string> unfixed() const;
  const std::vector<Formula>& positions() const { return instant_->positions(); }
  const std::vector<Formula>& velocities() const { return instant_->velocities(); }

 private:
  Value<Formula> value(const Expression& expression, const std::optional<Expression>& axes);
  void add_terms(const Expression& expression, const std::optional<Expression>& axes, std::vector<ClaimTerm>& terms);

  const Problem& problem_;
  const FormulaValues& values_;
  const SolvedInstant& numbers_;
  OpenLetters open_;
  std::unique_ptr<FormulaInstant> instant_, before_;
  std::unique_ptr<SolvedInstant> before_numbers_;
  std::vector<ClaimTerm> terms_;
  std::vector<FormulaComparison> assumptions_;
};

}  // namespace poinsot::statement
