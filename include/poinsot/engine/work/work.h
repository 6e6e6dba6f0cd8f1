// Work, counted: what a search may spend, in place of seconds.
//
// A search that ends after so many seconds finds less on a slower machine, and other things on a busy one. So
// computations count what they do, wherever time goes: terms of formulas, nodes of expressions, rows of linear systems,
// accelerations along a motion. The sum is the same for the same input on every machine, and limits are set on it.
#pragma once

#include <cstdint>
#include <limits>

namespace poinsot {

// In operations: of about a multiplication with what goes with it, a nanosecond on a machine of 2025. The parts of the
// library are weighted by what they take there, so that 1e9 operations are one to two seconds.
using Work = std::uint64_t;
inline constexpr Work unlimited_work = std::numeric_limits<Work>::max();

// Counts work of this thread, and looks whether the budget in force has ended (see budget.h): throws BudgetEnded.
void count_work(Work operations);

// By this thread until now. Only differences mean anything.
Work work_done();

// A bound on the work of this thread from now on.
class WorkLimit {
 public:
  explicit WorkLimit(Work most);

  bool spent() const { return work_done() > end_; }
  Work left() const;
  double part_spent() const;  // from 0 on; beyond 1 where it is spent

 private:
  Work begin_, end_;
};

}  // namespace poinsot
