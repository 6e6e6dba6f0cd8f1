// Which parts of a segment are seen before the surfaces of bodies.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "pictures/solids/solid.h"

namespace poinsot::pictures {

using Interval = std::pair<double, double>;

// A point of the paper and how near it is to the viewer.
struct DeepPoint {
  Point2 at;
  double depth = 0;
};

class Visibility {
 public:
  Visibility(const std::vector<Solid>& solids, const Projection& projection);

  // The parts of the segment, from 0 at its first end to 1, before which no triangle stands; in order.
  std::vector<Interval> seen(const DeepPoint& from, const DeepPoint& to) const;
  bool seen(const DeepPoint& point) const;
  // How much of the segment lies over bodies, in the plane of the paper, as a part of it.
  double covered(Point2 from, Point2 to) const;
  bool over_body(Point2 point) const;

 private:
  struct Facet {
    std::array<Point2, 3> corners;  // in the sense in which `area` is positive
    // Its depth at a point is base + slope . point.
    double base = 0;
    Point2 slope;
    int layer = 0;  // facets of a plate with holes count together
    bool hole = false;
  };
  template <class Visit>
  void visit_facets(Point2 from, Point2 to, Visit visit) const;
  std::size_t cell_at(double x, double y) const;

  std::vector<Facet> facets_;
  Box box_;
  std::size_t columns_ = 1, rows_ = 1;
  double cell_ = 1;
  std::vector<std::uint32_t> begins_, entries_;  // the facets that meet each cell
};

// The union of intervals in order, and what of [0, 1] is left without them.
std::vector<Interval> united(std::vector<Interval> intervals);
std::vector<Interval> remainder(const std::vector<Interval>& taken);

}  // namespace poinsot::pictures
