#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "pictures/figure/panel.h"
#include "pictures/figure/symbol_places.h"
#include "pictures/solids/areas.h"
#include "pictures/solids/outlines.h"

namespace poinsot::pictures {
namespace {

constexpr double particle_radius = 4, center_radius = 7;
constexpr double same_place = 1e-6;  // of the picture
constexpr double ball_radius = 9;    // of a particle at a joint, whose symbol would cover a smaller one

std::string hex(const std::array<double, 3>& color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const double part : color) {
    const int value = static_cast<int>(std::lround(std::clamp(part, 0.0, 255.0)));
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

// Where a surface lies under a body, at a place.
const scene::Symbol* contact_at(const Panel& panel, int body, const Vector& place) {
  for (const scene::Symbol& symbol : panel.scene.symbols)
    if (is_contact(symbol) && symbol.to == body &&
        norm(panel.ground(symbol.place) - place) < same_place * panel.scene.length)
      return &symbol;
  return nullptr;
}

bool is_joint_at(const Panel& panel, int body, const Vector& place) {
  return std::ranges::any_of(panel.scene.symbols, [&](const scene::Symbol& symbol) {
    return !is_contact(symbol) && (symbol.to == body || symbol.from == body) &&
           norm(panel.ground(symbol.place) - place) < same_place * panel.scene.length;
  });
}

// A block on the surface that a particle touches; a ball at a joint; else a dot.
void draw_particle(Panel& panel, int body, const Vector& place, double strength) {
  const Point2 at = panel.projection(place);
  if (const std::vector<Point2> block = block_of_particle(panel, body, place); !block.empty()) {
    panel.marks.emplace_back(Fill{.loops = {block}, .color = tone_of(body), .bordered = true, .opacity = strength});
    panel.marks.emplace_back(
        Stroke{.points = block, .width = silhouette_width, .role = Role::outline, .closed = true, .opacity = strength});
    return;
  }
  panel.marks.emplace_back(Fill{.loops = {circle(at, is_joint_at(panel, body, place) ? ball_radius : particle_radius)},
                                .color = "#333333",
                                .role = Role::point,
                                .opacity = strength});
}

// The quartered circle that stands for the mass center of a body whose shape is not known.
void draw_center(Panel& panel, Point2 at, double strength) {
  const std::vector<Point2> rim = circle(at, center_radius);
  panel.marks.emplace_back(Fill{.loops = {rim}, .color = "#ffffff", .role = Role::point, .opacity = strength});
  for (const double from : {0.0, std::numbers::pi}) {
    std::vector<Point2> quarter = arc(at, center_radius, from, from + std::numbers::pi / 2);
    quarter.push_back(at);
    panel.marks.emplace_back(
        Fill{.loops = {std::move(quarter)}, .color = "#333333", .role = Role::point, .opacity = strength});
  }
  panel.marks.emplace_back(Stroke{.points = rim, .width = 1, .role = Role::point, .closed = true, .opacity = strength});
}

void draw_rods(Panel& panel, std::vector<SeenLine> rods, double strength) {
  std::ranges::stable_sort(rods, {}, &SeenLine::depth);
  // Those of one body are joined, so that first their borders are drawn and then what is between.
  for (std::size_t begin = 0; begin < rods.size();) {
    std::size_t end = begin;
    while (end < rods.size() && rods[end].body == rods[begin].body) ++end;
    for (const bool inside : {false, true})
      for (std::size_t i = begin; i < end; ++i) {
        Stroke stroke{.points = rods[i].points,
                      .width = inside ? rod_width - 2 : rod_width,
                      .ink = inside ? Ink::light_grey : Ink::black,
                      .role = inside ? Role::body : Role::rod,
                      .closed = rods[i].closed,
                      .opacity = strength};
        panel.marks.emplace_back(std::move(stroke));
      }
    begin = end;
  }
}

// Dashed, where a named point lies behind a body.
void draw_hidden_edges(Panel& panel, double strength) {
  std::vector<Vector> behind;
  for (const scene::Point& point : panel.scene.points) {
    const Vector at = panel.ground(point.place);
    if (panel.draws(point.place.body) && !panel.visibility.seen({panel.projection(at), panel.projection.depth(at)}))
      behind.push_back(at);
  }
  if (behind.empty()) return;
  for (SeenLine& line :
       hidden_lines(panel.solids, behind, 1e-3 * panel.scene.length, panel.projection, panel.visibility))
    panel.marks.emplace_back(Stroke{.points = std::move(line.points),
                                    .width = 0.7,
                                    .ink = Ink::grey,
                                    .dash = Dash::hidden,
                                    .role = Role::hidden,
                                    .closed = line.closed,
                                    .opacity = strength});
}

}  // namespace

std::vector<Point2> block_of_particle(const Panel& panel, int body, const Vector& place) {
  const scene::Symbol* contact = contact_at(panel, body, place);
  if (contact == nullptr) return {};
  constexpr double half_width = 15, height = 18, least_seen = 0.5;
  const Point2 seen = panel.projection.direction_of(axis_on_ground(panel, *contact));
  if (!(norm(seen) > least_seen)) return {};
  const Point2 at = panel.projection(place), up = direction(seen), side = half_width * turned_left(up);
  return {at - side, at + side, at + side + height * up, at - side + height * up};
}

std::optional<Point2> middle_of_block(const Panel& panel, const scene::Arrow& arrow) {
  const int body = arrow.at.body;
  if (body < 0 || std::ranges::none_of(panel.solids, [&](const Solid& solid) {
        return solid.body == body && solid.extent == scene::Extent::point;
      }))
    return std::nullopt;
  const Vector place = panel.ground(arrow.at);
  const std::vector<Point2> block = block_of_particle(panel, body, place);
  if (block.empty()) return std::nullopt;
  const std::string& surface = contact_at(panel, body, place)->name;
  if (arrow.name == surface || arrow.name == "friction at " + surface) return std::nullopt;
  return 0.5 * (block[0] + block[2]);
}

bool Panel::draws(int body) const { return body < 0 || std::ranges::find(bodies, body) != bodies.end(); }

void Panel::seen_line(const Vector& from, const Vector& to, Role role, double width, Ink ink, Dash dash) {
  const DeepPoint a{projection(from), projection.depth(from)}, b{projection(to), projection.depth(to)};
  for (const Interval& part : visibility.seen(a, b))
    line({a.at + part.first * (b.at - a.at), a.at + part.second * (b.at - a.at)}, role, width, ink, dash);
}

std::string color_of(Ink ink) {
  switch (ink) {
    case Ink::black:
      return "#1a1a1a";
    case Ink::grey:
      return "#6b6b6b";
    case Ink::light_grey:
      return "#e3e3e3";
    case Ink::force:
      return "#a3150f";
    case Ink::motion:
      return "#0b4f9e";
    case Ink::momentum:
      return "#1b6b43";
    case Ink::white:
      return "#ffffff";
  }
  return "#000000";
}

std::string tone_of(int body) {
  // Light tones that differ in lightness too, so that they are told apart in print and by the color-blind.
  static constexpr std::array<std::array<double, 3>, 6> tones{
      {{232, 238, 246}, {247, 240, 226}, {226, 236, 226}, {240, 230, 238}, {222, 228, 236}, {238, 234, 222}}};
  return hex(tones[static_cast<std::size_t>(std::max(body, 0)) % tones.size()]);
}

void draw_bodies(Panel& panel, double strength) {
  const std::vector<Intersection> intersections = intersections_of(panel.solids);
  for (Area& area : areas_of(panel.solids, intersections, panel.projection)) {
    if (panel.scene.bodies.at(static_cast<std::size_t>(area.body)).massless) {
      panel.marks.emplace_back(
          Fill{.loops = std::move(area.loops), .color = "#f6f6f6", .bordered = true, .opacity = strength});
      continue;
    }
    panel.marks.emplace_back(
        Fill{.loops = std::move(area.loops), .color = tone_of(area.body), .bordered = true, .opacity = strength});
  }
  Lines lines = seen_lines(panel.solids, intersections, panel.projection, panel.visibility);
  for (SeenLine& line : lines.edges)
    panel.marks.emplace_back(Stroke{.points = std::move(line.points),
                                    .width = line.silhouette ? silhouette_width : edge_width,
                                    .dash = line.stand_in ? Dash::fine : Dash::none,
                                    .role = Role::outline,
                                    .closed = line.closed,
                                    .opacity = strength});
  draw_hidden_edges(panel, strength);
  for (SeenLine& line : lines_of_hidden_bodies(panel.solids, lines, panel.projection, panel.visibility))
    panel.marks.emplace_back(Stroke{.points = std::move(line.points),
                                    .width = edge_width,
                                    .dash = Dash::hidden,
                                    .role = Role::outline,
                                    .closed = line.closed,
                                    .opacity = strength});
  // Stand-ins are no more than pictures: what they hide shines through.
  constexpr double through = 0.3;
  draw_rods(panel, std::move(lines.rods_within), through * strength);
  draw_rods(panel, std::move(lines.rods), strength);
  for (const Solid& solid : panel.solids)
    if (solid.extent == scene::Extent::point)
      for (const Vector& vertex : solid.vertices) draw_particle(panel, solid.body, vertex, strength);
  for (const int body : panel.bodies) {
    if (body < 0) continue;
    const scene::Body& own = panel.scene.bodies.at(static_cast<std::size_t>(body));
    const bool of_unknown_shape = own.shapes.empty() || own.shapes.front().stand_in;
    if (of_unknown_shape && !own.frame && !own.massless) draw_center(panel, panel.paper({body, own.center}), strength);
  }
}

}  // namespace poinsot::pictures
