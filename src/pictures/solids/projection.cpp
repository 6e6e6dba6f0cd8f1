#include "pictures/solids/projection.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace poinsot::pictures {
namespace {

// The direction from which a reader looks at the front: the first axis to the right where `up` leaves it.
Vector front_of(const Vector& up) {
  const Vector right = std::abs(up.x) > 0.9 ? Vector{0, 1, 0} : Vector{1, 0, 0};
  return normalized(cross(right, up));
}

std::vector<double> numbers_of(std::string_view words) {
  std::vector<double> numbers;
  while (true) {
    while (!words.empty() && (words.front() == ' ' || words.front() == '+')) words.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    words.remove_prefix(static_cast<std::size_t>(end - words.data()));
    while (!words.empty() && words.front() == ' ') words.remove_prefix(1);
    if (words.empty()) return numbers;
    if (words.front() != ',') return {};
    words.remove_prefix(1);
  }
}

}  // namespace

Vector across(const Vector& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  const Vector other = x <= y && x <= z ? Vector{1, 0, 0} : y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1};
  return unit_or(cross(v, other), {1, 0, 0});
}

View view_from(const Vector& viewer, const Vector& up) {
  const Vector to = unit_or(viewer, {0, 0, 1});
  Vector top = up - dot(up, to) * to;
  if (norm(top) < 1e-6 * std::max(norm(up), 1e-12)) top = (dot(up, to) > 0 ? -1.0 : 1.0) * front_of(up);
  top = unit_or(top - dot(top, to) * to, across(to));
  return {cross(top, to), top, to};
}

std::optional<View> view_of_words(std::string_view words, const Vector& up) {
  const Vector front = front_of(up), right = cross(up, front);
  const std::array<std::pair<std::string_view, Vector>, 6> named{
      {{"front", front}, {"back", -front}, {"right", right}, {"left", -right}, {"top", up}, {"bottom", -up}}};
  for (const auto& [name, direction] : named)
    if (name == words) return view_from(direction, up);
  const std::vector<double> numbers = numbers_of(words);
  if (numbers.size() == 2) {
    const double azimuth = numbers[0] * std::numbers::pi / 180, elevation = numbers[1] * std::numbers::pi / 180;
    return view_from(
        std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right) + std::sin(elevation) * up, up);
  }
  if (numbers.size() == 3) {
    const Vector direction{numbers[0], numbers[1], numbers[2]};
    if (norm(direction) > 0 && std::isfinite(norm(direction))) return view_from(direction, up);
  }
  return std::nullopt;
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
