// Words that books and other programs use where the language has another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::problem {

// What is called `word` elsewhere: a key among those known here, or a call of a function among those known, as it is
// written. "" if there is none.
std::string customary_key(std::string_view word, const std::vector<std::string>& known);
// The unit of a quantity that is named in its place: kg of "mass"; "" if it names none.
std::string customary_unit_of(std::string_view quantity);
// The words by which the language joins what another word joins elsewhere, in quotes: 'at' for "through"; "" if
// there is none.
std::string customary_joining(std::string_view word);
std::string customary_call(std::string_view word, const std::vector<std::string>& known);

}  // namespace poinsot::problem
