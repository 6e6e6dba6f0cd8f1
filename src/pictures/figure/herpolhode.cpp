#include "pictures/figure/herpolhode.h"

#include <algorithm>

namespace poinsot::pictures {

Vector direction_across(const scene::Curve& herpolhode, const Vector& center) {
  if (herpolhode.points.empty()) return {};
  // Of the triangles on the first point and the one that is farthest from it, the largest.
  const Vector& first = herpolhode.points.front();
  const auto farthest =
      std::ranges::max_element(herpolhode.points, {}, [&](const Vector& p) { return norm(p - first); });
  const Vector side = *farthest - first;
  Vector largest{};
  for (const Vector& p : herpolhode.points) {
    const Vector normal = cross(side, p - first);
    if (norm(normal) > norm(largest)) largest = normal;
  }
  constexpr double flat = 1e-6;
  if (!(norm(largest) > flat * norm_squared(side))) return {};
  const Vector normal = normalized(largest);
  return dot(normal, first - center) < 0 ? -normal : normal;
}

}  // namespace poinsot::pictures
