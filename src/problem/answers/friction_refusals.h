// What is not solved where contacts have friction.
#pragma once

#include <optional>
#include <string>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// Throws StatementError, which says which and why: for facts of later instants, steady motions and stability,
// claims, tables over data beside unknowns, and extrema but for limits of what contacts do.
void refuse_beside_friction(const Statement& statement, const Settings& settings);

// Throws StatementError for what is not solved with blows at rough contacts: claims and choices;
// and with friction of teeth.
void refuse_beside_rough_blows(const Statement& statement);

// Whether the extremum is a limit of what contacts do at an instant, {smallest: mu, while: sticking(floor)}, or of a
// comparison there.
bool is_limit_of_states(const Ask& ask);

// A cord round a post one side of which may pull a billion times as hard as the other, so that no digits tell whether it
// slips; nothing if there is none.
std::optional<std::string> cord_beyond_digits(const Statement& statement, const Settings& settings);

}  // namespace poinsot::problem
