// Random placements and comparisons for the tests of mass properties.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/particles.h"
#include "poinsot/engine/mass/shapes.h"

namespace poinsot::testing {

template <class Scalar>
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  Scalar between(double low, double high) {
    return static_cast<Scalar>(std::uniform_real_distribution<double>(low, high)(engine_));
  }
  Scalar length() { return between(0.3, 2); }
  Vector3<Scalar> point() { return {between(-3, 3), between(-3, 3), between(-3, 3)}; }
  // Of any length but not near zero.
  Vector3<Scalar> direction() {
    for (;;) {
      const Vector3<Scalar> d{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (norm(d) > Scalar(0.2)) return between(0.5, 4) * d;
    }
  }
  Vector3<Scalar> unit() { return normalized(direction()); }
  // A direction well away from the line along `axis`.
  Vector3<Scalar> across(const Vector3<Scalar>& axis) {
    for (;;) {
      const Vector3<Scalar> d = direction();
      if (norm(cross(d, axis)) > Scalar(0.3) * norm(d) * norm(axis)) return d;
    }
  }
  Vector3<Scalar> point_apart_from(const Vector3<Scalar>& p) { return p + length() * unit(); }
  // Perpendicular unit vectors as columns, right-handed.
  Matrix3<Scalar> axes() {
    const Vector3<Scalar> x = unit();
    const Vector3<Scalar> z = normalized(cross(x, across(x)));
    return Matrix3<Scalar>::from_columns(x, cross(z, x), z);
  }
  // Any body that exists: a few particles of positive mass.
  MassProperties<Scalar> body() {
    std::vector<Particle<Scalar>> particles;
    for (int i = 0; i < 5; ++i) particles.push_back({between(0.1, 2), point()});
    return mass_properties(particles);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

 private:
  std::mt19937_64 engine_;
};

template <class Scalar>
Scalar largest_entry(const SymmetricMatrix3<Scalar>& a) {
  return std::max({std::abs(a.xx), std::abs(a.yy), std::abs(a.zz), std::abs(a.xy), std::abs(a.yz), std::abs(a.zx)});
}

// Relative to the scale `size`^2 in which lengths of shapes are of order size.
template <class Scalar>
::testing::AssertionResult near(const SymmetricMatrix3<Scalar>& a, const SymmetricMatrix3<Scalar>& b,
                                double tolerance) {
  const Scalar difference = largest_entry(a - b);
  const Scalar scale = std::max(largest_entry(a), largest_entry(b));
  if (difference <= Scalar(tolerance) * scale) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "tensors differ by " << difference << " of " << scale;
}
template <class Scalar>
::testing::AssertionResult near(const Vector3<Scalar>& a, const Vector3<Scalar>& b, double tolerance) {
  const Scalar difference = norm(a - b);
  const Scalar scale = std::max({norm(a), norm(b), Scalar(1)});
  if (difference <= Scalar(tolerance) * scale) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "vectors (" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", "
                                       << b.y << ", " << b.z << ") differ by " << difference;
}
template <class Scalar>
::testing::AssertionResult near(const Scalar& a, const Scalar& b, double tolerance) {
  if (std::abs(a - b) <= Scalar(tolerance) * std::max(std::abs(a), std::abs(b))) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << a << " and " << b << " differ by " << std::abs(a - b);
}
template <class Scalar>
::testing::AssertionResult near(const MassProperties<Scalar>& a, const MassProperties<Scalar>& b, double tolerance) {
  if (auto mass = near(a.mass, b.mass, tolerance); !mass) return mass << " (mass)";
  if (auto center = near(a.center, b.center, tolerance); !center) return center << " (center)";
  return near(a.inertia_center, b.inertia_center, tolerance);
}
template <class Scalar>
::testing::AssertionResult near(const ShapeProperties<Scalar>& a, const ShapeProperties<Scalar>& b, double tolerance) {
  return near(MassProperties<Scalar>{a.measure, a.center, a.inertia_center},
              MassProperties<Scalar>{b.measure, b.center, b.inertia_center}, tolerance);
}

}  // namespace poinsot::testing
