// What a body without shape, or the part of a body that its shapes leave out, is drawn as: straight arms to what holds
// it.
#pragma once

#include <array>
#include <vector>

#include "pictures/solids/solid.h"

namespace poinsot::pictures {

// Segments on ground axes. `solids` are the body's shapes.
std::vector<std::array<Vector, 2>> skeleton_of(const scene::Scene& scene, int body, const std::vector<Solid>& solids,
                                               const std::vector<scene::Pose>& poses);

}  // namespace poinsot::pictures
