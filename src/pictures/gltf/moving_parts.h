// What a glTF file shows beside bodies: cords, springs and dampers between two places, the arcs of cords on wheels,
// curves, and arrows. Each is a shape of its own that is placed, turned and stretched, at the shown instant and at
// every time of the motion.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/vector3.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

// Lines as pairs of points, triangles as triples.
struct ThinShape {
  std::vector<Vector3<double>> lines{}, triangles{};
};

struct Stance {
  Vector3<double> place{};
  Quaternion<double> turn = Quaternion<double>::identity();
  Vector3<double> stretch{1, 1, 1};
};

enum class PartTone { cord, metal, curve, load, couple, velocity, acceleration, momentum };

struct MovingPart {
  std::string name;
  PartTone tone = PartTone::cord;
  ThinShape shape{};
  Stance now{};
  std::vector<Stance> along{};  // at each time of the motion
};

std::vector<MovingPart> moving_parts(const scene::Scene& scene);

}  // namespace poinsot::pictures
