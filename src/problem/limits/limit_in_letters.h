// Up to which value of a datum contacts, cords and comparisons keep what is asked of them, in letters:
// {largest: P, while: touching(rear)}.
//
// Where letters have values the end is found by numbers (unknowns/extremum.h), and with it the states in which contacts
// with friction are just before and just beyond it. In each of these what must be positive while it lasts is known as a
// formula (instant/friction_conditions.h). The end is where one of them vanishes, and its formula holds where the
// others are positive there and that one falls towards it. So it is at other letters, where other contacts may slide or
// part first: each such formula is told with its conditions, as of other answers. All of them are held against ends
// that are found by numbers.
#pragma once

#include <vector>

#include "problem/formulas/formula_instant.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// The answer to one question, as a solution with nothing else: with the assumptions of its formula and what it rests
// on. ask: one of the statement, about what contacts do at an instant, whose states are still to be found. open: the
// letters without value. draws: settings with values for these, of which the first are nearest to their units. given:
// values from outside the file. Throws StatementError where the statement makes no sense at any of them.
Solution limit_in_letters(const Statement& statement, const Ask& ask, const std::vector<Letter>& open,
                          const std::vector<Settings>& draws, const FormulaValues& given);

}  // namespace poinsot::problem
