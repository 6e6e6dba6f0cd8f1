// A solved statement for whose answers formulas are sought.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "problem/formulas/formula_instant.h"
#include "problem/results/solution.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct FormulaTask {
  const Statement& statement;
  const std::vector<Letter>& open;  // letters without value
  const FormulaValues& given;       // values from outside the file, exactly
  const Settings& known;            // the same values as numbers
  const std::vector<Unknown>& unknowns;
  const AllSettings& settings;  // of each situation, with values for the open letters and for the unknowns of one root
  Sample& sample;               // the statement solved with these settings
  const std::vector<double>& natural;  // the natural size of each ask

  bool has_friction() const;
  // Another value of an open letter. With unknowns and with friction it stays close to the first one, as roots and
  // states of contacts may exist only there.
  double drawn(const Letter& letter, std::mt19937_64& random) const;
};

// Whether an ask is about an instant that no motion leads to.
bool is_at_instant(const FormulaTask& task, const Ask& ask);

// Whether what the situations assume of the letters alone holds at these settings.
bool is_assumed(const Statement& statement, const AllSettings& settings);

// Whether the check with particles confirms every instant of a sample that was solved.
bool confirmed_by_particles(Sample& sample);

// Whether an ask is for the largest or smallest value of the only open letter, which has no value of its own there.
bool speaks_of_no_letter(const FormulaTask& task, const Ask& ask);

// Takes back all formulas of a solution, for a reason, and numbers that depend on letters.
void withhold_formulas(const FormulaTask& task, Solution& solution, const std::string& reason);

// What is positive where unknowns with formulas lie in the ranges that are stated of them, as far as that is not so for
// all letters and can be told without motions.
std::vector<Formula> stated_bounds(const FormulaTask& task, const std::vector<SolvedUnknown>& unknowns);

// Whether there are cords or contacts.
bool acts_on_one_side(const Statement& statement);

// Whether a value is a word, or a list of such. Of a truth it is not known what decided it: sides that are compared by
// their numbers leave no sign.
bool is_word(const Value<double>& value);

}  // namespace poinsot::problem
