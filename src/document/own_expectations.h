// Compares the answers to a problem file with the `expect` block of the same file.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::document {

// Describes each discrepancy in one line; empty if all agrees. Throws problem::StatementError as solve_statement
// does, and BudgetEnded if the budget in force ends first.
std::vector<std::string> own_shortfalls(const problem::Statement& stated);

}  // namespace poinsot::document
