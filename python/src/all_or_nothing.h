// Results of long calls as Python gets them.
#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <type_traits>
#include <utility>

#include "long_call.h"

namespace poinsot::python {

// A result, and what was raised meanwhile by a signal handler or by the listener to progress, or None.
template <class Result>
using Found = std::pair<Result, nanobind::object>;
using Timeout = std::optional<double>;

// The result of a call that finds all or nothing.
template <class Work>
auto all_or_nothing(Timeout timeout, nanobind::object listener, const Work& work)
    -> Found<std::optional<std::invoke_result_t<Work, const Budget&>>> {
  LongCall call(timeout, std::move(listener));
  try {
    return {call(work), call.raised()};
  } catch (const BudgetEnded&) {
    if (call.raised().is_none()) throw;
    return {std::nullopt, call.raised()};
  }
}

}  // namespace poinsot::python
