// Makers of the methods that stand in files of their own, and the loop that drives them.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "engine/motion/integrator/step_method.h"
#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

// Backward differentiation formulas of SUNDIALS; none if poinsot was built without it.
std::unique_ptr<StepMethod> make_stiff_method(RightSide& right_side, const ErrorScale& scale, double first,
                                              double largest);
// Gauss-Legendre collocation of order 16 in fixed steps, h for 0 to be chosen at the start.
std::unique_ptr<StepMethod> make_gauss_method(RightSide& right_side, const ErrorScale& scale, double h);

// Makes the method that the options ask for; none if it cannot be had.
using MethodMaker = std::function<std::unique_ptr<StepMethod>(IntegrationMethod, RightSide&, const ErrorScale&,
                                                              const IntegrationOptions&)>;
std::unique_ptr<StepMethod> make_general_method(IntegrationMethod method, RightSide& right_side,
                                                const ErrorScale& scale, const IntegrationOptions& options);

// integrate() with methods made by `make`.
IntegrationResult integrate_by(const MethodMaker& make, const MotionEquations& equations, double start,
                               std::span<const double> q, std::span<const double> v, double end,
                               const IntegrationOptions& options, std::span<const Event> events);

}  // namespace poinsot
