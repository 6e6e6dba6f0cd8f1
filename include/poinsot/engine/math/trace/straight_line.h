// A straight-line program: what a trace (traced.h) needs for some of its results, made shorter and ready to be
// evaluated or written as code (straight_line_text.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "poinsot/engine/math/trace/traced.h"

namespace poinsot {

class StraightLine {
 public:
  struct Operand {
    std::uint32_t step = 0;
    bool negative = false;
    friend bool operator==(const Operand&, const Operand&) = default;
  };
  struct Step {
    TracedOperation operation = TracedOperation::constant;
    Operand first{}, second{};
    double value = 0;                             // of a constant, positive; 0 only at step 0
    std::int64_t numerator = 0, denominator = 0;  // of a constant that is a small fraction; else denominator 0
    std::uint32_t input = 0;                      // which input of the trace
  };

  // How thoroughly shorter programs are sought. quick: by common factors and other ways with one or two operations to
  // the same numbers, in about a millisecond for small models. thorough: by ways with up to three, in milliseconds,
  // which pays for code that is kept.
  enum class Shortening { quick, thorough };

  // Keeps only what the outputs need, and combines terms of sums that share a factor as long as this saves
  // operations.
  StraightLine(const Trace& trace, const std::vector<Traced>& outputs, Shortening shortening = Shortening::thorough);

  // Each step comes after those that it uses: zero first, then inputs, constants and operations.
  const std::vector<Step>& steps() const { return steps_; }
  const std::vector<Operand>& outputs() const { return outputs_; }
  std::size_t input_count() const { return inputs_; }
  // The number of additions, subtractions, products, quotients and functions. A sine and the cosine of the same angle
  // count as two.
  std::size_t operations() const;

  // input: one number per input of the trace; output: one per output. std::invalid_argument if a size is wrong.
  void evaluate(std::span<const double> input, std::span<double> output) const;

 private:
  std::vector<Step> steps_;
  std::vector<Operand> outputs_;
  std::size_t inputs_ = 0;
};

bool is_operation(TracedOperation operation);

}  // namespace poinsot
