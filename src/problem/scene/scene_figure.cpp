#include "problem/scene/scene_figure.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/work/work.h"
#include "problem/entries/viewing_direction.h"
#include "problem/machine/shapes.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t most_vertices = 400'000;  // of a scene; what comes after is left out

scene::Extent scene_extent(const Outline& outline) {
  if (!outline.triangles.empty()) return scene::Extent::surface;
  return outline.edges.empty() ? scene::Extent::point : scene::Extent::line;
}

}  // namespace

Dimension dimension_of(scene::Quantity quantity) {
  using scene::Quantity;
  switch (quantity) {
    case Quantity::force:
    case Quantity::weight:
    case Quantity::rate_of_momentum:
      return dimensions::force;
    case Quantity::couple:
    case Quantity::rate_of_angular_momentum:
      return dimensions::moment;
    case Quantity::impulse:
    case Quantity::linear_momentum:
      return dimensions::momentum;
    case Quantity::angular_impulse:
    case Quantity::angular_momentum:
      return dimensions::angular_momentum;
    case Quantity::velocity:
      return dimensions::velocity;
    case Quantity::angular_velocity:
      return dimensions::angular_velocity;
    case Quantity::acceleration:
      return dimensions::acceleration;
    case Quantity::angular_acceleration:
      return dimensions::angular_acceleration;
    case Quantity::displacement:
      return dimensions::length;
    case Quantity::angular_displacement:
      return dimensions::angle;
    case Quantity::unbalance:
      return dimensions::mass * dimensions::length;
  }
  return dimensions::angular_acceleration;
}

SceneFigure::SceneFigure(const Situation& situation, const Settings& settings, const Machine& machine,
                         const solve::MechanismState& state, const ExplanationTex& tex, scene::Scene& scene)
    : situation_(situation),
      settings_(settings),
      machine_(machine),
      state_(state),
      tex_(tex),
      scene_(scene),
      data_(situation, settings) {
  for (const Body& body : situation.bodies) tree_bodies_.push_back(machine.index.at(body.name));
  for (const Frame& frame : situation.frames) tree_bodies_.push_back(machine.index.at(frame.name));
  for (std::size_t k = 0; k < tree_bodies_.size(); ++k) scene_bodies_[tree_bodies_[k]] = static_cast<int>(k);
}

int SceneFigure::scene_body(int tree_body) const {
  const auto found = scene_bodies_.find(tree_body);
  return found == scene_bodies_.end() ? scene::ground : found->second;
}

scene::Pose SceneFigure::pose_of(int tree_body, const solve::MechanismState& state) const {
  // The workspace has the rotation of the body's working axes, which differ from those of its shapes.
  const SpatialTransform<double> pose = body_pose(mechanism().tree, state.workspace(), tree_body);
  return {pose.R, pose.p - pose.R * machine_.drawn_origin.at(tree_body)};
}

scene::Place SceneFigure::scene_place(const Place<double>& place) const {
  const int body = scene_body(place.body);
  if (body == scene::ground) return {scene::ground, state_.position(place)};
  return {body, place.point + machine_.drawn_origin.at(place.body)};
}

scene::Place SceneFigure::riding(int tree_body, const Vector3<double>& on_ground) const {
  const int body = scene_body(tree_body);
  if (body == scene::ground) return {scene::ground, on_ground};
  const scene::Pose pose = pose_of(tree_body, state_);
  return {body, transpose_times(pose.R, on_ground - pose.p)};
}

Vector3<double> SceneFigure::on_ground(const scene::Place& place) const {
  if (place.body == scene::ground) return place.at;
  const scene::Pose& pose = scene_.bodies[static_cast<std::size_t>(place.body)].pose;
  return pose.R * place.at + pose.p;
}

void SceneFigure::add_bodies() {
  for (std::size_t k = 0; k < situation_.bodies.size(); ++k) {
    const Body& body = situation_.bodies[k];
    scene::Body drawn;
    drawn.name = body.name;
    drawn.massless = body.massless;
    drawn.mass = machine_.masses[k].second.properties.mass;
    drawn.center = machine_.masses[k].second.properties.center;
    add_shapes(body, drawn);
    drawn.pose = pose_of(tree_bodies_[k], state_);
    scene_.bodies.push_back(std::move(drawn));
  }
  for (const Frame& frame : situation_.frames) {
    scene::Body drawn;
    drawn.name = frame.name;
    drawn.frame = true;
    drawn.massless = true;
    const int tree_body = machine_.index.at(frame.name);
    drawn.center = machine_.drawn_origin.at(tree_body);
    drawn.pose = pose_of(tree_body, state_);
    scene_.bodies.push_back(std::move(drawn));
  }
}

void SceneFigure::add_shapes(const Body& body, scene::Body& drawn) {
  for (const Part& part : body.parts) add_shape(part, false, drawn);
  if (body.parts.size() == 1 && !drawn.shapes.empty()) drawn.shapes.front().part.clear();
  for (const Part& part : body.added) add_shape(part, true, drawn);
  for (const Part& part : body.absorbed) add_shape(part, true, drawn);
}

void SceneFigure::add_shape(const Part& part, bool added, scene::Body& drawn) {
  const bool without =
      std::find(situation_.without.begin(), situation_.without.end(), part.name) != situation_.without.end();
  if (added && without) return;
  const ShapeValues<double> values = shape_values(part.shape, data_, part.name, false);
  Outline outline = shape_picture(part.shape, data_, part.name);
  count_work(work_of_triangle * (outline.triangles.size() + outline.vertices.size()));
  vertices_ += outline.vertices.size();
  if (vertices_ > most_vertices) {
    scene_.notes.push_back("the shape of '" + part.name + "' in '" + drawn.name +
                           "' is left out: the scene would have more than " + std::to_string(most_vertices) +
                           " vertices");
    vertices_ -= outline.vertices.size();
    return;
  }
  scene::Shape shape;
  shape.kind = part.shape.kind;
  shape.part = part.name;
  shape.extent = values.extent == Extent::volume ? scene::Extent::volume : scene_extent(outline);
  shape.hole = part.hole;
  shape.added = added;
  shape.vertices = std::move(outline.vertices);
  shape.triangles = std::move(outline.triangles);
  shape.normals = std::move(outline.normals);
  shape.edges = std::move(outline.edges);
  drawn.shapes.push_back(std::move(shape));
}

void SceneFigure::set_length() {
  std::vector<Vector3<double>> places;
  for (const scene::Body& body : scene_.bodies) {
    places.push_back(body.pose.R * body.center + body.pose.p);
    for (const scene::Shape& shape : body.shapes)
      for (const Vector3<double>& vertex : shape.vertices) places.push_back(body.pose.R * vertex + body.pose.p);
  }
  for (const scene::Point& point : scene_.points) places.push_back(on_ground(point.place));
  for (const scene::Symbol& symbol : scene_.symbols) places.push_back(on_ground(symbol.place));
  if (places.empty()) return;
  Vector3<double> low = places.front(), high = low;
  for (const Vector3<double>& place : places)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], place[k]);
      high[k] = std::max(high[k], place[k]);
    }
  if (const double size = norm(Vector3<double>(high - low)); size > 0 && std::isfinite(size)) scene_.length = size;
}

void SceneFigure::cut_long_links() {
  const auto carries_matter = [&](int body) {
    return body >= 0 && !scene_.bodies[static_cast<std::size_t>(body)].frame;
  };
  // The size of the bodies and of where they are held.
  double size = 0;
  std::vector<Vector3<double>> held;
  for (const scene::Body& body : scene_.bodies) {
    if (!body.frame) held.push_back(body.pose.R * body.center + body.pose.p);
    for (const scene::Shape& shape : body.shapes)
      for (const Vector3<double>& vertex : shape.vertices) held.push_back(body.pose.R * vertex + body.pose.p);
  }
  for (const scene::Symbol& symbol : scene_.symbols) held.push_back(on_ground(symbol.place));
  for (const Vector3<double>& place : held) size = std::max(size, norm(Vector3<double>(place - held.front())));
  constexpr double longest = 10, piece = 0.8;  // of that size
  for (scene::Link& link : scene_.links) {
    if (link.far || link.kind == scene::LinkKind::torsion || !(size > 0)) continue;
    if (carries_matter(link.from.body) == carries_matter(link.to.body)) continue;
    if (carries_matter(link.to.body)) std::swap(link.from, link.to);
    const Vector3<double> from = on_ground(link.from), end = on_ground(link.to), way = end - from;
    if (norm(way) < longest * size) continue;
    link.far = true;
    link.to = {scene::ground, from + piece * size * normalized(way)};
    // What is named at the far end is named where the link is cut off.
    constexpr double same = 1e-9;
    for (scene::Point& point : scene_.points)
      if (norm(Vector3<double>(on_ground(point.place) - end)) < same * norm(way)) point.place = link.to;
    set_length();
  }
}

void SceneFigure::add_world() {
  scene_.axes = situation_.axes;
  const Vector3<double> gravity = mechanism().tree.gravity();
  scene_.gravity = norm(gravity) > 0;
  // Texts draw y upward, and the axis that they call so.
  const auto named = std::find_if(situation_.axes.begin(), situation_.axes.end(),
                                  [](const std::string& axis) { return axis == "U" || axis == "up"; });
  const std::size_t upward =
      named == situation_.axes.end() ? 1 : static_cast<std::size_t>(named - situation_.axes.begin());
  scene_.up = scene_.gravity ? -normalized(gravity) : Vector3<double>::unit(upward);
  if (!situation_.view.empty()) scene_.viewer = viewing_direction(situation_.view, scene_.up);
  set_length();
  // Of what goes on beyond the figure a piece is shown.
  constexpr double piece = 0.4;
  for (scene::Link& link : scene_.links) {
    if (!link.far) continue;
    const Vector3<double> from = on_ground(link.from);
    link.to.at = from + piece * scene_.length * normalized(Vector3<double>(link.to.at - from));
  }
  cut_long_links();
}

scene::Arrow SceneFigure::arrow(scene::Quantity quantity, const std::string& name, int body, const scene::Place& at,
                                const Vector3<double>& vector, const ArrowSymbol& symbol) const {
  scene::Arrow arrow;
  arrow.quantity = quantity;
  arrow.name = name;
  arrow.body = body;
  arrow.at = at;
  constexpr double rounding = 1e-12;  // of the vector
  for (std::size_t k = 0; k < 3; ++k) arrow.vector[k] = std::abs(vector[k]) > rounding * norm(vector) ? vector[k] : 0;
  arrow.symbol = symbol.tex;
  arrow.text = symbol.text;
  const Unit& unit = tex_.unit(dimension_of(quantity));
  arrow.value = norm(vector) / unit.factor;
  arrow.unit = unit.text;
  return arrow;
}

ArrowSymbol SceneFigure::vector_symbol(const std::string& name) { return {ExplanationTex::vector_symbol(name), name}; }

ArrowSymbol SceneFigure::named_symbol(const std::string& letter, const std::string& name) {
  return name.size() <= 2 ? vector_symbol(name) : indexed_symbol(letter, name);
}

ArrowSymbol SceneFigure::indexed_symbol(const std::string& letter, const std::string& index) {
  if (index.empty()) return {letter, ExplanationTex::plain(letter)};
  const std::string tex = letter + "_{" + (index.size() > 1 ? ExplanationTex::upright(index) : index) + "}";
  return {tex, ExplanationTex::plain(tex)};
}

ArrowSymbol SceneFigure::impulse_symbol(const std::string& letter, const std::string& name) {
  ArrowSymbol symbol = named_symbol(letter, name);
  if (symbol.text == name) return symbol;
  const std::string tex = symbol.tex + "\\Delta t";
  return {tex, ExplanationTex::plain(tex)};
}

bool SceneFigure::vanishes(const Vector3<double>& vector, const Dimension& dimension) const {
  const double size = norm(vector);
  if (!(size > 0) || !std::isfinite(size)) return true;
  return natural_size_ && is_rounding(size, natural_size_(dimension));
}

}  // namespace poinsot::problem
