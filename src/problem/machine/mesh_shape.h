// The solid within a mesh that is read from a file.
#pragma once

#include "problem/machine/shape_arguments.h"

namespace poinsot::problem {

// p_OM is the place of the origin of the file's coordinates. The file must lie in the folder of the problem file or
// below it. Throws StatementError if it lies elsewhere, is unreadable, or if the mesh is open, inside out or not
// finite.
template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM);

}  // namespace poinsot::problem
