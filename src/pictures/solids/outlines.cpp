#include "pictures/solids/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace poinsot::pictures {
namespace {

// Pieces of lines between places, joined where one ends and another begins.
class Chains {
 public:
  void add(Point2 from, Point2 to, double depth) {
    if (norm(to - from) < 1e-4) return;
    pieces_.push_back({from, to, depth, false});
    ends_.emplace(key(from), pieces_.size() - 1);
    ends_.emplace(key(to), pieces_.size() - 1);
  }

  std::vector<SeenLine> take() {
    std::vector<SeenLine> lines;
    // Chains that begin at an end or a fork come first, then those that are closed.
    for (const bool closed : {false, true})
      for (Piece& piece : pieces_) {
        if (piece.used) continue;
        if (closed || degree(piece.from) != 2)
          lines.push_back(follow(piece, piece.from, piece.to));
        else if (degree(piece.to) != 2)
          lines.push_back(follow(piece, piece.to, piece.from));
      }
    return lines;
  }

 private:
  struct Piece {
    Point2 from, to;
    double depth = 0;
    bool used = false;
  };
  using Key = std::pair<long long, long long>;
  static Key key(Point2 p) { return {std::llround(p.x * 1e3), std::llround(p.y * 1e3)}; }
  std::size_t degree(Point2 p) const { return ends_.count(key(p)); }

  SeenLine follow(Piece& first, Point2 from, Point2 to) {
    SeenLine line{{from, to}, 0, first.depth};
    first.used = true;
    while (degree(line.points.back()) == 2) {
      Piece* next = nullptr;
      const auto [begin, end] = ends_.equal_range(key(line.points.back()));
      for (auto it = begin; it != end; ++it)
        if (!pieces_[it->second].used) next = &pieces_[it->second];
      if (next == nullptr) break;
      next->used = true;
      line.points.push_back(key(next->from) == key(line.points.back()) ? next->to : next->from);
    }
    line.closed = line.points.size() > 3 && key(line.points.front()) == key(line.points.back());
    if (line.closed) line.points.pop_back();
    return line;
  }

  std::vector<Piece> pieces_;
  std::multimap<Key, std::size_t> ends_;
};

std::vector<DeepPoint> projected(const Solid& solid, const Projection& projection) {
  std::vector<DeepPoint> points;
  points.reserve(solid.vertices.size());
  for (const Vector& vertex : solid.vertices) points.push_back({projection(vertex), projection.depth(vertex)});
  return points;
}

double signed_area(const std::array<std::uint32_t, 3>& t, const std::vector<DeepPoint>& p) {
  return cross(p[t[1]].at - p[t[0]].at, p[t[2]].at - p[t[0]].at);
}

bool is_silhouette(const MeshEdge& edge, const Solid& solid, const std::vector<DeepPoint>& points) {
  if (edge.feature) return false;
  if (edge.second < 0) return true;
  // Facing the viewer, y being downward, a triangle is wound the other way.
  const bool first = signed_area(solid.triangles[static_cast<std::size_t>(edge.first)], points) < 0;
  const bool second = signed_area(solid.triangles[static_cast<std::size_t>(edge.second)], points) < 0;
  return (first != second) != edge.same_sense;
}

void add_seen(Chains& chains, const DeepPoint& from, const DeepPoint& to, const Visibility& visibility) {
  for (const Interval& part : visibility.seen(from, to))
    chains.add(from.at + part.first * (to.at - from.at), from.at + part.second * (to.at - from.at),
               from.depth + (part.first + part.second) / 2 * (to.depth - from.depth));
}

}  // namespace

Lines seen_lines(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                 const Projection& projection, const Visibility& visibility) {
  Lines lines;
  const auto take = [](Chains& chains, int body, bool silhouette, std::vector<SeenLine>& into) {
    for (SeenLine& line : chains.take()) {
      line.body = body;
      line.silhouette = silhouette;
      into.push_back(std::move(line));
    }
  };
  for (const Solid& solid : solids) {
    const std::vector<DeepPoint> points = projected(solid, projection);
    Chains features, silhouettes;
    std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;  // two faces may name the edge between them
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (drawn.emplace(std::min(line[i], line[i + 1]), std::max(line[i], line[i + 1])).second)
          add_seen(features, points[line[i]], points[line[i + 1]], visibility);
    if (!solid.hole)
      for (const MeshEdge& edge : solid.mesh_edges)
        if (is_silhouette(edge, solid, points)) add_seen(silhouettes, points[edge.from], points[edge.to], visibility);
    take(features, solid.body, false, solid.extent == scene::Extent::line ? lines.rods : lines.edges);
    take(silhouettes, solid.body, true, lines.edges);
  }
  Chains meetings;
  for (const Intersection& meeting : intersections)
    add_seen(meetings, {projection(meeting.from), projection.depth(meeting.from)},
             {projection(meeting.to), projection.depth(meeting.to)}, visibility);
  take(meetings, 0, false, lines.edges);
  return lines;
}

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
