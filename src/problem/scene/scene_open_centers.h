// Mass centers of which a statement leaves coordinates open, in a place where a reader looks for them.
#pragma once

#include <optional>

#include "problem/entries/statement.h"

namespace poinsot::problem {

// The statement with `any` in the centers of bodies replaced by the coordinates of where a joint holds them; nothing if
// there is nothing to replace.
std::optional<Statement> with_open_centers_at_joints(const Statement& statement);

}  // namespace poinsot::problem
