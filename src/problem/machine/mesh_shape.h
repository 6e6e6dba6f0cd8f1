// The solid inside a mesh that the statement has read.
#pragma once

#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {

// The origin of the file's coordinates lies at p_OM. Throws NoFormula where the numbers must be exact.
template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM);

}  // namespace poinsot::problem
