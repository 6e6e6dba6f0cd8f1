// Puts quantities into words.
#pragma once

#include <string>
#include <string_view>

#include "problem/entries/statement.h"
#include "problem/language/expression.h"

namespace poinsot::problem {

// What is asked for, as in "angular momentum of disk about G, on the axes x y z of the ground".
std::string describe(const Ask& ask, const Situation& situation, bool is_vector);

// What a function of the language gives: "angular momentum"; "" if it has no noun of its own.
std::string_view noun_of(std::string_view function);

}  // namespace poinsot::problem
