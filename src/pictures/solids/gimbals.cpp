#include "pictures/solids/gimbals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::pictures {
namespace {

constexpr double around = 1.2;         // the radius of a ring, of what turns in it
constexpr double off_center = 0.1;     // of what it carries, as a part of its size: a ring is around a middle
constexpr double same_place = 1e-6;    // as a part of the picture
constexpr double without_size = 0.25;  // of the picture: the radius around what has no size
constexpr int segments = 36;

class Gimbals {
 public:
  Gimbals(const scene::Scene& scene, const std::vector<scene::Pose>& poses)
      : scene_(scene), poses_(poses), found_(scene.bodies.size()), looked_(scene.bodies.size()) {}

  std::vector<std::optional<Gimbal>> all() {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) look_at(static_cast<int>(i));
    return std::move(found_);
  }

 private:
  Vector axis_of(const scene::Symbol& symbol) const {
    return normalized(turned_to_ground(symbol.to, symbol.axis, poses_));
  }

  // The ring of a body, after those that it carries.
  void look_at(int body) {
    const auto number = static_cast<std::size_t>(body);
    if (looked_[number]) return;
    looked_[number] = true;
    const scene::Body& own = scene_.bodies[number];
    if (own.frame || !(own.shapes.empty() || own.shapes.front().stand_in)) return;
    for (const scene::Symbol& outer : scene_.symbols) {
      if (outer.to != body || !turns_about_axis(outer)) continue;
      const Vector center = on_ground(outer.place, poses_);
      for (const scene::Symbol& inner : scene_.symbols) {
        if (inner.from != body || inner.to < 0 || !turns_about_axis(inner)) continue;
        const Vector other = axis_of(inner), first = axis_of(outer);
        if (norm(on_ground(inner.place, poses_) - center) > same_place * scene_.length) continue;
        if (norm(cross(first, other)) < 0.1) continue;
        look_at(inner.to);
        if (const std::optional<double> size = size_around(inner.to, center)) {
          const double radius = around * (*size > 0 ? *size : without_size * scene_.length);
          found_[number] = Gimbal{center, radius, first, normalized(other - dot(other, first) * first)};
          return;
        }
      }
    }
  }

  // Whether a body is held or holds another one elsewhere.
  bool reaches_out(int body, const Vector& center) const {
    return std::ranges::any_of(scene_.symbols, [&](const scene::Symbol& symbol) {
      return (symbol.to == body || symbol.from == body) &&
             norm(on_ground(symbol.place, poses_) - center) > same_place * scene_.length;
    });
  }

  // How far a body reaches around a point that is its middle.
  std::optional<double> size_around(int body, const Vector& center, int depth = 0) const {
    const auto number = static_cast<std::size_t>(body);
    if (found_[number]) return found_[number]->radius;
    const scene::Body& own = scene_.bodies[number];
    double size = 0;
    for (const scene::Shape& shape : own.shapes)
      for (const Vector& vertex : shape.vertices)
        size = std::max(size, norm(on_ground({body, vertex}, poses_) - center));
    if (own.massless && own.shapes.empty()) {
      constexpr int deepest = 20;
      if (reaches_out(body, center) || depth > deepest) return std::nullopt;
      for (const scene::Symbol& symbol : scene_.symbols) {
        if (symbol.from != body || symbol.to < 0) continue;
        const std::optional<double> carried = size_around(symbol.to, center, depth + 1);
        if (!carried) return std::nullopt;
        size = std::max(size, *carried);
      }
    }
    const double away = own.massless ? 0 : norm(on_ground({body, own.center}, poses_) - center);
    if (away > std::max(off_center * size, same_place * scene_.length)) return std::nullopt;
    return size;
  }

  const scene::Scene& scene_;
  const std::vector<scene::Pose>& poses_;
  std::vector<std::optional<Gimbal>> found_;
  std::vector<bool> looked_;
};

const Gimbal* ring_of(const std::vector<std::optional<Gimbal>>& gimbals, int body) {
  if (body < 0 || static_cast<std::size_t>(body) >= gimbals.size()) return nullptr;
  const std::optional<Gimbal>& ring = gimbals[static_cast<std::size_t>(body)];
  return ring ? &*ring : nullptr;
}

// The ring in which the bearings of a joint sit: that of the body that carries, or else of the one that is carried.
const Gimbal* ring_of_bearings(const scene::Scene& scene, const scene::Symbol& symbol,
                               const std::vector<std::optional<Gimbal>>& gimbals,
                               const std::vector<scene::Pose>& poses) {
  if (!turns_about_axis(symbol)) return nullptr;
  for (const int body : {symbol.from, symbol.to})
    if (const Gimbal* ring = ring_of(gimbals, body))
      if (norm(ring->center - on_ground(symbol.place, poses)) < same_place * scene.length) return ring;
  return nullptr;
}

}  // namespace

bool turns_about_axis(const scene::Symbol& symbol) {
  using enum scene::SymbolKind;
  const auto bearings = {revolute, hinge, clevis, fork, journal, thrust};
  return norm(symbol.axis) > 0 && std::ranges::find(bearings, symbol.kind) != bearings.end();
}

std::vector<std::optional<Gimbal>> gimbals_of(const scene::Scene& scene, const std::vector<scene::Pose>& poses) {
  return Gimbals(scene, poses).all();
}

std::vector<Vector> bearings_of(const scene::Scene& scene, const scene::Symbol& symbol,
                                const std::vector<std::optional<Gimbal>>& gimbals,
                                const std::vector<scene::Pose>& poses) {
  const Vector place = on_ground(symbol.place, poses);
  const Gimbal* ring = ring_of_bearings(scene, symbol, gimbals, poses);
  if (ring == nullptr) return {place};
  const Vector axis = normalized(turned_to_ground(symbol.to, symbol.axis, poses));
  return {place - ring->radius * axis, place + ring->radius * axis};
}

std::vector<std::array<Vector, 2>> gimbal_arms(const scene::Scene& scene, int body,
                                               const std::vector<std::optional<Gimbal>>& gimbals,
                                               const std::vector<scene::Pose>& poses) {
  std::vector<std::array<Vector, 2>> arms;
  const Gimbal* own = ring_of(gimbals, body);
  if (own != nullptr) {
    const auto at = [&](int k) {
      const double angle = 2 * std::numbers::pi * (k % segments) / segments;
      return own->center + own->radius * (std::cos(angle) * own->first + std::sin(angle) * own->second);
    };
    for (int k = 0; k < segments; ++k) arms.push_back({at(k), at(k + 1)});
  }
  for (const scene::Symbol& symbol : scene.symbols) {
    if (symbol.to != body) continue;
    const Gimbal* ring = ring_of(gimbals, symbol.from);
    if (ring == nullptr || ring_of_bearings(scene, symbol, gimbals, poses) != ring) continue;
    const Vector axis = normalized(turned_to_ground(symbol.to, symbol.axis, poses));
    const double inside = own != nullptr ? own->radius : 0;
    for (const double sense : {-1.0, 1.0})
      arms.push_back({ring->center + sense * inside * axis, ring->center + sense * ring->radius * axis});
  }
  return arms;
}

}  // namespace poinsot::pictures
