#include "long_call.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace nb = nanobind;

namespace poinsot::python {
namespace {

// Python handles signals in its main thread alone.
bool in_main_thread() {
  const nb::module_ threading = nb::module_::import_("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

// Often enough that a person who presses Ctrl-C does not notice, and so seldom that other threads of Python lose
// nothing by the lock.
constexpr std::chrono::milliseconds between_signals{50};
// In place of no deadline: the clock is only read by a budget that has one. Ten years.
constexpr std::chrono::hours no_deadline{87'600};

}  // namespace

LongCall::LongCall(std::optional<double> timeout, nb::object listener)
    : listener_(std::move(listener)), main_thread_(in_main_thread()) {
  if (timeout && !(*timeout >= 0)) throw nb::value_error("the timeout is a number of seconds, 0 or more");
  const auto longest = std::chrono::duration<double>(no_deadline);
  const auto duration = timeout ? std::min(std::chrono::duration<double>(*timeout), longest) : longest;
  budget_.end_after(std::chrono::duration_cast<Budget::Clock::duration>(duration)).end_when(&ended_);
  budget_.by_clock([this] {
    const Budget::Clock::time_point now = Budget::Clock::now();
    if (main_thread_ && now - looked_at_ >= between_signals) {
      looked_at_ = now;
      look_at_signals();
    }
    return now;
  });
  if (listener_.is_none()) return;
  budget_.tell([this](const Progress& progress) {
    const nb::gil_scoped_acquire locked;
    if (ended_) return;
    try {
      listener_(nb::str(progress.doing.data(), progress.doing.size()),
                progress.part ? nb::object(nb::float_(*progress.part)) : nb::none(), progress.count);
    } catch (nb::python_error& error) {
      error.restore();
      keep_raised();
    }
  });
}

void LongCall::look_at_signals() {
  const nb::gil_scoped_acquire locked;
  if (!ended_ && PyErr_CheckSignals() != 0) keep_raised();
}

// The error that is set in the interpreter ends the call.
void LongCall::keep_raised() {
  try {
    nb::raise_python_error();
  } catch (nb::python_error& error) {
    raised_ = nb::borrow(error.value());
  }
  ended_ = true;
}

}  // namespace poinsot::python
