// The values of all asks for one choice of what the statement leaves open.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"
#include "problem/answers/watched_values.h"
#include "problem/language/diagnostic.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct AskValues {
  std::vector<std::optional<WatchedValue>> values;  // in the order of the asks; missing for an ask without value
  std::vector<std::unique_ptr<Sample>> extremal;    // the samples at the extrema that are asked for
  std::map<std::string, std::string> no_extremum;   // for each ask without extremum the reason
  std::vector<std::string> notes;                   // on extrema beyond which the conditions do not clearly fail
  // For each ask that a motion does not answer or a velocity leaves open, the message.
  std::map<std::string, Diagnostic> unanswered;
  std::optional<BudgetEnd> ended;  // what ended the search for values before the last ones were found
  Work work = 0;                   // that the values were

  // Whether the search ended before this ask.
  bool was_not_reached(const std::string& name, std::size_t index) const {
    return ended && !values[index] && !no_extremum.contains(name) && !unanswered.contains(name);
  }
};

// Adds the value of the next ask: that of which there is none yet. settings: those of the sample. Throws
// StatementError.
void add_ask_value(const Statement& statement, Sample& sample, const AllSettings& settings, const OpenChoice& choice,
                   AskValues& values);
// Those of all asks. Throws StatementError.
AskValues ask_values(const Statement& statement, Sample& sample, const AllSettings& settings, const OpenChoice& choice);

}  // namespace poinsot::problem
