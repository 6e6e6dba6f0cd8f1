// Vectors of a planar problem, which are written by two components.
#pragma once

#include <cstddef>

#include "problem/language/tree.h"

namespace poinsot::problem {

// The entry of a problem in which places, directions and vectors that are lists of two have zero as their component
// along the axis `normal` of the figure.
Entry with_vectors_of_plane(Entry problem, std::size_t normal);

}  // namespace poinsot::problem
