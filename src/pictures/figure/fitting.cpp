#include "pictures/figure/fitting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace poinsot::pictures {

Size size_of_panels(std::size_t count) {
  return count <= 1 ? Size{400, 300} : count == 2 ? Size{300, 260} : Size{260, 250};
}

Size size_of_model(std::size_t bodies) {
  constexpr double usual = 12, most = 3;
  const double factor = std::clamp(std::sqrt(static_cast<double>(bodies) / usual), 1.0, most);
  const Size one = size_of_panels(1);
  return {factor * one.width, factor * one.height};
}

std::vector<int> all_bodies(const scene::Scene& scene) {
  std::vector<int> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) bodies.push_back(static_cast<int>(i));
  return bodies;
}

std::vector<Vector> places_of(const scene::Scene& scene, const std::vector<int>& bodies,
                              const std::vector<scene::Pose>& poses, const std::vector<scene::Arrow>& arrows,
                              bool with_symbols) {
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
    for (const scene::Curve& curve : scene.curves) {
      if (!drawn(curve.body)) continue;
      if (curve.kind == scene::CurveKind::surface || curve.kind == scene::CurveKind::attractor)
        places.push_back(curve.points.front());
      if (curve.kind != scene::CurveKind::pitch_circle && curve.kind != scene::CurveKind::post) continue;
      for (const Vector& point : curve.points) places.push_back(on_ground({curve.body, point}, poses));
    }
    for (const scene::Point& point : scene.points)
      if (drawn(point.place.body)) places.push_back(on_ground(point.place, poses));
  }
  std::erase_if(places, [](const Vector& p) { return !std::isfinite(norm(p)); });
  if (places.empty()) places.emplace_back();
  return places;
}

double extent_of(const std::vector<Vector>& places) {
  Vector least = places.front(), most = places.front();
  for (const Vector& place : places)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], place[k]);
      most[k] = std::max(most[k], place[k]);
    }
  return norm(Vector(most - least));
}

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

}  // namespace poinsot::pictures
