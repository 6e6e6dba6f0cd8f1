// Fuzz entry for the mesh readers: any bytes as STL and as OBJ, then the checks and sums over what was read.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "poinsot/engine/mass/mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const auto format : {poinsot::MeshFormat::stl, poinsot::MeshFormat::obj}) {
    const auto result = poinsot::read_mesh(bytes, format, "input", {1 << 20, 10'000});
    // A result is a mesh or a message, never both or neither.
    if (result.mesh.has_value() != result.error.message.empty()) std::abort();
    if (!result.mesh) continue;
    for (const auto& triangle : result.mesh->triangles) {
      for (const auto corner : triangle) {
        if (corner >= result.mesh->vertices.size()) std::abort();
      }
    }
    const auto faults = poinsot::find_faults(*result.mesh, "input");
    const auto solid = poinsot::solid_of_mesh(*result.mesh);
    if (faults.empty() && !(solid.measure > 0)) std::abort();
  }
  return 0;
}
