// A scene as a glTF file: the bodies with their surfaces and edges, cords and springs between them, arrows, and the
// motion of all as an animation.
#pragma once

#include <string>

#include "poinsot/scene.h"

namespace poinsot::pictures {

std::string gltf_of(const scene::Scene& scene, const std::string& title);

}  // namespace poinsot::pictures
