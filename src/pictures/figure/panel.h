// One picture of bodies and arrows, to which its parts are added one after the other: bodies, symbols, arrows, labels.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pictures/drawing/drawing.h"
#include "pictures/drawing/label_placement.h"
#include "pictures/solids/solid.h"
#include "pictures/solids/visibility.h"
#include "poinsot/scene.h"

namespace poinsot::pictures {

constexpr double edge_width = 0.9, silhouette_width = 1.3, rod_width = 5;

struct Panel {
  const scene::Scene& scene;
  std::vector<int> bodies;  // those that are drawn
  std::vector<scene::Pose> poses;
  Projection projection;
  std::vector<scene::Link> links;  // with the ends where they are in these poses
  std::vector<Solid> solids;
  Visibility visibility;
  bool values = false;
  bool small = false;  // whether bodies are too small for the names of their points
  std::vector<Mark> marks{};
  std::vector<LabelRequest> labels{};
  bool not_to_scale = false;  // whether an arrow is

  Panel(const scene::Scene& of, std::vector<int> drawn, std::vector<scene::Pose> where, const Projection& by)
      : scene(of),
        bodies(std::move(drawn)),
        poses(std::move(where)),
        projection(by),
        links(of.links),
        solids(solids_of(of, bodies, poses)),
        visibility(solids, projection) {}

  Vector ground(const scene::Place& place) const { return on_ground(place, poses); }
  Point2 paper(const scene::Place& place) const { return projection(ground(place)); }
  bool draws(int body) const;

  void line(std::vector<Point2> points, Role role, double width = 1, Ink ink = Ink::black, Dash dash = Dash::none) {
    marks.emplace_back(
        Stroke{.points = std::move(points), .width = width, .ink = ink, .dash = dash, .role = role, .round = true});
  }
  void loop(std::vector<Point2> points, Role role, double width = 1, Ink ink = Ink::black) {
    marks.emplace_back(Stroke{.points = std::move(points), .width = width, .ink = ink, .role = role, .closed = true});
  }
  void area(std::vector<Point2> points, const std::string& color, Role role) {
    marks.emplace_back(Fill{.loops = {std::move(points)}, .color = color, .role = role});
  }
  // A filled area with its border.
  void shape(const std::vector<Point2>& points, const std::string& color, Role role, double width = 1,
             Ink ink = Ink::black) {
    area(points, color, role);
    loop(points, role, width, ink);
  }
  // A segment as far as no body hides it.
  void seen_line(const Vector& from, const Vector& to, Role role, double width, Ink ink, Dash dash = Dash::none);
};

// The color of an ink, and of the areas of a body.
std::string color_of(Ink ink);
std::string tone_of(int body);

// The block by which a particle is drawn on the surface that it touches; empty if it touches none that is seen from the
// side.
std::vector<Point2> block_of_particle(const Panel& panel, int body, const Vector& place);
// Its middle, where an arrow stands that is not of the surface: what acts on the particle, and how it moves.
std::optional<Point2> middle_of_block(const Panel& panel, const scene::Arrow& arrow);

// The bodies: their areas, edges, rods and particles. `strength` below 1 draws them paler.
void draw_bodies(Panel& panel, double strength = 1);
// What bodies hide is drawn before them, and what is touched, on which they stand.
enum class Layer { behind_bodies, before_bodies };
void draw_symbols(Panel& panel, Layer layer);
void draw_center_lines(Panel& panel);
void draw_links(Panel& panel);
// Posts that cords are led round, and surfaces that are touched later.
void draw_posts(Panel& panel);
// The axes of the ground, from its origin where that is near, else in a corner.
void draw_axes(Panel& panel, bool at_origin);
// cut_free: of the ground's points only those at which something acts.
// momenta: those of all diagrams of an equation, which name mass centers.
void draw_points(Panel& panel, const std::vector<scene::Arrow>& arrows, bool cut_free = false,
                 const std::vector<scene::Arrow>& momenta = {});
void draw_body_names(Panel& panel);
void draw_dimensions(Panel& panel);
// Those of points, and of the axes of tops.
void draw_paths(Panel& panel);
void draw_cones(Panel& panel);
// Polhode and herpolhode on the invariable plane, as large as cones are.
void draw_polhodes(Panel& panel);

// Strokes under a line, as a draughtsman marks the ground: on the right of the direction from one end to the other.
void hatch(Panel& panel, Point2 from, Point2 to, double depth = 6);

}  // namespace poinsot::pictures
