// What a planar problem says and asks, in the words of three dimensions: quantities across the plane are left out.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

// In a statement with a plane: angular velocities, moments and whatever else points along the normal become numbers,
// vectors in the plane pairs of components. Throws StatementError for what asks or states something across the plane.
// A statement without a plane stays as it is.
void restrict_to_plane(Statement& statement);

}  // namespace poinsot::problem
