// Scenes built by hand, for tests of their drawings.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "poinsot/scene.h"

namespace poinsot::pictures_test {

using Vector = Vector3<double>;

inline scene::Shape box_shape(const Vector& low, const Vector& high) {
  scene::Shape shape{.kind = "box", .part = ""};
  for (int i = 0; i < 8; ++i)
    shape.vertices.push_back(
        {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    shape.triangles.push_back({a, b, c});
    shape.triangles.push_back({a, c, d});
    shape.edges.push_back({a, b, c, d, a});
  };
  face(0, 2, 3, 1);
  face(4, 5, 7, 6);
  face(0, 1, 5, 4);
  face(2, 6, 7, 3);
  face(0, 4, 6, 2);
  face(1, 3, 7, 5);
  return shape;
}

inline scene::Shape cylinder_shape(double radius, double low, double high, std::uint32_t count = 48) {
  scene::Shape shape{.kind = "cylinder", .part = ""};
  for (const double z : {low, high})
    for (std::uint32_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      shape.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  shape.vertices.push_back({0, 0, low});
  shape.vertices.push_back({0, 0, high});
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t k = (i + 1) % count;
    shape.triangles.push_back({i, k, count + k});
    shape.triangles.push_back({i, count + k, count + i});
    shape.triangles.push_back({2 * count, k, i});
    shape.triangles.push_back({2 * count + 1, count + i, count + k});
    bottom.push_back(i);
    top.push_back(count + i);
  }
  bottom.push_back(0);
  top.push_back(count);
  shape.edges = {bottom, top};
  return shape;
}

inline scene::Shape plate_shape(double a, double b, double z = 0, bool hole = false) {
  scene::Shape shape{.kind = "plate", .part = "", .extent = scene::Extent::surface, .hole = hole};
  shape.vertices = {{-a / 2, -b / 2, z}, {a / 2, -b / 2, z}, {a / 2, b / 2, z}, {-a / 2, b / 2, z}};
  shape.triangles = {{0, 1, 2}, {0, 2, 3}};
  shape.edges = {{0, 1, 2, 3, 0}};
  return shape;
}

inline scene::Shape wire_shape(const std::vector<Vector>& points) {
  scene::Shape shape{.kind = "wire", .part = "", .extent = scene::Extent::line};
  shape.vertices = points;
  shape.edges.emplace_back();
  for (std::uint32_t i = 0; i < points.size(); ++i) shape.edges[0].push_back(i);
  return shape;
}

inline scene::Arrow arrow(scene::Quantity quantity, int body, const Vector& at, const Vector& vector,
                          const std::string& symbol) {
  return {.quantity = quantity,
          .name = symbol,
          .body = body,
          .at = {body, at},
          .vector = vector,
          .symbol = "\\mathbf{" + symbol + "}",
          .text = symbol,
          .value = norm(vector),
          .unit = "N"};
}

// A disk askew on a shaft in two bearings.
inline scene::Scene shaft_scene() {
  scene::Scene scene;
  scene.length = 1;
  scene.up = {0, 1, 0};
  const double c = std::cos(0.35), s = std::sin(0.35);
  scene::Body disk{.name = "disk", .mass = 8, .shapes = {cylinder_shape(0.3, -0.02, 0.02)}};
  disk.pose.R = Matrix3<double>::from_columns({-s, c, 0}, {0, 0, 1}, {c, s, 0});
  scene::Body shaft{.name = "shaft", .shapes = {cylinder_shape(0.04, -0.5, 0.5, 24)}};
  shaft.pose.R = Matrix3<double>::from_columns({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
  scene.bodies = {disk, shaft};
  scene.points = {
      {"A", {scene::ground, {-0.5, 0, 0}}}, {"B", {scene::ground, {0.5, 0, 0}}}, {"G", {scene::ground, {}}}};
  for (const double z : {-0.5, 0.5})
    scene.symbols.push_back(
        {.kind = scene::SymbolKind::journal, .name = "bearing", .to = 1, .place = {1, {0, 0, z}}, .axis = {0, 0, 1}});
  scene::Diagram model{.kind = scene::DiagramKind::model, .title = "Figure", .bodies = {0, 1}};
  model.arrows.push_back(arrow(scene::Quantity::angular_velocity, 1, {0, 0, 0.3}, {12, 0, 0}, "omega"));
  model.arrows.back().symbol = "\\boldsymbol{\\omega}";
  scene.diagrams.push_back(model);
  scene::Diagram cut{
      .kind = scene::DiagramKind::free_body, .title = "What acts on disk and shaft", .group = 1, .bodies = {0, 1}};
  cut.arrows = {arrow(scene::Quantity::force, 1, {0, 0, -0.5}, {0, -450, 20}, "A"),
                arrow(scene::Quantity::force, 1, {0, 0, 0.5}, {0, 450, -20}, "B"),
                arrow(scene::Quantity::weight, 0, {}, {0, -78, 0}, "W")};
  scene.diagrams.push_back(cut);
  scene::Diagram kinetic{
      .kind = scene::DiagramKind::kinetic, .title = "What it does to them", .group = 1, .bodies = {0, 1}};
  kinetic.arrows = {arrow(scene::Quantity::rate_of_angular_momentum, 0, {}, {0, 0, 220}, "H")};
  kinetic.arrows[0].symbol = "\\dot{\\mathbf{H}}_G";
  scene.diagrams.push_back(kinetic);
  scene.dimensions = {
      {.name = "L", .text = "L = 1 m", .from = {scene::ground, {-0.5, 0, 0}}, .to = {scene::ground, {0.5, 0, 0}}}};
  return scene;
}

// A plate with a hole on two cords, a bent wire before it and a box behind.
inline scene::Scene plate_scene() {
  scene::Scene scene;
  scene.up = {0, 1, 0};
  scene.gravity = true;
  scene::Body plate{.name = "plate", .mass = 3, .shapes = {plate_shape(1, 0.8), plate_shape(0.3, 0.2, 0, true)}};
  scene::Body wire{.name = "wire", .mass = 1, .shapes = {wire_shape({{-0.4, 0, -0.2}, {0, 0, 0.3}, {0, 0.5, 0.3}})}};
  scene::Body box{.name = "box", .mass = 1, .shapes = {box_shape({-0.2, -0.2, -0.6}, {0.5, 0.3, -0.3})}};
  scene.bodies = {plate, wire, box};
  scene.points = {{"A", {0, {-0.5, 0.4, 0}}}, {"B", {0, {0.5, 0.4, 0}}}, {"C", {0, {0.5, -0.4, 0}}}};
  for (const double x : {-0.5, 0.5})
    scene.links.push_back({.name = "cord", .from = {0, {x, 0.4, 0}}, .to = {scene::ground, {x, 0.8, 0}}});
  scene.links.push_back(
      {.kind = scene::LinkKind::spring, .name = "spring", .from = {0, {0.5, -0.4, 0}}, .to = {2, {0.5, -0.2, -0.3}}});
  scene.symbols.push_back({.kind = scene::SymbolKind::ball, .name = "ball", .to = 1, .place = {1, {-0.4, 0, -0.2}}});
  scene::Diagram model{.kind = scene::DiagramKind::model, .title = "", .bodies = {0, 1, 2}};
  model.arrows = {arrow(scene::Quantity::impulse, 0, {0.5, -0.4, 0}, {0, 0, -5}, "P"),
                  arrow(scene::Quantity::velocity, 1, {0, 0.5, 0.3}, {3, 1, 0}, "v_1")};
  scene.diagrams.push_back(model);
  return scene;
}

}  // namespace poinsot::pictures_test
