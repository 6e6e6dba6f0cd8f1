#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/mass/mesh_formats.h"
#include "engine/mass/text_scanner.h"

namespace poinsot::mesh_text {
namespace {

// Statements that say nothing about the surface's shape.
constexpr std::array<std::string_view, 16> passed_over{"vn",     "vt",     "vp",         "g",        "o", "s",
                                                       "mg",     "usemtl", "mtllib",     "usemap",   "p", "l",
                                                       "maplib", "lod",    "shadow_obj", "trace_obj"};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name, const MeshLimits& limits)
      : scanner_(bytes), name_(name), limits_(limits) {}

  MeshReadResult read() {
    for (; !scanner_.at_end(); scanner_.skip_line()) {
      count_work(work_of_triangle);
      if (!statement()) return *failure_;
    }
    return {std::move(mesh_), {}};
  }

 private:
  bool fail(const std::string& message) {
    failure_ = error_at_line(name_, scanner_.line(), message);
    return false;
  }
  bool statement() {
    const std::string_view keyword = scanner_.word_on_line();
    if (keyword.empty() || keyword.front() == '#') return true;
    if (keyword == "v") return vertex();
    if (keyword == "f") return face();
    if (std::find(passed_over.begin(), passed_over.end(), keyword) != passed_over.end()) return true;
    return fail("expected an OBJ statement such as 'v x y z' or 'f i j k', found " + shown(keyword));
  }
  // v x y z, and after that a weight or a colour.
  bool vertex() {
    Vector3<double> v;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view word = scanner_.word_on_line();
      const std::optional<double> value = number(word);
      if (!value) {
        return fail("expected three numbers after 'v', found " +
                    (word.empty() ? std::string("the end of the line") : shown(word)));
      }
      if (!std::isfinite(*value)) return fail("a coordinate is not a finite number: " + shown(word));
      v[i] = *value;
    }
    if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max()) return fail("too many vertices");
    mesh_.vertices.push_back(v);
    return true;
  }
  // f with corners v, v/vt, v//vn or v/vt/vn; negative numbers count back from the last vertex.
  bool face() {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::size_t corners = 0;
    for (;;) {
      const std::string_view word = scanner_.word_on_line();
      if (word.empty() || word.front() == '#') break;
      std::uint32_t index = 0;
      if (!corner(word, index)) return false;
      if (corners == 0) first = index;
      if (corners >= 2) {
        if (mesh_.triangles.size() >= limits_.triangles) return fail(too_many_triangles(limits_));
        count_work(work_of_triangle);
        mesh_.triangles.push_back({first, last, index});
      }
      last = index;
      ++corners;
    }
    if (corners < 3) return fail(fmt::format("a face needs at least three corners, found {}", corners));
    return true;
  }
  bool corner(std::string_view word, std::uint32_t& index) {
    const std::string_view digits = word.substr(0, word.find('/'));
    long long value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || digits.empty()) {
      return fail("expected a vertex number in a face, found " + shown(word));
    }
    const auto known = static_cast<long long>(mesh_.vertices.size());
    if (value == 0 || value > known || value < -known) {
      return fail(
          fmt::format("vertex number {} of a face is outside 1 to {} (or -{} to -1): a face follows its vertices",
                      value, known, known));
    }
    index = static_cast<std::uint32_t>(value > 0 ? value - 1 : known + value);
    return true;
  }

  Scanner scanner_;
  const std::string& name_;
  const MeshLimits& limits_;
  TriangleMesh<double> mesh_;
  std::optional<MeshReadResult> failure_;
};

}  // namespace

MeshReadResult read_obj(std::string_view bytes, const std::string& name, const MeshLimits& limits) {
  return Reader(bytes, name, limits).read();
}

}  // namespace poinsot::mesh_text
