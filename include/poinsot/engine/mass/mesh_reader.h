// Triangle meshes from STL (binary and text) and Wavefront OBJ files.
//
// A reader takes any bytes: it returns a mesh or says what is wrong and where, and never needs memory beyond a small
// multiple of the input. It does not ask whether the mesh is closed: see find_faults in poinsot/engine/mass/mesh.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "poinsot/engine/mass/mesh.h"

namespace poinsot {

enum class MeshFormat { stl, obj };

struct MeshLimits {
  std::size_t bytes = std::size_t{512} << 20;
  std::size_t triangles = 10'000'000;
};

struct MeshReadError {
  std::string message;     // "wheel.stl:7: expected ..." or "wheel.stl: byte 84: ..."
  std::size_t line = 0;    // counted from 1 in text files, else 0
  std::size_t offset = 0;  // in binary files, the byte where the trouble starts
};

// Either a mesh or an error.
struct MeshReadResult {
  std::optional<TriangleMesh<double>> mesh;
  MeshReadError error;
};

// From bytes in memory; `name` stands in messages for the file. Vertices of an STL file with equal coordinates become
// one vertex. Faces of an OBJ file with more than three corners, which must be flat, are split into triangles from
// their first corner; colours, normals, textures, groups, lines and points are passed over.
MeshReadResult read_mesh(std::string_view bytes, MeshFormat format, const std::string& name,
                         const MeshLimits& limits = {});

// From a file; the format goes by its ending, .stl or .obj.
MeshReadResult read_mesh_file(const std::string& path, const MeshLimits& limits = {});

}  // namespace poinsot
