// The figure of a motion.
#pragma once

#include "pictures/figure/figure.h"

namespace poinsot::pictures {

// Several poses on each other, the earlier ones paler. Where they would lie on one place, or bodies be lost beside
// their way, the poses stand beside each other.
Drawing motion_figure(const scene::Scene& scene, const Looks& looks);

}  // namespace poinsot::pictures
