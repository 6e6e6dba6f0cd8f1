// Lengths and angles that data name.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/panel.h"
#include "pictures/figure/symbol_places.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_dimensions = 8;

// The symbol sloped, its value upright.
Label equation_label(std::string_view text) {
  const std::size_t sign = text.find(" = ");
  if (sign == std::string_view::npos) return name_label(text, 12);
  std::string value(text.substr(sign + 1));
  if (value.ends_with(" deg")) value.replace(value.size() - 4, 4, "°");
  // Between the parts of a unit stands a dot: N·m.
  if (const std::size_t unit = value.find_last_of(' '); unit != std::string::npos && unit > 0)
    for (std::size_t at = value.find('*', unit); at != std::string::npos; at = value.find('*', at))
      value.replace(at, 1, "·");
  // What stands for a value is a number with its unit, or a formula.
  const bool number = value.size() > 2 && (std::isdigit(static_cast<unsigned char>(value[2])) != 0 || value[2] == '-');
  Label right = number ? words_label(value, 12) : formula_label(value, 12);
  return joined(name_label(text.substr(0, sign), 12), right, 3);
}

// One equation, or several with a comma between them.
Label label_of(const scene::Dimension& dimension) {
  const std::string& text = dimension.text.empty() ? dimension.name : dimension.text;
  const std::size_t comma = text.find(", ");
  if (comma == std::string::npos) return equation_label(text);
  const Label first = joined(equation_label(std::string_view(text).substr(0, comma)), words_label(",", 12), 0);
  return joined(first, equation_label(std::string_view(text).substr(comma + 2)), 5);
}

// The strokes drawn so far, piece by piece, but for those of bodies that are only areas.
template <class Visit>
void visit_drawn(const Panel& panel, Visit visit) {
  for (const Mark& mark : panel.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark);
    if (stroke == nullptr || stroke->role == Role::body) continue;
    for (std::size_t i = 0; i + 1 < stroke->points.size() + (stroke->closed ? 1 : 0); ++i)
      visit(*stroke, stroke->points[i], stroke->points[(i + 1) % stroke->points.size()]);
  }
}

// How much of what is drawn lies beside a segment, as a length.
double drawn_beside(const Panel& panel, Point2 a, Point2 b) {
  constexpr double beside = 6;
  const Point2 along = direction(b - a), across = turned_left(along);
  const Box band{0, -beside, norm(b - a), beside};
  const auto turned = [&](Point2 p) { return Point2{dot(p - a, along), dot(p - a, across)}; };
  double sum = 0;
  visit_drawn(panel,
              [&](const Stroke&, Point2 from, Point2 to) { sum += length_within(band, turned(from), turned(to)); });
  return sum;
}

// How many outlines of bodies a segment crosses.
int outlines_crossed(const Panel& panel, Point2 a, Point2 b) {
  int count = 0;
  visit_drawn(panel, [&](const Stroke& stroke, Point2 from, Point2 to) {
    if (stroke.role == Role::outline && cross(b - a, from - a) * cross(b - a, to - a) < 0 &&
        cross(to - from, a - from) * cross(to - from, b - from) < 0)
      ++count;
  });
  return count;
}

// A radius as an arrow from the center to the rim, in the direction in which it is seen best and runs along nothing.
void draw_radius(Panel& panel, const scene::Dimension& dimension) {
  const Vector center = panel.ground(dimension.from);
  const Vector axis = normalized(turned_to_ground(dimension.from.body, dimension.axis, panel.poses));
  const Vector arm = panel.ground(dimension.to) - center;
  const Vector side = cross(axis, arm);
  const Point2 from = panel.projection(center);
  constexpr int directions = 24;
  constexpr double longest_counts = 3, preferred_side = 0.1;
  Point2 best = from;
  double least = 1e9, longest = 0;
  std::vector<Point2> ends;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
    ends.push_back(panel.projection(center + std::cos(angle) * arm + std::sin(angle) * side));
    longest = std::max(longest, norm(ends.back() - from));
  }
  for (const Point2& end : ends) {
    const double length = norm(end - from);
    const double cost = longest_counts * (1 - length / std::max(longest, 1e-9)) +
                        drawn_beside(panel, from, end) / std::max(length, 1.0) -
                        preferred_side * direction(end - from).x;
    if (cost < least) {
      least = cost;
      best = end;
    }
  }
  constexpr double shortest = 14;
  if (norm(best - from) < shortest) return;
  plain_arrow(panel, from, best, Role::dimension, 0.7, Ink::grey, 6);
  const Point2 middle = from + 0.55 * (best - from), upper = turned_left(direction(best - from));
  const double sense = upper.y <= 0 ? 1 : -1;
  panel.labels.push_back({label_of(dimension), {{middle, sense * upper, 3, 0}, {middle, -sense * upper, 3, 0.5}}, 1.5});
}

void draw_length(Panel& panel, const scene::Dimension& dimension) {
  const Point2 from = panel.paper(dimension.from), to = panel.paper(dimension.to);
  const double length = norm(to - from);
  Label label = label_of(dimension);
  if (length < 14) return;
  const Point2 along = direction(to - from), side = turned_left(along);
  const Box box = extent(panel.marks);
  double best_offset = 16, least = 1e9;
  constexpr double for_an_outline = 1.2;  // what one that is crossed costs: as much as 36 units of distance
  for (const double near : {16.0, 28.0, 42.0, 60.0, 85.0, 115.0, 150.0, 190.0})
    for (const double offset : {near, -near}) {
      const Point2 a = from + offset * side, b = to + offset * side;
      double cost = std::abs(offset) / 30 + 4 * panel.visibility.covered(a, b);
      cost += drawn_beside(panel, a, b) / 15 + for_an_outline * outlines_crossed(panel, a, b);
      // The lines from its ends to it run over bodies, too.
      for (const auto& [end, head] : {std::pair{from, a}, std::pair{to, b}})
        cost += panel.visibility.covered(end, head) * near / 40;
      // Outside of the picture rather than across it.
      if (!box.contains(a) || !box.contains(b)) cost -= 0.2;
      if (cost < least) {
        least = cost;
        best_offset = offset;
      }
    }
  const double sign = best_offset > 0 ? 1 : -1;
  const Point2 a = from + best_offset * side, b = to + best_offset * side;
  panel.line({from + (sign * 4) * side, a + (sign * 3) * side}, Role::dimension, 0.6, Ink::grey);
  panel.line({to + (sign * 4) * side, b + (sign * 3) * side}, Role::dimension, 0.6, Ink::grey);
  const Point2 middle = 0.5 * (a + b);
  std::vector<Anchor> places{{middle, sign * side, 3, 0}, {middle, -sign * side, 3, 0.5}};
  if (length > 30) {
    plain_arrow(panel, middle, a, Role::dimension, 0.7, Ink::grey, 6);
    plain_arrow(panel, middle, b, Role::dimension, 0.7, Ink::grey, 6);
  } else {
    const Point2 before = a - 12.0 * along, behind = b + 12.0 * along;
    plain_arrow(panel, before, a, Role::dimension, 0.7, Ink::grey, 6);
    plain_arrow(panel, behind, b, Role::dimension, 0.7, Ink::grey, 6);
    // A label wider than its dimension may stand behind either arrow, or over it.
    for (const auto& [tail, away] : {std::pair{before, -1.0 * along}, std::pair{behind, along}}) {
      places.push_back({tail, away, 3, 0.6});
      places.push_back({tail, sign * side, 3, 0.7});
    }
  }
  panel.labels.push_back({std::move(label), std::move(places), 1.5});
}

void draw_angle(Panel& panel, const scene::Dimension& dimension) {
  const Vector corner = panel.ground(dimension.corner);
  const Vector a = panel.ground(dimension.from) - corner, b = panel.ground(dimension.to) - corner;
  if (!(norm(a) > 0) || !(norm(b) > 0)) return;
  const Vector first = normalized(a);
  const Vector second = unit_or(b - dot(b, first) * first, Vector{});
  if (norm(second) == 0) return;
  const double angle = std::atan2(dot(b, second), dot(b, first));
  const double radius = 34 / panel.projection.scale();
  std::vector<Point2> points;
  for (int i = 0; i <= 24; ++i) {
    const double turn = angle * i / 24;
    points.push_back(panel.projection(corner + radius * (std::cos(turn) * first + std::sin(turn) * second)));
  }
  const Point2 at = panel.projection(corner);
  constexpr double readable = 4;  // units of the paper
  if (distance(points[12], points.front(), points.back()) + norm(points.back() - points.front()) < readable) return;
  for (const Vector& arm : {first, normalized(b)})
    panel.line({at, panel.projection(corner + (1.25 * radius) * arm)}, Role::dimension, 0.6, Ink::grey);
  const Point2 middle = points[12];
  panel.line(std::move(points), Role::dimension, 0.8, Ink::grey);
  Label label = label_of(dimension);
  panel.labels.push_back({std::move(label), {{middle, middle - at, 4, 0}}, 1.5});
}

// A number that belongs to a surface which is touched stands under it.
bool draw_number_of_surface(Panel& panel, const scene::Dimension& dimension) {
  const Vector at = panel.ground(dimension.from);
  const double same = 1e-9 * panel.scene.length;
  if (dimension.angle || norm(panel.ground(dimension.to) - at) > same) return false;
  for (const scene::Symbol& symbol : panel.scene.symbols) {
    if (!is_contact(symbol) || norm(panel.ground(symbol.place) - at) > same) continue;
    constexpr double depth = 10;  // of the hatches
    const Point2 into = direction(panel.projection.direction_of(-axis_on_ground(panel, symbol)), {0, 1});
    const Point2 side = turned_left(into);
    panel.labels.push_back({label_of(dimension),
                            {{panel.projection(at) + depth * into, into + 0.5 * side, 2, 0},
                             {panel.projection(at), into - 0.5 * side, 4, 1}},
                            1.2});
    return true;
  }
  // In a joint, on a post or between teeth it stands beside the place.
  const Point2 paper = panel.projection(at);
  constexpr double beside = 9;
  panel.labels.push_back(
      {label_of(dimension), {{paper, {0.7, 0.7}, beside, 0}, {paper, {-0.7, 0.7}, beside, 0.3}}, 1.2});
  return true;
}

// Whether a place is where a long cord or spring is cut off: what is measured to its end is longer than it is drawn.
bool is_cut_off(const Panel& panel, const scene::Place& place) {
  return std::ranges::any_of(panel.scene.links, [&](const scene::Link& link) {
    return link.far && norm(Vector(panel.ground(link.to) - panel.ground(place))) < 1e-6 * panel.scene.length;
  });
}

}  // namespace

void draw_dimensions(Panel& panel) {
  std::size_t drawn = 0;
  for (const scene::Dimension& dimension : panel.scene.dimensions) {
    if (!panel.draws(dimension.from.body) || !panel.draws(dimension.to.body)) continue;
    if (draw_number_of_surface(panel, dimension)) continue;
    if (!dimension.angle && (is_cut_off(panel, dimension.from) || is_cut_off(panel, dimension.to))) continue;
    if (++drawn > most_dimensions) break;
    if (dimension.angle)
      draw_angle(panel, dimension);
    else if (norm(dimension.axis) > 0)
      draw_radius(panel, dimension);
    else
      draw_length(panel, dimension);
  }
}

}  // namespace poinsot::pictures
