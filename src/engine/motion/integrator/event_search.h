// Finds the events within one step of an integration.
//
// On pieces of the step the value is interpolated at Chebyshev points; pieces on which the interpolant does not yet
// follow the value are halved. The extremes of the interpolant part each piece into stretches without a turn, so that
// several zeros in one step are all found; an extreme that comes as near to zero as the interpolant may be off is
// sought on the value itself. Each zero is then located on the state of the step.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "poinsot/engine/motion/integrator/event.h"

namespace poinsot {

// A zero of the value: its time, and the direction as in EventHit.
struct Zero {
  double time = 0.0;
  int direction = 0;
};

struct ZeroSearch {
  std::function<double(double t)> value;
  double start = 0.0;
  double end = 0.0;
  double touch = 0.0;       // extremes no farther from zero count as touching it; 0: touching is not wanted
  bool from_zero = false;   // the value was zero at the start: that zero is no finding
  double resolution = 0.0;  // s: how far from the start a zero is the start's own
};

// The zeros in (start, end] in the order of time's run.
std::vector<Zero> find_zeros(const ZeroSearch& search);

// Where a number that is smooth is zero, or has an extreme if `turns`, between the first and the last of times at which
// it is looked at: these, in the order of time's run, resolve how it changes.
std::vector<double> corners_between(const std::function<double(double t)>& value, bool turns,
                                    const std::vector<double>& looks);

}  // namespace poinsot
