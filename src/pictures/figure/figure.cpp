#include "pictures/figure/figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "pictures/drawing/label_text.h"
#include "pictures/figure/arrows.h"
#include "pictures/figure/enlarged.h"
#include "pictures/figure/fitting.h"
#include "pictures/figure/layout.h"
#include "pictures/figure/motion_figure.h"
#include "pictures/figure/panel.h"
#include "pictures/figure/shortened.h"
#include "pictures/figure/view_choice.h"

namespace poinsot::pictures {
namespace {

using scene::Diagram;
using scene::DiagramKind;
using scene::Scene;

constexpr double margin = 14, row_gap = 26;
const Diagram no_arrows{};

struct PanelKind {
  bool symbols = true;  // joints, supports, links, dimensions
  bool axes = true;
  bool axes_at_origin = true;
  bool cones = false;
  bool body_names = true;
  const Shortened* broken = nullptr;  // if what is drawn is broken
};

Drawing draw_panel(Panel& panel, const Diagram& diagram, const Largest& largest, const PanelKind& kind,
                   const std::vector<scene::Arrow>& momenta = {}) {
  // The cones are what is shown; the body tells how it is turned.
  constexpr double beside_cones = 0.4;
  if (kind.symbols) {
    draw_posts(panel);
    draw_symbols(panel, Layer::behind_bodies);
  }
  draw_bodies(panel, kind.cones ? beside_cones : 1);
  if (kind.symbols) {
    draw_links(panel);
    if (kind.broken != nullptr) draw_breaks(panel, *kind.broken);
    draw_symbols(panel, Layer::before_bodies);
  }
  if (kind.cones) {
    draw_polhodes(panel);
    draw_cones(panel);
  }
  if (kind.axes && kind.axes_at_origin) draw_axes(panel, true);
  if (kind.symbols) draw_dimensions(panel);
  if (!kind.cones) draw_points(panel, diagram.arrows, !kind.symbols, momenta);
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

Drawing equation(const Scene& whole, const std::vector<const Diagram*>& diagrams, const Looks& looks, bool& marked) {
  const std::vector<scene::Pose> poses = shown_poses(whole);
  std::vector<scene::Arrow> arrows;
  std::vector<int> bodies;
  Largest largest;
  for (const Diagram* diagram : diagrams) {
    arrows.insert(arrows.end(), diagram->arrows.begin(), diagram->arrows.end());
    for (const int body : diagram->bodies)
      if (body >= 0 && std::ranges::find(bodies, body) == bodies.end()) bodies.push_back(body);
  }
  for (const scene::Arrow& arrow : arrows) largest.include(arrow);
  const std::optional<Scene> small = of_length(whole, extent_of(places_of(whole, bodies, poses, arrows, false)));
  const Scene& scene = small ? *small : whole;
  // Of a planar problem all bodies are seen across its plane, also those that would be free to turn out of it.
  const std::optional<View> across = looks.view ? looks.view : view_across_plane(scene, poses);
  const View view = across ? *across : chosen_view(scene, bodies, arrows, poses);
  const Projection projection =
      fitted(view, places_of(scene, bodies, poses, arrows, false), size_of_panels(diagrams.size()));
  std::vector<Drawing> parts;
  std::vector<std::string> signs, captions;
  for (const Diagram* diagram : diagrams) {
    Panel panel(scene, diagram->bodies, poses, projection);
    panel.values = looks.values;
    const PanelKind kind{.symbols = false, .axes = parts.empty(), .axes_at_origin = false};
    Drawing part = draw_panel(panel, *diagram, largest, kind, arrows);
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
  Panel panel(scene, bodies, poses, fitted(view, places, size_of_model(bodies.size())));
  panel.values = looks.values;
  Drawing drawing = draw_panel(panel, diagram, largest, kind);
  marked = panel.not_to_scale;
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
      else if (arrow.open)
        text += ", whose size is open";
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

// With which values of letters the figure has its proportions, to the digits that are seen.
std::string letters_drawn(const Scene& scene) {
  constexpr int seen = 3;
  std::string letters;
  for (const scene::DrawnLetter& letter : scene.drawn_letters) {
    if (!is_size_or_angle(letter.unit) || letter.only_grows) continue;
    const bool radians = letter.unit == "rad";
    const double value = radians ? letter.value * 180 / std::numbers::pi : letter.value;
    const std::string unit = radians ? "deg" : letter.unit;
    letters += (letters.empty() ? "Drawn with " : ", ") +
               unbroken(with_greek_letters(letter.name) + " = " + value_text(value, unit, seen));
  }
  return letters;
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
      const std::optional<Shortened> nearer = shortened(scene);
      const std::optional<Enlarged> readable = nearer ? std::nullopt : enlarged(scene);
      if (nearer) {
        const Diagram* moved_nearer = diagram ? find(nearer->scene, diagram->kind) : nullptr;
        drawing = single(nearer->scene, moved_nearer ? *moved_nearer : no_arrows, {.broken = &*nearer}, looks, marked);
        caption(drawing, fmt::format("Drawn nearer than to scale: {}", fmt::join(nearer->bodies, ", ")), 240);
      } else if (readable) {
        const Diagram* grown = diagram ? find(readable->scene, diagram->kind) : nullptr;
        drawing = single(readable->scene, grown ? *grown : no_arrows, {}, looks, marked);
        caption(drawing, fmt::format("Drawn larger than to scale: {}", fmt::join(readable->bodies, ", ")), 240);
      } else {
        drawing = single(scene, own, {}, looks, marked);
      }
      break;
    }
    case FigureKind::cones:
      drawing = single(scene, no_arrows, {.symbols = false, .cones = true}, looks, marked);
      break;
    case FigureKind::motion:
      drawing = motion_figure(scene, looks);
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
  if (const std::string letters = letters_drawn(scene); !letters.empty()) caption(drawing, letters, 240);
  if (std::ranges::any_of(scene.bodies,
                          [](const scene::Body& body) { return !body.shapes.empty() && body.shapes.front().stand_in; }))
    caption(drawing, "Dotted: what stands for bodies whose shape is not stated, by their moments of inertia", 240);
  if (std::ranges::any_of(
          shown, [](const Diagram* diagram) { return std::ranges::any_of(diagram->arrows, &scene::Arrow::open); }))
    caption(drawing, "Arrows with one stroke show a sense and no size", 240);
  if (marked) caption(drawing, "Arrows with two strokes are not to scale", 240);
  drawing.paper = drawing.paper.grown(margin);
  drawing.title = title.empty() ? name.title : title;
  drawing.description = name.title + ". " + description(scene, shown);
  return drawing;
}

}  // namespace poinsot::pictures
