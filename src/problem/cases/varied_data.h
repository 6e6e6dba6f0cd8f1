// The data of a statement that differ from case to case.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"

namespace poinsot::problem {

struct VariedDatum {
  std::string name;
  Dimension dimension;
  bool positive = false;  // whether its stated value is positive, or the file has it as a positive letter
  bool in_file = false;   // whether it is a datum with a value in the file, not a letter or an unknown
};

// The data, letters and unknowns with these names. Throws StatementError for a name that is none of these, one that is
// no number, and a datum that changes in time; `what` and the name are its place.
std::vector<VariedDatum> varied_data(const Statement& statement, const std::vector<std::string>& names,
                                     const std::string& what = "over");

// The statement with these data as letters without value.
Statement with_letters(const Statement& statement, const std::vector<VariedDatum>& data);

// A value of it as the text of a setting, which reads back to the same bits.
std::string setting_text(const VariedDatum& datum, double value);

// The statement with the questions of these names alone, in this order, and without claims; with all its questions if
// there are no names. Throws StatementError for a name that is no question's.
Statement with_questions(const Statement& statement, const std::vector<std::string>& names);

}  // namespace poinsot::problem
