// Unknowns as formulas, from what must vanish if all facts and equations hold.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// A letter that stands for an unknown number until its formula is found.
struct UnknownLetter {
  std::string name;
  bool angle = false;
  double value = 0;  // of the root that is meant, at the point where decisions are taken (PlainPointScope)
};

// The expression up to the first power of letters that are small, without products of them. Throws std::domain_error
// where it has no value when they are zero.
Formula first_order(const Formula& x, const std::vector<std::string>& small);

// Equations are taken one after the other: those that are linear in an unknown first, then those that are quadratic in
// it, in its square, or of this kind in the tangent of half an angle. Of two roots that near the value is taken.
// remainders: all must vanish. Throws NoFormula if unknowns are left, or equations that do not hold.
std::map<std::string, Formula> solve_unknowns(std::vector<Formula> remainders, std::vector<UnknownLetter> unknowns);

}  // namespace poinsot::problem
