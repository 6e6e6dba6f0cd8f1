#include "pictures/solids/areas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include "pictures/solids/projected.h"

namespace poinsot::pictures {
namespace {

constexpr double finest_part = 1.0 / 16;  // of the picture: triangles are divided until their sides are no longer
constexpr std::size_t most_divided = 30000;
constexpr std::size_t lattice = 64;

struct FlatTriangle {
  std::array<DeepPoint, 3> corners;
  double depth = 0;
  int body = 0, unit = 0;
};

// Divides the longest side until none is longer. Whether a side is divided depends on it alone, so that neighbors go
// on fitting.
void divide(const FlatTriangle& triangle, double longest, std::vector<FlatTriangle>& into) {
  std::size_t side = 3;
  double length = longest;
  for (std::size_t k = 0; k < 3; ++k) {
    const DeepPoint &a = triangle.corners[k], &b = triangle.corners[(k + 1) % 3];
    const Point2 d = b.at - a.at;
    const double own = std::sqrt(dot(d, d) + (b.depth - a.depth) * (b.depth - a.depth));
    if (own > length) {
      length = own;
      side = k;
    }
  }
  if (side == 3 || into.size() > most_divided) {
    into.push_back(triangle);
    return;
  }
  const DeepPoint &a = triangle.corners[side], &b = triangle.corners[(side + 1) % 3];
  const DeepPoint middle{0.5 * (a.at + b.at), (a.depth + b.depth) / 2};
  FlatTriangle first = triangle, second = triangle;
  first.corners[(side + 1) % 3] = middle;
  second.corners[side] = middle;
  divide(first, longest, into);
  divide(second, longest, into);
}

// The border of triangles wound in one sense: sides that two of them run along in opposite directions fall away.
class Border {
 public:
  void add(const FlatTriangle& triangle) {
    for (std::size_t k = 0; k < 3; ++k)
      ++sides_[(number(triangle.corners[k]) << 32U) | number(triangle.corners[(k + 1) % 3])];
  }
  std::vector<std::vector<Point2>> loops() {
    std::multimap<std::size_t, std::size_t> next;
    for (const auto& [side, count] : sides_) {
      const std::size_t from = side >> 32U, to = side & 0xffffffffU;
      const auto reverse = sides_.find((to << 32U) | from);
      const int left = count - (reverse == sides_.end() ? 0 : reverse->second);
      for (int i = 0; i < left; ++i) next.emplace(from, to);
    }
    std::vector<std::vector<Point2>> result;
    while (!next.empty()) {
      std::vector<Point2> loop;
      const std::size_t begin = next.begin()->first;
      std::size_t at = begin;
      for (auto it = next.find(at); it != next.end(); it = next.find(at)) {
        loop.push_back(points_[at]);
        at = it->second;
        next.erase(it);
        if (at == begin) break;
      }
      if (loop.size() > 2) result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  std::size_t number(const DeepPoint& p) {
    const auto part = [](double d) { return static_cast<std::uint64_t>(std::llround(d * 256)) & 0x1fffffU; };
    const std::uint64_t key = (part(p.at.x) << 42U) | (part(p.at.y) << 21U) | part(p.depth);
    const auto [it, is_new] = numbers_.try_emplace(key, points_.size());
    if (is_new) points_.push_back(p.at);
    return it->second;
  }
  std::unordered_map<std::uint64_t, std::size_t> numbers_;
  std::vector<Point2> points_;
  std::unordered_map<std::size_t, int> sides_;
};

std::vector<FlatTriangle> facing_triangles(const std::vector<Solid>& solids, const Projection& projection) {
  std::vector<FlatTriangle> triangles;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids[i];
    if (solid.hole || solid.extent == scene::Extent::line || solid.extent == scene::Extent::point) continue;
    const std::vector<DeepPoint> points = projected(solid, projection);
    for (const auto& t : solid.triangles) {
      const double area = signed_area(t, points);
      if (area == 0 || (area > 0 && solid.extent == scene::Extent::volume)) continue;
      FlatTriangle flat{{points[t[0]], points[t[1]], points[t[2]]}, 0, solid.body, static_cast<int>(i)};
      if (area > 0) std::swap(flat.corners[1], flat.corners[2]);
      triangles.push_back(flat);
    }
  }
  return triangles;
}

// The loops of the holes in a plate, wound against it.
std::vector<std::vector<Point2>> holes_in(int plate, const std::vector<Solid>& solids, const Projection& projection) {
  std::vector<std::vector<Point2>> loops;
  for (const Solid& hole : solids) {
    if (hole.plate != plate) continue;
    const std::vector<DeepPoint> points = projected(hole, projection);
    Border border;
    for (const auto& t : hole.triangles) {
      FlatTriangle flat{{points[t[0]], points[t[1]], points[t[2]]}};
      if (signed_area(t, points) < 0) std::swap(flat.corners[1], flat.corners[2]);
      border.add(flat);
    }
    std::ranges::move(border.loops(), std::back_inserter(loops));
  }
  return loops;
}

struct Layer {
  int body = 0, unit = 0;
  Border border;
};

// Appends each triangle, the farthest first, to the last layer of its unit, if no later layer of another covers the
// same cells of a lattice over the picture.
class Layers {
 public:
  Layers(const Box& box, std::size_t units)
      : box_(box), cell_(std::max({box.width(), box.height(), 1e-9}) / lattice), last_(lattice * lattice) {
    own_.assign(units, -1);
  }

  void add(const FlatTriangle& triangle) {
    Box box;
    for (const DeepPoint& corner : triangle.corners) box.include(corner.at);
    int above = -1;
    visit(box, [&](Cell& cell) { above = std::max(above, cell.unit == triangle.unit ? cell.other : cell.newest); });
    int& own = own_[static_cast<std::size_t>(triangle.unit)];
    if (own < 0 || own < above) {
      own = static_cast<int>(layers_.size());
      layers_.push_back({triangle.body, triangle.unit, {}});
    }
    layers_[static_cast<std::size_t>(own)].border.add(triangle);
    visit(box, [&](Cell& cell) {
      if (cell.unit != triangle.unit) {
        cell.other = std::max(cell.other, cell.newest);
        cell.newest = own;
        cell.unit = triangle.unit;
      } else {
        cell.newest = std::max(cell.newest, own);
      }
    });
  }
  std::vector<Layer>& layers() { return layers_; }

 private:
  struct Cell {
    int newest = -1, unit = -1, other = -1;  // the newest layer, its unit, and the newest one of any other unit
  };
  template <class Visit>
  void visit(const Box& box, Visit visit) {
    const auto place = [&](double d) {
      return static_cast<std::size_t>(std::clamp(d / cell_, 0.0, double{lattice - 1}));
    };
    for (std::size_t row = place(box.top - box_.top); row <= place(box.bottom - box_.top); ++row)
      for (std::size_t column = place(box.left - box_.left); column <= place(box.right - box_.left); ++column)
        visit(last_[row * lattice + column]);
  }
  Box box_;
  double cell_;
  std::vector<Cell> last_;
  std::vector<int> own_;
  std::vector<Layer> layers_;
};

}  // namespace

std::vector<Area> areas_of(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                           const Projection& projection) {
  std::vector<FlatTriangle> triangles = facing_triangles(solids, projection);
  if (triangles.empty()) return {};
  // Bodies that reach into each other get one tone, that of the first: what of one is before the other then needs no
  // areas of its own, and their lines tell.
  std::map<int, int> tone;
  const auto tone_of = [&](int body) {
    for (auto it = tone.find(body); it != tone.end(); it = tone.find(body)) body = it->second;
    return body;
  };
  for (const Intersection& meeting : intersections) {
    const int first = tone_of(solids[meeting.first].body), second = tone_of(solids[meeting.second].body);
    if (first != second) tone[std::max(first, second)] = std::min(first, second);
  }
  for (FlatTriangle& triangle : triangles) triangle.body = tone_of(triangle.body);
  Box box;
  bool several = false, holed = false;
  for (FlatTriangle& triangle : triangles) {
    for (const DeepPoint& corner : triangle.corners) box.include(corner.at);
    several = several || triangle.body != triangles.front().body;
  }
  for (const Solid& solid : solids) holed = holed || solid.plate >= 0;
  // Shapes of one body have one tone: only between bodies, and around holes, it counts what is before.
  std::map<std::pair<int, int>, int> units;
  for (FlatTriangle& triangle : triangles) {
    bool has_holes = false;
    for (const Solid& solid : solids) has_holes = has_holes || solid.plate == triangle.unit;
    const std::pair<int, int> unit{triangle.body, has_holes ? triangle.unit : -1};
    triangle.unit = units.try_emplace(unit, static_cast<int>(units.size())).first->second;
  }
  if (several || holed) {
    std::vector<FlatTriangle> divided;
    const double longest = finest_part * std::max(box.width(), box.height());
    for (const FlatTriangle& triangle : triangles) divide(triangle, longest, divided);
    triangles = std::move(divided);
  }
  std::vector<std::pair<double, double>> plates(units.size());  // sums of depths, and how many they are of
  for (FlatTriangle& triangle : triangles) {
    triangle.depth = (triangle.corners[0].depth + triangle.corners[1].depth + triangle.corners[2].depth) / 3;
    auto& [sum, count] = plates[static_cast<std::size_t>(triangle.unit)];
    sum += triangle.depth;
    ++count;
  }
  // A plate with holes is drawn at once, or its holes would be wound around where it is not.
  for (const auto& [unit, number] : units)
    if (unit.second >= 0)
      for (FlatTriangle& triangle : triangles)
        if (triangle.unit == number)
          triangle.depth =
              plates[static_cast<std::size_t>(number)].first / plates[static_cast<std::size_t>(number)].second;
  std::ranges::stable_sort(triangles, {}, &FlatTriangle::depth);
  Layers layers(box, units.size());
  for (const FlatTriangle& triangle : triangles) layers.add(triangle);

  std::vector<Area> areas;
  for (Layer& layer : layers.layers()) {
    Area area{layer.body, layer.border.loops()};
    for (const auto& [unit, number] : units)
      if (number == layer.unit && unit.second >= 0)
        std::ranges::move(holes_in(unit.second, solids, projection), std::back_inserter(area.loops));
    areas.push_back(std::move(area));
  }
  return areas;
}

}  // namespace poinsot::pictures
