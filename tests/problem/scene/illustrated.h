// Scenes of problem files, and what is read from them.
#pragma once

#include <cmath>
#include <string>

#include "poinsot/problem.h"
#include "poinsot/scene.h"

namespace poinsot::scene_tests {

using Vector = Vector3<double>;

inline Document illustrated(const std::string& text) { return Problem::from_text(text, "marks.yaml").illustrate(); }
inline const scene::Scene& scene_of(const Document& document) { return *document.solutions.at(0).scene; }

inline Vector on_ground(const scene::Scene& scene, const scene::Place& place) {
  if (place.body == scene::ground) return place.at;
  const scene::Pose& pose = scene.bodies.at(static_cast<std::size_t>(place.body)).pose;
  return pose.R * place.at + pose.p;
}

inline double drawn_angle(const scene::Scene& scene, const scene::Dimension& dimension) {
  const Vector corner = on_ground(scene, dimension.corner);
  const Vector a = on_ground(scene, dimension.from) - corner, b = on_ground(scene, dimension.to) - corner;
  return std::atan2(norm(Vector(cross(a, b))), dot(a, b));
}

inline const scene::Dimension* angle_named(const scene::Scene& scene, const std::string& name) {
  for (const scene::Dimension& dimension : scene.dimensions)
    if (dimension.angle && dimension.name == name) return &dimension;
  return nullptr;
}

inline std::string degrees(double value) { return std::to_string(value) + " deg"; }

}  // namespace poinsot::scene_tests
