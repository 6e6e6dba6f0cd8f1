// What is not solved where contacts have friction.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// Throws StatementError, which says which and why: for facts of later instants, steady motions and stability, and
// claims.
void refuse_beside_friction(const Statement& statement);

// Some questions are not answered beside friction, whatever the rest of the file is: tables over data beside unknowns,
// and extrema but for limits of what contacts do. Where there are such, the answers to the others, with the reason at
// these. Throws StatementError where no others are left or one cannot be read.
std::optional<SolvedStatement> solve_without_refused(const Statement& statement,
                                                     const std::function<SolvedStatement(const Statement&)>& solve);

// Throws StatementError for what is not solved with blows at rough contacts: claims and choices;
// and with friction of teeth.
void refuse_beside_rough_blows(const Statement& statement);

// Whether the extremum is a limit of what contacts do at an instant, {smallest: mu, while: sticking(floor)}, or of a
// comparison there.
bool is_limit_of_states(const Ask& ask);

// A cord round a post one side of which may pull a billion times as hard as the other, so that no digits tell whether
// it slips; nothing if there is none.
std::optional<std::string> cord_beyond_digits(const Statement& statement, const Settings& settings);

// Whether facts state accelerations, which friction may contradict.
bool states_accelerations(const Statement& statement);

}  // namespace poinsot::problem
