// Shorter ways to numbers of a trace: an operation that needs much of its own may equal what few others make together.
#pragma once

#include <optional>
#include <vector>

#include "engine/math/trace/trace_nodes.h"

namespace poinsot {

// How many operations the outputs need.
std::size_t operations_needed(const Trace& trace, const std::vector<Traced>& outputs);

// The same outputs in a trace in which an operation is written as up to two others of numbers that are there anyhow
// (thorough: up to three), wherever that saves some; nothing where none is found, or the trace is too large to look.
//
// Candidates are a b, a + b, these with one more number, and two of these added or multiplied; they are looked
// up in a table of all pairs by their values at one point of the field, and compared at both and at the sample. (What
// is called resubstitution in the synthesis of logic circuits; Mishchenko and Brayton, IWLS 2006.)
struct Resubstituted {
  Trace trace;
  std::vector<Traced> outputs;
};
std::optional<Resubstituted> resubstituted(const Trace& trace, const std::vector<Traced>& outputs, bool thorough);

}  // namespace poinsot
