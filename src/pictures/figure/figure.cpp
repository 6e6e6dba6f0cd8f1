#include "pictures/figure/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/layout.h"
#include "pictures/figure/panel.h"
#include "pictures/figure/view_choice.h"

namespace poinsot::pictures {
namespace {

using scene::Diagram;
using scene::DiagramKind;
using scene::Scene;

constexpr double margin = 14, row_gap = 26;
constexpr std::size_t most_poses = 6;
const Diagram no_arrows{};

struct Size {
  double width = 400, height = 300;
};
// The more panels stand side by side, the smaller each is.
Size size_of_panels(std::size_t count) {
  return count <= 1 ? Size{400, 300} : count == 2 ? Size{300, 260} : Size{260, 250};
}

std::vector<int> all_bodies(const Scene& scene) {
  std::vector<int> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) bodies.push_back(static_cast<int>(i));
  return bodies;
}

// The places that a drawing must hold.
std::vector<Vector> places_of(const Scene& scene, const std::vector<int>& bodies, const std::vector<scene::Pose>& poses,
                              const std::vector<scene::Arrow>& arrows, bool with_symbols) {
  std::vector<Vector> places;
  for (const Solid& solid : solids_of(scene, bodies, poses))
    places.insert(places.end(), solid.vertices.begin(), solid.vertices.end());
  for (const int body : bodies) {
    if (body < 0) continue;
    const scene::Body& own = scene.bodies.at(static_cast<std::size_t>(body));
    if (own.shapes.empty() && !own.frame) places.push_back(on_ground({body, own.center}, poses));
  }
  const auto drawn = [&](int body) { return body < 0 || std::ranges::find(bodies, body) != bodies.end(); };
  for (const scene::Arrow& arrow : arrows) places.push_back(on_ground(arrow.at, poses));
  if (with_symbols) {
    for (const scene::Symbol& symbol : scene.symbols)
      if (drawn(symbol.to)) places.push_back(on_ground(symbol.place, poses));
    for (const scene::Link& link : scene.links)
      for (const scene::Place& place : {link.from, link.to})
        if (drawn(place.body)) places.push_back(on_ground(place, poses));
    for (const scene::Point& point : scene.points)
      if (drawn(point.place.body)) places.push_back(on_ground(point.place, poses));
  }
  std::erase_if(places, [](const Vector& p) { return !std::isfinite(norm(p)); });
  if (places.empty()) places.emplace_back();
  return places;
}

// The projection in which the places fill the size.
Projection fitted(const View& view, const std::vector<Vector>& places, const Size& size) {
  const Projection unscaled(view, 1);
  Box box;
  double near = 1e300, far = -1e300;
  for (const Vector& place : places) {
    box.include(unscaled(place));
    near = std::min(near, unscaled.depth(place));
    far = std::max(far, unscaled.depth(place));
  }
  const double scale =
      std::min(size.width / std::max(box.width(), 1e-300), size.height / std::max(box.height(), 1e-300));
  const Point2 middle = box.center();
  const Vector center = middle.x * view.right - middle.y * view.up + ((near + far) / 2) * view.viewer;
  return {view, std::isfinite(scale) && scale < 1e200 ? scale : 100.0, center};
}

struct PanelKind {
  bool symbols = true;  // joints, supports, links, dimensions
  bool axes = true;
  bool axes_at_origin = true;
  bool cones = false;
  bool body_names = true;
};

// The labels of a panel placed, and what it covers.
Drawing finished(Panel& panel) {
  Drawing drawing;
  const auto over_body = [&](Point2 p) { return panel.visibility.over_body(p); };
  std::vector<Mark> labels = place_labels(std::move(panel.labels), panel.marks, over_body);
  drawing.marks = std::move(panel.marks);
  std::ranges::move(labels, std::back_inserter(drawing.marks));
  drawing.paper = extent(drawing.marks);
  if (drawing.paper.empty()) drawing.paper = {0, 0, 1, 1};
  return drawing;
}

Drawing draw_panel(Panel& panel, const Diagram& diagram, const Largest& largest, const PanelKind& kind) {
  // The cones are what is shown; the body tells how it is turned.
  constexpr double beside_cones = 0.4;
  if (kind.symbols) draw_symbols(panel, Layer::behind_bodies);
  draw_bodies(panel, kind.cones ? beside_cones : 1);
  if (kind.symbols) {
    draw_links(panel);
    draw_symbols(panel, Layer::before_bodies);
  }
  if (kind.cones) {
    draw_polhodes(panel);
    draw_cones(panel);
  }
  if (kind.axes && kind.axes_at_origin) draw_axes(panel, true);
  if (kind.symbols) draw_dimensions(panel);
  if (!kind.cones) draw_points(panel, diagram.arrows, !kind.symbols);
  draw_arrows(panel, diagram.arrows, largest);
  if (kind.axes && !kind.axes_at_origin) draw_axes(panel, false);
  if (kind.body_names) draw_body_names(panel);
  return finished(panel);
}

bool is_equation_of(DiagramKind kind, FigureKind figure) {
  const bool blow =
      kind == DiagramKind::momenta_before || kind == DiagramKind::impulses || kind == DiagramKind::momenta_after;
  const bool cut_free = kind == DiagramKind::free_body || kind == DiagramKind::kinetic;
  return figure == FigureKind::free_body ? cut_free
         : figure == FigureKind::impulse ? blow
                                         : figure == FigureKind::body && (blow || cut_free);
}

std::string sign_before(DiagramKind kind) { return kind == DiagramKind::impulses ? "+" : "="; }

// The diagrams of each equation.
std::vector<std::vector<const Diagram*>> equations_of(const Scene& scene, const FigureName& name) {
  std::map<int, std::vector<const Diagram*>> groups;
  for (const Diagram& diagram : scene.diagrams)
    if (is_equation_of(diagram.kind, name.kind)) groups[diagram.group].push_back(&diagram);
  std::vector<std::vector<const Diagram*>> rows;
  for (auto& [group, diagrams] : groups) {
    const bool has_body = std::ranges::any_of(diagrams, [&](const Diagram* diagram) {
      return std::ranges::find(diagram->bodies, name.body) != diagram->bodies.end();
    });
    if (name.kind != FigureKind::body || has_body) rows.push_back(std::move(diagrams));
  }
  return rows;
}

Drawing equation(const Scene& scene, const std::vector<const Diagram*>& diagrams, const Looks& looks, bool& marked) {
  const std::vector<scene::Pose> poses = shown_poses(scene);
  std::vector<scene::Arrow> arrows;
  std::vector<int> bodies;
  Largest largest;
  for (const Diagram* diagram : diagrams) {
    arrows.insert(arrows.end(), diagram->arrows.begin(), diagram->arrows.end());
    for (const int body : diagram->bodies)
      if (body >= 0 && std::ranges::find(bodies, body) == bodies.end()) bodies.push_back(body);
  }
  for (const scene::Arrow& arrow : arrows) largest.include(arrow);
  const View view = looks.view ? *looks.view : chosen_view(scene, bodies, arrows, poses);
  const Projection projection =
      fitted(view, places_of(scene, bodies, poses, arrows, false), size_of_panels(diagrams.size()));
  std::vector<Drawing> parts;
  std::vector<std::string> signs, captions;
  for (const Diagram* diagram : diagrams) {
    Panel panel(scene, diagram->bodies, poses, projection);
    panel.values = looks.values;
    const PanelKind kind{.symbols = false, .axes = parts.empty(), .axes_at_origin = false};
    Drawing part = draw_panel(panel, *diagram, largest, kind);
    marked = marked || panel.not_to_scale;
    captions.push_back(diagram->title);
    if (!parts.empty()) signs.push_back(sign_before(diagram->kind));
    parts.push_back(std::move(part));
  }
  return side_by_side(std::move(parts), signs, captions);
}

Drawing single(const Scene& scene, const Diagram& diagram, const PanelKind& kind, const Looks& looks, bool& marked) {
  const std::vector<scene::Pose> poses = shown_poses(scene);
  const std::vector<int> bodies = diagram.bodies.empty() ? all_bodies(scene) : diagram.bodies;
  Largest largest;
  for (const scene::Arrow& arrow : diagram.arrows) largest.include(arrow);
  const View view = looks.view   ? *looks.view
                    : kind.cones ? chosen_view_of_cones(scene, bodies, poses)
                                 : chosen_view(scene, bodies, diagram.arrows, poses);
  std::vector<Vector> places = places_of(scene, bodies, poses, diagram.arrows, kind.symbols);
  Panel panel(scene, bodies, poses, fitted(view, places, size_of_panels(1)));
  panel.values = looks.values;
  Drawing drawing = draw_panel(panel, diagram, largest, kind);
  marked = panel.not_to_scale;
  return drawing;
}

// Whether the bodies, each together with what it holds, are small beside the way that they go.
bool is_small(const Panel& panel) {
  constexpr double readable = 110;  // units of the paper: of a body with some names at its points
  Box box;
  for (const Solid& solid : panel.solids)
    for (const Vector& vertex : solid.vertices) box.include(panel.projection(vertex));
  return !box.empty() && std::max(box.width(), box.height()) < readable;
}

// Several poses, the earlier ones paler.
Drawing motion(const Scene& scene, const Looks& looks) {
  const scene::Motion& motion = *scene.motion;
  std::vector<std::size_t> shown;
  const std::size_t count = std::min(most_poses, motion.poses.size());
  for (std::size_t i = 0; i < count; ++i) shown.push_back(count == 1 ? 0 : i * (motion.poses.size() - 1) / (count - 1));
  const std::vector<int> bodies = all_bodies(scene);
  std::vector<Vector> places;
  for (const std::size_t i : shown)
    std::ranges::move(places_of(scene, bodies, motion.poses[i], {}, i == shown.back()), std::back_inserter(places));
  const View view = looks.view ? *looks.view : chosen_view_of_motion(scene, bodies, motion.poses[shown.back()]);
  const Projection projection = fitted(view, places, size_of_panels(1));
  std::vector<Mark> before;
  for (std::size_t k = 0; k + 1 < shown.size(); ++k) {
    Panel panel(scene, bodies, motion.poses[shown[k]], projection);
    draw_bodies(panel, 0.25 + 0.35 * static_cast<double>(k) / static_cast<double>(shown.size()));
    // What is past stands behind labels.
    for (Mark& mark : panel.marks) {
      std::visit(
          [](auto& own) {
            if constexpr (requires { own.role; })
              if (own.role == Role::outline || own.role == Role::rod) own.role = Role::hidden;
          },
          mark);
      before.push_back(std::move(mark));
    }
  }
  Panel panel(scene, bodies, motion.poses[shown.back()], projection);
  panel.marks = std::move(before);
  draw_symbols(panel, Layer::behind_bodies);
  draw_bodies(panel);
  draw_links(panel);
  draw_symbols(panel, Layer::before_bodies);
  draw_paths(panel);
  panel.small = is_small(panel);
  draw_axes(panel, true);
  if (!panel.small) {
    draw_points(panel, {});
    draw_body_names(panel);
  }
  Drawing drawing = finished(panel);
  caption(drawing,
          fmt::format("From t = {} to {}, {} poses", value_text(motion.times[shown.front()], ""),
                      value_text(motion.times[shown.back()], "s"), shown.size()),
          200);
  return drawing;
}

// What a screen reader says of the arrows.
std::string description(const Scene& scene, const std::vector<const Diagram*>& diagrams) {
  std::string text;
  if (!scene.bodies.empty()) {
    text = "Bodies: ";
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) text += (i > 0 ? ", " : "") + scene.bodies[i].name;
    text += ". ";
  }
  for (const Diagram* diagram : diagrams) {
    if (diagram->arrows.empty()) continue;
    text += diagram->title.empty() ? "Arrows" : diagram->title;
    text += ": ";
    for (std::size_t i = 0; i < diagram->arrows.size(); ++i) {
      const scene::Arrow& arrow = diagram->arrows[i];
      text += (i > 0 ? ", " : "") + (arrow.text.empty() ? arrow.name : arrow.text);
      if (!arrow.formula.empty())
        text += " = " + arrow.formula;
      else if (scene.drawn_letters.empty())
        text += " = " + value_text(arrow.value, arrow.unit);
    }
    text += ". ";
  }
  for (const scene::Dimension& dimension : scene.dimensions)
    text += (dimension.text.empty() ? dimension.name : dimension.text) + ". ";
  return text;
}

const Diagram* find(const Scene& scene, DiagramKind kind) {
  const auto found = std::ranges::find(scene.diagrams, kind, &Diagram::kind);
  return found == scene.diagrams.end() ? nullptr : &*found;
}

// Whether something is drawn that a motion can move: the turning of a body of which only the center is drawn is not
// seen.
bool is_seen_to_move(const Scene& scene) {
  const auto& poses = scene.motion->poses;
  if (poses.empty()) return false;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const scene::Body& body = scene.bodies[i];
    const int number = static_cast<int>(i);
    if (!body.shapes.empty() || !arms_of(scene, number).empty()) return true;
    const scene::Place center{number, body.center};
    constexpr double noticeable = 1e-3;
    if (!body.frame && std::ranges::any_of(poses, [&](const std::vector<scene::Pose>& pose) {
          return norm(on_ground(center, pose) - on_ground(center, poses.front())) > noticeable * scene.length;
        }))
      return true;
  }
  return false;
}

// Whether a letter of this unit shows in the proportions of a figure.
bool is_size_or_angle(const std::string& unit) {
  static constexpr std::array<std::string_view, 15> units{"m",  "km", "dm",  "cm",   "mm",  "um",  "ft",  "in",
                                                          "yd", "mi", "rad", "mrad", "deg", "rev", "turn"};
  return std::ranges::find(units, unit) != units.end();
}

}  // namespace

std::vector<FigureName> figures_of(const Scene& scene) {
  std::vector<FigureName> names{{FigureKind::model, "model", "The figure of the statement"}};
  const auto has = [&](DiagramKind kind) { return find(scene, kind) != nullptr; };
  if (has(DiagramKind::free_body) || has(DiagramKind::kinetic))
    names.push_back({FigureKind::free_body, "free-body", "What acts on the bodies, equal to what it does to them"});
  if (has(DiagramKind::impulses) || has(DiagramKind::momenta_before) || has(DiagramKind::momenta_after))
    names.push_back({FigureKind::impulse, "impulse", "Momenta before, impulses, momenta after"});
  const bool polhode = std::ranges::any_of(
      scene.curves, [](const scene::Curve& curve) { return curve.kind == scene::CurveKind::polhode; });
  if (!scene.cones.empty() || polhode)
    names.push_back(
        {FigureKind::cones, "cones",
         scene.cones.empty() ? "Polhode and herpolhode of the angular velocity" : "Body cone and space cone"});
  if (scene.motion && scene.motion->times.size() == scene.motion->poses.size() && is_seen_to_move(scene))
    names.push_back({FigureKind::motion, "motion", "The motion"});
  if (has(DiagramKind::answers)) names.push_back({FigureKind::answers, "answers", "What is asked for"});
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    FigureName body{FigureKind::body, scene.bodies[i].name, "What acts on " + scene.bodies[i].name,
                    static_cast<int>(i)};
    const bool taken = std::ranges::any_of(names, [&](const FigureName& other) { return other.name == body.name; });
    if (!taken && !equations_of(scene, body).empty()) names.push_back(std::move(body));
  }
  return names;
}

Drawing figure(const Scene& scene, const FigureName& name, const std::string& title, const Looks& looks) {
  Drawing drawing;
  bool marked = false;
  std::vector<const Diagram*> shown;
  switch (name.kind) {
    case FigureKind::model:
    case FigureKind::answers: {
      const Diagram* diagram =
          find(scene, name.kind == FigureKind::answers ? DiagramKind::answers : DiagramKind::model);
      const Diagram& own = diagram != nullptr ? *diagram : no_arrows;
      shown.push_back(&own);
      drawing = single(scene, own, {}, looks, marked);
      break;
    }
    case FigureKind::cones:
      drawing = single(scene, no_arrows, {.symbols = false, .cones = true}, looks, marked);
      break;
    case FigureKind::motion:
      drawing = motion(scene, looks);
      break;
    case FigureKind::free_body:
    case FigureKind::impulse:
    case FigureKind::body:
      for (const auto& diagrams : equations_of(scene, name)) {
        Drawing row = equation(scene, diagrams, looks, marked);
        shown.insert(shown.end(), diagrams.begin(), diagrams.end());
        const double y = drawing.paper.empty() ? 0 : drawing.paper.bottom + row_gap - row.paper.top;
        append(drawing, moved(std::move(row), {0, y}));
      }
      break;
  }
  if (!scene.drawn_letters.empty()) {
    std::string letters;
    for (const scene::DrawnLetter& letter : scene.drawn_letters)
      if (is_size_or_angle(letter.unit))
        letters += (letters.empty() ? "Drawn with " : ", ") +
                   unbroken(with_greek_letters(letter.name) + " = " + value_text(letter.value, letter.unit));
    if (!letters.empty()) caption(drawing, letters, 240);
  }
  if (std::ranges::any_of(scene.bodies,
                          [](const scene::Body& body) { return !body.shapes.empty() && body.shapes.front().stand_in; }))
    caption(drawing, "Dotted: what stands for bodies whose shape is not stated, by their moments of inertia", 240);
  if (marked) caption(drawing, "Arrows with two strokes are not to scale", 240);
  drawing.paper = drawing.paper.grown(margin);
  drawing.title = title.empty() ? name.title : title;
  drawing.description = name.title + ". " + description(scene, shown);
  return drawing;
}

}  // namespace poinsot::pictures
