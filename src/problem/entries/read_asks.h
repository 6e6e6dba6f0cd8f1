// Reads what is asked, and what is expected.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

Ask read_ask(const Key& name, const Entry& entry, const std::string& file);

// `expect:` is one case (`letters:` gives its letters values), or several under `cases:`.
std::vector<ExpectedCase> read_expect(const Entry& entry, const std::string& file);

}  // namespace poinsot::problem
