#include "poinsot/engine/work/work.h"

#include <algorithm>

#include "poinsot/engine/work/budget.h"

namespace poinsot {
namespace {

constinit thread_local Work counted_work = 0;

}  // namespace

void count_work(Work operations) {
  counted_work += operations;
  check_budget();
}

Work work_done() { return counted_work; }

WorkLimit::WorkLimit(Work most) : begin_(work_done()), end_(begin_ + std::min(most, unlimited_work - begin_)) {}

Work WorkLimit::left() const { return end_ - std::min(work_done(), end_); }

double WorkLimit::part_spent() const {
  return static_cast<double>(work_done() - begin_) / std::max(1.0, static_cast<double>(end_ - begin_));
}

}  // namespace poinsot
