// One problem for many cases: what is the same for all of them is done once.
//
//   poinsot::Cases cases = problem.cases({.over = {"n", "b"}, .asks = {"B"}, .first = {100.0, 0.3}});
//   poinsot::CaseRows rows = cases.solve({speeds, angles}, 0);
//   rows.columns[1]  // of cases.columns()[1], "B.y" in N
//
// Where the answers have formulas in what is varied, these are evaluated as straight-line code over many cases at once.
// Where they have none, and instants are all that is asked about, the equations of these are evaluated so, with an
// elimination that was recorded at the first case, and unknowns are found by Newton's method from their values there.
// Each case tells whether what was found is its solution: else its instant is solved again. Every thousandth case of
// these is compared with a full solution. All other cases are solved in full, one by one.
//
// Derivatives of answers are those of the formulas, or of the equations of instants; of cases that are solved one by
// one they are differences of the solutions beside them, which every thousandth of the others is compared with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/work/budget.h"

namespace poinsot {

namespace problem {
class CompiledCases;
}

struct CaseQuestions {
  std::vector<std::string> over;  // the letters, data and unknowns that differ from case to case
  std::vector<std::string> asks;  // the names of the questions; all if there are none
  std::vector<std::pair<std::string, std::string>> sets{};  // values that are the same for all cases
  std::vector<double> first{};  // the values in some case, SI: shows the shape of answers where formulas do not
  bool formulas = true;         // whether formulas may be used where there are some
  // Those of `over` by which every number of the answers is differentiated as well.
  std::vector<std::string> sensitivities{};
  // How large the values of each of `over` usually are, SI; those of `first` by default. Differences of solutions go by
  // steps of that size where a value is small beside it, as at zero.
  std::vector<double> usual{};
};

// A number of each case, in the coherent SI unit.
struct CaseColumn {
  std::string name;  // "T", "B.y" of a vector, "B.y by n" of a derivative
  std::string unit;
};

// How the answers of a case were found.
enum class CaseRoad : std::uint8_t { in_full, by_instant, by_formula };

struct CaseRows {
  std::vector<std::vector<double>> columns;  // as those of Cases::columns(); NaN where a case has no answer
  std::vector<CaseRoad> roads;               // of each case
  std::vector<std::pair<std::size_t, std::string>> reasons;  // of the cases in which an answer is missing, ascending
  std::size_t checked = 0;  // cases by formula or instant that were solved in full as well
  std::size_t refuted = 0;  // those where this gave something else: then all of these cases were solved in full
};

// A value that copies share and that does not change: several threads may use it at the same time.
class Cases {
 public:
  // What is varied, in the order of `over`.
  std::vector<CaseColumn> over() const;
  const std::vector<CaseColumn>& columns() const { return columns_; }
  bool has_formulas() const;
  std::string no_formulas() const;  // why there are none; else ""
  bool by_instants() const;         // whether cases may be answered by solving their instants alone
  std::string no_program() const;   // why equations of instants are not evaluated for many cases at once; else ""

  // values: a column for each of over(), of as many numbers as there are cases, in SI units. first: the number of the
  // first of these cases among all. The numbers of a case do not depend on the others in the call, unless a check
  // refutes a formula. Throws std::invalid_argument if the columns do not fit, and BudgetEnded, which is no
  // std::exception, if the budget ends first.
  CaseRows solve(const std::vector<std::span<const double>>& values, std::uint64_t first,
                 const Budget& budget = {}) const;

 private:
  friend class Problem;
  explicit Cases(std::shared_ptr<const problem::CompiledCases> parts);
  std::shared_ptr<const problem::CompiledCases> parts_;
  std::vector<CaseColumn> columns_;
};

}  // namespace poinsot
