// What is done with answers before they are given: those that are unphysical or fail a check are refused, and what the
// reader of a motion wants to know besides is noted.
#pragma once

#include <memory>
#include <vector>

#include "problem/answers/ask_values.h"
#include "problem/answers/solve_statement.h"

namespace poinsot::problem {

// A cord that would push or a contact that would pull: what depends on forces is refused, tables with such a row,
// extrema at which it is so, and unknowns that follow from stated forces; not whether it touches or is taut.
void refuse_unphysical(const Statement& statement, const AskValues& asked, Sample& sample, Solution& result);

// The check on particles of every instant that was solved, the drift of energy and the error of motions; what fails it
// is refused, and everything where a fact does not hold in what was found. extremal: instants at extrema.
void check_answers(const Statement& statement, Sample& sample, const std::vector<std::unique_ptr<Sample>>& extremal,
                   Solution& result);

// Stability of steady motions, what happened on the way of a motion and how it was found.
void add_notes(const Statement& statement, const Sample& sample, Solution& result);

}  // namespace poinsot::problem
