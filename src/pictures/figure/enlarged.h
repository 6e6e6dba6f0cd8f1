// What is lost beside the way between bodies: a satellite on its orbit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/scene.h"

namespace poinsot::pictures {

struct Enlarged {
  scene::Scene scene;
  std::vector<std::string> bodies;  // those that are drawn larger than they are
};
// The scene with such bodies as large as can be read, about their centers: only those that nothing else is near to and
// that nothing holds but at the center. Nothing if there is none.
std::optional<Enlarged> enlarged(const scene::Scene& scene);

// The scene with the length of what is seen of it, where that is much less: what counts as one place depends on it.
std::optional<scene::Scene> of_length(const scene::Scene& scene, double length);

}  // namespace poinsot::pictures
