// Contacts with dry friction: in which states they stick, slide and part, and the answers in each of them.
//
// Each combination of states that holds (contact_state_search.h) makes a statement without unknown states, which is
// solved like any other and is a solution. There may be none or several (Painleve's rod). With open letters the
// combinations are those that hold at some values of them; each solution tells its conditions.
#pragma once

#include <functional>
#include <vector>

#include "problem/formulas/formula_instant.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// No state of the contacts with friction holds, whatever is tried: rigid bodies with dry friction may have no motion.
class NoStateError : public StatementError {
 public:
  using StatementError::StatementError;
};

// How far the values of letters spread at one draw after another, so that contacts come to stick and to slide, and how
// often they are drawn.
inline constexpr int most_state_draws = 80;
inline int spread_of_state_draw(int draw) { return draw / 4; }

// Whether contacts have friction whose states are still to be found.
bool has_open_contact_states(const Statement& statement);

// The statement in which the contacts are in the states of a solution.
Statement in_contact_states(const Statement& statement, const std::vector<ContactState>& states);

// The settings of each situation with the unknowns of a root.
std::vector<Settings> settings_of_root(const Statement& statement, const Settings& settings, const Solution& solution);
// The formulas of each situation for unknowns that depend on open letters.
std::vector<FormulaValues> formulas_of_root(const Statement& statement, const Solution& solution);

// Solves a statement in all states that hold, each by `solve`. exact: the settings, as formulas. Throws NoStateError
// where none does, and StatementError for what is not solved with friction.
SolvedStatement solve_contact_states(const Statement& statement, const Settings& settings, const FormulaValues& exact,
                                     const std::function<SolvedStatement(const Statement&)>& solve);

}  // namespace poinsot::problem
