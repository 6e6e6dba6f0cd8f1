#include "pictures/solids/projection.h"

#include <algorithm>
#include <cmath>

#include "problem/entries/viewing_direction.h"

namespace poinsot::pictures {
Vector across(const Vector& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  const Vector other = x <= y && x <= z ? Vector{1, 0, 0} : y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1};
  return unit_or(cross(v, other), {1, 0, 0});
}

View view_from(const Vector& viewer, const Vector& up) {
  const Vector to = unit_or(viewer, {0, 0, 1});
  Vector top = up - dot(up, to) * to;
  if (norm(top) < 1e-6 * std::max(norm(up), 1e-12))
    top = (dot(up, to) > 0 ? -1.0 : 1.0) * problem::front_and_right(up).front;
  top = unit_or(top - dot(top, to) * to, across(to));
  return {cross(top, to), top, to};
}

std::optional<View> view_of_words(std::string_view words, const Vector& up) {
  const std::optional<Vector> viewer = problem::viewing_direction(words, up);
  if (!viewer) return std::nullopt;
  return view_from(*viewer, up);
}

std::vector<scene::Pose> shown_poses(const scene::Scene& scene) {
  std::vector<scene::Pose> poses;
  for (const scene::Body& body : scene.bodies) poses.push_back(body.pose);
  return poses;
}

Vector turned_to_ground(int body, const Vector& v, const std::vector<scene::Pose>& poses) {
  return body < 0 ? v : poses.at(static_cast<std::size_t>(body)).R * v;
}

Vector on_ground(const scene::Place& place, const std::vector<scene::Pose>& poses) {
  if (place.body < 0) return place.at;
  const scene::Pose& pose = poses.at(static_cast<std::size_t>(place.body));
  return pose.R * place.at + pose.p;
}

}  // namespace poinsot::pictures
