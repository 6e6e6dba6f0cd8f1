// Makers of the methods that stand in files of their own.
#pragma once

#include <memory>

#include "motion/step_method.h"

namespace poinsot {

// Backward differentiation formulas of SUNDIALS; none if poinsot was built without it.
std::unique_ptr<StepMethod> make_stiff_method(RightSide& right_side, const ErrorScale& scale, double first,
                                              double largest);
// Gauss-Legendre collocation of order 16 in fixed steps, h for 0 to be chosen at the start.
std::unique_ptr<StepMethod> make_gauss_method(RightSide& right_side, const ErrorScale& scale, double h);

}  // namespace poinsot
