// Derivatives of what a trace holds (traced.h), recorded in the same trace.
#pragma once

#include <vector>

#include "poinsot/engine/math/trace/traced.h"

namespace poinsot {

// How the outputs change while the inputs of the trace change at these rates; inputs beyond the last rate stay.
// The trace must be the one that is being recorded.
std::vector<Traced> traced_derivative(const Trace& trace, const std::vector<Traced>& outputs,
                                      const std::vector<Traced>& input_rates);

}  // namespace poinsot
