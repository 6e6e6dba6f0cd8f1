// The solid inside a mesh from a file.
#pragma once

#include <string>

#include "statement/shapes.h"

namespace poinsot::statement {

// The origin of the file's coordinates lies at p_OM. The file must lie in the folder of the problem file, or below it.
// Throws StatementError: files elsewhere, unreadable, open, inside out or not finite.
ShapeValues mesh_shape(const Shape& shape, const Vector3<double>& p_OM, const std::string& problem_file);

}  // namespace poinsot::statement
