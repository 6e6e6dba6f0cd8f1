// Rings of gimbals: a body without shape that turns in what carries it about one axis, and carries another body about
// another axis through the same point, is drawn as a ring in the plane of the two axes, and its bearings on the ring.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pictures/solids/projection.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

struct Gimbal {
  Vector center;
  double radius = 0;
  Vector first, second;  // unit vectors across each other in its plane
};

// Whether a joint or a support is one about an axis.
bool turns_about_axis(const scene::Symbol& symbol);

// For each body its ring, if it is one.
std::vector<std::optional<Gimbal>> gimbals_of(const scene::Scene& scene, const std::vector<scene::Pose>& poses);

// Where the bearings of a joint are drawn: at its place, or on both sides of a ring.
std::vector<Vector> bearings_of(const scene::Scene& scene, const scene::Symbol& symbol,
                                const std::vector<std::optional<Gimbal>>& gimbals,
                                const std::vector<scene::Pose>& poses);

// What of a body its gimbals are drawn with: its own ring, and the pins from it or from its middle to the ring around
// it.
std::vector<std::array<Vector, 2>> gimbal_arms(const scene::Scene& scene, int body,
                                               const std::vector<std::optional<Gimbal>>& gimbals,
                                               const std::vector<scene::Pose>& poses);

}  // namespace poinsot::pictures
