// The meshes that a statement names, read once each, with the mass properties of the solids inside them.
#pragma once

#include <memory>
#include <string>

#include "poinsot/engine/mass/mesh.h"
#include "problem/entries/named_files.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// The solid inside a closed mesh, as its file has it, in metres.
struct MeshSolid {
  std::shared_ptr<const std::string> bytes;  // of the file
  TriangleMesh<double> mesh;
  ShapeProperties<double> properties;
};

// Gives every mesh of the statement its solid; parts of the same file and unit share one. Throws StatementError at the
// shape: files that cannot be had or read, meshes that are open, inside out or not finite, units that are no lengths.
void read_meshes(Statement& statement, const ReadNamedFile& read);

}  // namespace poinsot::problem
