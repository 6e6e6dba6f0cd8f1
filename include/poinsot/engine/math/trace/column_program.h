// A straight-line program (straight_line.h) for many cases at once: columns of numbers in, columns of numbers out.
//
// The cases go through the program in blocks that stay in the fastest memory of the processor; within a block each
// operation is one loop over numbers, compiled for several instruction sets of which the best is taken when the program
// runs. Every operation is rounded by itself, so that the numbers of a case are the same bits wherever it stands, on
// every processor and with every division of the cases among threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "poinsot/engine/math/trace/straight_line.h"

namespace poinsot {

class ColumnProgram {
 public:
  explicit ColumnProgram(const StraightLine& program);

  std::size_t input_count() const { return inputs_; }
  std::size_t output_count() const { return outputs_.size(); }
  std::size_t operations() const { return instructions_.size(); }

  // inputs: a column for each input; outputs: room for a column for each output. Each has `rows` numbers, and none of
  // the outputs overlaps anything. Where a number does not exist (a root of less than zero) it is NaN.
  // std::invalid_argument if the number of columns is wrong.
  void evaluate(std::span<const double* const> inputs, std::size_t rows, std::span<double* const> outputs) const;
  // The same where only the first outputs have columns, and the others are conditions, which are looked at and not
  // kept. Returns of each case whether all of its numbers with columns are finite and all others are positive.
  std::vector<char> evaluate_where_valid(std::span<const double* const> inputs, std::size_t rows,
                                         std::span<double* const> outputs) const;

  // A place of a number of each case: an input, or a block of memory that is used again once its number is not needed
  // any more.
  struct Place {
    bool input = false;
    std::uint32_t index = 0;
  };
  enum class Operation : std::uint8_t {
    add,
    subtract,
    multiply,
    multiply_negative,  // -(a b)
    divide,
    divide_negative,
    negate,
    square_root,
    sine_cosine,  // with two results
    arc_sine,
    arc_cosine,
    arc_tangent,
    arc_tangent_2,
    absolute
  };
  struct Instruction {
    Operation operation = Operation::add;
    Place first{}, second{};
    std::uint32_t result = 0, second_result = 0;
  };

 private:
  struct Constant {
    std::uint32_t block = 0;
    double value = 0;
  };

  // Calls finish(start, count, at) after each block of cases: at(place) is where its numbers stand.
  template <class Finish>
  void run(std::span<const double* const> inputs, std::size_t rows, const Finish& finish) const;

  std::vector<Constant> constants_;
  std::vector<Instruction> instructions_;
  std::vector<Place> outputs_;
  std::vector<bool> negative_outputs_;
  std::size_t inputs_ = 0, blocks_ = 0;

  class Compiler;
};

}  // namespace poinsot
