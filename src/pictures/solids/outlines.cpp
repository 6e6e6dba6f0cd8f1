#include "pictures/solids/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "pictures/solids/projected.h"

namespace poinsot::pictures {
namespace {

// Pieces of lines between places, joined where one ends and another begins.
class Chains {
 public:
  void add(Point2 from, Point2 to, double depth) {
    if (norm(to - from) < 1e-4) return;
    // One behind another, as both rims of a shell that is seen along its axis, would make a fork of each place.
    if (!drawn_.insert(std::minmax(key(from), key(to))).second) return;
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
  std::set<std::pair<Key, Key>> drawn_;
};

// Keeps of a line, besides its ends, the points that it would be seen to miss: by `seen` or more.
void keep_bends(const std::vector<Point2>& points, double seen, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = seen;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double away = distance(points[i], points[first], points[last]); away > farthest) {
        farthest = away;
        at = i;
      }
    if (at == first) continue;
    kept[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
}

// Which points lie on the convex hull of all.
std::vector<bool> on_hull(const std::vector<Point2>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(points[i].x, points[i].y); });
  std::vector<bool> found(points.size());
  for (const double side : {1.0, -1.0}) {  // the lower and the upper half
    std::vector<std::size_t> half;
    for (const std::size_t i : order) {
      const auto turns_in = [&] {
        const Point2 a = points[half[half.size() - 2]], b = points[half.back()], c = points[i];
        return side * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) <= 0;
      };
      while (half.size() > 1 && turns_in()) half.pop_back();
      half.push_back(i);
    }
    for (const std::size_t i : half) found[i] = true;
  }
  return found;
}

// The tangent of the circle through three points at the one in the middle.
Point2 tangent_between(Point2 a, Point2 b, Point2 c) {
  const Point2 before = b - a, after = c - b;
  const double first = norm(before), second = norm(after);
  return direction((second / first) * before + (first / second) * after);
}

// The angle by which a line turns at the middle one of three points.
double turn_at(Point2 a, Point2 b, Point2 c) { return std::abs(std::atan2(cross(b - a, c - b), dot(b - a, c - b))); }

// Puts further points between those of a curve without corners, on cubic pieces through them.
std::vector<Point2> curve_through(const std::vector<Point2>& points, bool closed) {
  constexpr double finest = 0.2;  // radians between two chords
  constexpr double longest = 12;  // units of the paper
  constexpr std::size_t least = 4;
  const std::size_t count = points.size();
  if (count < least) return points;
  std::vector<Point2> tangents(count);
  std::vector<double> turns(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const bool end = i == 0 || i + 1 == count;
    if (end && !closed) continue;
    // A closed line ends with its first point.
    const Point2 &before = points[end ? count - 2 : i - 1], &after = points[end ? 1 : i + 1];
    turns[i] = turn_at(before, points[i], after);
    tangents[i] = tangent_between(before, points[i], after);
  }
  if (!closed) {
    const auto mirrored = [](Point2 tangent, Point2 along) { return 2 * dot(tangent, along) * along - tangent; };
    tangents.front() = mirrored(tangents[1], direction(points[1] - points[0]));
    tangents.back() = mirrored(tangents[count - 2], direction(points[count - 1] - points[count - 2]));
    turns.front() = turns[1];
    turns.back() = turns[count - 2];
  }
  std::vector<Point2> finer;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Point2 from = points[i], to = points[i + 1];
    const double chord = norm(to - from);
    const double parts = std::max(chord / longest, (turns[i] + turns[i + 1]) / 2 / finest);
    const int pieces = std::max(1, static_cast<int>(std::ceil(parts)));
    const Point2 first = from + chord / 3 * tangents[i], second = to - chord / 3 * tangents[i + 1];
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, u = 1 - t;
      finer.push_back(u * u * u * from + 3 * u * u * t * first + 3 * u * t * t * second + t * t * t * to);
    }
  }
  finer.push_back(points.back());
  return finer;
}

// Makes curves of what runs between corners, so that it has no flats where its points are far apart and no corners
// where it turns fast.
void round_off(std::vector<Point2>& points, bool closed) {
  constexpr double sharpest = 0.9;  // radians between two chords: what turns more is a corner
  constexpr std::size_t least = 5;
  if (points.size() < least) return;
  const auto is_corner = [&](std::size_t i) {
    const std::size_t last = points.size() - 1;
    const bool end = i == 0 || i == last;
    return turn_at(points[end ? last - 1 : i - 1], points[i], points[end ? 1 : i + 1]) > sharpest;
  };
  std::vector<std::size_t> corners;
  for (std::size_t i = closed ? 0 : 1; i + 1 < points.size(); ++i)
    if (is_corner(i)) corners.push_back(i);
  if (closed && corners.empty()) {
    points = curve_through(points, true);
    return;
  }
  if (closed) {
    // From a corner to itself.
    points.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(corners.front()), points.end());
    points.push_back(points.front());
    const std::size_t first = corners.front();
    corners.erase(corners.begin());
    for (std::size_t& corner : corners) corner -= first;
  }
  corners.push_back(points.size() - 1);
  std::vector<Point2> all{points.front()};
  std::size_t begin = 0;
  for (const std::size_t end : corners) {
    const std::vector<Point2> run = curve_through(
        {points.begin() + static_cast<std::ptrdiff_t>(begin), points.begin() + static_cast<std::ptrdiff_t>(end) + 1},
        false);
    all.insert(all.end(), run.begin() + 1, run.end());
    begin = end;
  }
  points = std::move(all);
}

// Of what is convex all corners of triangles lie within the true outline: of those that a silhouette goes through, the
// outermost are nearest to it. Returns false if the line is not that of something convex, and leaves it as it is.
bool keep_outermost(std::vector<Point2>& points, double to_and_fro) {
  std::vector<bool> kept = on_hull(points);
  kept.front() = kept.back() = true;
  std::size_t last = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!kept[i]) continue;
    for (std::size_t k = last + 1; k < i; ++k)
      if (distance(points[k], points[last], points[i]) > to_and_fro) return false;
    last = i;
  }
  constexpr double too_near = 0.3;  // of the next chord: what is seen as a bend
  constexpr double unseen = 0.4;    // units of the paper
  std::vector<Point2> outer;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!kept[i]) continue;
    while (outer.size() > 1) {
      const Point2 before = outer[outer.size() - 2], here = outer.back();
      const double first = norm(here - before), second = norm(points[i] - here);
      if (std::min(first, second) > too_near * std::max(first, second) || distance(here, before, points[i]) > unseen)
        break;
      outer.pop_back();
    }
    outer.push_back(points[i]);
  }
  points = std::move(outer);
  return true;
}

// A silhouette goes to and fro along the sides of triangles, by a part of what it goes around: what is left is where it
// goes. Through points as far apart as that a curve is smooth, where nearer ones would give it bends.
void simplify(SeenLine& line) {
  if (line.points.size() < 3) return;
  if (line.closed) {
    // From an outermost point to itself.
    std::rotate(line.points.begin(), std::ranges::min_element(line.points, {}, &Point2::x), line.points.end());
    line.points.push_back(line.points.front());
  }
  constexpr double least = 0.25, to_and_fro = 0.002;  // units of the paper; of the line's width and height
  Box box;
  for (const Point2& point : line.points) box.include(point);
  constexpr double most_to_and_fro = 5;  // of what is simplified
  const bool convex = keep_outermost(line.points, most_to_and_fro * to_and_fro * (box.width() + box.height()));
  std::vector<bool> kept(line.points.size());
  kept.front() = kept.back() = true;
  keep_bends(line.points, std::max(least, to_and_fro * (box.width() + box.height())), kept);
  std::vector<Point2> points;
  for (std::size_t i = 0; i < line.points.size(); ++i)
    if (kept[i]) points.push_back(line.points[i]);
  if (convex) round_off(points, line.closed);
  if (line.closed) points.pop_back();
  line.points = std::move(points);
}

bool is_silhouette(const MeshEdge& edge, const Solid& solid, const std::vector<DeepPoint>& points) {
  if (edge.feature) return false;
  if (edge.second < 0) return true;
  // Facing the viewer, y being downward, a triangle is wound the other way.
  const bool first = signed_area(solid.triangles[static_cast<std::size_t>(edge.first)], points) < 0;
  const bool second = signed_area(solid.triangles[static_cast<std::size_t>(edge.second)], points) < 0;
  return (first != second) != edge.same_sense;
}

double distance_to_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector d = b - a;
  const double square = norm_squared(d);
  return norm(p - a - (square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0.0) * d);
}

void add_seen(Chains& chains, const DeepPoint& from, const DeepPoint& to, const Visibility& visibility) {
  for (const Interval& part : visibility.seen(from, to))
    chains.add(from.at + part.first * (to.at - from.at), from.at + part.second * (to.at - from.at),
               from.depth + (part.first + part.second) / 2 * (to.depth - from.depth));
}

// What of a segment is hidden, but not by what `alone` has.
void add_hidden(Chains& chains, const DeepPoint& a, const DeepPoint& b, const Visibility& visibility,
                const Visibility& alone) {
  for (const Interval& hidden : remainder(visibility.seen(a, b)))
    for (const Interval& part : alone.seen(a, b)) {
      const double begin = std::max(hidden.first, part.first), end = std::min(hidden.second, part.second);
      if (begin < end) chains.add(a.at + begin * (b.at - a.at), a.at + end * (b.at - a.at), a.depth);
    }
}

void add_rods_within(Lines& lines, const std::vector<Solid>& solids, const Projection& projection,
                     const Visibility& visibility) {
  if (std::ranges::none_of(solids, &Solid::stand_in)) return;
  std::vector<Solid> stated = solids;
  for (Solid& solid : stated)
    if (solid.stand_in) solid.triangles.clear();
  const Visibility without(stated, projection);
  for (const Solid& solid : stated) {
    if (solid.extent != scene::Extent::line) continue;
    const std::vector<DeepPoint> points = projected(solid, projection);
    Chains chains;
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)  // hidden with them and seen without them
        add_hidden(chains, points[line[i]], points[line[i + 1]], visibility, without);
    for (SeenLine& line : chains.take()) {
      line.body = solid.body;
      lines.rods_within.push_back(std::move(line));
    }
  }
}

}  // namespace

Lines seen_lines(const std::vector<Solid>& solids, const std::vector<Intersection>& intersections,
                 const Projection& projection, const Visibility& visibility) {
  Lines lines;
  const auto take = [](Chains& chains, int body, bool stand_in, bool silhouette, std::vector<SeenLine>& into) {
    for (SeenLine& line : chains.take()) {
      line.body = body;
      line.stand_in = stand_in;
      line.silhouette = silhouette;
      if (silhouette) simplify(line);
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
    take(features, solid.body, solid.stand_in, false, solid.extent == scene::Extent::line ? lines.rods : lines.edges);
    take(silhouettes, solid.body, solid.stand_in, true, lines.edges);
  }
  add_rods_within(lines, solids, projection, visibility);
  Chains meetings;
  for (const Intersection& meeting : intersections)
    add_seen(meetings, {projection(meeting.from), projection.depth(meeting.from)},
             {projection(meeting.to), projection.depth(meeting.to)}, visibility);
  take(meetings, 0, false, false, lines.edges);
  return lines;
}

namespace {

// Which segments of a line run through one of the places, with those that go on from them without a corner.
std::vector<bool> segments_through(const std::vector<std::uint32_t>& line, const Solid& solid,
                                   const std::vector<Vector>& places, double near) {
  constexpr double straight_on = 0.9;  // the cosine of the largest angle that is no corner
  const std::size_t count = line.size() - 1;
  const bool closed = line.front() == line.back();
  const auto vertex = [&](std::size_t i) { return solid.vertices[line[i]]; };
  const auto goes_on = [&](std::size_t i, std::size_t k) {
    const Vector a = vertex(i + 1) - vertex(i), b = vertex(k + 1) - vertex(k);
    return dot(a, b) > straight_on * norm(a) * norm(b);
  };
  std::vector<bool> through(count);
  for (std::size_t i = 0; i < count; ++i)
    through[i] = std::ranges::any_of(
        places, [&](const Vector& place) { return distance_to_segment(place, vertex(i), vertex(i + 1)) < near; });
  // Around a closed line twice, so that what is found reaches everything.
  for (std::size_t step = 0; step < 2 * count; ++step) {
    const std::size_t i = step % count, k = (i + 1) % count;
    if ((k == 0 && !closed) || !goes_on(i, k)) continue;
    if (through[i]) through[k] = true;
  }
  for (std::size_t step = 2 * count; step-- > 0;) {
    const std::size_t i = step % count, k = (i + 1) % count;
    if ((k == 0 && !closed) || !goes_on(i, k)) continue;
    if (through[k]) through[i] = true;
  }
  return through;
}

}  // namespace

std::vector<SeenLine> hidden_lines(const std::vector<Solid>& solids, const std::vector<Vector>& places, double near,
                                   const Projection& projection, const Visibility& visibility) {
  std::vector<SeenLine> found;
  for (const Solid& solid : solids) {
    if (solid.hole || solid.extent == scene::Extent::line) continue;
    const std::vector<DeepPoint> points = projected(solid, projection);
    std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;  // two faces may name the edge between them
    Chains chains;
    for (const auto& line : solid.lines) {
      const std::vector<bool> through = segments_through(line, solid, places, near);
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (!through[i] || !drawn.emplace(std::min(line[i], line[i + 1]), std::max(line[i], line[i + 1])).second)
          continue;
        const DeepPoint &a = points[line[i]], &b = points[line[i + 1]];
        for (const Interval& part : remainder(visibility.seen(a, b)))
          chains.add(a.at + part.first * (b.at - a.at), a.at + part.second * (b.at - a.at), 0);
      }
    }
    for (SeenLine& hidden : chains.take()) {
      hidden.body = solid.body;
      found.push_back(std::move(hidden));
    }
  }
  return found;
}

std::vector<SeenLine> lines_of_hidden_bodies(const std::vector<Solid>& solids, const Lines& seen,
                                             const Projection& projection, const Visibility& visibility) {
  // Of what is seen to be round or long less is seen than this, as a part of its width and height.
  constexpr double least_seen = 0.25;
  std::map<int, Box> boxes;
  for (const Solid& solid : solids)
    if (!solid.hole && solid.extent != scene::Extent::point && !solid.massless)
      for (const Vector& vertex : solid.vertices) boxes[solid.body].include(projection(vertex));
  std::map<int, double> lengths;
  for (const auto* lines : {&seen.edges, &seen.rods})
    for (const SeenLine& line : *lines)
      for (std::size_t i = 0; i + 1 < line.points.size() + (line.closed ? 1 : 0); ++i)
        lengths[line.body] += norm(line.points[(i + 1) % line.points.size()] - line.points[i]);
  std::vector<SeenLine> found;
  if (boxes.size() < 2) return found;
  for (const auto& [body, box] : boxes) {
    if (!(lengths[body] < least_seen * (box.width() + box.height()))) continue;
    std::vector<Solid> own;
    for (const Solid& solid : solids)
      if (solid.body == body) own.push_back(solid);
    const Visibility alone(own, projection);
    for (const Solid& solid : own) {
      if (solid.hole || solid.massless) continue;
      const std::vector<DeepPoint> points = projected(solid, projection);
      Chains features, silhouettes;
      for (const auto& line : solid.lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
          add_hidden(features, points[line[i]], points[line[i + 1]], visibility, alone);
      for (const MeshEdge& edge : solid.mesh_edges)
        if (is_silhouette(edge, solid, points))
          add_hidden(silhouettes, points[edge.from], points[edge.to], visibility, alone);
      for (Chains* chains : {&features, &silhouettes})
        for (SeenLine& line : chains->take()) {
          line.body = body;
          if (chains == &silhouettes) simplify(line);
          found.push_back(std::move(line));
        }
    }
  }
  return found;
}

}  // namespace poinsot::pictures
