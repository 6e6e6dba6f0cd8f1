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

// What is fixed to the ground and a cord is led round.
struct Post {
  Vector center;
  double radius = 0;
};
Post post_of(const scene::Curve& curve) {
  Post post;
  for (const Vector& point : curve.points) post.center += point / static_cast<double>(curve.points.size());
  post.radius = norm(Vector(curve.points.front() - post.center));
  return post;
}

bool is_clear_of_bodies(const scene::Scene& scene, const Post& post, double whole,
                        const std::vector<scene::Pose>& poses) {
  constexpr double beside = 2 * drawn;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Body& other = scene.bodies[k];
    if (other.frame || (other.massless && other.shapes.empty())) continue;
    const Vector apart = on_ground({static_cast<int>(k), other.center}, poses) - post.center;
    if (norm(apart) - reach_of(other) < beside * whole) return false;
  }
  return true;
}

// With the ends of the cords that come off it.
void enlarge(scene::Scene& scene, const Post& post, double factor) {
  constexpr double rounding = 1e-6;
  const auto grow = [&](Vector& at) {
    if (norm(Vector(at - post.center)) <= (1 + rounding) * post.radius) at = post.center + factor * (at - post.center);
  };
  const auto grow_place = [&](scene::Place& place) {
    if (place.body == scene::ground) grow(place.at);
  };
  for (scene::Curve& curve : scene.curves)
    if (curve.kind == scene::CurveKind::post)
      for (Vector& point : curve.points) grow(point);
  for (scene::Link& link : scene.links)
    for (scene::Place* end : {&link.from, &link.to}) grow_place(*end);
  for (scene::Point& point : scene.points) grow_place(point.place);
  for (scene::Dimension& dimension : scene.dimensions)
    for (scene::Place* place : {&dimension.from, &dimension.to, &dimension.corner}) grow_place(*place);
}

// How the statement calls the place in its middle.
std::string name_of(const scene::Scene& scene, const Post& post) {
  for (const scene::Point& point : scene.points)
    if (point.place.body == scene::ground && norm(Vector(point.place.at - post.center)) < 1e-3 * post.radius)
      return point.name;
  return "what the cord goes round";
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
  for (const scene::Curve& curve : scene.curves) {
    if (curve.kind != scene::CurveKind::post || curve.points.empty()) continue;
    const Post post = post_of(curve);
    if (!(post.radius > 0) || post.radius > lost * whole || !is_clear_of_bodies(scene, post, whole, poses)) continue;
    if (!found) found = Enlarged{scene, {}};
    enlarge(found->scene, post, drawn * whole / post.radius);
    found->bodies.push_back(name_of(scene, post));
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
