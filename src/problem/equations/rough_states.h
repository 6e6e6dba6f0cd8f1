// The states of contacts with dry friction in which equations of motion hold.
#pragma once

#include <string>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// A situation whose contacts are in the states in which they are as it is stated, and the words that say so.
struct SituationInStates {
  Situation situation;
  std::vector<std::string> words;
};

// Throws StatementError, and NoEquations where the contacts may be in several states, or in one whose forces do not
// follow from those of constraints.
SituationInStates in_stated_states(const Statement& statement, const Situation& situation, const Settings& settings);

}  // namespace poinsot::problem
