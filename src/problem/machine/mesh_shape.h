// The solid inside a mesh from a file.
#pragma once

#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {

// The origin of the file's coordinates lies at p_OM. The file must lie in the folder of the problem file, or below it.
// Throws StatementError: files elsewhere, unreadable, open, inside out or not finite.
template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM);

}  // namespace poinsot::problem
