#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>

#include "engine/mass/mesh_formats.h"
#include "engine/mass/text_scanner.h"

namespace poinsot::mesh_text {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t count_end = 84;
constexpr std::size_t record_bytes = 50;  // normal, three corners, attribute

// Gives equal points one vertex.
class VertexPool {
 public:
  explicit VertexPool(TriangleMesh<double>& mesh) : mesh_(mesh) {}

  std::uint32_t index_of(Vector3<double> v) {
    // Minus zero is zero.
    v = {v.x + 0.0, v.y + 0.0, v.z + 0.0};
    const auto [place, is_new] = numbers_.try_emplace(v, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(v);
    return place->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Vector3<double>& v) const {
      std::uint64_t mixed = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &v[i], sizeof bits);
        mixed = (mixed ^ bits) * 0x9E3779B97F4A7C15ULL;
        mixed ^= mixed >> 32;
      }
      return static_cast<std::size_t>(mixed);
    }
  };
  struct Equal {
    bool operator()(const Vector3<double>& a, const Vector3<double>& b) const {
      return a.x == b.x && a.y == b.y && a.z == b.z;
    }
  };
  TriangleMesh<double>& mesh_;
  std::unordered_map<Vector3<double>, std::uint32_t, Hash, Equal> numbers_;
};

bool is_finite(const Vector3<double>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::uint32_t unsigned_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

double float_at(std::string_view bytes, std::size_t at) {
  const std::uint32_t bits = unsigned_at(bytes, at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

MeshReadResult read_binary(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  const std::size_t count = unsigned_at(bytes, header_bytes);
  if (count > limits.triangles) return error_at_byte(name, header_bytes, too_many_triangles(limits));
  if (bytes.size() < count_end + record_bytes * count) {
    return error_at_byte(name, bytes.size(),
                         fmt::format("the binary STL file ends early: {} triangles need {} bytes, but it has {}", count,
                                     count_end + record_bytes * count, bytes.size()));
  }
  TriangleMesh<double> mesh;
  mesh.triangles.reserve(count);
  VertexPool pool(mesh);
  for (std::size_t i = 0; i < count; ++i) {
    count_work(work_of_triangle);
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = count_end + record_bytes * i + 12 * (k + 1);
      const Vector3<double> v{float_at(bytes, at), float_at(bytes, at + 4), float_at(bytes, at + 8)};
      if (!is_finite(v)) {
        return error_at_byte(
            name, at, fmt::format("corner {} of triangle {} is not finite: ({}, {}, {})", k + 1, i + 1, v.x, v.y, v.z));
      }
      corners[k] = pool.index_of(v);
    }
    mesh.triangles.push_back(corners);
  }
  return {std::move(mesh), {}};
}

// facet normal x y z / outer loop / vertex x y z (three times) / endloop / endfacet, between solid and endsolid.
class TextReader {
 public:
  TextReader(std::string_view bytes, const std::string& name, const MeshLimits& limits)
      : scanner_(bytes), name_(name), limits_(limits), pool_(mesh_) {}

  MeshReadResult read() {
    while (next_solid() && facets()) {
    }
    if (failure_) return *failure_;
    return {std::move(mesh_), {}};
  }

 private:
  bool fail(const std::string& message) {
    failure_ = error_at_line(name_, scanner_.line(), message);
    return false;
  }
  // False at the end of the file and for trouble.
  bool next_solid() {
    const std::string_view word = scanner_.word();
    if (word.empty()) return false;
    if (!equal_ignoring_case(word, "solid")) return fail("expected 'solid', found " + shown(word));
    scanner_.skip_line();
    return true;
  }
  bool facets() {
    for (;;) {
      const std::string_view word = scanner_.word();
      if (equal_ignoring_case(word, "endsolid")) {
        scanner_.skip_line();
        return true;
      }
      if (!equal_ignoring_case(word, "facet")) {
        return fail(word.empty() ? "the file ends before 'endsolid'"
                                 : "expected 'facet' or 'endsolid', found " + shown(word));
      }
      if (!facet()) return false;
    }
  }
  bool facet() {
    count_work(5 * work_of_triangle);
    if (mesh_.triangles.size() >= limits_.triangles) return fail(too_many_triangles(limits_));
    // The normal is not needed, and some writers leave it undefined.
    Vector3<double> normal;
    if (!expect("normal") || !coordinates(normal, "the normal", false)) return false;
    if (!expect("outer") || !expect("loop")) return false;
    std::array<std::uint32_t, 3> corners{};
    for (auto& corner : corners) {
      Vector3<double> v;
      if (!expect("vertex") || !coordinates(v, "the vertex", true)) return false;
      corner = pool_.index_of(v);
    }
    mesh_.triangles.push_back(corners);
    return expect("endloop") && expect("endfacet");
  }
  bool expect(std::string_view keyword) {
    const std::string_view word = scanner_.word();
    if (equal_ignoring_case(word, keyword)) return true;
    if (keyword == "endloop" && equal_ignoring_case(word, "vertex")) {
      return fail("a facet with more than three vertices; STL facets are triangles");
    }
    return fail(fmt::format("expected '{}', found {}", keyword, word.empty() ? "the end of the file" : shown(word)));
  }
  bool coordinates(Vector3<double>& v, std::string_view what, bool finite) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view word = scanner_.word();
      const std::optional<double> value = number(word);
      if (!value) {
        return fail(fmt::format("expected three numbers for {}, found {}", what,
                                word.empty() ? "the end of the file" : shown(word)));
      }
      if (finite && !std::isfinite(*value)) {
        return fail(fmt::format("a coordinate of {} is not a finite number: {}", what, shown(word)));
      }
      v[i] = *value;
    }
    return true;
  }

  Scanner scanner_;
  const std::string& name_;
  const MeshLimits& limits_;
  TriangleMesh<double> mesh_;
  VertexPool pool_;
  std::optional<MeshReadResult> failure_;
};

}  // namespace

MeshReadResult read_stl(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  // Some binary files begin with "solid" too, so the exact size decides first.
  if (bytes.size() >= count_end && bytes.size() == count_end + record_bytes * unsigned_at(bytes, header_bytes)) {
    return read_binary(bytes, name, limits);
  }
  const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n\f\v"), bytes.size());
  if (equal_ignoring_case(bytes.substr(start, 5), "solid")) return TextReader(bytes, name, limits).read();
  if (bytes.size() < count_end) {
    return error_at_byte(name, bytes.size(),
                         "neither a text STL file, which starts with 'solid', nor a binary one, which has at least 84 "
                         "bytes");
  }
  return read_binary(bytes, name, limits);
}

}  // namespace poinsot::mesh_text
