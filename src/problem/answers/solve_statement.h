// All questions of a statement, answered.
//
// An answer is determined when no choice of what the statement leaves open changes it: letters without value, values
// given as `any`, gravity of which nothing is said, velocities and forces that no equation fixes. Each of these is
// varied by itself and the answers are compared, so that what an answer depends on can be named.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// sets: names of letters and data with the texts of their values; a later one for a name counts.
// tell_claims: also what a worked solution shows of claims: their comparisons, assumed, stability. Throws
// StatementError: unknown names, wrong dimensions, contradictions, unphysical bodies.
SolvedStatement solve_statement(const Statement& statement,
                                const std::vector<std::pair<std::string, std::string>>& sets, bool tell_claims = false);

// The settings that the texts stand for. Throws StatementError.
Settings read_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets);

}  // namespace poinsot::problem
