// A formula as it stands in answers, conditions and assumptions.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/exact_numbers.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

struct FormulaTask;

// The text of a formula of the statement's letters and numbers, with standard gravity as a factor by itself:
// 5*m*9.80665/2.
std::string formula_words(const Formula& x);

// Tells of formulas that hold in SI units only, as their numbers have units that are not written, where the statement
// uses others: 0.531*M for a couple M in lb*ft.
void tell_units(const FormulaTask& task, Solution& solution);

// Values of letters, in their units: "d = 2 m, k = 30 N/m".
std::string values_in_words(const std::vector<Letter>& letters, const LetterValues& values);

}  // namespace poinsot::problem
