// Whether two shapes that touch can do so: by their curvatures, told by the equations of their surfaces.
#pragma once

#include <optional>

#include "poinsot/engine/dynamics/contact_surface.h"

namespace poinsot::solve {

// The least sum of the normal curvatures of both shapes at a place where they touch, over all directions there, 1/m:
// negative where they cut into each other beside the place, zero where they touch along a line. Infinite for a point.
// Nothing for two curves. normal: into `on`.
std::optional<double> least_relative_curvature(const ContactSurface<double>& on, const ContactSurface<double>& from,
                                               const Vector3<double>& place, const Vector3<double>& normal);

}  // namespace poinsot::solve
