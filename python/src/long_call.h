// A call of poinsot that may take long: it works without the interpreter's lock, ends at a deadline or when a signal
// handler of Python raises (Ctrl-C), and tells its progress.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <optional>

#include "poinsot/engine/work/budget.h"

namespace poinsot::python {

class LongCall {
 public:
  // timeout: in seconds. listener: called with what is done, its part from 0 to 1 if known, and a count; or None.
  LongCall(std::optional<double> timeout, nanobind::object listener);
  LongCall(const LongCall&) = delete;
  LongCall& operator=(const LongCall&) = delete;

  // The result of work(budget), during which other threads of Python run. What a signal handler or the listener raised
  // meanwhile is kept in raised(): the caller of Python may still want what was found until then.
  template <class Work>
  auto operator()(const Work& work) {
    const nanobind::gil_scoped_release released;
    return work(static_cast<const Budget&>(budget_));
  }

  // What ended the call from Python's side, an exception or None.
  nanobind::object raised() const { return raised_; }

 private:
  void look_at_signals();
  void keep_raised();

  Budget budget_;
  nanobind::object listener_, raised_ = nanobind::none();
  std::atomic<bool> ended_ = false;
  bool main_thread_ = false;
  Budget::Clock::time_point looked_at_{};
};

}  // namespace poinsot::python
