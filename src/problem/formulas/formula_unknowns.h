// Solves for the unknowns as formulas, from what must vanish if all facts and equations hold.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"
#include "problem/language/value.h"

namespace poinsot::problem {

// A letter that stands for a number until its formula is found.
struct UnknownLetter {
  std::string name;
  bool angle = false;
  double value = 0;    // at the root that is meant, where signs are decided too (PlainPointScope)
  double natural = 0;  // the natural size of such an unknown, beside which one that vanishes is found with rounding
};

// The coefficients of x as a polynomial in a letter, in ascending order; nothing if it is none of the fourth degree or
// less.
std::optional<std::vector<Formula>> polynomial_in(const Formula& x, const std::string& letter);

// The formula to first order in letters that are small. Throws std::domain_error if it has no value where they
// vanish.
Formula first_order(const Formula& x, const std::vector<std::string>& small);

// A formula whose sign is part of other formulas, and the sign that it is taken to have there.
struct DecidedSign {
  Formula of;
  int sign = 1;
  Formula positive() const { return sign < 0 ? -of : of; }
};
// What in the formulas has a sign and contains one of the letters, with its sign at the point of decisions. With these
// the size of an unknown is that unknown or minus it.
std::vector<DecidedSign> signs_of_unknowns(const std::vector<Formula>& remainders,
                                           const std::vector<UnknownLetter>& letters);
Formula with_signs(const Formula& x, const std::vector<DecidedSign>& signs);
Value<Formula> with_signs(const Value<Formula>& value, const std::vector<DecidedSign>& signs);
// With sizes |x| as x or -x where all of these are positive, as far as that is seen.
Value<Formula> with_sizes(const Value<Formula>& value, const std::vector<Formula>& positive);

// Solves the equations one after the other. Those that are linear in an unknown come first, then those that are
// quadratic in it, in its square, or in the tangent of half an angle. Of several roots the one close to the unknown's
// value is taken. remainders: must all vanish. Throws NoFormula if unknowns are left over, or equations that do not
// hold. leading: gets the leading over the linear coefficients of quadratics, also of those in tangents of half angles.
// Where one vanishes there is a root, too, but of the two formulas one is 0/0 there and the other infinite.
std::map<std::string, Formula> solve_unknowns(std::vector<Formula> remainders, std::vector<UnknownLetter> unknowns,
                                              std::vector<Formula>* leading = nullptr);

}  // namespace poinsot::problem
