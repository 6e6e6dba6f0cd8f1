#include "poinsot/engine/mass/outline_inside.h"

#include <algorithm>
#include <cmath>

#include "engine/mass/solid_angle.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {
namespace {

using Vector = Vector3<double>;

double square_to_segment(const Vector& p, const Vector& A, const Vector& B) {
  const Vector along = B - A;
  const double length = norm_squared(along);
  const double part = length > 0 ? std::clamp(dot(p - A, along) / length, 0.0, 1.0) : 0;
  return norm_squared(Vector(p - A - part * along));
}

// The square of the distance to a triangle: that to its plane where the foot is between its sides.
double square_to_triangle(const Vector& p, const Vector& A, const Vector& B, const Vector& C) {
  const Vector n = cross(B - A, C - A);
  const double size = norm_squared(n);
  const auto inside = [&](const Vector& P, const Vector& Q) { return dot(n, cross(Q - P, p - P)) >= 0; };
  if (size > 0 && inside(A, B) && inside(B, C) && inside(C, A)) {
    const double height = dot(n, p - A);
    return height * height / size;
  }
  return std::min({square_to_segment(p, A, B), square_to_segment(p, B, C), square_to_segment(p, C, A)});
}

}  // namespace

double size_of(const Outline& outline) {
  if (outline.vertices.empty()) return 0;
  Vector low = outline.vertices.front(), high = low;
  for (const Vector& vertex : outline.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], vertex[k]);
      high[k] = std::max(high[k], vertex[k]);
    }
  return norm(Vector(high - low));
}

bool lies_on(const Outline& outline, const Vector3<double>& point, double near) {
  const auto& vertices = outline.vertices;
  count_work(work_of_triangle * outline.triangles.size());
  return std::ranges::any_of(outline.triangles, [&](const auto& t) {
    return square_to_triangle(point, vertices[t[0]], vertices[t[1]], vertices[t[2]]) <= near * near;
  });
}

bool lies_within(const Outline& outline, const Vector3<double>& point) {
  double turns = 0;
  count_work(work_of_triangle * outline.triangles.size());
  for (const auto& t : outline.triangles)
    turns += winding(point, outline.vertices[t[0]], outline.vertices[t[1]], outline.vertices[t[2]]);
  return std::abs(turns) > 0.5;
}

}  // namespace poinsot
