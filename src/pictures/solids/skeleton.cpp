#include "pictures/solids/skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "pictures/solids/bent_arms.h"
#include "pictures/solids/gimbals.h"

namespace poinsot::pictures {
namespace {

constexpr double near_part = 0.02;  // of the picture: a place this near to a shape belongs to it
constexpr std::size_t most_places = 40;

Vector nearest_on(const std::array<Vector, 2>& segment, const Vector& p) {
  const Vector d = segment[1] - segment[0];
  const double square = norm_squared(d);
  return segment[0] + (square > 0 ? std::clamp(dot(p - segment[0], d) / square, 0.0, 1.0) : 0.0) * d;
}

// Whether the spring of a slide runs between the two bodies of it: then the one that carries the other needs no rail.
bool springs_alone(const scene::Scene& scene, const scene::Symbol& symbol, const std::vector<scene::Pose>& poses) {
  if (symbol.kind != scene::SymbolKind::prismatic || symbol.from < 0) return false;
  const scene::Body& carrier = scene.bodies.at(static_cast<std::size_t>(symbol.from));
  const double near = 1e-6 * scene.length;
  return std::ranges::any_of(scene.links, [&](const scene::Link& link) {
    if (link.name != symbol.name || link.from.body != symbol.from || link.to.body != symbol.to) return false;
    const Vector end = on_ground(link.from, poses);
    if (!carrier.massless && norm(on_ground({symbol.from, carrier.center}, poses) - end) < near) return true;
    return std::ranges::any_of(scene.symbols, [&](const scene::Symbol& other) {
      return &other != &symbol && (other.to == symbol.from || other.from == symbol.from) &&
             norm(on_ground(other.place, poses) - end) < near;
    });
  });
}

// Whether a place lies on the circle of a wheel that is drawn of the body: what winds there needs no arm.
bool on_wheel(const scene::Scene& scene, const scene::Place& place) {
  constexpr double alike = 1e-3;
  return std::ranges::any_of(scene.curves, [&](const scene::Curve& curve) {
    if (curve.kind != scene::CurveKind::pitch_circle || curve.body != place.body || curve.points.empty()) return false;
    Vector middle{};
    for (const Vector& point : curve.points) middle += point / static_cast<double>(curve.points.size());
    const double radius = norm(curve.points.front() - middle);
    const Vector axis =
        normalized(cross(curve.points.front() - middle, curve.points[curve.points.size() / 4] - middle));
    return std::abs(norm(place.at - middle) - radius) < alike * radius &&
           std::abs(dot(place.at - middle, axis)) < alike * radius;
  });
}

// The places at which something holds the body, acts on it or is fixed to it, each once.
std::vector<Vector> places_on(const scene::Scene& scene, int body, bool with_points,
                              const std::vector<scene::Pose>& poses) {
  std::vector<Vector> places;
  const double near = 1e-3 * scene.length;
  const auto add = [&](const Vector& at) {
    if (!std::isfinite(norm(at)) || places.size() >= most_places) return;
    if (std::ranges::none_of(places, [&](const Vector& other) { return norm(other - at) < near; }))
      places.push_back(at);
  };
  for (const scene::Symbol& symbol : scene.symbols) {
    const bool touched = symbol.kind == scene::SymbolKind::contact || symbol.kind == scene::SymbolKind::rolling_contact;
    if (symbol.from == body && springs_alone(scene, symbol, poses)) continue;
    if (symbol.to == body || (symbol.from == body && !touched)) add(on_ground(symbol.place, poses));
  }
  for (const scene::Link& link : scene.links)
    for (const scene::Place& place : {link.from, link.to})
      if (place.body == body && !(link.far && &place == &link.to) && !on_wheel(scene, place))
        add(on_ground(place, poses));
  if (with_points)
    for (const scene::Point& point : scene.points)
      if (point.place.body == body) add(on_ground(point.place, poses));
  if (with_points && !scene.diagrams.empty())
    for (const scene::Arrow& arrow : scene.diagrams.front().arrows)
      if (arrow.body == body && arrow.at.body == body) add(on_ground(arrow.at, poses));
  return places;
}

// The box along the axes of the ground that holds a shape.
struct Span {
  Vector low, high;

  explicit Span(const Solid& solid) : low(solid.vertices.front()), high(low) {
    for (const Vector& v : solid.vertices)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], v[i]);
        high[i] = std::max(high[i], v[i]);
      }
  }
  Vector middle() const { return 0.5 * (low + high); }
  bool hold(const Vector& place, double little) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(place[i] > low[i] - little && place[i] < high[i] + little)) return false;
    return true;
  }
};

// Disks, rings and solids have a middle that is drawn as theirs.
bool has_middle(const Solid& solid) { return solid.extent != scene::Extent::line && solid.vertices.size() > 8; }

// Where the axis on which a body is held at a place meets a shape: a shaft runs to the middle of its disk.
std::optional<Vector> along_axis(const scene::Scene& scene, int body, const std::vector<Solid>& solids,
                                 const Vector& place, const std::vector<scene::Pose>& poses, double near) {
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.to != body && symbol.from != body) continue;
    // Along a normal or a way of sliding runs no shaft.
    using scene::SymbolKind;
    const bool along_shaft = symbol.kind != SymbolKind::contact && symbol.kind != SymbolKind::rolling_contact &&
                             symbol.kind != SymbolKind::prismatic && symbol.kind != SymbolKind::slot &&
                             symbol.kind != SymbolKind::planar;
    const Vector axis = turned_to_ground(symbol.to, symbol.axis, poses);
    if (!along_shaft || !(norm(axis) > 0) || norm(on_ground(symbol.place, poses) - place) > near) continue;
    const Vector direction = normalized(axis);
    for (const Solid& solid : solids) {
      if (solid.hole || solid.vertices.empty()) continue;
      const Span bounds(solid);
      const Vector foot = place + dot(bounds.middle() - place, direction) * direction;
      if (bounds.hold(foot, near)) return foot;
    }
  }
  return std::nullopt;
}

// The point of the shapes that is nearest to a place; the place itself if it lies within the bounds of a volume.
Vector nearest_of_shapes(std::span<const Solid> solids, const Vector& place, double little) {
  Vector best = place;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vector& p) {
    if (const double away = norm(p - place); away < least) {
      least = away;
      best = p;
    }
  };
  for (const Solid& solid : solids) {
    if (solid.hole || solid.vertices.empty()) continue;
    for (const Vector& v : solid.vertices) offer(v);
    const Span bounds(solid);
    if (solid.extent != scene::Extent::line && bounds.hold(place, little)) return place;
    for (const auto& line : solid.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        offer(nearest_on({solid.vertices[line[i]], solid.vertices[line[i + 1]]}, place));
    // An arm to a disk or a ring goes to its middle.
    if (has_middle(solid)) offer(bounds.middle());
  }
  return best;
}

// The shortest way from one part to another: from the best of its points, then to and fro between the nearest points.
std::array<Vector, 2> way_between(const Solid& first, const Solid& second, double near) {
  const std::span<const Solid> from(&first, 1), to(&second, 1);
  std::vector<Vector> starts;
  const std::size_t stride = first.vertices.size() / 100 + 1;
  for (std::size_t v = 0; v < first.vertices.size(); v += stride) starts.push_back(first.vertices[v]);
  for (const auto& line : first.lines)
    if (starts.size() < 200 && !line.empty())
      starts.push_back(0.5 * (first.vertices[line[0]] + first.vertices[line[1]]));
  std::array<Vector, 2> best{};
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& start : starts) {
    if (least == 0) break;
    const Vector end = nearest_of_shapes(to, start, near);
    if (norm(end - start) < least) {
      least = norm(end - start);
      best = {start, end};
    }
  }
  constexpr int rounds = 40;
  for (int i = 0; i < rounds; ++i) {
    const std::array<Vector, 2> before = best;
    best[0] = nearest_of_shapes(from, best[1], near);
    best[1] = nearest_of_shapes(to, best[0], near);
    if (norm(best[0] - before[0]) + norm(best[1] - before[1]) == 0) break;
  }
  // From middle to middle if that is hardly longer.
  constexpr double hardly_longer = 1.05;
  if (has_middle(first) && has_middle(second)) {
    const std::array<Vector, 2> middles{Span(first).middle(), Span(second).middle()};
    if (norm(middles[1] - middles[0]) <= hardly_longer * norm(best[1] - best[0])) return middles;
  }
  return best;
}

// The shortest ways between parts of a body that lie apart.
void join_parts(const std::vector<Solid>& solids, double near, std::vector<std::array<Vector, 2>>& arms) {
  std::vector<std::size_t> apart;
  for (std::size_t i = 0; i < solids.size() && apart.size() < most_places; ++i)
    if (!solids[i].hole && !solids[i].vertices.empty()) apart.push_back(i);
  if (apart.size() < 2) return;
  std::vector<std::size_t> joined{apart.back()};
  apart.pop_back();
  while (!apart.empty()) {
    double least = std::numeric_limits<double>::infinity();
    std::array<Vector, 2> way{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < apart.size(); ++i)
      for (const std::size_t other : joined) {
        const std::array<Vector, 2> shortest = way_between(solids[apart[i]], solids[other], near);
        if (const double length = norm(shortest[1] - shortest[0]); length < least) {
          least = length;
          way = shortest;
          next = i;
        }
      }
    joined.push_back(apart[next]);
    apart.erase(apart.begin() + static_cast<std::ptrdiff_t>(next));
    if (least > near) arms.push_back(way);
  }
}

// What stands for a shape reaches to the points of the body by arms. Its surface is not where the true one is: points
// that are hardly outside have none.
void reach_points(const scene::Scene& scene, int body, const std::vector<Solid>& solids,
                  const std::vector<scene::Pose>& poses, std::vector<std::array<Vector, 2>>& arms) {
  if (std::ranges::none_of(solids, &Solid::stand_in)) return;
  constexpr double outside_part = 0.1;
  const double outside = outside_part * scene.length;
  const std::vector<Vector> held = places_on(scene, body, false, poses);
  for (const Vector& place : places_on(scene, body, true, poses)) {
    if (std::ranges::find_if(held, [&](const Vector& other) { return norm(other - place) < outside; }) != held.end())
      continue;
    const Vector end = nearest_of_shapes(solids, place, outside);
    if (norm(end - place) > outside) arms.push_back({place, end});
  }
}

// The axis that is held at a place, or zero if there is none or more than one.
Vector axis_at(const scene::Scene& scene, int body, const Vector& place, const std::vector<scene::Pose>& poses) {
  Vector found{};
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.to != body && symbol.from != body) continue;
    if (norm(on_ground(symbol.place, poses) - place) > 1e-3 * scene.length) continue;
    const Vector axis = turned_to_ground(symbol.to, symbol.axis, poses);
    // A support of listed components stands at the axis of its joint.
    const bool turning =
        turns_about_axis(symbol) || (symbol.kind == scene::SymbolKind::listed_support && norm(axis) > 0);
    constexpr double askew = 1e-3;
    if (!turning || (norm(found) > 0 && norm(cross(found, axis)) > askew * norm(axis))) return {};
    found = normalized(axis);
  }
  return found;
}

// What the bodies that a body carries go through.
std::vector<Sweep> sweeps_of(const scene::Scene& scene, int body, const std::vector<scene::Pose>& poses) {
  std::vector<Sweep> sweeps;
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.from != body || symbol.to < 0 || !turns_about_axis(symbol)) continue;
    std::vector<Vector> vertices;
    for (const scene::Shape& shape : scene.bodies.at(static_cast<std::size_t>(symbol.to)).shapes)
      for (const Vector& vertex : shape.vertices) vertices.push_back(on_ground({symbol.to, vertex}, poses));
    sweeps.push_back(sweep_of(on_ground(symbol.place, poses),
                              normalized(turned_to_ground(symbol.to, symbol.axis, poses)), vertices));
  }
  return sweeps;
}

}  // namespace

std::vector<std::array<Vector, 2>> skeleton_of(const scene::Scene& scene, int body, const std::vector<Solid>& solids,
                                               const std::vector<scene::Pose>& poses) {
  const scene::Body& own = scene.bodies.at(static_cast<std::size_t>(body));
  if (own.frame) return {};
  const std::vector<std::optional<Gimbal>> gimbals = gimbals_of(scene, poses);
  std::vector<std::array<Vector, 2>> arms = gimbal_arms(scene, body, gimbals, poses);
  if (gimbals[static_cast<std::size_t>(body)]) return arms;
  std::vector<Vector> places = places_on(scene, body, solids.empty(), poses);
  const double near = near_part * scene.length;
  if (!solids.empty()) {
    for (const Vector& place : places) {
      const Vector end =
          along_axis(scene, body, solids, place, poses, near).value_or(nearest_of_shapes(solids, place, near));
      if (norm(end - place) > near) arms.push_back({place, end});
    }
    reach_points(scene, body, solids, poses, arms);
    join_parts(solids, near, arms);
    return arms;
  }
  if (!own.massless) {
    const Vector center = on_ground({body, own.center}, poses);
    for (const Vector& place : places)
      if (norm(place - center) > 1e-3 * scene.length) arms.push_back({center, place});
    // What is held at two places and has its mass beside the line between them is a frame of three corners.
    constexpr double beside_line = 0.15;  // of that line
    if (arms.size() == 2) {
      const std::array<Vector, 2> between{arms[0][1], arms[1][1]};
      if (norm(nearest_on(between, center) - center) > beside_line * norm(between[1] - between[0]))
        arms.push_back(between);
    }
    return arms;
  }
  if (places.size() < 2) return arms;
  // First the two that an axis joins, or those that are farthest apart; then each other by the shortest way to an arm.
  std::array<std::size_t, 2> first{0, 1};
  double most = -1;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Vector d = places[i] - places[k];
      double length = norm(d);
      for (const scene::Symbol& symbol : scene.symbols) {
        const Vector axis = turned_to_ground(symbol.to, symbol.axis, poses);
        if ((symbol.to == body || symbol.from == body) && norm(axis) > 0 && length > near &&
            norm(cross(axis, d)) < 1e-3 * norm(axis) * length &&
            norm(on_ground(symbol.place, poses) - places[i]) < near)
          length *= 1000;
      }
      if (length > most) {
        most = length;
        first = {i, k};
      }
    }
  const std::vector<Sweep> sweeps = sweeps_of(scene, body, poses);
  const auto add_way = [&](const ArmEnd& from, const ArmEnd& to) {
    const std::vector<Vector> way = bent_way(from, to, sweeps, near);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) arms.push_back({way[i], way[i + 1]});
  };
  const auto end_at = [&](std::size_t i) { return ArmEnd{places[i], axis_at(scene, body, places[i], poses)}; };
  // From the ground on.
  const bool swapped = std::ranges::any_of(scene.symbols, [&](const scene::Symbol& symbol) {
    return symbol.from < 0 && norm(on_ground(symbol.place, poses) - places[first[1]]) < near;
  });
  if (swapped) std::swap(first[0], first[1]);
  // Where they hold a body that turns between them, the arms go around it.
  std::vector<Vector> fork;
  for (const Sweep& sweep : sweeps)
    for (const Vector& place : places)
      if (fork.empty()) fork = fork_way(places[first[0]], places[first[1]], place, sweep, near);
  for (std::size_t i = 0; i + 1 < fork.size(); ++i) arms.push_back({fork[i], fork[i + 1]});
  if (fork.empty()) add_way(end_at(first[0]), end_at(first[1]));
  std::vector<bool> joined(places.size());
  joined[first[0]] = joined[first[1]] = true;
  for (std::size_t count = 2; count < places.size(); ++count) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    Vector foot{};
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (joined[i]) continue;
      // Where the first two are too near each other for an arm there is none yet.
      const double to_first = norm(places[first[0]] - places[i]);
      if (arms.empty() && to_first < least) {
        least = to_first;
        next = i;
        foot = places[first[0]];
      }
      for (const auto& arm : arms)
        if (const Vector p = nearest_on(arm, places[i]); norm(p - places[i]) < least) {
          least = norm(p - places[i]);
          next = i;
          foot = p;
        }
    }
    joined[next] = true;
    if (least > 1e-3 * scene.length) add_way(end_at(next), {foot, {}});
  }
  return arms;
}

}  // namespace poinsot::pictures
