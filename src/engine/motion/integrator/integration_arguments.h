// Whether what integrate() is called with makes sense.
#pragma once

#include <span>

#include "poinsot/engine/motion/integrator/integrate.h"

namespace poinsot {

// Errors: std::invalid_argument, as integrate() says.
void check_arguments(const MotionEquations& equations, double start, std::span<const double> q,
                     std::span<const double> v, double end, const IntegrationOptions& options,
                     std::span<const Event> events);

}  // namespace poinsot
