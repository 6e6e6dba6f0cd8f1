// Answers all questions of a statement.
//
// An answer is determined when it is the same for every choice of what the statement leaves open: letters without
// value, values given as `any`, gravity of which nothing is said, velocities and forces that no equation determines.
// These are varied one at a time and the answers compared, so that what an answer depends on can be named.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// sets: names of letters and data with the texts of their values; for a name given twice the later one counts.
// tell_claims: whether to keep what a worked solution shows of claims (comparisons, assumptions, stability). Throws
// StatementError for unknown names, wrong dimensions, contradictions and unphysical bodies.
SolvedStatement solve_statement(const Statement& statement,
                                const std::vector<std::pair<std::string, std::string>>& sets, bool tell_claims = false);

// The questions of a statement without claims whose letters all have values. settings: of letters and data, in SI
// units.
SolvedStatement solve_questions(const Statement& statement, const Settings& settings);
// The same for what is not shown, but compared with answers of another road: no scan vouches for the values of
// unknowns.
SolvedStatement solve_to_compare(const Statement& statement, const Settings& settings);

}  // namespace poinsot::problem
