// A problem file's answers against the `expect` block of the same file.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::document {

// What falls short, one line each; none: all agrees. Throws problem::StatementError as solve_statement does.
std::vector<std::string> own_shortfalls(const problem::Statement& stated);

}  // namespace poinsot::document
