// Principal moments and axes of inertia.
#pragma once

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot {

enum class InertiaSymmetry {
  triaxial,      // three different principal moments: the axes are unique but for their senses
  axisymmetric,  // two equal: every direction across the axis of symmetry is principal
  spherical,     // all equal: every direction is principal
};

// The tensor is the sum of moments[i] a_i a_i^T, where a_i is column i of `axes`.
template <class Scalar>
struct PrincipalAxes {
  Vector3<Scalar> moments;  // ascending, as the tensor's unit
  Matrix3<Scalar> axes;     // columns: right-handed perpendicular unit vectors on the tensor's axes
  InertiaSymmetry symmetry = InertiaSymmetry::triaxial;
  std::size_t symmetry_axis = 2;  // the column that is the axis of symmetry, if axisymmetric: 0 (rods) or 2 (disks)
};

// Moments closer together than `equal` times the largest count as equal. Senses and free directions are chosen so that
// they do not depend on rounding: the first two axes have their largest component positive; across an axis of symmetry
// and for a spherical tensor the axes follow the coordinate axes as far as they can. A not finite tensor gives not
// finite moments.
PrincipalAxes<double> principal_axes(const SymmetricMatrix3<double>& inertia, double equal = 1e-12);
PrincipalAxes<long double> principal_axes(const SymmetricMatrix3<long double>& inertia, long double equal = 1e-15L);

}  // namespace poinsot
