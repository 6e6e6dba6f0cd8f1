// The formulas of a solved statement as one straight-line program over the data that differ from case to case.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poinsot/engine/math/trace/column_program.h"
#include "problem/cases/varied_data.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// The numbers of a number, a vector or a list of numbers; nothing of anything else.
template <class Scalar>
std::vector<Scalar> numbers_in(const Value<Scalar>& value) {
  if (value.is_number()) return {value.number};
  if (value.is_vector()) return {value.vector.x, value.vector.y, value.vector.z};
  std::vector<Scalar> numbers;
  for (const Value<Scalar>& item : value.items) {
    if (!item.is_number()) return {};
    numbers.push_back(item.number);
  }
  return numbers;
}

class CaseFormulas {
 public:
  // solved: the statement with the data as letters. Nothing, and the reason, if not every question has a formula, or
  // the conditions under which these hold are known in words alone. by: the places of the data by which the answers are
  // differentiated.
  static std::optional<CaseFormulas> made(const SolvedStatement& solved, const std::vector<VariedDatum>& data,
                                          const std::vector<std::size_t>& by, std::string& reason);

  // data: a column for each datum. results: room for a column for each number of the answers, in their order, and then
  // for each of its derivatives, all by the first datum before those by the next. Returns
  // for each case whether the conditions hold and every number exists.
  std::vector<char> evaluate(std::span<const double* const> data, std::size_t rows,
                             std::span<double* const> results) const;

  std::size_t operations() const { return program_.operations(); }

 private:
  explicit CaseFormulas(ColumnProgram program) : program_(std::move(program)) {}

  ColumnProgram program_;  // its outputs are the results and then what must be positive
};

}  // namespace poinsot::problem
