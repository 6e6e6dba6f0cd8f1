// Gauss-Legendre collocation of order 16 whose eight stages are evaluated together, in steps chosen by its error: for
// equations that give accelerations at eight instants at once. Several times faster than an explicit method where the
// processor computes on packs; states within a step cost a shorter step each.
#pragma once

#include <memory>

#include "engine/motion/integrator/step_method.h"

namespace poinsot {

// first, largest: steps, 0 for none stated. The right side and the scale must outlive the method. A step that ends with
// StepOutcome::stiff is good; so short a step was needed that an explicit method may be faster.
std::unique_ptr<StepMethod> make_packed_collocation(RightSide& right_side, const ErrorScale& scale, double first,
                                                    double largest);

}  // namespace poinsot
