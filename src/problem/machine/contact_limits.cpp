#include "problem/machine/contact_limits.h"

#include <algorithm>
#include <cmath>

#include "poinsot/engine/dynamics/velocity_constraint.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;

const VelocityConstraint<double>* touching(const ContactLimit& limit, const Mechanism<double>& mechanism) {
  const auto found = std::ranges::find_if(mechanism.constraints, [&](const VelocityConstraint<double>& constraint) {
    return constraint.action == limit.action && constraint.normal;
  });
  return found == mechanism.constraints.end() ? nullptr : &*found;
}

// How far along its axis a place of contact is on a surface with an end, and how fast it goes there.
struct OnSurface {
  double along, rate;
};
OnSurface along_surface(const ContactLimit::End& end, const VelocityConstraint<double>& constraint,
                        const solve::MechanismState& state) {
  const Model<double>& tree = state.mechanism().tree;
  const Workspace<double>& w = state.workspace();
  const int body = end.of_against ? constraint.from : constraint.on;
  const auto now = detail::touching_as_it_moves(tree, w, constraint);
  const Vector P = detail::value_of(end.of_against ? now.from : now.on);
  const Vector own = P - point_position(tree, w, body, end.point), axis = state.direction({body, end.axis});
  const Vector moves = detail::rate_of(end.of_against ? now.from : now.on) - detail::velocity_at(w, body, P);
  return {dot(axis, own), dot(axis, moves)};
}

}  // namespace

std::optional<double> left_of_surface(const ContactLimit& limit, const solve::MechanismState& state) {
  const VelocityConstraint<double>* constraint = touching(limit, state.mechanism());
  if (!constraint) return std::nullopt;
  const Model<double>& tree = state.mechanism().tree;
  if (limit.end) {
    const double along = along_surface(*limit.end, *constraint, state).along / limit.end->extent;
    return std::min(along, 1 - along);
  }
  if (norm(limit.middle) == 0) return std::nullopt;
  const auto reach = detail::reach_of_rolling(tree, state.workspace(), *constraint);
  if (!reach) return std::nullopt;
  return dot(normalized(*reach), state.direction({constraint->on, limit.middle})) - limit.cosine;
}

// Of a cosine and of the turning: what rounding leaves where a motion has stopped at the edge of a surface, whose place
// is found to 1e-12 of an angle and whose cosine near its end to no more than that.
constexpr double nothing = 1e-9;

bool goes_beyond(const ContactLimit& limit, const solve::MechanismState& state) {
  const std::optional<double> left = left_of_surface(limit, state);
  if (!left || *left > nothing) return false;
  const VelocityConstraint<double>& constraint = *touching(limit, state.mechanism());
  const Workspace<double>& now = state.workspace();
  if (limit.end) {
    const OnSurface on = along_surface(*limit.end, constraint, state);
    const double pace = norm(angular_velocity(now, constraint.on) - angular_velocity(now, constraint.from));
    return (2 * on.along < limit.end->extent ? on.rate : -on.rate) < -nothing * pace * limit.end->extent;
  }
  const Vector u = normalized(*detail::reach_of_rolling(state.mechanism().tree, now, constraint));
  const Vector w = angular_velocity(now, constraint.on) - angular_velocity(now, constraint.from);
  const Vector middle = state.direction({constraint.on, limit.middle});
  return dot(u, cross(w, middle)) < -nothing * norm(w);
}

bool leaves_plane(const ContactLimit& limit, const solve::MechanismState& state, double pace) {
  const VelocityConstraint<double>* constraint = touching(limit, state.mechanism());
  if (!constraint || limit.straight.empty() || constraint->carried_by) return false;
  const Workspace<double>& now = state.workspace();
  const Vector w = angular_velocity(now, constraint->on) - angular_velocity(now, constraint->from);
  const Vector n = state.direction(constraint->along);
  return std::ranges::any_of(limit.straight, [&](const Vector& side) {
    return std::abs(dot(cross(w, state.direction({constraint->on, side})), n)) > nothing * std::max(norm(w), pace);
  });
}

// With w = a n + b s, which turns a straight side s within the plane and about itself, s'' has the part
// (alpha x s + w x (w x s)) . n out of it; n turns with the body on the other side.
bool begins_to_leave_plane(const ContactLimit& limit, const solve::MechanismState& state, double pace) {
  const VelocityConstraint<double>* constraint = touching(limit, state.mechanism());
  if (!constraint || limit.straight.empty() || constraint->carried_by) return false;
  const Workspace<double>& now = state.workspace();
  const Vector from = angular_velocity(now, constraint->from), w = angular_velocity(now, constraint->on) - from;
  const Vector turning =
      angular_acceleration(now, constraint->on) - angular_acceleration(now, constraint->from) - cross(from, w);
  const Vector n = state.direction(constraint->along);
  constexpr double rounding = 1e-7;  // of accelerations, whose forces are known to some 1e-10 of the largest
  const double size = std::max({norm(turning), norm_squared(w), pace * pace});
  return std::ranges::any_of(limit.straight, [&](const Vector& side) {
    const Vector s = state.direction({constraint->on, side});
    return std::abs(dot(cross(turning, s) + cross(w, cross(w, s)), n)) > rounding * size;
  });
}

bool is_of_rod(const ContactLimit& limit, const Situation& situation) {
  const auto body = std::ranges::find(situation.bodies, limit.body, &Body::name);
  return body != situation.bodies.end() &&
         std::ranges::any_of(body->parts, [](const Part& part) { return part.shape.kind == "rod"; });
}

std::string words_of_end(const ContactLimit& limit) {
  return "contact '" + limit.contact + "' is beyond the end of the " + (limit.end ? "" : "round ") + "surface of '" +
         limit.body + "'";
}

std::string words_of_side(const ContactLimit& limit) {
  return "'" + limit.body + "' is straight where contact '" + limit.contact +
         "' is: turning as it does it would cut into a flat '" + limit.against + "'";
}

std::string hint_of_flat_side(const ContactLimit& limit) {
  return "if '" + limit.body +
         "' lies flat there, state contacts at the ends of that side, with corner: in place of at:; if it only "
         "slides, make it a particle";
}

std::string hint_of_side(const ContactLimit& limit) {
  return "if it slides over a peg or corner, state the contact from there, of: that body (a particle welded to what "
         "holds it), against: " +
         limit.body + "; if a pin of it touches, give it one: added: {pin: {particle: " + limit.place +
         ", mass: 0 kg}}";
}

}  // namespace poinsot::problem
