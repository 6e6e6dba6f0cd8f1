#include "pictures/figure/shortened.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pictures/figure/fitting.h"

namespace poinsot::pictures {
namespace {

// The way between the parts as so many times what they take together: from where on it is broken, and what is left.
constexpr double long_way = 10, drawn_way = 1.5;

// What is moved as a whole: a shape within a ball, or a place.
struct Item {
  Vector at;
  double radius = 0;
};

double apart(const Item& one, const Item& other) {
  return std::max(0.0, norm(Vector(one.at - other.at)) - one.radius - other.radius);
}

Item ball_around(int body, const scene::Shape& shape, const std::vector<scene::Pose>& poses) {
  Vector sum{};
  for (const Vector& vertex : shape.vertices) sum += on_ground({body, vertex}, poses);
  Item item{sum / static_cast<double>(std::max<std::size_t>(shape.vertices.size(), 1))};
  for (const Vector& vertex : shape.vertices)
    item.radius = std::max(item.radius, norm(Vector(on_ground({body, vertex}, poses) - item.at)));
  return item;
}

// Visits all places of the scene that a figure of the statement shows, but for those of shapes.
template <class Scene, class Visit>
void for_each_place(Scene& scene, Visit visit) {
  for (auto& point : scene.points) visit(point.place);
  for (auto& symbol : scene.symbols) visit(symbol.place);
  for (auto& link : scene.links) {
    visit(link.from);
    visit(link.to);
  }
  for (auto& wrap : scene.wraps) visit(wrap.center);
  for (auto& diagram : scene.diagrams)
    if (diagram.kind == scene::DiagramKind::model || diagram.kind == scene::DiagramKind::answers)
      for (auto& arrow : diagram.arrows) visit(arrow.at);
  for (auto& dimension : scene.dimensions) {
    visit(dimension.from);
    visit(dimension.to);
    if (dimension.angle) visit(dimension.corner);
  }
}

std::vector<Item> items_of(const scene::Scene& scene, const std::vector<scene::Pose>& poses) {
  std::vector<Item> items;
  const auto add = [&](const scene::Place& place) { items.push_back({on_ground(place, poses)}); };
  for_each_place(scene, add);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Body& body = scene.bodies[k];
    for (const scene::Shape& shape : body.shapes) items.push_back(ball_around(static_cast<int>(k), shape, poses));
    if (!body.frame && !body.massless) add({static_cast<int>(k), body.center});
  }
  for (const scene::Curve& curve : scene.curves)
    for (const Vector& point : curve.points) add({curve.body, point});
  std::erase_if(items, [](const Item& item) { return !std::isfinite(norm(item.at) + item.radius); });
  return items;
}

struct Parts {
  std::vector<Item> near, far;
  double way = 0;
};

// Apart by the longest of the shortest ways that join all of them. The near part has what is nearest to the origin.
std::optional<Parts> parts_of(const std::vector<Item>& items) {
  constexpr std::size_t most = 600;
  if (items.size() < 3 || items.size() > most) return std::nullopt;
  // The order in which they are joined, each by the shortest way to those before it (Prim).
  std::vector<double> least(items.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(items.size(), 0);
  std::vector<bool> joined(items.size());
  std::vector<std::pair<std::size_t, std::size_t>> ways;
  std::size_t last = 0;
  joined[0] = true;
  for (std::size_t count = 1; count < items.size(); ++count) {
    std::size_t next = items.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (joined[i]) continue;
      if (const double way = apart(items[i], items[last]); way < least[i]) {
        least[i] = way;
        from[i] = last;
      }
      if (next == items.size() || least[i] < least[next]) next = i;
    }
    joined[next] = true;
    ways.emplace_back(from[next], next);
    last = next;
  }
  const auto longest =
      std::ranges::max_element(ways, {}, [&](const auto& way) { return apart(items[way.first], items[way.second]); });
  // Those that hang together behind the longest way.
  std::vector<bool> behind(items.size());
  behind[longest->second] = true;
  for (auto way = longest + 1; way != ways.end(); ++way) behind[way->second] = behind[way->first];
  Parts parts{.near = {}, .far = {}, .way = apart(items[longest->first], items[longest->second])};
  for (std::size_t i = 0; i < items.size(); ++i) (behind[i] ? parts.far : parts.near).push_back(items[i]);
  const auto from_origin = [](const std::vector<Item>& part) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Item& item : part) nearest = std::min(nearest, norm(item.at));
    return nearest;
  };
  if (from_origin(parts.far) < from_origin(parts.near)) std::swap(parts.near, parts.far);
  return parts;
}

Item all_of(const std::vector<Item>& part) {
  Vector low = part.front().at, high = low;
  for (const Item& item : part)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], item.at[k] - item.radius);
      high[k] = std::max(high[k], item.at[k] + item.radius);
    }
  return {0.5 * (low + high), 0.5 * norm(Vector(high - low))};
}

// Visits the lines of arms and what runs between places that cross the plane of the break, with the part of each before
// that.
template <class Visit>
void for_each_crossing(const std::vector<Solid>& solids, const std::vector<scene::Link>& links,
                       const std::vector<scene::Pose>& poses, const Shortened& broken, Visit visit) {
  const auto cross = [&](const Vector& from, const Vector& to) {
    const double a = dot(from - broken.middle, broken.along), b = dot(to - broken.middle, broken.along);
    if ((a > 0) != (b > 0)) visit(from, to, a / (a - b));
  };
  for (const Solid& solid : solids)
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; solid.extent == scene::Extent::line && i + 1 < line.size(); ++i)
        cross(solid.vertices[line[i]], solid.vertices[line[i + 1]]);
  for (const scene::Link& link : links) cross(on_ground(link.from, poses), on_ground(link.to, poses));
  if (broken.radius) cross((*broken.radius)[0], (*broken.radius)[1]);
}

// Where in the figure of a statement a frame of reference turns, as that of a curve does about its middle.
std::optional<Vector> axis_of_frame(const scene::Scene& scene, const std::vector<scene::Pose>& poses) {
  for (const scene::Diagram& diagram : scene.diagrams)
    for (const scene::Arrow& arrow : diagram.arrows)
      if (diagram.kind == scene::DiagramKind::model && arrow.quantity == scene::Quantity::angular_velocity &&
          arrow.body >= 0 && scene.bodies[static_cast<std::size_t>(arrow.body)].frame)
        return on_ground(arrow.at, poses);
  return std::nullopt;
}

}  // namespace

std::optional<Shortened> shortened(const scene::Scene& scene) {
  const std::vector<scene::Pose> poses = shown_poses(scene);
  const std::optional<Parts> parts = parts_of(items_of(scene, poses));
  if (!parts) return std::nullopt;
  const Item near = all_of(parts->near), far = all_of(parts->far);
  const double taken = 2 * (near.radius + far.radius);
  if (!(taken > 0) || parts->way < long_way * taken) return std::nullopt;
  Shortened found{.scene = scene, .bodies = {}, .middle = {}, .along = normalized(Vector(far.at - near.at))};
  const double left = near.radius + far.radius + drawn_way * taken;
  const Vector shift = near.at + left * found.along - far.at;
  found.middle = near.at + (near.radius + 0.5 * drawn_way * taken) * found.along;
  const auto is_far = [&](const Vector& at) { return norm(Vector(at - far.at)) < norm(Vector(at - near.at)); };
  const auto turned_back = [&](int body, const Vector& vector) {
    return body < 0 ? vector : transpose_times(poses[static_cast<std::size_t>(body)].R, vector);
  };
  const auto move = [&](scene::Place& place) {
    if (is_far(on_ground(place, poses))) place.at += turned_back(place.body, shift);
  };
  for_each_place(found.scene, move);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const int number = static_cast<int>(k);
    scene::Body& body = found.scene.bodies[k];
    if (is_far(on_ground({number, body.center}, poses))) {
      body.center += turned_back(number, shift);
      if (!body.frame && !(body.massless && body.shapes.empty())) found.bodies.push_back(body.name);
    }
    for (scene::Shape& shape : body.shapes)
      if (is_far(ball_around(number, shape, poses).at))
        for (Vector& vertex : shape.vertices) vertex += turned_back(number, shift);
  }
  for (scene::Curve& curve : found.scene.curves)
    if (!curve.points.empty() && is_far(on_ground({curve.body, curve.points.front()}, poses)))
      for (Vector& point : curve.points) point += turned_back(curve.body, shift);
  found.scene.length = extent_of(places_of(found.scene, all_bodies(found.scene), poses, {}, true));
  bool joined = false;
  for_each_crossing(solids_of(found.scene, all_bodies(found.scene), poses), found.scene.links, poses, found,
                    [&](const Vector&, const Vector&, double) { joined = true; });
  if (joined) return found;
  // A satellite on its orbit is not drawn beside what it goes round, even in a frame that turns.
  const std::optional<Vector> axis = axis_of_frame(found.scene, poses);
  if (!axis || std::ranges::find(scene.curves, scene::CurveKind::attractor, &scene::Curve::kind) != scene.curves.end())
    return std::nullopt;
  const bool axis_far = dot(*axis - found.middle, found.along) > 0;
  found.radius = {*axis, axis_far ? near.at : Vector(far.at + shift)};
  return found;
}

void draw_breaks(Panel& panel, const Shortened& broken) {
  if (broken.radius)
    panel.line({panel.projection((*broken.radius)[0]), panel.projection((*broken.radius)[1])}, Role::hidden, 0.7,
               Ink::grey, Dash::chain);
  // A gap between two strokes that lean.
  for_each_crossing(
      panel.solids, panel.links, panel.poses, broken, [&](const Vector& from, const Vector& to, double part) {
        const Point2 at = panel.projection(Vector(from + part * (to - from)));
        const Point2 along = direction(panel.projection(to) - panel.projection(from)), across = turned_left(along);
        constexpr double half_gap = 3, half_length = 9, lean = 3;
        const auto corner = [&](double u, double v) {
          return at + (u * half_gap + v * lean) * along + v * half_length * across;
        };
        panel.area({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, color_of(Ink::white), Role::link);
        for (const double u : {-1.0, 1.0}) panel.line({corner(u, -1), corner(u, 1)}, Role::link, 1.1);
      });
}

}  // namespace poinsot::pictures
