// The instants of a statement as straight-line programs over the data that differ from case to case.
//
// Machine, conditions and equations are set up once, as formulas in the data. What their linear equations determine is
// solved by an elimination that is recorded once, and stands as a letter in all that follows. Unknowns are found by
// Newton's method, from the root at the values where the program was made: so the numbers of a case do not depend on
// other cases. Each case tells whether all of this holds for it too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poinsot/engine/math/trace/column_program.h"
#include "problem/cases/varied_data.h"
#include "problem/formulas/formula_instant.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Where a program is made.
struct ProgramSample {
  const Statement& statement;  // with the data as letters
  const std::vector<VariedDatum>& data;
  const std::vector<std::size_t>& by;  // the places of the data by which the answers are differentiated
  const FormulaValues& given;          // what is the same for all cases
  const std::vector<Unknown>& unknowns;
  Sample& numbers;  // solved there; with the unknowns among its settings
};

class InstantProgram {
 public:
  // Nothing, and the reason, if the instants cannot be put so.
  static std::optional<InstantProgram> made(const ProgramSample& sample, std::string& reason);

  // data: a column for each datum. results: room for a column for each number of the answers, in their order, and then
  // for each of its derivatives, all by the first datum before those by the next. Returns
  // for each case whether what was found is its solution: the equations hold, pivots and signs are as they were where
  // the program was made, unknowns lie in their ranges, cords pull and contacts push.
  std::vector<char> evaluate(std::span<const double* const> data, std::size_t rows,
                             std::span<double* const> results) const;

 private:
  friend class InstantTracer;
  // Of the numbers of a case: inputs of the trace first, data before all others, then what programs tell.
  using Slot = std::uint32_t;
  struct Part {
    ColumnProgram program;
    std::vector<Slot> slots;  // of its outputs
  };
  // An unknown and the equations it is found by.
  struct Root {
    Slot slot = 0;
    double start = 0;
    double size = 1;  // beside which changes of it count
  };
  struct Equation {
    Slot value = 0;
    std::vector<Slot> slopes;  // by each of the roots
    std::vector<Slot> by;      // by each of the data that answers are differentiated by
    double weight = 1;         // makes the largest of its slopes, by the sizes of the roots, one
  };
  class Block;

  InstantProgram() = default;

  std::size_t slots_ = 0;
  std::vector<Part> parts_;  // one after the other
  std::vector<Root> roots_;
  std::vector<Equation> equations_;
  // Derivatives stand among the results as they are while the roots stay; how these change adds to them.
  std::vector<Slot> positive_, results_;
  std::vector<std::vector<Slot>>
      slopes_;  // of each number of the answers by each of the roots, where there is use of them
};

}  // namespace poinsot::problem
