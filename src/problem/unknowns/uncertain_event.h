// Instants found along a motion that may lie elsewhere than where they were found.
//
// Close to an unstable equilibrium, where a motion creeps, what is told to happen may happen at quite another time, or
// never: a crossing is certain only where the error of the motion moves it by less than a thousandth of its time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "problem/entries/statement.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// An event in words, and when it was found to happen, s.
struct UncertainEvent {
  std::string words;
  double time = 0;
};

// What is uncertain of the instants at which an expression is asked: those under instants: that it names in their
// situations, and the ends of stages that lie before.
std::optional<UncertainEvent> uncertain_event_in(Sample& sample, const Expression& asked);
// The first end of a stage up to a time, s, that is uncertain, so that all that comes later is.
std::optional<UncertainEvent> uncertain_stage_end(Sample& sample, std::size_t situation, double until);
// The same for an ask: also of the times at which something happens. told: its value. Tables are looked at row by row.
std::optional<UncertainEvent> uncertain_event_of(Sample& sample, const Ask& ask, const Value<double>& told);

// Why there is no answer by such an event.
std::string in_words(const UncertainEvent& event);

}  // namespace poinsot::problem
