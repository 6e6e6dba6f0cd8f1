// The values of all asks for one choice of everything that the statement leaves open.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/answers/watched_values.h"
#include "problem/language/diagnostic.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct AskValues {
  std::vector<std::optional<WatchedValue>> values;  // in the order of the asks; missing where there is none
  std::vector<std::unique_ptr<Sample>> extremal;    // at the extrema that are asked
  std::map<std::string, std::string> no_extremum;   // why there is none, by ask
  std::vector<std::string> notes;                   // what else ends where an extremum is
  std::map<std::string, Diagnostic> unanswered;     // what a motion does not tell or a velocity leaves open, by ask
};

// settings: those of the sample. Throws StatementError.
AskValues ask_values(const Statement& statement, Sample& sample, const AllSettings& settings, const OpenChoice& choice);

}  // namespace poinsot::problem
