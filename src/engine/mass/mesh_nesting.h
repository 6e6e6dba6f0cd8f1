// How the closed surfaces of a mesh lie in each other.
#pragma once

#include <optional>
#include <string>

#include "poinsot/engine/mass/mesh.h"

namespace poinsot {

// A surface that lies where its orientation cannot be meant: a part inside another or overlapping it, whose space would
// count twice, or one that is inside out and no cavity of another. mesh: of closed, consistently turned surfaces.
// Looks at points just below some triangles of each surface, as many as a bound of work allows: surfaces that cross
// elsewhere only are not found.
std::optional<MeshFault> find_nesting_fault(const TriangleMesh<double>& mesh, const std::string& name);

}  // namespace poinsot
