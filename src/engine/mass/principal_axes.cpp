#include "poinsot/engine/mass/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>

namespace poinsot {
namespace {

template <class Scalar>
using Axes = std::array<Vector3<Scalar>, 3>;

// How much larger than another a component must be so that the choice does not depend on rounding: directions are good
// to 1e-15 over the distance of the moments, and to the root of that where two of these meet.
constexpr double clearly = 1e-9;

template <class Scalar>
std::size_t largest_component(const Vector3<Scalar>& v) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(v[i]) > std::abs(v[largest]) * Scalar(1 + clearly)) largest = i;
  }
  return largest;
}

template <class Scalar>
Vector3<Scalar> with_positive_sense(const Vector3<Scalar>& v) {
  return v[largest_component(v)] < 0 ? -v : v;
}

// The direction across `axis` that is nearest to a coordinate axis: the one most nearly perpendicular to `axis`.
template <class Scalar>
Vector3<Scalar> across(const Vector3<Scalar>& axis) {
  std::size_t flattest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(axis[i]) < std::abs(axis[flattest]) * Scalar(1 - clearly)) flattest = i;
  }
  const Vector3<Scalar> unit = Vector3<Scalar>::unit(flattest);
  return normalized(unit - dot(unit, axis) * axis);
}

template <class Scalar>
PrincipalAxes<Scalar> compute(const SymmetricMatrix3<Scalar>& inertia, Scalar equal) {
  using EigenMatrix = Eigen::Matrix<Scalar, 3, 3>;
  EigenMatrix matrix;
  matrix << inertia.xx, inertia.xy, inertia.zx, inertia.xy, inertia.yy, inertia.yz, inertia.zx, inertia.yz, inertia.zz;
  if (!matrix.allFinite()) {
    const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
    return {{nan, nan, nan}, Matrix3<Scalar>::identity()};
  }
  const Eigen::SelfAdjointEigenSolver<EigenMatrix> solver(matrix);
  const auto& values = solver.eigenvalues();
  PrincipalAxes<Scalar> result{{values[0], values[1], values[2]}, Matrix3<Scalar>::identity()};
  const auto eigenvector = [&solver](int i) {
    const auto& vectors = solver.eigenvectors();
    return with_positive_sense(normalized(Vector3<Scalar>{vectors(0, i), vectors(1, i), vectors(2, i)}));
  };

  const Scalar closeness = equal * std::max(std::abs(values[0]), std::abs(values[2]));
  const bool low_pair = values[1] - values[0] <= closeness;
  const bool high_pair = values[2] - values[1] <= closeness;
  Axes<Scalar> axes{Vector3<Scalar>::unit(0), Vector3<Scalar>::unit(1), Vector3<Scalar>::unit(2)};
  if (low_pair && high_pair) {
    result.symmetry = InertiaSymmetry::spherical;
  } else if (low_pair) {
    // A disk: the free axes are chosen across the third.
    result.symmetry = InertiaSymmetry::axisymmetric;
    result.symmetry_axis = 2;
    const Vector3<Scalar> axis = eigenvector(2);
    axes[0] = across(axis);
    axes[1] = with_positive_sense(cross(axis, axes[0]));
    axes[2] = cross(axes[0], axes[1]);
  } else {
    if (high_pair) {
      result.symmetry = InertiaSymmetry::axisymmetric;
      result.symmetry_axis = 0;
    }
    axes[0] = eigenvector(0);
    axes[1] = high_pair ? across(axes[0]) : eigenvector(1);
    axes[2] = cross(axes[0], axes[1]);
  }
  result.axes = Matrix3<Scalar>::from_columns(axes[0], axes[1], axes[2]);
  return result;
}

}  // namespace

PrincipalAxes<double> principal_axes(const SymmetricMatrix3<double>& inertia, double equal) {
  return compute(inertia, equal);
}
PrincipalAxes<long double> principal_axes(const SymmetricMatrix3<long double>& inertia, long double equal) {
  return compute(inertia, equal);
}

}  // namespace poinsot
