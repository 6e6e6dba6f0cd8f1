#include "pictures/figure/view_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "pictures/figure/arrows.h"
#include "pictures/figure/herpolhode.h"
#include "pictures/solids/solid.h"
#include "poinsot/engine/mass/principal_axes.h"

namespace poinsot::pictures {
namespace {

constexpr std::size_t most_places_compared = 40, most_facets = 2500;
constexpr double shortest_seen = 1.0 / 3;  // of its length: an arrow or a rod should not be seen shorter
constexpr double near_part = 0.04;         // of the picture: places should not be seen nearer to each other

struct Directed {
  Vector at, direction;
  bool turning = false;
  double size = 1;  // beside the largest that is drawn to the same scale
};

struct Plate {
  Vector normal;
  double weight = 0;
};

// What a view must show.
struct Matter {
  double size = 1;
  Vector center{};
  std::vector<Vector> points;
  std::vector<Vector> held;  // where symbols stand
  std::vector<Directed> arrows;
  std::vector<std::pair<Vector, double>> rods;  // directions, and how much they count
  std::vector<Plate> plates;
  std::vector<std::array<Vector, 3>> facets;
  std::vector<std::array<Vector, 3>> uneven;  // those of what does not look alike from all sides, as balls do
  std::vector<Vector> joint_axes;
  std::vector<Vector> slides;       // ways of sliding
  std::vector<Vector> ways;         // of springs and cords, and of what moves
  bool turns = false;               // whether a joint lets a body turn
  std::vector<Vector> normals;      // of contacts
  Vector gravity{};                 // upward, or zero
  bool touches = false;             // whether something stands on the ground or on another body
  std::vector<Vector> angle_faces;  // normals of the planes of marked angles
  std::vector<Vector> plate_middles;
  std::vector<Vector> leanings;   // what is seen by nothing else than how long it looks
  std::vector<Vector> cone_axes;  // into the cones one should look, and see how high they are
};

void add_point(Matter& matter, const Vector& at) {
  for (const Vector& known : matter.points)
    if (norm(known - at) < 1e-3 * matter.size) return;
  if (matter.points.size() < most_places_compared) matter.points.push_back(at);
}

// The direction in which a solid is longest; zero if no other is much shorter.
Vector longest_axis(const Solid& solid) {
  Vector middle{};
  for (const Vector& p : solid.vertices) middle += p / static_cast<double>(solid.vertices.size());
  SymmetricMatrix3<double> spread;  // as an inertia: least about the longest axis
  for (const Vector& p : solid.vertices) {
    const Vector d = p - middle;
    spread.xx += d.y * d.y + d.z * d.z;
    spread.yy += d.z * d.z + d.x * d.x;
    spread.zz += d.x * d.x + d.y * d.y;
    spread.xy -= d.x * d.y;
    spread.yz -= d.y * d.z;
    spread.zx -= d.z * d.x;
  }
  const PrincipalAxes<double> axes = principal_axes(spread);
  constexpr double longer = 1.1;
  return axes.moments.y > longer * axes.moments.x ? axes.axes.column(0) : Vector{};
}

bool is_ball(const Solid& solid) {
  if (solid.extent != scene::Extent::volume || solid.vertices.empty()) return false;
  Vector middle{};
  for (const Vector& p : solid.vertices) middle += p / static_cast<double>(solid.vertices.size());
  const double radius = norm(solid.vertices.front() - middle);
  constexpr double alike = 0.02;
  return std::ranges::all_of(solid.vertices,
                             [&](const Vector& p) { return std::abs(norm(p - middle) - radius) < alike * radius; }) &&
         solid.vertices.size() > 20;
}

void add_solids(Matter& matter, const std::vector<Solid>& solids) {
  std::size_t facets = 0;
  for (const Solid& solid : solids) facets += solid.triangles.size();
  const std::size_t stride = facets / most_facets + 1;
  for (const Solid& solid : solids) {
    Vector area{};
    double whole = 0;
    const bool ball = is_ball(solid);
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
      const auto& v = solid.triangles[t];
      const std::array<Vector, 3> p{solid.vertices[v[0]], solid.vertices[v[1]], solid.vertices[v[2]]};
      const Vector normal = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
      area += dot(normal, area) < 0 ? -normal : normal;
      whole += norm(normal);
      if (t % stride == 0 && !solid.hole) matter.facets.push_back(p);
      if (t % stride == 0 && !solid.hole && !ball) matter.uneven.push_back(p);
    }
    if (solid.extent == scene::Extent::surface && norm(area) > 0.9 * whole && !solid.hole && whole > 0) {
      matter.plates.push_back({normalized(area), std::min(1.0, std::sqrt(whole) / matter.size * 3)});
      Vector middle{};
      for (const Vector& p : solid.vertices) middle += p / static_cast<double>(solid.vertices.size());
      constexpr std::size_t most_plates = 12;
      if (matter.plate_middles.size() < most_plates) matter.plate_middles.push_back(middle);
    }
    if (solid.extent == scene::Extent::volume && solid.lines.empty() && !solid.hole)
      if (const Vector axis = longest_axis(solid); norm(axis) > 0) matter.leanings.push_back(axis);
    if (solid.extent == scene::Extent::line)
      for (const auto& line : solid.lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
          const Vector d = solid.vertices[line[i + 1]] - solid.vertices[line[i]];
          if (const double length = norm(d); length > 0.05 * matter.size)
            matter.rods.emplace_back(d / length, std::min(1.0, length / matter.size * 2));
        }
  }
}

bool touches(const scene::Symbol& symbol) {
  return symbol.kind == scene::SymbolKind::contact || symbol.kind == scene::SymbolKind::rolling_contact;
}

bool slides(const scene::Symbol& symbol) {
  return symbol.kind == scene::SymbolKind::prismatic || symbol.kind == scene::SymbolKind::slot;
}

Matter matter_of(const scene::Scene& scene, const std::vector<int>& bodies, const std::vector<scene::Arrow>& arrows,
                 const std::vector<scene::Pose>& poses) {
  Matter matter;
  const std::vector<Solid> solids = solids_of(scene, bodies, poses);
  std::vector<Vector> all;
  for (const Solid& solid : solids) all.insert(all.end(), solid.vertices.begin(), solid.vertices.end());
  const auto drawn = [&](int body) { return body < 0 || std::ranges::find(bodies, body) != bodies.end(); };
  std::vector<Vector> named;
  for (const scene::Point& point : scene.points)
    if (drawn(point.place.body)) named.push_back(on_ground(point.place, poses));
  for (const scene::Symbol& symbol : scene.symbols)
    if (drawn(symbol.to)) {
      named.push_back(on_ground(symbol.place, poses));
      matter.held.push_back(named.back());
      matter.turns = matter.turns || (!touches(symbol) && !slides(symbol) && symbol.kind != scene::SymbolKind::weld);
      if (norm(symbol.axis) > 0) {
        const Vector axis = normalized(turned_to_ground(symbol.to, symbol.axis, poses));
        (touches(symbol) ? matter.normals : slides(symbol) ? matter.slides : matter.joint_axes).push_back(axis);
        // A screw moves along its axis too.
        if (symbol.kind == scene::SymbolKind::screw) matter.slides.push_back(axis);
      }
      matter.touches = matter.touches || touches(symbol);
    } else if (touches(symbol) && symbol.from >= 0 && drawn(symbol.from)) {
      matter.touches = true;
      matter.normals.push_back(normalized(turned_to_ground(symbol.to, symbol.axis, poses)));
    }
  matter.gravity = scene.gravity ? scene.up : Vector{};
  for (const scene::Dimension& dimension : scene.dimensions) {
    if (!dimension.angle || !drawn(dimension.corner.body)) continue;
    const Vector corner = on_ground(dimension.corner, poses);
    const Vector face = cross(unit_or(on_ground(dimension.from, poses) - corner, Vector{}),
                              unit_or(on_ground(dimension.to, poses) - corner, Vector{}));
    constexpr double noticeable = 0.02;
    if (norm(face) > noticeable) matter.angle_faces.push_back(normalized(face));
  }
  for (const scene::Link& link : scene.links) {
    for (const scene::Place& place : {link.from, link.to})
      if (drawn(place.body)) named.push_back(on_ground(place, poses));
    if (link.kind == scene::LinkKind::torsion || !drawn(link.from.body) || !drawn(link.to.body)) continue;
    const Vector way = on_ground(link.to, poses) - on_ground(link.from, poses);
    if (norm(way) > 0) matter.ways.push_back(normalized(way));
  }
  for (const scene::Arrow& arrow : arrows) named.push_back(on_ground(arrow.at, poses));
  for (const scene::Curve& curve : scene.curves) {
    if (!drawn(curve.body)) continue;
    if (curve.kind == scene::CurveKind::attractor) {
      named.push_back(curve.points.front());
      // What goes round a center moves in one plane with it.
      for (const scene::Arrow& arrow : arrows) {
        const Vector across = cross(on_ground(arrow.at, poses) - curve.points.front(), arrow.vector);
        if (arrow.quantity == scene::Quantity::velocity && norm(across) > 0)
          matter.joint_axes.push_back(normalized(across));
      }
    }
    if (curve.kind == scene::CurveKind::surface) {
      matter.touches = true;
      named.push_back(curve.points[0]);
      matter.normals.push_back(normalized(curve.points[1] - curve.points[0]));
    }
    // What goes round is seen from along its axis.
    if ((curve.kind == scene::CurveKind::post || curve.kind == scene::CurveKind::pitch_circle) &&
        curve.points.size() > 4) {
      const auto at = [&](std::size_t i) { return on_ground({curve.body, curve.points[i]}, poses); };
      const std::size_t quarter = curve.points.size() / 4;
      matter.joint_axes.push_back(normalized(cross(at(quarter) - at(0), at(2 * quarter) - at(quarter))));
      for (std::size_t i = 0; i < 4; ++i) all.push_back(at(i * quarter));
    }
  }
  all.insert(all.end(), named.begin(), named.end());
  if (all.empty()) all.emplace_back();
  for (const Vector& p : all) matter.center += p / static_cast<double>(all.size());
  matter.size = 0;
  for (const Vector& p : all) matter.size = std::max(matter.size, 2 * norm(p - matter.center));
  if (!(matter.size > 0)) matter.size = std::max(scene.length, 1e-12);
  for (const Vector& p : named) add_point(matter, p);
  std::array<double, scale_count> largest{};
  for (const scene::Arrow& arrow : arrows)
    if (!arrow.open)
      largest[static_cast<std::size_t>(scale_of(arrow.quantity))] =
          std::max(largest[static_cast<std::size_t>(scale_of(arrow.quantity))], norm(arrow.vector));
  for (const scene::Arrow& arrow : arrows)
    if (const double size = norm(arrow.vector); arrow.open)
      matter.arrows.push_back({on_ground(arrow.at, poses), arrow.vector, turns(arrow.quantity)});
    else if (size > rounding_part * largest[static_cast<std::size_t>(scale_of(arrow.quantity))])
      matter.arrows.push_back({on_ground(arrow.at, poses), arrow.vector / size, turns(arrow.quantity),
                               size / largest[static_cast<std::size_t>(scale_of(arrow.quantity))]});
  add_solids(matter, solids);
  return matter;
}

// How far what is shorter than it should be falls short, from 0 to 1.
double shortfall(double seen) { return seen < shortest_seen ? 1 - seen / shortest_seen : 0; }

bool hidden(const Vector& point, const Matter& matter, const View& view) {
  const double px = dot(point, view.right), py = dot(point, view.up), pz = dot(point, view.viewer);
  for (const auto& facet : matter.facets) {
    const double ax = dot(facet[0], view.right) - px, bx = dot(facet[1], view.right) - px,
                 cx = dot(facet[2], view.right) - px;
    if ((ax > 0 && bx > 0 && cx > 0) || (ax < 0 && bx < 0 && cx < 0)) continue;
    const double ay = dot(facet[0], view.up) - py, by = dot(facet[1], view.up) - py, cy = dot(facet[2], view.up) - py;
    const double u = bx * cy - by * cx, v = cx * ay - cy * ax, w = ax * by - ay * bx;
    if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) continue;
    const double depth =
        (u * dot(facet[0], view.viewer) + v * dot(facet[1], view.viewer) + w * dot(facet[2], view.viewer)) /
        (u + v + w);
    if (depth > pz + 0.01 * matter.size) return true;
  }
  return false;
}

double cost_of(const View& view, const Matter& matter) {
  const Projection projection(view, 1 / matter.size);
  const auto length = [&](const Vector& v) { return norm(projection.direction_of(v)); };
  double cost = 0;
  // What is short in itself, and would be drawn to scale, should not become shorter yet.
  constexpr double to_scale = 0.25;
  for (const Directed& arrow : matter.arrows) {
    cost += 2.5 * shortfall(length(arrow.direction));
    if (arrow.size > to_scale) cost += shortfall(arrow.size * length(arrow.direction));
    // Rather well seen than only just.
    constexpr double well_seen = 0.65, weight = 0.8;
    cost += weight * std::max(0.0, 1 - length(arrow.direction) / well_seen);
  }
  for (const auto& [rod, weight] : matter.rods)
    cost += 2.0 * weight * shortfall(length(rod)) / std::sqrt(static_cast<double>(matter.rods.size()));
  for (const Vector& leaning : matter.leanings) cost += 1.5 * (norm(leaning) - length(leaning));
  // What is touched is seen from the side: the place is not on the front or the back of a round body.
  constexpr double normal_seen = 0.9, normal_weight = 1.5;
  for (const Vector& normal : matter.normals) cost += normal_weight * std::max(0.0, 1 - length(normal) / normal_seen);
  for (const Plate& plate : matter.plates)
    cost += 2 * plate.weight * shortfall(std::abs(dot(plate.normal, view.viewer)));
  // An angle is read where its plane is not seen askew.
  constexpr double face_on = 0.7;
  for (const Vector& face : matter.angle_faces) {
    const double seen = std::abs(dot(face, view.viewer));
    if (seen < face_on) cost += 1.5 * (1 - seen / face_on);
  }
  constexpr double cone_weight = 3, highest = 0.6;
  for (const Vector& axis : matter.cone_axes) {
    cost += cone_weight * shortfall(std::abs(dot(axis, view.viewer)));
    cost += cone_weight * shortfall(shortest_seen / highest * length(axis));
  }
  for (std::size_t i = 0; i < 3; ++i) cost += 1.2 * shortfall(length(Vector::unit(i)));
  for (std::size_t i = 0; i < matter.points.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const double apart = norm(projection(matter.points[i]) - projection(matter.points[k]));
      if (apart < near_part && norm(matter.points[i] - matter.points[k]) > near_part * matter.size)
        cost += 1 - apart / near_part;
    }
  // Arrows that run into each other: heads, and arrows from one point in nearly one direction.
  constexpr double arrow_part = 0.25;
  for (std::size_t i = 0; i < matter.arrows.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Directed &a = matter.arrows[i], &b = matter.arrows[k];
      const Point2 da = projection.direction_of(a.direction), db = projection.direction_of(b.direction);
      const Point2 tail = projection(a.at) - projection(b.at);
      if (norm(tail + arrow_part * (da - db)) < near_part) cost += 1;
      if (norm(a.at - b.at) < 1e-3 * matter.size && norm(cross(a.direction, b.direction)) > 0.1 &&
          std::abs(cross(da, db)) < 0.2 * norm(da) * norm(db) && dot(da, db) > 0)
        cost += 1;
    }
  for (const Vector& point : matter.plate_middles) cost += hidden(point, matter, view) ? 0.7 : 0;
  for (const Vector& point : matter.points) cost += hidden(point, matter, view) ? 0.35 : 0;
  for (const Vector& point : matter.held) cost += hidden(point, matter, view) ? 0.5 : 0;
  return cost;
}

// Whether the faces of solids lie across the plane or in it, as those of a crate that is drawn from the side.
bool stands_across(const Matter& matter, const Vector& normal) {
  constexpr double askew = 1e-3;
  return std::ranges::all_of(matter.uneven, [&](const std::array<Vector, 3>& facet) {
    const Vector face = unit_or(cross(facet[1] - facet[0], facet[2] - facet[0]), normal);
    const double part = std::abs(dot(face, normal));
    return part < askew || part > 1 - askew;
  });
}

// The axes that a reader expects to come towards him and to run to the right: those after the upward one.
struct Expected {
  Vector up, front, right;
};
Expected expected_axes(const scene::Scene& scene) {
  Expected axes;
  axes.up = unit_or(scene.up, {0, 0, 1});
  const std::size_t upward = std::abs(axes.up.x) > 0.9 ? 0 : std::abs(axes.up.y) > 0.9 ? 1 : 2;
  const Vector next = Vector::unit((upward + 1) % 3);
  axes.front = unit_or(next - dot(next, axes.up) * axes.up, across(axes.up));
  axes.right = cross(axes.up, axes.front);
  return axes;
}

// The direction across the plane in which all of some directions lie; across the upward one if they are all one line.
Vector across_all(const std::vector<Vector>& directions, const Expected& axes) {
  if (directions.empty()) return axes.front;
  for (const Vector& v : directions)
    if (const Vector normal = cross(directions.front(), v); norm(normal) > 0.1) return normalized(normal);
  const Vector normal = cross(directions.front(), axes.up);
  return norm(normal) > 0.1 ? normalized(normal) : axes.front;
}

// The direction across the plane of the problem, if all lies and acts in one: then it is looked at face-on.
std::optional<Vector> planar_normal(const Matter& matter, const Expected& axes) {
  std::vector<Vector> across_plane = matter.joint_axes, in_plane;
  for (const Directed& arrow : matter.arrows) (arrow.turning ? across_plane : in_plane).push_back(arrow.direction);
  for (const Plate& plate : matter.plates) across_plane.push_back(plate.normal);
  for (const auto& [rod, weight] : matter.rods) in_plane.push_back(rod);
  const bool straight = !matter.turns && (matter.touches || !matter.slides.empty());
  // A turning alone lies in no plane; nor does what stands on its shaft and weighs on it.
  const bool upright = norm(matter.gravity) > 0 && !across_plane.empty() &&
                       std::abs(dot(across_plane.front(), unit_or(matter.gravity, {}))) > 1 - 1e-6;
  const bool something_lies = !in_plane.empty() || (!matter.facets.empty() && !upright) || matter.points.size() >= 2 ||
                              matter.touches || straight;
  in_plane.insert(in_plane.end(), matter.slides.begin(), matter.slides.end());
  in_plane.insert(in_plane.end(), matter.ways.begin(), matter.ways.end());
  if (across_plane.empty() && (matter.touches || straight)) {
    if (norm(matter.gravity) > 0) in_plane.push_back(matter.gravity);
    in_plane.insert(in_plane.end(), matter.normals.begin(), matter.normals.end());
    across_plane.push_back(across_all(in_plane, axes));
    // Where nothing but a way of moving tells the plane, as of a ball, and it stands askew to the axes, two of these
    // would be seen as one line.
    constexpr double along_axis = 1 - 1e-6;
    const Vector& normal = across_plane.back();
    const double most = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (matter.uneven.empty() && matter.rods.empty() && most < along_axis) return std::nullopt;
  }
  if (across_plane.empty() || !something_lies) return std::nullopt;
  const Vector normal = across_plane.front();
  for (const Vector& v : across_plane)
    if (norm(cross(v, normal)) > 1e-3) return std::nullopt;
  for (const Vector& v : in_plane)
    if (std::abs(dot(v, normal)) > 1e-3) return std::nullopt;
  // What stands on a table may move in its plane.
  for (const Vector& v : matter.normals)
    if (std::abs(dot(v, normal)) > 1e-3 && norm(cross(v, normal)) > 1e-3) return std::nullopt;
  double low = 1e300, high = -1e300;
  for (const Vector& p : matter.points) {
    low = std::min(low, dot(p - matter.center, normal));
    high = std::max(high, dot(p - matter.center, normal));
  }
  if (high - low > 0.02 * matter.size) return std::nullopt;
  if ((matter.touches || straight) && stands_across(matter, normal)) return normal;
  for (const auto& facet : matter.uneven)
    for (const Vector& p : facet)
      if (std::abs(dot(p - matter.center, normal)) > 0.12 * matter.size) return std::nullopt;
  return normal;
}

std::optional<View> across_plane(const scene::Scene& scene, const Matter& matter) {
  const std::optional<Vector> normal = planar_normal(matter, expected_axes(scene));
  if (!normal || !matter.cone_axes.empty()) return std::nullopt;
  // From the side on which the axis of the plane points to the viewer.
  const Vector to = normal->x + normal->y + normal->z < 0 ? -*normal : *normal;
  return view_from(to, scene.up);
}

View best_view(const scene::Scene& scene, const Matter& matter) {
  const auto [up, front, right] = expected_axes(scene);
  if (const std::optional<View> view = across_plane(scene, matter)) return *view;
  View best = view_from(front, up);
  double least = 1e300;
  for (const double elevation : {20.0, 33.0, 50.0})
    for (int i = 0; i < 16; ++i) {
      const double azimuth = (30 + 22.5 * i) * std::numbers::pi / 180, rise = elevation * std::numbers::pi / 180;
      const View view =
          view_from(std::cos(rise) * (std::cos(azimuth) * front + std::sin(azimuth) * right) + std::sin(rise) * up, up);
      double cost = cost_of(view, matter);
      // What readers are used to: axes that run to the right or towards them, seen from a little above and aside.
      for (std::size_t k = 0; k < 3; ++k)
        cost += std::max(dot(Vector::unit(k), view.right), dot(Vector::unit(k), view.viewer)) < 0.05 ? 0.5 : 0;
      cost += 0.012 * (elevation - 20);
      cost += 0.6 * (1 - std::cos(azimuth - 30 * std::numbers::pi / 180));
      if (cost < least - 1e-9) {
        least = cost;
        best = view;
      }
    }
  return best;
}

}  // namespace

View chosen_view(const scene::Scene& scene, const std::vector<int>& bodies, const std::vector<scene::Arrow>& arrows,
                 const std::vector<scene::Pose>& poses) {
  if (scene.viewer) return view_from(*scene.viewer, scene.up);
  return best_view(scene, matter_of(scene, bodies, arrows, poses));
}

std::optional<View> view_across_plane(const scene::Scene& scene, const std::vector<scene::Pose>& poses) {
  if (scene.viewer) return std::nullopt;
  std::vector<int> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) bodies.push_back(static_cast<int>(i));
  std::vector<scene::Arrow> arrows;
  for (const scene::Diagram& diagram : scene.diagrams)
    if (diagram.kind != scene::DiagramKind::answers)
      arrows.insert(arrows.end(), diagram.arrows.begin(), diagram.arrows.end());
  return across_plane(scene, matter_of(scene, bodies, arrows, poses));
}

View chosen_view_of_cones(const scene::Scene& scene, const std::vector<int>& bodies,
                          const std::vector<scene::Pose>& poses) {
  if (scene.viewer) return view_from(*scene.viewer, scene.up);
  Matter matter = matter_of(scene, bodies, {}, poses);
  for (const scene::Cone& cone : scene.cones)
    matter.cone_axes.push_back(unit_or(turned_to_ground(cone.body, cone.axis, poses), {0, 0, 1}));
  for (const scene::Curve& curve : scene.curves)
    if (curve.kind == scene::CurveKind::herpolhode)
      for (const int body : bodies) {
        const Vector center = on_ground({body, scene.bodies.at(static_cast<std::size_t>(body)).center}, poses);
        if (const Vector axis = direction_across(curve, center); norm(axis) > 0) matter.cone_axes.push_back(axis);
      }
  return best_view(scene, matter);
}

View chosen_view_of_motion(const scene::Scene& scene, const std::vector<int>& bodies,
                           const std::vector<scene::Pose>& poses) {
  if (scene.viewer) return view_from(*scene.viewer, scene.up);
  Matter matter = matter_of(scene, bodies, {}, poses);
  for (const scene::Curve& curve : scene.curves) {
    if (curve.kind != scene::CurveKind::path || curve.points.empty()) continue;
    std::vector<Vector> points;
    for (const Vector& point : curve.points) points.push_back(on_ground({curve.body, point}, poses));
    const Vector way = *std::ranges::max_element(points, {}, [&](const Vector& p) {
      return norm(p - points.front());
    }) - points.front();
    matter.leanings.push_back(way / std::max(norm(way), matter.size));
    constexpr std::size_t compared = 20;
    const std::size_t stride = points.size() / compared + 1;
    for (std::size_t i = stride; i < points.size(); i += stride)
      if (const Vector gone = points[i] - points.front(); norm(gone) > near_part * matter.size)
        matter.ways.push_back(normalized(gone));
  }
  return best_view(scene, matter);
}

}  // namespace poinsot::pictures
