// A datum as text for a reader; a matrix takes a line for each row.
#pragma once

#include <string>
#include <vector>

#include "poinsot/document.h"

namespace poinsot::document {

// At least one line; the unit (printable) stands once, behind the last. Numbers are a list, `[a, b]`, or if `vector`
// the components of one, `(a, b, c)`, rounded together; texts are joined by commas; an empty list is "none".
std::vector<std::string> datum_lines(const Datum& datum, const std::string& unit, int digits, bool vector);

// The same on one line, rows of a matrix side by side; three numbers are a vector.
std::string datum_text(const Datum& datum, const std::string& unit, int digits);

// The assumptions of a solution, those that have conditions as formulas with these: "the cord 'c' stays taut: F - g*m >
// 0".
std::vector<std::string> assumptions_in_words(const Solution& solution);

}  // namespace poinsot::document
