// Checks of answers before they are given. Answers that are unphysical or fail a check are refused, and notes tell
// what else a reader of a motion should know.
#pragma once

#include <memory>
#include <vector>

#include "problem/answers/ask_values.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {

// Where a cord would push or a contact pull, this refuses the answers that depend on forces, tables with such a row,
// extrema at which it happens, and unknowns that follow from stated forces. Whether something touches or is taut is
// still answered.
void refuse_unphysical(const Statement& statement, const AskValues& asked, Sample& sample, Solution& result);

// Checks every solved instant with particles, the drift of energy, and the error of motions. What fails is refused;
// if a fact does not hold in the solution, everything is. extremal: the instants at extrema.
void check_answers(const Statement& statement, Sample& sample, const std::vector<std::unique_ptr<Sample>>& extremal,
                   Solution& result);

// Adds notes on the stability of steady motions, on events during a motion, and on how it was found.
void add_notes(const Statement& statement, const Sample& sample, Solution& result);

}  // namespace poinsot::problem
