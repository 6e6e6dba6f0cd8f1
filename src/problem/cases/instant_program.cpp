#include "problem/cases/instant_program.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/work/budget.h"
#include "problem/cases/small_least_squares.h"

namespace poinsot::problem {
namespace {

// Cases that go through all programs before the next ones: their numbers stay near the processor.
constexpr std::size_t block_rows = 256;

// Newton's method, in sizes of the roots. A step of this size is followed by one that leaves rounding.
constexpr double last_but_one = 1e-8, found = 1e-9;
// Steps that shrink less may lead anywhere.
constexpr double shrinking = 0.7;
constexpr int most_steps = 20;

}  // namespace

// Some cases with all their numbers.
class InstantProgram::Block {
 public:
  explicit Block(const InstantProgram& program)
      // What is left open is zero, and nothing writes it.
      : program_(program),
        memory_(program.slots_ * block_rows),
        inputs_(program.slots_),
        columns_(program.slots_),
        steps_(program.roots_.size()),
        slopes_(program.roots_.size()) {
    for (std::size_t k = 0; k < columns_.size(); ++k) inputs_[k] = columns_[k] = memory_.data() + k * block_rows;
  }

  void evaluate(std::span<const double* const> data, std::size_t start, std::size_t rows) {
    rows_ = rows;
    for (std::size_t k = 0; k < data.size(); ++k) inputs_[k] = data[k] + start;
    for (const Root& root : program_.roots_) std::fill_n(columns_[root.slot], rows, root.start);
    for (std::size_t i = 0; i + 1 < program_.parts_.size(); ++i) run(program_.parts_[i]);
    valid_.assign(rows, 1);
    if (!program_.roots_.empty()) find_roots();
    run(program_.parts_.back());
    if (!program_.slopes_.empty()) follow_roots();
    for (const Slot slot : program_.positive_)
      for (std::size_t row = 0; row < rows; ++row)
        valid_[row] = static_cast<char>(valid_[row] & (columns_[slot][row] > 0));
    for (const Slot slot : program_.results_)
      for (std::size_t row = 0; row < rows; ++row)
        valid_[row] = static_cast<char>(valid_[row] & std::isfinite(inputs_[slot][row]));
  }

  const double* result(std::size_t k) const { return inputs_[program_.results_[k]]; }
  const std::vector<char>& valid() const { return valid_; }

 private:
  void run(const Part& part) {
    const std::span<const double* const> inputs = std::span(inputs_).first(part.program.input_count());
    std::vector<double*> outputs;
    for (const Slot slot : part.slots) outputs.push_back(columns_[slot]);
    part.program.evaluate(inputs, rows_, outputs);
  }

  // A case that has come to its root, or to nothing, is left alone, so that it does not see how long others take.
  void find_roots() {
    std::vector<double> before(rows_, 0);
    std::vector<char> moving(rows_, 1), last(rows_, 0);
    for (int step = 0; std::ranges::any_of(moving, [](char one) { return one != 0; }); ++step) {
      for (std::size_t row = 0; row < rows_; ++row) {
        if (!moving[row]) continue;
        const double size = take_step(row);
        const bool shrinks = step == 0 || size <= last_but_one || size <= shrinking * before[row];
        if (!std::isfinite(size) || !shrinks || step == most_steps) valid_[row] = 0;
        if (valid_[row] == 0 || last[row]) moving[row] = 0;
        if (last[row] && !(size <= found)) valid_[row] = 0;
        last[row] = static_cast<char>(size <= last_but_one);
        before[row] = size;
      }
      for (std::size_t i = 0; i + 1 < program_.parts_.size(); ++i) run(program_.parts_[i]);
    }
    for (std::size_t row = 0; row < rows_; ++row)
      for (const Equation& equation : program_.equations_)
        if (!(std::fabs(columns_[equation.value][row]) * equation.weight <= found)) valid_[row] = 0;
  }

  // The size of the step, beside those of the roots.
  double take_step(std::size_t row) {
    const std::vector<double>& step = changes(row, [](const Equation& equation) { return equation.value; });
    double largest = 0;
    for (std::size_t k = 0; k < step.size(); ++k) {
      largest = std::isfinite(step[k]) ? std::max(largest, std::fabs(step[k])) : step[k];
      columns_[program_.roots_[k].slot][row] += step[k] * program_.roots_[k].size;
    }
    return largest;
  }

  // While a datum changes, the equations stay met: that tells how the roots change.
  void follow_roots() {
    const std::size_t answers = program_.slopes_.size();
    for (std::size_t by = 0; by < program_.equations_.front().by.size(); ++by)
      for (std::size_t row = 0; row < rows_; ++row) {
        const std::vector<double>& rates = changes(row, [&](const Equation& equation) { return equation.by[by]; });
        for (std::size_t i = 0; i < answers; ++i)
          for (std::size_t k = 0; k < rates.size(); ++k)
            columns_[program_.results_[(by + 1) * answers + i]][row] +=
                columns_[program_.slopes_[i][k]][row] * rates[k] * program_.roots_[k].size;
      }
  }

  // How the roots must change, in their sizes, to take this away from each equation.
  template <class Rest>
  const std::vector<double>& changes(std::size_t row, const Rest& rest) {
    steps_.clear();
    for (const Equation& equation : program_.equations_) {
      for (std::size_t k = 0; k < slopes_.size(); ++k)
        slopes_[k] = columns_[equation.slopes[k]][row] * equation.weight * program_.roots_[k].size;
      steps_.add(slopes_, -columns_[rest(equation)][row] * equation.weight);
    }
    return steps_.solve();
  }

  const InstantProgram& program_;
  std::vector<double> memory_;
  std::vector<const double*> inputs_;
  std::vector<double*> columns_;
  SmallLeastSquares steps_;  // the equations of a step
  std::vector<double> slopes_;
  std::vector<char> valid_;
  std::size_t rows_ = 0;
};

std::vector<char> InstantProgram::evaluate(std::span<const double* const> data, std::size_t rows,
                                           std::span<double* const> results) const {
  std::vector<char> valid(rows, 0);
  Block block(*this);
  for (std::size_t start = 0; start < rows; start += block_rows) {
    check_budget();
    const std::size_t count = std::min(block_rows, rows - start);
    block.evaluate(data, start, count);
    std::ranges::copy(block.valid(), valid.begin() + static_cast<std::ptrdiff_t>(start));
    for (std::size_t k = 0; k < results.size(); ++k) std::copy_n(block.result(k), count, results[k] + start);
  }
  return valid;
}

}  // namespace poinsot::problem
