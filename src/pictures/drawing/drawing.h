// A line drawing in numbers: what is drawn, in the order in which it is drawn, and what each mark stands for.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pictures/drawing/plane.h"

namespace poinsot::pictures {

// What a mark stands for. Labels keep away from some more than from others.
enum class Role {
  paper,
  body,     // the area of a body
  outline,  // an edge that is seen
  hidden,   // one that is not, dashed
  rod,      // a thin body
  symbol,   // a joint or a support
  link,
  point,
  axis,
  arrow,
  arrowhead,
  dimension,
  curve,
  leader,
  label,
};

enum class Ink { black, grey, light_grey, force, motion, momentum, white };
enum class Dash { none, hidden, inertial, fine, chain };

struct Stroke {
  std::vector<Point2> points;
  double width = 1;
  Ink ink = Ink::black;
  Dash dash = Dash::none;
  Role role = Role::outline;
  bool round = true;  // its ends
  bool closed = false;
  double opacity = 1;
  std::string hint{};  // told where somebody points at it
};

// Areas: loops, with the rule that what is wound around is inside.
struct Fill {
  std::vector<std::vector<Point2>> loops;
  std::string color;      // "#rrggbb"
  bool bordered = false;  // with a thin border of the same color, which closes the gaps between neighbors
  Role role = Role::body;
  double opacity = 1;
};

enum class Face { upright, italic, bold, bold_italic };

// Letters of one face and size, side by side.
struct Run {
  std::string text;
  Face face = Face::upright;
  double size = 14;
  Point2 offset{};  // of its left end on its base line
  double width = 0;
};

// Lines above letters: bars over centers of mass, dots of rates.
struct Accent {
  enum class Kind { bar, dot, two_dots } kind = Kind::bar;
  Point2 from{}, to{};
};

struct Label {
  std::vector<Run> runs;
  std::vector<Accent> accents{};
  Point2 at{};  // what the offsets of the runs are from
  Box box{};    // relative to `at`
  Ink ink = Ink::black;
  std::string hint{};  // told where somebody points at it

  Box placed() const { return box.moved(at); }
};

using Mark = std::variant<Stroke, Fill, Label>;

// Marks that stand for one thing, as programs and screen readers may want it.
struct Drawing {
  Box paper;
  std::string title, description;
  std::vector<Mark> marks;
};

Drawing moved(Drawing drawing, Point2 by);
// What the marks cover, with the widths of strokes.
Box extent(const std::vector<Mark>& marks);

// A full circle, and an arc from one angle to another (radians, counterclockwise as seen), as points.
std::vector<Point2> circle(Point2 center, double radius);
std::vector<Point2> arc(Point2 center, double radius, double from, double to);

// The smallest convex loop around the points.
std::vector<Point2> hull(std::vector<Point2> points);

}  // namespace poinsot::pictures
