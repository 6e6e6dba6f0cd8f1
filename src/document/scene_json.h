// The scene (poinsot/scene.h) as JSON: the names are those of its fields.
#pragma once

#include <nlohmann/json.hpp>

#include "poinsot/scene.h"

namespace poinsot::document {

// Vectors are [x, y, z], kinds their words, a pose is {"R": nine numbers row by row, "p": vector}. Numbers of places
// have nine digits and normals four; values of arrows have all digits.
nlohmann::ordered_json scene_json(const scene::Scene& scene);

}  // namespace poinsot::document
