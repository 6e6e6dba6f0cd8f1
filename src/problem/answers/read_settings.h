// Values that letters and data get from outside of the file, by --set or by a caller.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problem/formulas/formula_answers.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// sets: names of letters and data with the texts of their values; for a name given twice the later one counts. Throws
// StatementError.
Settings read_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets);

// The same values as formulas; names that no situation has are left out.
FormulaValues exact_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets);

}  // namespace poinsot::problem
