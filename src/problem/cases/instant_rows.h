// Answers at instants for many cases: of each case the instant alone is solved again.
//
// An answer is determined where nothing is left open, which the solved instant knows. The variations that find out
// what an answer depends on, and the check with particles, are left to the few cases that are solved in full.
#pragma once

#include <optional>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Whether the questions need instants alone: no motion, no search for unknowns, extremes or ranges, nothing whose
// answer hangs on what the statement does not say.
bool needs_instants_alone(const Statement& statement);

// Whether each question is about instants to which no motion leads.
bool asks_instants_alone(const Statement& statement);

// The numbers of all answers, one after the other; nothing where the case has to be solved in full, since something is
// open, a cord would push, an answer is no number or does not exist. Throws nothing but BudgetEnded.
std::optional<std::vector<double>> instant_numbers(const Statement& statement, const AllSettings& settings);

// Whether the case of a statement that asks instants alone may be confirmed as below: no choices among roots, no later
// facts.
bool may_be_confirmed(const Statement& statement);

// The same with unknowns found anew, and with all second roads to what is told: the bodies as particles, constraints by
// geometry, laws, facts. What a full solution varies one by one to see whether an answer depends on it - gravity of
// which nothing is said, open velocities and forces - has one random choice here: who compares the numbers with others
// sees the same. Nothing where there are several roots, where a second road does not confirm the numbers, or where what
// is open keeps a cord from pulling.
std::optional<std::vector<double>> confirmed_numbers(const Statement& statement, const Settings& settings);

}  // namespace poinsot::problem
