#include "pictures/figure/enlarged.h"

#include <algorithm>

#include "pictures/figure/fitting.h"
#include "pictures/solids/solid.h"

namespace poinsot::pictures {
namespace {

// As parts of the picture: how far from its center what is lost reaches, how far it is drawn, and how far from there
// everything else has to be.
constexpr double lost = 0.01, drawn = 0.08, clear = 0.25;

double reach_of(const scene::Body& body) {
  double reach = 0;
  for (const scene::Shape& shape : body.shapes)
    for (const Vector& vertex : shape.vertices) reach = std::max(reach, norm(Vector(vertex - body.center)));
  return reach;
}

bool stands_alone(const scene::Scene& scene, int body, double reach, double whole,
                  const std::vector<scene::Pose>& poses) {
  const Vector& own = scene.bodies[static_cast<std::size_t>(body)].center;
  const Vector center = on_ground({body, own}, poses);
  constexpr double at_center = 1e-3;
  for (const scene::Symbol& symbol : scene.symbols)
    if ((symbol.to == body || symbol.from == body) &&
        norm(Vector(on_ground(symbol.place, poses) - center)) > at_center * reach)
      return false;
  for (const scene::Link& link : scene.links)
    if (link.from.body == body || link.to.body == body) return false;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Body& other = scene.bodies[k];
    if (static_cast<int>(k) == body || other.frame || (other.massless && other.shapes.empty())) continue;
    const Vector apart = on_ground({static_cast<int>(k), other.center}, poses) - center;
    if (norm(apart) - reach_of(other) < clear * whole) return false;
  }
  return true;
}

void enlarge(scene::Scene& scene, int number, double factor) {
  scene::Body& body = scene.bodies[static_cast<std::size_t>(number)];
  const auto grown = [&](const Vector& at) { return Vector(body.center + factor * (at - body.center)); };
  for (scene::Shape& shape : body.shapes)
    for (Vector& vertex : shape.vertices) vertex = grown(vertex);
  const auto grow = [&](scene::Place& place) {
    if (place.body == number) place.at = grown(place.at);
  };
  for (scene::Point& point : scene.points) grow(point.place);
  for (scene::Diagram& diagram : scene.diagrams)
    for (scene::Arrow& arrow : diagram.arrows) grow(arrow.at);
  for (scene::Dimension& dimension : scene.dimensions)
    for (scene::Place* place : {&dimension.from, &dimension.to, &dimension.corner}) grow(*place);
}

}  // namespace

std::optional<Enlarged> enlarged(const scene::Scene& scene) {
  const std::vector<scene::Pose> poses = shown_poses(scene);
  const double whole = extent_of(places_of(scene, all_bodies(scene), poses, {}, true));
  std::optional<Enlarged> found;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Body& body = scene.bodies[k];
    const double reach = reach_of(body);
    if (body.frame || !(reach > 0) || reach > lost * whole ||
        !stands_alone(scene, static_cast<int>(k), reach, whole, poses))
      continue;
    if (!found) found = Enlarged{scene, {}};
    enlarge(found->scene, static_cast<int>(k), drawn * whole / reach);
    found->bodies.push_back(body.name);
  }
  return found;
}

std::optional<scene::Scene> of_length(const scene::Scene& scene, double length) {
  if (!(length > 0) || length > lost * scene.length) return std::nullopt;
  scene::Scene found = scene;
  found.length = length;
  return found;
}

}  // namespace poinsot::pictures
