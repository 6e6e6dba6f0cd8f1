#include "document/scene_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "problem/scene/scene_words.h"

namespace poinsot::document {
namespace {

using problem::word;
using Json = nlohmann::ordered_json;

constexpr int digits_of_places = 9, digits_of_normals = 4;

double rounded(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return value;
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  double shown = value;
  std::from_chars(text.data(), text.data() + text.size(), shown);
  return shown;
}

Json vector_json(const Vector3<double>& v) {
  return Json::array({rounded(v.x, digits_of_places), rounded(v.y, digits_of_places), rounded(v.z, digits_of_places)});
}
// A part of one, so that what is far below the last digit is zero.
Json normal_json(const Vector3<double>& v) {
  const double scale = std::pow(10, digits_of_normals);
  Json parts = Json::array();
  for (std::size_t k = 0; k < 3; ++k) {
    const double part = std::round(v[k] * scale) / scale;
    if (part == std::round(part))
      parts.push_back(static_cast<int>(part));
    else
      parts.push_back(part);
  }
  return parts;
}
Json exact_vector_json(const Vector3<double>& v) { return Json::array({v.x, v.y, v.z}); }

Json place_json(const scene::Place& place) { return {{"body", place.body}, {"at", vector_json(place.at)}}; }

Json pose_json(const scene::Pose& pose) {
  Json R = Json::array();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) R.push_back(rounded(pose.R(i, j), digits_of_places));
  return {{"R", R}, {"p", vector_json(pose.p)}};
}

template <class List, class Make>
Json list_json(const List& list, const Make& make) {
  Json items = Json::array();
  for (const auto& item : list) items.push_back(make(item));
  return items;
}

Json shape_json(const scene::Shape& shape) {
  return {{"kind", shape.kind},
          {"part", shape.part},
          {"extent", word(shape.extent)},
          {"hole", shape.hole},
          {"added", shape.added},
          {"stand_in", shape.stand_in},
          {"vertices", list_json(shape.vertices, vector_json)},
          {"triangles", shape.triangles},
          {"normals", list_json(shape.normals, [](const auto& corners) { return list_json(corners, normal_json); })},
          {"edges", shape.edges}};
}

Json body_json(const scene::Body& body) {
  return {{"name", body.name},
          {"frame", body.frame},
          {"massless", body.massless},
          {"mass", body.mass},
          {"center", vector_json(body.center)},
          {"shapes", list_json(body.shapes, shape_json)},
          {"pose", pose_json(body.pose)}};
}

Json symbol_json(const scene::Symbol& symbol) {
  return {{"kind", word(symbol.kind)},
          {"name", symbol.name},
          {"from", symbol.from},
          {"to", symbol.to},
          {"place", place_json(symbol.place)},
          {"axis", vector_json(symbol.axis)},
          {"second_axis", vector_json(symbol.second_axis)}};
}

Json link_json(const scene::Link& link) {
  Json json{{"kind", word(link.kind)},   {"name", link.name}, {"from", place_json(link.from)},
            {"to", place_json(link.to)}, {"far", link.far},   {"slack", link.slack}};
  if (!link.symbol.empty()) json["symbol"] = link.symbol;
  return json;
}

Json arrow_json(const scene::Arrow& arrow) {
  Json json{{"quantity", word(arrow.quantity)},
            {"name", arrow.name},
            {"body", arrow.body},
            {"at", place_json(arrow.at)},
            {"vector", exact_vector_json(arrow.vector)},
            {"symbol", arrow.symbol},
            {"text", arrow.text}};
  if (!arrow.open) {
    json["value"] = arrow.value;
    json["unit"] = arrow.unit;
  }
  if (!arrow.formula.empty()) json["formula"] = arrow.formula;
  json["known"] = arrow.known;
  if (arrow.swings) json["swings"] = true;
  if (arrow.open) json["open"] = true;
  return json;
}

Json diagram_json(const scene::Diagram& diagram) {
  return {{"kind", word(diagram.kind)},
          {"title", diagram.title},
          {"group", diagram.group},
          {"bodies", diagram.bodies},
          {"arrows", list_json(diagram.arrows, arrow_json)}};
}

Json dimension_json(const scene::Dimension& dimension) {
  Json json{{"name", dimension.name},
            {"text", dimension.text},
            {"angle", dimension.angle},
            {"from", place_json(dimension.from)},
            {"to", place_json(dimension.to)}};
  if (dimension.angle) json["corner"] = place_json(dimension.corner);
  if (norm(dimension.axis) > 0) json["axis"] = vector_json(dimension.axis);
  return json;
}

Json curve_json(const scene::Curve& curve) {
  return {{"kind", word(curve.kind)},
          {"name", curve.name},
          {"body", curve.body},
          {"closed", curve.closed},
          {"points", list_json(curve.points, vector_json)}};
}

Json cone_json(const scene::Cone& cone) {
  return {{"name", cone.name},
          {"body", cone.body},
          {"apex", vector_json(cone.apex)},
          {"axis", vector_json(cone.axis)},
          {"half_angle", cone.half_angle},
          {"touching_line", vector_json(cone.touching_line)}};
}

Json plot_json(const scene::Plot& plot) {
  Json values = Json::array();
  for (const std::vector<double>& line : plot.values)
    values.push_back(list_json(line, [](double value) -> Json {
      if (!std::isfinite(value)) return nullptr;
      return rounded(value, digits_of_places);
    }));
  return {{"name", plot.name}, {"words", plot.words}, {"unit", plot.unit}, {"labels", plot.labels}, {"values", values}};
}

Json places_json(const std::vector<Vector3<double>>& places) {
  Json flat = Json::array();
  for (const Vector3<double>& place : places)
    for (std::size_t i = 0; i < 3; ++i) flat.push_back(rounded(place[i], digits_of_places));
  return flat;
}

Json moving_arrow_json(const scene::MovingArrow& arrow) {
  return {{"quantity", word(arrow.quantity)},
          {"name", arrow.name},
          {"at", place_json(arrow.at)},
          {"symbol", arrow.symbol},
          {"text", arrow.text},
          {"unit", arrow.unit},
          {"factor", arrow.factor},
          {"vectors", places_json(arrow.vectors)}};
}

// The poses of each body on its own: places one after the other, and turns as quaternions of which each is the nearer
// one to that before it, so that a renderer can go between them.
Json motion_json(const scene::Motion& motion) {
  Json bodies = Json::array();
  const std::size_t count = motion.poses.empty() ? 0 : motion.poses.front().size();
  for (std::size_t body = 0; body < count; ++body) {
    Json position = Json::array(), orientation = Json::array();
    Quaternion<double> last{};
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      const scene::Pose& pose = motion.poses[k][body];
      for (std::size_t i = 0; i < 3; ++i) position.push_back(rounded(pose.p[i], digits_of_places));
      Quaternion<double> q = quaternion_of(pose.R);
      if (k > 0 && q.w * last.w + q.x * last.x + q.y * last.y + q.z * last.z < 0) q = {-q.w, -q.x, -q.y, -q.z};
      last = q;
      for (const double part : {q.w, q.x, q.y, q.z}) orientation.push_back(rounded(part, digits_of_places));
    }
    bodies.push_back({{"position", position}, {"orientation", orientation}});
  }
  Json json{{"times", list_json(motion.times, [](double t) { return rounded(t, digits_of_places); })},
            {"bodies", bodies},
            {"plots", list_json(motion.plots, plot_json)},
            {"arrows", list_json(motion.arrows, moving_arrow_json)},
            {"events", list_json(motion.events,
                                 [](const scene::Event& event) -> Json {
                                   return {{"time", event.time}, {"words", event.words}};
                                 })},
            {"complete", motion.complete}};
  if (!motion.links.empty())
    json["links"] = list_json(motion.links, [](const scene::MovingLink& link) -> Json {
      return {{"link", link.link}, {"from", places_json(link.from)}, {"to", places_json(link.to)}};
    });
  if (!motion.stopped.empty()) json["stopped"] = motion.stopped;
  return json;
}

}  // namespace

Json scene_json(const scene::Scene& scene) {
  Json json{{"situation", scene.situation},
            {"axes", scene.axes},
            {"up", vector_json(scene.up)},
            {"gravity", scene.gravity},
            {"length", scene.length},
            {"bodies", list_json(scene.bodies, body_json)},
            {"points", list_json(scene.points,
                                 [](const scene::Point& point) -> Json {
                                   return {{"name", point.name}, {"place", place_json(point.place)}};
                                 })},
            {"symbols", list_json(scene.symbols, symbol_json)},
            {"links", list_json(scene.links, link_json)},
            {"diagrams", list_json(scene.diagrams, diagram_json)},
            {"dimensions", list_json(scene.dimensions, dimension_json)},
            {"curves", list_json(scene.curves, curve_json)},
            {"cones", list_json(scene.cones, cone_json)}};
  if (!scene.wraps.empty())
    json["wraps"] = list_json(scene.wraps, [](const scene::Wrap& wrap) -> Json {
      return {{"name", wrap.name},
              {"comes", wrap.comes},
              {"leaves", wrap.leaves},
              {"center", place_json(wrap.center)},
              {"axis", vector_json(wrap.axis)}};
    });
  if (scene.viewer) json["viewer"] = vector_json(*scene.viewer);
  if (scene.motion) json["motion"] = motion_json(*scene.motion);
  json["drawn_letters"] = list_json(scene.drawn_letters, [](const scene::DrawnLetter& letter) -> Json {
    Json one{{"name", letter.name}, {"unit", letter.unit}, {"value", letter.value}};
    if (letter.only_grows) one["only_grows"] = true;
    return one;
  });
  json["notes"] = scene.notes;
  return json;
}

}  // namespace poinsot::document
