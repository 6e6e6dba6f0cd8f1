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

// What is positive by what the situations assume of the letters, where it is not equal to a bound either.
std::vector<Formula> assumed_positive(const FormulaTask& task);
// Whether something is positive wherever these are, as far as that is seen; or_zero: or zero.
bool is_assumed_positive(const Formula& x, const std::vector<Formula>& assumed, bool or_zero = false);

// A value with that of its formula at letters in its place; angles are those within half a turn of it.
Value<double> at_letters(const Value<Formula>& formula, Value<double> near, const LetterValues& letters);
// Settings in which unknowns are what their formulas tell at letters.
AllSettings with_unknowns(AllSettings settings, const std::vector<SolvedUnknown>& unknowns,
                          const LetterValues& letters);

// Whether there are cords or contacts.
bool acts_on_one_side(const Statement& statement);

// Whether a value is a word, or a list of such.
bool is_word(const Value<double>& value);
// Whether signs that decide a word keep it for all letters that are assumed. by_trial: as far as letters show that lie
// all over six decades and where what is assumed just holds; else what is assumed must tell it. A comparison may turn
// anywhere: where its sign is not told it is for a claim, of which counterexamples are sought.
bool positive_where_assumed(const FormulaTask& task, const std::vector<Formula>& signs, bool by_trial);
// Whether it is the truth of inequalities, or of stability, of which formulas tell what decides it.
bool is_decided_truth(const Ask& ask, const Value<double>& value);

}  // namespace poinsot::problem
