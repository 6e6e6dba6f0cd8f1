// Reads what may be chosen: which of several impulses, loads or added masses there are.
#pragma once

#include <string>

#include "problem/entries/statement.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

Choice read_choice(const Key& name, const Entry& entry, const std::string& file);

// `choose:` may name impulses, loads and added masses, `without:` added masses only; the latter are taken out here.
void check_choices(Situation& situation);

}  // namespace poinsot::problem
