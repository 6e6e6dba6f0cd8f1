// Takes what an explanation shows out of a solved instant.
#pragma once

#include "problem/entries/statement.h"
#include "problem/explanation/explanation_figures.h"
#include "problem/formulas/formula_instant.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

// The figures of an instant as numbers. before: the instant before the blow, if there is one.
InstantFigures<double> figures_of(const SolvedInstant& solved, const SolvedInstant* before);

// The figures of an instant as formulas. forces: whether forces were solved.
InstantFigures<Formula> figures_of(const FormulaInstant& formulas, bool forces);

}  // namespace poinsot::problem
