// The parallel projection of the ground on the paper.
#pragma once

#include <optional>
#include <string_view>

#include "pictures/drawing/plane.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

using Vector = Vector3<double>;

// Unit vectors on ground axes: to the right of the paper, to its top, and to who looks at it.
struct View {
  Vector right{1, 0, 0}, up{0, 1, 0}, viewer{0, 0, 1};
};

// The view from a direction in which `up` points to the top of the paper; from above or below, as from the front with
// the paper laid down.
View view_from(const Vector& viewer, const Vector& up);
// As problem::viewing_direction() understands the words.
std::optional<View> view_of_words(std::string_view words, const Vector& up);

class Projection {
 public:
  Projection() = default;
  Projection(const View& view, double scale, Vector center = {}) : view_(view), scale_(scale), center_(center) {}

  Point2 operator()(const Vector& p) const {
    const Vector d = p - center_;
    return {scale_ * dot(d, view_.right), -scale_ * dot(d, view_.up)};
  }
  // How near to the viewer, in the units of the paper.
  double depth(const Vector& p) const { return scale_ * dot(p - center_, view_.viewer); }
  Point2 direction_of(const Vector& v) const { return {dot(v, view_.right), -dot(v, view_.up)}; }
  const View& view() const { return view_; }
  double scale() const { return scale_; }
  const Vector& center() const { return center_; }

 private:
  View view_;
  double scale_ = 1;
  Vector center_{};
};

// The place on ground axes.
Vector on_ground(const scene::Place& place, const std::vector<scene::Pose>& poses);
Vector turned_to_ground(int body, const Vector& v, const std::vector<scene::Pose>& poses);
std::vector<scene::Pose> shown_poses(const scene::Scene& scene);

// A unit vector across the given one.
Vector across(const Vector& v);
inline Vector unit_or(const Vector& v, const Vector& otherwise) {
  const double length = norm(v);
  return length > 1e-12 ? v / length : otherwise;
}

}  // namespace poinsot::pictures
