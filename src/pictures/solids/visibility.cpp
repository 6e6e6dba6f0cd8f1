#include "pictures/solids/visibility.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace poinsot::pictures {
namespace {

constexpr double nearer_by = 0.05;       // units of the paper; what lies on a surface is before it
constexpr double edge_on = 1e-4;         // the sine of the angle under which a facet hides nothing
constexpr double least_part = 1e-3;      // shorter parts of a segment are taken with what is beside them
constexpr std::size_t most_cells = 128;  // along one side

double clamp_part(double t) { return std::clamp(t, 0.0, 1.0); }

}  // namespace

std::vector<Interval> united(std::vector<Interval> intervals) {
  std::ranges::sort(intervals);
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (!result.empty() && interval.first <= result.back().second + 1e-9)
      result.back().second = std::max(result.back().second, interval.second);
    else
      result.push_back(interval);
  }
  return result;
}

std::vector<Interval> remainder(const std::vector<Interval>& taken) {
  std::vector<Interval> left;
  double begin = 0;
  for (const Interval& interval : taken) {
    if (interval.first > begin + least_part) left.emplace_back(begin, interval.first);
    begin = std::max(begin, interval.second);
  }
  if (begin < 1 - least_part) left.emplace_back(begin, 1.0);
  return left;
}

Visibility::Visibility(const std::vector<Solid>& solids, const Projection& projection) {
  std::set<int> with_holes;
  for (const Solid& solid : solids)
    if (solid.plate >= 0) with_holes.insert(solid.plate);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids[i];
    if (solid.hole && solid.plate < 0) continue;  // a hole in a volume shows by its rims
    std::vector<DeepPoint> points;
    for (const Vector& vertex : solid.vertices) points.push_back({projection(vertex), projection.depth(vertex)});
    const int own = solid.plate >= 0 ? solid.plate : static_cast<int>(i);
    for (const auto& triangle : solid.triangles) {
      std::array<DeepPoint, 3> p{points[triangle[0]], points[triangle[1]], points[triangle[2]]};
      double area = cross(p[1].at - p[0].at, p[2].at - p[0].at);
      // Seen from behind, the facets of a volume are hidden by those before them.
      if (solid.extent == scene::Extent::volume && area > 0) continue;
      if (area < 0) {
        std::swap(p[1], p[2]);
        area = -area;
      }
      const Point2 a = p[1].at - p[0].at, b = p[2].at - p[0].at;
      const double za = p[1].depth - p[0].depth, zb = p[2].depth - p[0].depth;
      const Point2 slope{(za * b.y - zb * a.y) / area, (zb * a.x - za * b.x) / area};
      if (!(area > 0) || !(norm(slope) < 1 / edge_on)) continue;
      facets_.push_back({{p[0].at, p[1].at, p[2].at},
                         p[0].depth - dot(slope, p[0].at),
                         slope,
                         with_holes.contains(own) ? own : -1,
                         solid.plate >= 0});
      for (const DeepPoint& q : p) box_.include(q.at);
    }
  }
  if (facets_.empty()) return;
  const double side = std::max({box_.width(), box_.height(), 1e-9});
  const double wanted = std::clamp(std::sqrt(static_cast<double>(facets_.size())) * 2, 1.0, double{most_cells});
  cell_ = side / wanted;
  columns_ = static_cast<std::size_t>(box_.width() / cell_) + 1;
  rows_ = static_cast<std::size_t>(box_.height() / cell_) + 1;
  // Counted first, then entered.
  begins_.assign(columns_ * rows_ + 1, 0);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      Box own;
      for (const Point2& q : facets_[f].corners) own.include(q);
      const std::size_t first = cell_at(own.left, own.top), last = cell_at(own.right, own.bottom);
      for (std::size_t row = first / columns_; row <= last / columns_; ++row)
        for (std::size_t column = first % columns_; column <= last % columns_; ++column) {
          const std::size_t cell = row * columns_ + column;
          if (pass == 0)
            ++begins_[cell];
          else
            entries_[--begins_[cell]] = static_cast<std::uint32_t>(f);
        }
    }
    if (pass == 0) {
      for (std::size_t cell = 1; cell < begins_.size(); ++cell) begins_[cell] += begins_[cell - 1];
      entries_.resize(begins_.back());
    }
  }
}

std::size_t Visibility::cell_at(double x, double y) const {
  const auto place = [&](double d, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(std::floor(d / cell_), 0.0, static_cast<double>(count - 1)));
  };
  return place(y - box_.top, rows_) * columns_ + place(x - box_.left, columns_);
}

// Visits the facets in the cells along the segment, some of them more than once.
template <class Visit>
void Visibility::visit_facets(Point2 from, Point2 to, Visit visit) const {
  if (facets_.empty()) return;
  const double length = norm(to - from);
  const int pieces = std::clamp(static_cast<int>(length / cell_), 1, 4 * static_cast<int>(most_cells));
  for (int i = 0; i < pieces; ++i) {
    const Point2 a = from + (static_cast<double>(i) / pieces) * (to - from);
    const Point2 b = from + (static_cast<double>(i + 1) / pieces) * (to - from);
    Box own;
    own.include(a);
    own.include(b);
    if (!own.grown(1e-6).overlaps(box_.grown(1e-6))) continue;
    const std::size_t first = cell_at(own.left, own.top), last = cell_at(own.right, own.bottom);
    for (std::size_t row = first / columns_; row <= last / columns_; ++row)
      for (std::size_t column = first % columns_; column <= last % columns_; ++column) {
        const std::size_t cell = row * columns_ + column;
        for (std::uint32_t e = begins_[cell]; e < begins_[cell + 1]; ++e) visit(facets_[entries_[e]]);
      }
  }
}

namespace {

// The part of the segment from a to b that lies in the triangle; empty if its end is not after its begin.
template <class Corners>
Interval part_within(const Corners& corners, Point2 a, Point2 b) {
  double begin = 0, end = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 side = corners[(k + 1) % 3] - corners[k];
    const double at_a = cross(side, a - corners[k]), at_b = cross(side, b - corners[k]);
    if (at_a < 0 && at_b < 0) return {1, 0};
    if (at_a < 0) begin = std::max(begin, at_a / (at_a - at_b));
    if (at_b < 0) end = std::min(end, at_a / (at_a - at_b));
  }
  return {begin, end};
}

std::vector<Interval> without(const std::vector<Interval>& whole, const std::vector<Interval>& holes) {
  std::vector<Interval> result;
  for (const Interval& part : whole) {
    double begin = part.first;
    for (const Interval& hole : holes) {
      if (hole.second <= begin || hole.first >= part.second) continue;
      if (hole.first > begin) result.emplace_back(begin, hole.first);
      begin = hole.second;
    }
    if (begin < part.second) result.emplace_back(begin, part.second);
  }
  return result;
}

}  // namespace

std::vector<Interval> Visibility::seen(const DeepPoint& from, const DeepPoint& to) const {
  std::vector<Interval> hidden;
  std::map<int, std::pair<std::vector<Interval>, std::vector<Interval>>> layers;
  visit_facets(from.at, to.at, [&](const Facet& facet) {
    auto [begin, end] = part_within(facet.corners, from.at, to.at);
    if (!(begin < end)) return;
    // How far the facet is before the segment, at its ends; linear between them.
    const double first = facet.base + dot(facet.slope, from.at) - from.depth - nearer_by;
    const double second = facet.base + dot(facet.slope, to.at) - to.depth - nearer_by;
    if (first <= 0 && second <= 0) return;
    if (first < 0) begin = std::max(begin, first / (first - second));
    if (second < 0) end = std::min(end, first / (first - second));
    if (!(begin < end)) return;
    const Interval part{clamp_part(begin), clamp_part(end)};
    if (facet.layer < 0)
      hidden.push_back(part);
    else
      (facet.hole ? layers[facet.layer].second : layers[facet.layer].first).push_back(part);
  });
  for (auto& [layer, parts] : layers) {
    const std::vector<Interval> left = without(united(std::move(parts.first)), united(std::move(parts.second)));
    hidden.insert(hidden.end(), left.begin(), left.end());
  }
  return remainder(united(std::move(hidden)));
}

bool Visibility::seen(const DeepPoint& point) const {
  constexpr double little = 0.01;
  return !seen({point.at - Point2{little, 0}, point.depth}, {point.at + Point2{little, little / 3}, point.depth})
              .empty();
}

double Visibility::covered(Point2 from, Point2 to) const {
  std::vector<Interval> over;
  visit_facets(from, to, [&](const Facet& facet) {
    const Interval part = part_within(facet.corners, from, to);
    if (!facet.hole && part.first < part.second) over.push_back(part);
  });
  double sum = 0;
  for (const Interval& part : united(std::move(over))) sum += part.second - part.first;
  return sum;
}

bool Visibility::over_body(Point2 point) const {
  return covered(point - Point2{0.01, 0}, point + Point2{0.01, 0.003}) > 0.5;
}

}  // namespace poinsot::pictures
