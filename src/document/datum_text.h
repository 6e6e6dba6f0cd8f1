// A datum as text for a reader; a matrix takes a line for each row.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poinsot/document.h"

namespace poinsot::document {

// At least one line. The unit (printable) stands behind the last line. Numbers are shown as a list `[a, b]`, or if they
// are as many as `vector` as components `(a, b, c)` that are rounded together; texts are joined by commas; an empty
// list is "none".
std::vector<std::string> datum_lines(const Datum& datum, const std::string& unit, int digits, std::size_t vector);

// The same on a single line, with the rows of a matrix one after the other.
std::string datum_text(const Datum& datum, const std::string& unit, int digits, std::size_t vector = 3);
// Whether that text is a list in brackets, as the rows of a matrix are.
bool has_brackets(const Datum& datum, std::size_t vector = 3);

// The assumptions of a solution, without those of a single one of several formulas of an answer. Those that have a
// condition are followed by its formula: "the cord 'c' stays taut: F
// - g*m > 0".
std::vector<std::string> assumptions_in_words(const Solution& solution);

// The rows of a table in letters; a single one may stand as a list.
std::vector<std::vector<std::string>> formula_rows(const Datum& formula);

// The columns of a table as it is shown: before those that are asked for stands what it runs over.
std::vector<Column> shown_columns(const Answer& answer);

}  // namespace poinsot::document
