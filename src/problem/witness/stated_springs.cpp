#include "problem/witness/stated_springs.h"

#include <algorithm>
#include <cmath>

namespace poinsot::problem {
namespace {

using Real = DrawnSpring::Real;
using Vector = DrawnSpring::Vector;

// A sine: axes that are the same but for data stated to nine digits.
constexpr Real same_axis = 1e-9L;

Dimension effort_of(bool turning) { return turning ? dimensions::moment : dimensions::force; }
Dimension extent_of(bool turning) { return turning ? dimensions::angle : dimensions::length; }
Dimension stiffness_of(bool turning) { return effort_of(turning) / extent_of(turning); }

}  // namespace

double StatedSprings::stiffness(const Spring& spring) const {
  return number(spring.stiffness, stiffness_of(spring.about.has_value()));
}
double StatedSprings::damping(const Spring& spring) const {
  return number(spring.damping, stiffness_of(spring.about.has_value()) * dimensions::time);
}
double StatedSprings::stiffness(const Freedom& freedom) const {
  return number(freedom.stiffness, stiffness_of(freedom.turning));
}
double StatedSprings::damping(const Freedom& freedom) const {
  return number(freedom.damping, stiffness_of(freedom.turning) * dimensions::time);
}

std::optional<DrawnSpring> StatedSprings::drawn(const Spring& spring) const {
  return spring.about ? twisted(spring) : between_points(spring);
}

std::optional<DrawnSpring> StatedSprings::drawn(const Joint& joint, const Freedom& freedom) const {
  const Name* name = freedom.position ? freedom.position->as<Name>() : nullptr;
  const auto coordinate = std::ranges::find_if(machine_.coordinates, [&](const NamedCoordinate& one) {
    return one.joint == joint.name && (joint.freedoms.size() == 1 || (name && one.name == name->name));
  });
  if (coordinate == machine_.coordinates.end()) return std::nullopt;
  const Real x = machine_.q[static_cast<std::size_t>(coordinate->position)],
             free = number(freedom.free_position, extent_of(freedom.turning));
  DrawnSpring found;
  found.out = x - free;
  found.rate = v_[static_cast<std::size_t>(coordinate->velocity)];
  found.size = std::abs(x) + std::abs(free);
  return found;
}

DrawnSpring StatedSprings::between_points(const Spring& spring) const {
  const int to = machine_.index.at(spring.to), from = machine_.index.at(spring.from);
  const Vector start = widened(data_.place(*spring.at)), end = widened(data_.place(*spring.end));
  const Real as_drawn = norm(end - start);
  Real free = as_drawn;
  if (spring.free_length)
    free = number(spring.free_length, dimensions::length);
  else if (spring.stiffness)
    free -= Real(number(spring.tension, dimensions::force)) / Real(stiffness(spring));
  const Vector P = paths_.place(from, start), Q = paths_.place(to, end);
  const Real length = norm(Q - P);
  const Vector hastens = paths_.velocity(to, Q, -1) - paths_.velocity(from, P, -1);
  DrawnSpring found;
  found.out = length - free;
  found.end = Q;
  if (length > 0) {
    found.along = (Q - P) / length;
    found.rate = dot(hastens, found.along);
  }
  found.size = length + free + as_drawn;
  return found;
}

std::optional<DrawnSpring> StatedSprings::twisted(const Spring& spring) const {
  const int to = machine_.index.at(spring.to), from = machine_.index.at(spring.from);
  const Vector u = normalized(widened(data_.direction(*spring.about)));
  const Vector now = paths_.turn(from) * u;
  if (norm(cross(now, paths_.turn(to) * u)) > same_axis) return std::nullopt;
  // Any arm across the axis shows how far one body has turned beyond the other.
  Vector arm = cross(u, Vector::unit(0));
  if (norm(arm) < Real(0.5)) arm = cross(u, Vector::unit(1));
  const Vector one = paths_.turn(from) * arm, other = paths_.turn(to) * arm;
  const Real angle = std::atan2(dot(now, cross(one, other)), dot(one, other));
  const Real free = number(spring.free_angle, dimensions::angle);
  DrawnSpring found;
  found.out = angle - free;
  found.rate = dot(now, paths_.angular_velocity(to, -1) - paths_.angular_velocity(from, -1));
  found.size = std::abs(angle) + std::abs(free);
  found.along = now;
  return found;
}

}  // namespace poinsot::problem
