// Reads what is asked, and the values that are expected.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Ask read_ask(const Key& name, const Entry& entry, const std::string& file);

// `expect:` holds one case, in which `letters:` gives values to letters, or several cases under `cases:`.
std::vector<ExpectedCase> read_expect(const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
