// The solid angle of a triangle.
#pragma once

#include <cmath>
#include <numbers>

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

// Of the triangle ABC seen from p, over 4 pi: A. Van Oosterom and J. Strackee, "The solid angle of a plane triangle",
// 1983. The sum over a closed surface is 1 inside it and 0 outside.
inline double winding(const Vector3<double>& p, const Vector3<double>& A, const Vector3<double>& B,
                      const Vector3<double>& C) {
  const Vector3<double> a = A - p, b = B - p, c = C - p;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  const double above = dot(a, cross(b, c));
  const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return std::atan2(above, below) / (2 * std::numbers::pi);
}

}  // namespace poinsot
