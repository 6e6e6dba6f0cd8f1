#include "problem/witness/cut_parts.h"

#include <algorithm>
#include <vector>

#include "poinsot/engine/mass/outline_inside.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;

// Chords of a circle in 48 parts lie two thousandths of its radius within it; a hole may end on the surface.
constexpr double allowance = 3e-3;              // of the size of the part
constexpr double in_its_plane = 1e-6;           // of the size of a plate, for points that are in it
constexpr std::size_t most_points = 100;        // of a hole
constexpr std::size_t most_triangles = 20'000;  // of a mesh that is looked at

struct Cut {
  const Part* part;
  Extent extent;
  Outline outline;
  double size;

  bool looked_at() const { return !outline.triangles.empty() && outline.triangles.size() <= most_triangles; }
  bool reaches(const Vector& point) const {
    return (extent == Extent::volume && lies_within(outline, point)) || lies_on(outline, point, allowance * size);
  }
  // Not at its border, which others may share.
  bool holds(const Vector& point) const {
    return extent == Extent::volume ? lies_within(outline, point) && !lies_on(outline, point, allowance * size)
                                    : lies_on(outline, point, in_its_plane * size);
  }
};

Cut cut_of(const Part& part, DataScope<double>& data) {
  Cut cut{&part, shape_values(part.shape, data, part.name, false).extent, shape_picture(part.shape, data, part.name),
          0};
  cut.size = size_of(cut.outline);
  return cut;
}

// Points on the border, evenly taken from all.
std::vector<Vector> border_of(const Cut& hole) {
  const std::vector<Vector>& all = hole.outline.vertices;
  const std::size_t step = (all.size() + most_points - 1) / most_points;
  std::vector<Vector> points;
  for (std::size_t k = 0; k < all.size(); k += step) points.push_back(all[k]);
  return points;
}

// Points between the middle of a shape and its border that are in it.
std::vector<Vector> inner_of(const Cut& hole) {
  const std::vector<Vector> border = border_of(hole);
  Vector middle = Vector::zero();
  for (const Vector& point : border) middle += point / static_cast<double>(border.size());
  std::vector<Vector> points{middle};
  for (const Vector& point : border) points.push_back((middle + point) / 2.0);
  std::erase_if(points, [&](const Vector& point) { return !hole.holds(point); });
  return points;
}

std::optional<std::string> unsound_hole(const Body& body, DataScope<double>& data) {
  std::vector<Cut> parts, holes;
  for (const std::vector<Part>* list : {&body.parts, &body.added})
    for (const Part& part : *list) (part.hole ? holes : parts).push_back(cut_of(part, data));
  // Nothing is cut out of particles and bars here.
  const auto thin = [](const Cut& cut) { return cut.extent == Extent::point || cut.extent == Extent::length; };
  std::erase_if(parts, thin);
  std::erase_if(holes, thin);
  const auto looked_at = [](const Cut& cut) { return cut.looked_at(); };
  if (parts.empty() || !std::ranges::all_of(parts, looked_at) || !std::ranges::all_of(holes, looked_at))
    return std::nullopt;
  const std::string of_body = " of body '" + body.name + "'";
  for (const Cut& hole : holes)
    for (const Vector& point : border_of(hole))
      if (std::ranges::none_of(parts, [&](const Cut& part) { return part.reaches(point); }))
        return "the hole '" + hole.part->name + "'" + of_body +
               " reaches out of it, and there is nothing to cut out there (state the shape that is cut out: "
               "a semicircle, sector, half_cylinder ... for a notch, a bore no longer than the body)";
  for (std::size_t i = 0; i < holes.size(); ++i)
    for (const Vector& point : inner_of(holes[i]))
      for (std::size_t k = 0; k < holes.size(); ++k)
        if (k != i && holes[k].extent == holes[i].extent && holes[k].holds(point))
          return "the holes '" + holes[std::min(i, k)].part->name + "' and '" + holes[std::max(i, k)].part->name + "'" +
                 of_body + " overlap: what both cut out would count twice (state holes that do not overlap)";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> unsound_hole(const Situation& situation, DataScope<double>& data) {
  for (const Body& body : situation.bodies) {
    const auto is_hole = [](const Part& part) { return part.hole; };
    if (std::ranges::none_of(body.parts, is_hole) && std::ranges::none_of(body.added, is_hole)) continue;
    if (auto reason = unsound_hole(body, data)) return reason;
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
