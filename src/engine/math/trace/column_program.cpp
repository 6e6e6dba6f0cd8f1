#include "poinsot/engine/math/trace/column_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/math/algebra/sine_cosine.h"

// The loops are compiled for these instruction sets, and the loader takes the best that the processor has. Sanitizers
// run before it may ask the processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define POINSOT_FOR_EACH_INSTRUCTION_SET \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), flatten))
#else
#define POINSOT_FOR_EACH_INSTRUCTION_SET
#endif

namespace poinsot {
namespace {

using Op = TracedOperation;

// Cases of a block: many enough that finding the next operation takes little beside its loop, and few enough that the
// blocks of some twenty numbers stay in 32 KiB.
constexpr std::size_t block_rows = 128;

}  // namespace

// Gives the numbers of a program their places.
class ColumnProgram::Compiler {
 public:
  Compiler(ColumnProgram& compiled, const StraightLine& program) : to_(compiled), steps_(program.steps()) {
    last_use_.assign(steps_.size(), 0);
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (is_operation(steps_[i].operation))
        for (const std::uint32_t used : {steps_[i].first.step, steps_[i].second.step}) last_use_[used] = i;
    for (const StraightLine::Operand& output : program.outputs()) last_use_[output.step] = never;
    places_.resize(steps_.size());
    pair_angles();
    for (std::size_t i = 0; i < steps_.size(); ++i) add(i);
    for (const StraightLine::Operand& output : program.outputs()) {
      to_.outputs_.push_back(places_[output.step]);
      to_.negative_outputs_.push_back(output.negative);
    }
    to_.blocks_ = blocks_;
  }

 private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  // The sine and the cosine of one angle are computed together, where the first of them stands.
  void pair_angles() {
    std::map<std::pair<std::uint32_t, bool>, std::size_t> first;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (steps_[i].operation != Op::sine && steps_[i].operation != Op::cosine) continue;
      const auto [known, is_new] = first.try_emplace({steps_[i].first.step, steps_[i].first.negative}, i);
      if (is_new || steps_[known->second].operation == steps_[i].operation) continue;
      partner_[known->second] = i;
      partner_[i] = known->second;
    }
  }

  std::uint32_t new_block() {
    if (free_.empty()) return blocks_++;
    const std::uint32_t block = free_.back();
    free_.pop_back();
    return block;
  }
  void release(std::uint32_t step, std::size_t now) {
    if (last_use_[step] != now || places_[step].input || !is_operation(steps_[step].operation)) return;
    free_.push_back(places_[step].index);
    last_use_[step] = never;
  }
  Place operand(const StraightLine::Operand& x) {
    if (!x.negative) return places_[x.step];
    const std::uint32_t block = new_block();
    to_.instructions_.push_back({Operation::negate, places_[x.step], places_[x.step], block, block});
    scratch_.push_back(block);
    return {false, block};
  }

  void add(std::size_t i) {
    const StraightLine::Step& step = steps_[i];
    if (step.operation == Op::input) {
      places_[i] = {true, step.input};
      return;
    }
    if (step.operation == Op::constant) {
      // Written once for all cases: no block in which anything else ever stands.
      places_[i] = {false, blocks_++};
      to_.constants_.push_back({places_[i].index, step.value});
      return;
    }
    const bool angle = step.operation == Op::sine || step.operation == Op::cosine;
    const auto partner = angle ? partner_.find(i) : partner_.end();
    if (partner == partner_.end() || partner->second > i) compute(i, partner == partner_.end() ? i : partner->second);
    release(step.first.step, i);
    if (step.second.step != step.first.step) release(step.second.step, i);
    free_.insert(free_.end(), scratch_.begin(), scratch_.end());
    scratch_.clear();
  }

  void compute(std::size_t i, std::size_t partner) {
    const StraightLine::Step& step = steps_[i];
    Instruction made;
    const bool product = step.operation == Op::multiply || step.operation == Op::divide;
    const bool negative = step.first.negative != step.second.negative;
    if (product) {
      made.operation = step.operation == Op::multiply ? negative ? Operation::multiply_negative : Operation::multiply
                       : negative                     ? Operation::divide_negative
                                                      : Operation::divide;
    } else {
      made.operation = plain_operation(step);
    }
    const bool signs_are_in_operation = product || (step.operation == Op::add && !step.first.negative);
    made.first = signs_are_in_operation ? places_[step.first.step] : operand(step.first);
    made.second = signs_are_in_operation ? places_[step.second.step] : operand(step.second);
    made.result = made.second_result = new_block();
    places_[i] = {false, made.result};
    if (made.operation == Operation::sine_cosine) {
      // The second result of an angle whose other function nobody needs is thrown away.
      made.second_result = new_block();
      if (partner == i)
        scratch_.push_back(made.second_result);
      else
        places_[partner] = {false, made.second_result};
      if (step.operation == Op::cosine) std::swap(made.result, made.second_result);
    }
    to_.instructions_.push_back(made);
  }

  static Operation plain_operation(const StraightLine::Step& step) {
    switch (step.operation) {
      case Op::square_root:
        return Operation::square_root;
      case Op::sine:
      case Op::cosine:
        return Operation::sine_cosine;
      case Op::arc_sine:
        return Operation::arc_sine;
      case Op::arc_cosine:
        return Operation::arc_cosine;
      case Op::arc_tangent:
        return Operation::arc_tangent;
      case Op::arc_tangent_2:
        return Operation::arc_tangent_2;
      case Op::absolute:
        return Operation::absolute;
      default:
        return !step.first.negative && step.second.negative ? Operation::subtract : Operation::add;
    }
  }

  ColumnProgram& to_;
  const std::vector<StraightLine::Step>& steps_;
  std::vector<std::size_t> last_use_;  // of each step: the last that needs it
  std::vector<Place> places_;
  std::map<std::size_t, std::size_t> partner_;
  std::vector<std::uint32_t> free_, scratch_;
  std::uint32_t blocks_ = 0;
};

ColumnProgram::ColumnProgram(const StraightLine& program) : inputs_(program.input_count()) {
  const Compiler compiler(*this, program);
}

namespace {

using Operation = ColumnProgram::Operation;

// One operation on `count` cases.
POINSOT_FOR_EACH_INSTRUCTION_SET
void operate(Operation operation, const double* a, const double* b, int count, double* __restrict result,
             double* __restrict second_result) {
  switch (operation) {
    case Operation::add:
      for (int i = 0; i < count; ++i) result[i] = a[i] + b[i];
      return;
    case Operation::subtract:
      for (int i = 0; i < count; ++i) result[i] = a[i] - b[i];
      return;
    case Operation::multiply:
      for (int i = 0; i < count; ++i) result[i] = a[i] * b[i];
      return;
    case Operation::multiply_negative:
      for (int i = 0; i < count; ++i) result[i] = -(a[i] * b[i]);
      return;
    case Operation::divide:
      for (int i = 0; i < count; ++i) result[i] = a[i] / b[i];
      return;
    case Operation::divide_negative:
      for (int i = 0; i < count; ++i) result[i] = -(a[i] / b[i]);
      return;
    case Operation::negate:
      for (int i = 0; i < count; ++i) result[i] = -a[i];
      return;
    case Operation::square_root:
      for (int i = 0; i < count; ++i) result[i] = std::sqrt(a[i]);
      return;
    case Operation::sine_cosine:
      sine_cosine_list(a, count, result, second_result);
      return;
    case Operation::arc_sine:
      for (int i = 0; i < count; ++i) result[i] = std::asin(a[i]);
      return;
    case Operation::arc_cosine:
      for (int i = 0; i < count; ++i) result[i] = std::acos(a[i]);
      return;
    case Operation::arc_tangent:
      for (int i = 0; i < count; ++i) result[i] = std::atan(a[i]);
      return;
    case Operation::arc_tangent_2:
      for (int i = 0; i < count; ++i) result[i] = std::atan2(a[i], b[i]);
      return;
    case Operation::absolute:
      for (int i = 0; i < count; ++i) result[i] = std::fabs(a[i]);
      return;
  }
}

void write(const double* from, bool negative, int count, double* to) {
  if (negative)
    operate(Operation::negate, from, from, count, to, to);
  else
    std::copy_n(from, count, to);
}

// Zero stays zero where a number is finite; else it becomes, and stays, no number.
POINSOT_FOR_EACH_INSTRUCTION_SET
void hold_finite(const double* number, int count, double* __restrict held) {
  for (int i = 0; i < count; ++i) held[i] += number[i] * 0.0;
}
POINSOT_FOR_EACH_INSTRUCTION_SET
void hold_positive(const double* number, double sign, int count, double* __restrict held) {
  for (int i = 0; i < count; ++i) held[i] = sign * number[i] > 0 ? held[i] : std::numeric_limits<double>::quiet_NaN();
}
POINSOT_FOR_EACH_INSTRUCTION_SET
void write_held(const double* held, int count, char* __restrict valid) {
  for (int i = 0; i < count; ++i) valid[i] = static_cast<char>(held[i] == 0);
}

}  // namespace

template <class Finish>
void ColumnProgram::run(std::span<const double* const> inputs, std::size_t rows, const Finish& finish) const {
  std::vector<double> memory(blocks_ * block_rows);
  const auto block = [&](std::uint32_t index) { return memory.data() + index * block_rows; };
  for (const Constant& constant : constants_) std::fill_n(block(constant.block), block_rows, constant.value);
  for (std::size_t start = 0; start < rows; start += block_rows) {
    const auto count = static_cast<int>(std::min(block_rows, rows - start));
    const auto at = [&](const Place& place) -> const double* {
      return place.input ? inputs[place.index] + start : block(place.index);
    };
    for (const Instruction& one : instructions_)
      operate(one.operation, at(one.first), at(one.second), count, block(one.result), block(one.second_result));
    finish(start, count, at);
  }
}

void ColumnProgram::evaluate(std::span<const double* const> inputs, std::size_t rows,
                             std::span<double* const> outputs) const {
  if (inputs.size() != inputs_ || outputs.size() != outputs_.size())
    throw std::invalid_argument("ColumnProgram::evaluate: the number of columns is wrong");
  run(inputs, rows, [&](std::size_t start, int count, const auto& at) {
    for (std::size_t k = 0; k < outputs.size(); ++k)
      write(at(outputs_[k]), negative_outputs_[k], count, outputs[k] + start);
  });
}

std::vector<char> ColumnProgram::evaluate_where_valid(std::span<const double* const> inputs, std::size_t rows,
                                                      std::span<double* const> outputs) const {
  if (inputs.size() != inputs_ || outputs.size() > outputs_.size())
    throw std::invalid_argument("ColumnProgram::evaluate_where_valid: the number of columns is wrong");
  std::vector<char> valid(rows);
  std::array<double, block_rows> held{};
  run(inputs, rows, [&](std::size_t start, int count, const auto& at) {
    held.fill(0);
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      const double* const from = at(outputs_[k]);
      if (k >= outputs.size()) {
        hold_positive(from, negative_outputs_[k] ? -1 : 1, count, held.data());
        continue;
      }
      write(from, negative_outputs_[k], count, outputs[k] + start);
      hold_finite(from, count, held.data());
    }
    write_held(held.data(), count, valid.data() + start);
  });
  return valid;
}

}  // namespace poinsot
