#include "pictures/figure/arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/drawing/label_text.h"

namespace poinsot::pictures {
namespace {

using scene::Quantity;

constexpr double end_on_part = 0.12;  // of its length: an arrow that is seen shorter is drawn as a point or a cross
constexpr double head_length = 10, head_half_width = 3.4;
constexpr double around = 0.42;  // where the curved arrow of a turning goes around its shaft, as a part of it
constexpr double shortest_turning = 46;
constexpr double to_and_fro = 0.6;  // of the length of what acts in one sense
constexpr double open_arrow = 0.5;  // of the longest, of one whose size is open
constexpr double past_symbol = 18;  // how far a symbol reaches from its middle

enum class Head { full, open, hollow };

struct Style {
  Ink ink = Ink::force;
  Head head = Head::full;
  Dash dash = Dash::none;
  double width = 1.5;
};

// Kinds differ by head and dash, so that they are told apart without color.
Style style_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
    case Quantity::weight:
    case Quantity::couple:
      return {};
    case Quantity::impulse:
    case Quantity::angular_impulse:
      return {.width = 2.6};
    case Quantity::velocity:
    case Quantity::angular_velocity:
    case Quantity::displacement:
    case Quantity::angular_displacement:
      return {.ink = Ink::motion, .head = Head::open};
    case Quantity::acceleration:
    case Quantity::angular_acceleration:
      return {.ink = Ink::motion, .head = Head::open, .dash = Dash::fine};
    case Quantity::linear_momentum:
    case Quantity::angular_momentum:
    case Quantity::rate_of_momentum:
    case Quantity::rate_of_angular_momentum:
      return {.ink = Ink::momentum, .head = Head::hollow, .dash = Dash::inertial};
    case Quantity::unbalance:
      return {.ink = Ink::black};
  }
  return {};
}

// Whether it shows a state of the body, whose tail stands at the point, and nothing that pushes or pulls.
bool belongs_to_body(Quantity quantity) { return style_of(quantity).head != Head::full; }

// What a particle brings to the body that it hits: its head is at the point.
bool arrives(const scene::Arrow& arrow) { return arrow.quantity == Quantity::linear_momentum && arrow.known; }

void draw_head(Panel& panel, Point2 tip, Point2 along, const Style& style) {
  const Point2 side = turned_left(along);
  const Point2 left = tip - head_length * along + head_half_width * side;
  const Point2 right = tip - head_length * along - head_half_width * side;
  switch (style.head) {
    case Head::full:
      return panel.area({tip, left, right}, color_of(style.ink), Role::arrowhead);
    case Head::open:
      return panel.line({left, tip, right}, Role::arrowhead, 1.4, style.ink);
    case Head::hollow:
      return panel.shape({tip, left, right}, "#ffffff", Role::arrowhead, 1.2, style.ink);
  }
}

// What has been drawn, so that the next arrow is not drawn over it.
struct Shaft {
  Point2 tail, tip;
};

// How much of one arrow runs along another, as a part of it, and how near their heads are.
double clash(const Shaft& a, const Shaft& b) {
  double sum = 0;
  constexpr int samples = 9;
  for (int i = 1; i < samples; ++i) {
    const Point2 p = a.tail + (static_cast<double>(i) / samples) * (a.tip - a.tail);
    if (distance(p, b.tail, b.tip) < 4.5) sum += 1.0 / samples;
  }
  // Where only their tails meet, as at one point of application, nothing is lost.
  return sum + (norm(a.tip - b.tip) < 12 ? 1.5 : 0) + (distance(a.tip, b.tail, b.tip) < 6 ? 0.5 : 0);
}

class ArrowDrawer {
 public:
  ArrowDrawer(Panel& panel, const Largest& largest) : panel_(panel), largest_(largest) {
    for (const Mark& mark : panel.marks) {
      const auto* stroke = std::get_if<Stroke>(&mark);
      if (stroke == nullptr || (stroke->role != Role::rod && stroke->role != Role::symbol)) continue;
      std::vector<Shaft>& segments = stroke->role == Role::rod ? rods_ : symbols_;
      for (std::size_t i = 0; i + 1 < stroke->points.size(); ++i)
        segments.push_back({stroke->points[i], stroke->points[i + 1]});
    }
  }

  void draw(const scene::Arrow& arrow) {
    const double size = norm(arrow.vector);
    const double largest = largest_.of[static_cast<std::size_t>(scale_of(arrow.quantity))];
    if (!std::isfinite(size) || (!arrow.open && !(size > rounding_part * largest))) return;
    const double to_scale = longest_arrow * (arrow.open ? open_arrow : size / largest);
    const bool marked = to_scale < shortest_arrow;
    const double full = std::max(to_scale, shortest_arrow);
    const Vector direction = arrow.vector / size;
    const Point2 seen = panel_.projection.direction_of(direction);
    const Point2 at = middle_of_block(panel_, arrow).value_or(panel_.paper(arrow.at));
    if (arrow.quantity == Quantity::unbalance) return unbalance(arrow, at, pictures::direction(seen, {1, 0}));
    if (norm(seen) < end_on_part) return end_on(arrow, at, dot(direction, panel_.projection.view().viewer) > 0);
    // What is not to scale has its least length on the paper.
    const Shaft shaft = place(arrow, at,
                              (arrow.swings ? to_and_fro : 1) *
                                  (marked ? least_length(arrow.quantity) * pictures::direction(seen) : full * seen));
    const Style style = style_of(arrow.quantity);
    const Point2 along = pictures::direction(shaft.tip - shaft.tail);
    const bool doubled = turns(arrow.quantity);
    const double back = head_length * (doubled ? 1.7 : 0.9);
    panel_.line({shaft.tail, shaft.tip - std::min(back, 0.8 * norm(shaft.tip - shaft.tail)) * along}, Role::arrow,
                style.width, style.ink, style.dash);
    std::get<Stroke>(panel_.marks.back()).hint = hint_of(arrow);
    if (doubled) {
      draw_head(panel_, shaft.tip - 0.8 * head_length * along, along, style);
      curved(shaft, direction, style, arrow.swings);
    }
    draw_head(panel_, shaft.tip, along, style);
    if (arrow.swings && !doubled) draw_head(panel_, shaft.tail, -along, style);
    if (marked) mark(shaft, style, doubled);
    if (arrow.open) stroke_across(shaft, style, doubled ? 0.12 : 0.28);
    drawn_.push_back(shaft);
    label(arrow, shaft, along);
  }

 private:
  // A double head and a curved arrow need more room.
  static double least_length(Quantity quantity) { return turns(quantity) ? shortest_turning : shortest_arrow; }

  // The best of some places: tail or head at the point, or beside it, clear of bodies and of other arrows.
  Shaft place(const scene::Arrow& arrow, Point2 at, Point2 arm) const {
    const Point2 side = turned_left(direction(arm));
    Shaft best{at, at + arm};
    double least = 1e9;
    // So may how a frame of reference moves, since all of it does.
    const bool movable = turns(arrow.quantity) || is_of_frame(arrow);
    constexpr double beside = 20;
    const auto attempt = [&](const Shaft& shaft, double cost) {
      // What may be moved does not lie on a body from which its line has a way out.
      cost += (movable ? 1.3 : 0.8) * panel_.visibility.covered(shaft.tail, shaft.tip);
      for (const Shaft& other : drawn_) {
        const double clashing = clash(shaft, other);
        // Two along one line would read as one.
        constexpr double as_one = 0.2;
        cost += 2 * clashing + (movable && clashing > as_one ? 0.8 : 0);
        // A couple at the tail of a force that stands elsewhere would seem to belong to it.
        if (movable && distance(other.tail, at, at) > beside && distance(other.tail, shaft.tail, shaft.tip) < beside)
          cost += 1;
      }
      // What may be moved does not lie on a thin body or a symbol if there is room elsewhere; what pushes along a body
      // stands before its end.
      cost += (movable ? 1.3 : 0.6) * along_rods(shaft);
      cost += (movable ? 1 : 0.5) * over_symbols(shaft);
      // What turns, drawn from outside with its head at a body, would seem to push it.
      constexpr double at_head = 12;
      if (movable && !panel_.visibility.over_body(shaft.tail) &&
          panel_.visibility.over_body(shaft.tip + at_head * direction(arm)))
        cost += 0.8;
      if (cost < least - 1e-9) {
        least = cost;
        best = shaft;
      }
    };
    if (arrow.swings && !movable) {
      // Both its heads are free: it stands beside the place, or beyond the body.
      constexpr double aside = 22;
      for (const double part : {0.0, 0.5, 1.0})
        for (const double sense : {1.0, -1.0})
          for (const double distance : {aside, 2 * aside}) {
            const Point2 middle = at + sense * distance * side;
            attempt({middle - part * arm, middle + (1 - part) * arm}, std::abs(part - 0.5) + 0.2 * distance / aside);
          }
      return best;
    }
    attempt({at, at + arm}, arrives(arrow) ? 1.5 : 0);
    if (arrives(arrow)) attempt({at - arm, at}, 0);
    if (!belongs_to_body(arrow.quantity)) attempt({at - arm, at}, 0.1);
    for (const double step : {9.0, -9.0}) {
      attempt({at + step * side, at + step * side + arm}, 0.8);
      if (!belongs_to_body(arrow.quantity)) attempt({at + step * side - arm, at + step * side}, 0.9);
    }
    if (movable) {
      // Free vectors may stand further along.
      for (const double part : {0.5, 1.0, 1.5}) attempt({at + part * arm, at + (1 + part) * arm}, 0.3 + 0.3 * part);
      attempt({at - 1.6 * arm, at - 0.6 * arm}, 1.2);
      // Where its line has left the body, not far from where it belongs; a frame of reference turns all of the picture.
      if (const double out = way_out(at, direction(arm)); out > 0)
        for (const double aside : {0.0, 9.0, -9.0, 16.0, -16.0}) {
          const Point2 begin = at + out * direction(arm) + aside * side;
          attempt({begin, begin + arm}, 0.4 + (is_of_frame(arrow) ? 0 : out / 400) + std::abs(aside) / 40);
        }
      // Beside a shaft, beyond the bearing at its end.
      const Point2 beyond = past_symbol * direction(arm);
      attempt({at + beyond, at + beyond + arm}, 0.25);
      for (const double step : {9.0, -9.0}) {
        attempt({at + step * side + beyond, at + step * side + beyond + arm}, 0.9);
        attempt({at + step * side - beyond - arm, at + step * side - beyond}, 1.0);
      }
    }
    return best;
  }

  bool is_of_frame(const scene::Arrow& arrow) const {
    return arrow.body >= 0 && panel_.scene.bodies.at(static_cast<std::size_t>(arrow.body)).frame;
  }

  // How far along its line an arrow finds itself beyond all bodies; 0 if it begins there.
  double way_out(Point2 at, Point2 along) const {
    constexpr double step = 6;
    constexpr int most = 77;
    int out = 0;
    for (int steps = 0; steps < most; ++steps)
      if (panel_.visibility.over_body(at + steps * step * along)) out = steps + 2;
    return out * step;
  }

  // How much of an arrow runs along thin bodies, as a part of it.
  double along_rods(const Shaft& shaft) const {
    constexpr int samples = 9;
    int on = 0;
    for (int i = 1; i < samples; ++i) {
      const Point2 p = shaft.tail + (static_cast<double>(i) / samples) * (shaft.tip - shaft.tail);
      on += std::ranges::any_of(rods_,
                                [&](const Shaft& rod) { return distance(p, rod.tail, rod.tip) < 0.6 * rod_width; });
    }
    return static_cast<double>(on) / (samples - 1);
  }

  // How much of an arrow stands over symbols: 1 if it is as long as these are.
  double over_symbols(const Shaft& shaft) const {
    constexpr double step = 3, near = 6;
    const double length = norm(shaft.tip - shaft.tail);
    const int steps = static_cast<int>(length / step);
    int over = 0;
    for (int i = 0; i <= steps; ++i) {
      const Point2 p = shaft.tail + i * step / std::max(length, 1e-9) * (shaft.tip - shaft.tail);
      if (std::ranges::any_of(symbols_, [&](const Shaft& s) { return distance(p, s.tail, s.tip) < near; })) ++over;
    }
    return std::min(1.0, over * step / past_symbol);
  }

  // The arrow around the shaft by the rule of the right hand, open where it passes behind.
  void curved(const Shaft& shaft, const Vector& axis, const Style& style, bool both_ways) {
    const double toward = dot(axis, panel_.projection.view().viewer);
    const Point2 shaft_along = direction(shaft.tip - shaft.tail);
    // Seen from the side a circle would be a stroke: it is drawn a little open.
    constexpr double radius = 9, least_opening = 0.35, gap = 0.75;
    const Point2 nearest = (toward > 0 ? -1 : 1) * std::max(std::abs(toward), least_opening) * shaft_along;
    const Point2 onward = -turned_left(shaft_along);  // where the right hand turns what is nearest
    const Point2 center = shaft.tail + around * (shaft.tip - shaft.tail);
    std::vector<Point2> points;
    const double from = -std::numbers::pi + gap, to = std::numbers::pi - gap;
    for (int i = 0; i <= 30; ++i) {
      const double angle = from + (to - from) * i / 30;
      points.push_back(center + radius * (std::cos(angle) * nearest + std::sin(angle) * onward));
    }
    panel_.line(points, Role::arrow, 1.1, style.ink);
    const auto small_head = [&](Point2 tip, Point2 along) {
      panel_.line({tip - 5.0 * along + 3.0 * turned_left(along), tip, tip - 5.0 * along - 3.0 * turned_left(along)},
                  Role::arrowhead, 1.1, style.ink);
    };
    small_head(points[30], direction(points[30] - points[28]));
    if (both_ways) small_head(points[0], direction(points[0] - points[2]));
  }

  // A small heavy spot beside the axis, whatever its distance.
  void unbalance(const scene::Arrow& arrow, Point2 at, Point2 along) {
    constexpr double distance = 24, radius = 4;
    const Shaft shaft{at, at + distance * along};
    panel_.line({shaft.tail, shaft.tip}, Role::arrow, 0.9);
    panel_.area(circle(shaft.tip, radius), color_of(Ink::black), Role::arrowhead);
    drawn_.push_back(shaft);
    add_label(arrow, {{shaft.tip, along, radius + 3, 0}, {shaft.tip, turned_left(along), radius + 3, 0.3}}, Ink::black);
  }

  // Two strokes across the shaft.
  void mark(const Shaft& shaft, const Style& style, bool turning) {
    panel_.not_to_scale = true;
    // Clear of the arrow that goes around.
    for (const double part : turning ? std::array{0.08, 0.17} : std::array{0.22, 0.34})
      stroke_across(shaft, style, part);
  }
  void stroke_across(const Shaft& shaft, const Style& style, double part) {
    const Point2 along = direction(shaft.tip - shaft.tail), side = turned_left(along);
    const Point2 at = shaft.tail + part * (shaft.tip - shaft.tail);
    panel_.line({at - 4.0 * side - 1.5 * along, at + 4.0 * side + 1.5 * along}, Role::arrow, 1, style.ink);
  }

  // A vector along the line of sight: a circle with the point or the feathers of an arrow; a turning goes around.
  void end_on(const scene::Arrow& arrow, Point2 at, bool to_viewer) {
    const Style style = style_of(arrow.quantity);
    if (turns(arrow.quantity)) {
      double radius = 17;
      for (const Point2& center : turned_) radius += norm(center - at) < 10 ? 7 : 0;
      turned_.push_back(at);
      const double from = 0.6, sweep = to_viewer ? 4.4 : -4.4;
      std::vector<Point2> points = arc(at, radius, from, from + sweep);
      const Point2 tip = points.back(), along = direction(tip - points[points.size() - 3]);
      const Point2 begin = points.front(), back = direction(begin - points[2]);
      panel_.line(std::move(points), Role::arrow, style.width, style.ink, style.dash);
      draw_head(panel_, tip + 3.0 * along, along, style);
      if (arrow.swings) draw_head(panel_, begin + 3.0 * back, back, style);
      drawn_.push_back({tip - 8.0 * along, tip});
      return add_label(arrow, {{at + radius * Point2{0.7, -0.7}, {1, -1}, 4, 0}, {tip, {}, 6, 1}}, style.ink);
    }
    const double radius = 6;
    Point2 center = at;
    for (const Shaft& other : drawn_)
      if (norm(other.tip - center) < 12) center = center + Point2{13, 0};
    panel_.shape(circle(center, radius), "#ffffff", Role::arrowhead, style.width, style.ink);
    if (to_viewer) {
      panel_.area(circle(center, 2), color_of(style.ink), Role::arrowhead);
    } else {
      const double d = radius / std::numbers::sqrt2;
      panel_.line({center + Point2{-d, -d}, center + Point2{d, d}}, Role::arrowhead, 1.2, style.ink);
      panel_.line({center + Point2{-d, d}, center + Point2{d, -d}}, Role::arrowhead, 1.2, style.ink);
    }
    drawn_.push_back({center, center});
    add_label(arrow, {{center, {1, -1}, radius + 2, 0}}, style.ink);
  }

  void label(const scene::Arrow& arrow, const Shaft& shaft, Point2 along) {
    const Point2 side = turned_left(along);
    const Point2 upper = side.y <= 0 ? side : -side;
    const Point2 middle = shaft.tail + 0.6 * (shaft.tip - shaft.tail);
    add_label(arrow,
              {{shaft.tip, along, 4, 0},
               {shaft.tip - 6.0 * along, side, 6, 0.6},
               {shaft.tip - 6.0 * along, -side, 6, 0.6},
               {middle, upper, 5, 1.2},
               {middle, -upper, 5, 1.4},
               {shaft.tail, -along, 4, 3}},
              style_of(arrow.quantity).ink);
  }

  // Where letters are drawn with values that nobody stated, a number would say something that does not hold.
  bool has_value(const scene::Arrow& arrow) const {
    return !arrow.open && std::isfinite(arrow.value) && panel_.scene.drawn_letters.empty();
  }

  // What it is and how large, for who points at it.
  std::string hint_of(const scene::Arrow& arrow) const {
    std::string text = arrow.text.empty() ? arrow.name : arrow.text;
    constexpr std::size_t longest_formula = 200;
    if (!arrow.formula.empty() && arrow.formula.size() < longest_formula)
      text += " = " + arrow.formula;
    else if (has_value(arrow))
      text += " = " + value_text(arrow.value, arrow.unit);
    return text;
  }

  void add_label(const scene::Arrow& arrow, std::vector<Anchor> anchors, Ink ink) {
    Label label = !arrow.symbol.empty() ? tex_label(arrow.symbol) : name_label(arrow.text);
    if (panel_.values) {
      constexpr std::size_t longest_formula = 36;
      constexpr double size = 12;
      if (!arrow.formula.empty() && arrow.formula.size() < longest_formula)
        label = joined(joined(std::move(label), words_label("=", size), 4), formula_label(arrow.formula, size), 4);
      else if (has_value(arrow))
        label = joined(std::move(label), words_label("= " + value_text(arrow.value, arrow.unit), size), 4);
    }
    if (label.runs.empty()) return;
    label.ink = ink;
    label.hint = hint_of(arrow);
    panel_.labels.push_back({std::move(label), std::move(anchors), 3, false, ink});
  }

  Panel& panel_;
  const Largest& largest_;
  std::vector<Shaft> drawn_, rods_, symbols_;
  std::vector<Point2> turned_;
};

}  // namespace

void draw_arrows(Panel& panel, const std::vector<scene::Arrow>& arrows, const Largest& largest) {
  ArrowDrawer drawer(panel, largest);
  // Those that stand at a point first; those that may be moved give way.
  for (const bool turning : {false, true})
    for (const scene::Arrow& arrow : arrows)
      if (turns(arrow.quantity) == turning) drawer.draw(arrow);
}

void plain_arrow(Panel& panel, Point2 from, Point2 to, Role role, double width, Ink ink, double head) {
  const Point2 along = direction(to - from), side = turned_left(along);
  panel.line({from, to - 0.8 * head * along}, role, width, ink);
  panel.area({to, to - head * along + 0.33 * head * side, to - head * along - 0.33 * head * side}, color_of(ink), role);
}

}  // namespace poinsot::pictures
