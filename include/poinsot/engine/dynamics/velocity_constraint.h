// The constraints of a Mechanism as lines of force: each row of J as the unit force (or couple) that the constraint
// exerts, the rate that the velocities bring, and the gap by which a constraint on positions is open.
//
// A constraint of body `on` relative to body `from` has the rate J v = f . (v_on - v_from) + c . (w_on - w_from), the
// velocities taken at one point: the power of the force f at that point and the couple c, exerted on `on` and reversed
// on `from` (principle of virtual work). Its derivative is J dv/dt + bias.
//
// A cord that is led over wheels acts between several pairs of bodies: each straight part of it between the two that it
// touches, and the rate is the sum of the powers.
//
// Decisions look at plain numbers (math/algebra/plain.h).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "poinsot/engine/dynamics/contact_surface.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/plain.h"

namespace poinsot {

template <class Scalar>
struct ConstraintLine {
  PlacedForce<Scalar> unit{};
  Scalar bias{};  // the rate of the constraint's rate at the accelerations in the workspace
};

// Whether a constraint binds positions as well; those against slipping bind velocities only.
template <class Scalar>
bool binds_positions(const VelocityConstraint<Scalar>& c) {
  return c.action < 0 || c.kind == VelocityConstraintKind::cord_length || c.normal || c.keeps_length;
}

// Whether the point at which it holds moves over the bodies.
template <class Scalar>
bool moves_over_surfaces(const VelocityConstraint<Scalar>& c) {
  return c.kind == VelocityConstraintKind::rolling || c.kind == VelocityConstraintKind::touching;
}

namespace detail {

// If this sine is less, a body of revolution lies flat on the surface and its whole circle touches.
inline constexpr double flat_sine = 1e-9;

// From the center of a rolling body's circle to where it touches, along u = b - (b . e) e (e: axis of the circle, b: of
// the surface); nothing if it lies flat. After update_poses.
template <class Scalar>
std::optional<Vector3<Scalar>> reach_of_rolling(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                                const VelocityConstraint<Scalar>& c) {
  const Vector3<Scalar> center = point_position(tree, w, c.on, c.center);
  const Vector3<Scalar> b = direction_on_ground(tree, w, c.surface_axis.body, c.surface_axis.vector);
  Vector3<Scalar> u = b;
  if (norm_squared(plain(c.axis)) > 0) {
    const Vector3<Scalar> e = direction_on_ground(tree, w, c.on, c.axis);
    u = b - dot(b, e) * e;
  }
  if (norm(plain(u)) < flat_sine) return std::nullopt;
  // The side of the center that faces the surface.
  const Vector3<Scalar> touched = point_position(tree, w, c.toward.body, c.toward.point);
  const double side = plain(dot(center - touched, b)) > 0 ? -1 : 1;
  return (Scalar(side) * c.radius) * normalized(u);
}

// Velocity of the place where a rolling body of revolution touches at r from the center of its circle.
template <class Scalar>
Vector3<Scalar> contact_velocity(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                 const VelocityConstraint<Scalar>& c, const Vector3<Scalar>& r) {
  Vector3<Scalar> center_velocity = point_velocity(tree, w, c.on, c.center);
  const Vector3<Scalar> b = direction_on_ground(tree, w, c.surface_axis.body, c.surface_axis.vector);
  const Vector3<Scalar> b_rate = cross(angular_velocity(w, c.surface_axis.body), b);
  if (norm_squared(plain(c.axis)) == 0) {
    const double side = plain(dot(r, b)) < 0 ? -1 : 1;
    return center_velocity + (Scalar(side) * norm(r)) * b_rate;
  }
  const Vector3<Scalar> e = direction_on_ground(tree, w, c.on, c.axis);
  const Vector3<Scalar> e_rate = cross(angular_velocity(w, c.on), e);
  const Scalar along = dot(b, e);
  const Vector3<Scalar> u = b - along * e;
  const Scalar size = norm(u);
  if (plain(size) < flat_sine) return center_velocity;
  const Vector3<Scalar> u_rate = b_rate - (dot(b_rate, e) + dot(b, e_rate)) * e - along * e_rate;
  const Vector3<Scalar> direction = u / size;
  const Vector3<Scalar> direction_rate = (u_rate - dot(u_rate, direction) * direction) / size;
  return center_velocity + dot(r, direction) * direction_rate;
}

// A surface of a body on ground axes, and the same with its rate as the body moves. After update_poses, and
// update_velocities for the rate.
template <class Scalar>
ContactSurface<Scalar> placed_surface(const Model<Scalar>& tree, const Workspace<Scalar>& w, int body,
                                      const ContactSurface<Scalar>& s) {
  return converted_surface<Scalar>(
      s, [&](const Vector3<Scalar>& p) { return point_position(tree, w, body, p); },
      [&](const Vector3<Scalar>& d) { return direction_on_ground(tree, w, body, d); },
      [](const Scalar& x) { return x; });
}
template <class Scalar>
Vector3<Dual<1, Scalar>> with_rate(const Vector3<Scalar>& a, const Vector3<Scalar>& rate) {
  return {{a.x, {rate.x}}, {a.y, {rate.y}}, {a.z, {rate.z}}};
}
template <class Scalar>
Vector3<Scalar> rate_of(const Vector3<Dual<1, Scalar>>& a) {
  return {a.x.partial[0], a.y.partial[0], a.z.partial[0]};
}
template <class Scalar>
Vector3<Scalar> value_of(const Vector3<Dual<1, Scalar>>& a) {
  return {a.x.value, a.y.value, a.z.value};
}
template <class Scalar>
ContactSurface<Dual<1, Scalar>> moving_surface(const Model<Scalar>& tree, const Workspace<Scalar>& w, int body,
                                               const ContactSurface<Scalar>& s) {
  const BodyMotion<Scalar>& motion = w.motion[static_cast<std::size_t>(body + 1)];
  return converted_surface<Dual<1, Scalar>>(
      s,
      [&](const Vector3<Scalar>& p) {
        const Vector3<Scalar> P = point_position(tree, w, body, p);
        return with_rate<Scalar>(P, motion.v + cross(motion.w, P - motion.p));
      },
      [&](const Vector3<Scalar>& d) {
        const Vector3<Scalar> D = direction_on_ground(tree, w, body, d);
        return with_rate<Scalar>(D, cross(motion.w, D));
      },
      [](const Scalar& x) { return Dual<1, Scalar>(x); });
}

// Where the two surfaces touch now, on ground axes.
template <class Scalar>
Touching<Scalar> touching_now(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                              const VelocityConstraint<Scalar>& c) {
  return nearest_points(placed_surface(tree, w, c.on, c.surfaces->on),
                        placed_surface(tree, w, c.from, c.surfaces->from), c.surfaces->branch);
}
// The same with the rates as the bodies move. After update_velocities.
template <class Scalar>
Touching<Dual<1, Scalar>> touching_as_it_moves(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                               const VelocityConstraint<Scalar>& c) {
  return nearest_points(moving_surface(tree, w, c.on, c.surfaces->on),
                        moving_surface(tree, w, c.from, c.surfaces->from), c.surfaces->branch);
}
// A direction of `from` that belongs to the normal as the contact knows it, turned to the present normal.
template <class Scalar>
Vector3<Scalar> with_normal(const Model<Scalar>& tree, const Workspace<Scalar>& w, const VelocityConstraint<Scalar>& c,
                            const Vector3<Scalar>& normal, const Vector3<Scalar>& d) {
  return turned_with_normal(direction_on_ground(tree, w, c.from, c.surfaces->normal),
                            direction_on_ground(tree, w, c.from, c.surfaces->tangent), normal, d);
}

// The velocity and the acceleration of the point of a body that is now at the ground point p.
template <class Scalar>
Vector3<Scalar> velocity_at(const Workspace<Scalar>& w, int body, const Vector3<Scalar>& p) {
  const BodyMotion<Scalar>& motion = w.motion[static_cast<std::size_t>(body + 1)];
  return motion.v + cross(motion.w, p - motion.p);
}
template <class Scalar>
Vector3<Scalar> acceleration_at(const Workspace<Scalar>& w, int body, const Vector3<Scalar>& p) {
  const BodyMotion<Scalar>& motion = w.motion[static_cast<std::size_t>(body + 1)];
  const Vector3<Scalar> r = p - motion.p;
  return motion.a + cross(motion.alpha, r) + cross(motion.w, cross(motion.w, r));
}

// The velocity of a contact that rests in a frame of a steady motion.
template <class Scalar>
Vector3<Scalar> carried_velocity(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                 const VelocityConstraint<Scalar>& c, const Vector3<Scalar>& P) {
  if (!c.carried_along) return velocity_at(w, *c.carried_by, P);
  const SpatialInertia<Scalar>& I = tree.body(*c.carried_along).inertia;
  const Vector3<Scalar> center = plain(I.mass) > 0 ? Vector3<Scalar>(I.first_moment / I.mass) : Vector3<Scalar>::zero();
  return point_velocity(tree, w, *c.carried_along, center) +
         cross(angular_velocity(w, *c.carried_by), P - point_position(tree, w, *c.carried_along, center));
}

}  // namespace detail

// The point at which the constraint holds the two bodies together, m; for rolling bodies of revolution the present
// point of contact. After update_poses.
template <class Scalar>
Vector3<Scalar> constraint_point(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                 const VelocityConstraint<Scalar>& c) {
  if (c.kind == VelocityConstraintKind::rolling) {
    if (const auto r = detail::reach_of_rolling(tree, w, c)) return point_position(tree, w, c.on, c.center) + *r;
  }
  if (c.kind == VelocityConstraintKind::touching) return detail::touching_now(tree, w, c).on;
  return point_position(tree, w, c.at.body, c.at.point);
}

// The unit force of the constraint, without its bias, at the point P where it holds. After update_poses.
template <class Scalar>
PlacedForce<Scalar> constraint_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                     const VelocityConstraint<Scalar>& c, const Vector3<Scalar>& P) {
  const Vector3<Scalar> none = Vector3<Scalar>::zero();
  if (c.kind == VelocityConstraintKind::cord_length) {
    const Vector3<Scalar> Q = point_position(tree, w, c.toward.body, c.toward.point);
    return {P, normalized(P - Q), none};
  }
  if (c.kind == VelocityConstraintKind::led_cord) return span_force(tree, w, c.spans.front());
  const Vector3<Scalar> d = direction_on_ground(tree, w, c.along.body, c.along.vector);
  if (c.kind == VelocityConstraintKind::angular) return {P, none, d};
  if (c.kind == VelocityConstraintKind::touching) {
    const Touching<Scalar> now = detail::touching_now(tree, w, c);
    return {now.on, detail::with_normal(tree, w, c, now.normal, d), none};
  }
  return {P, d, none};
}

// Brings the force of a contact's component to where the contact of this constraint is now: to the point, and where
// surfaces are curved with the normal. After update_poses.
template <class Scalar>
void follow_contact(const Model<Scalar>& tree, const Workspace<Scalar>& w, const VelocityConstraint<Scalar>& c,
                    PlacedForce<Scalar>& force) {
  if (c.kind == VelocityConstraintKind::rolling) force.point = constraint_point(tree, w, c);
  if (c.kind != VelocityConstraintKind::touching) return;
  const Touching<Scalar> now = detail::touching_now(tree, w, c);
  force.point = now.on;
  force.force = detail::with_normal(tree, w, c, now.normal, force.force);
}

template <class Scalar>
PlacedForce<Scalar> constraint_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                     const VelocityConstraint<Scalar>& c) {
  return constraint_force(tree, w, c, constraint_point(tree, w, c));
}

// Calls visit(on, from, PlacedForce) with each pair of bodies that the constraint acts between and its unit force
// there. After update_poses.
template <class Scalar, class Visit>
void for_each_unit_force(const Model<Scalar>& tree, const Workspace<Scalar>& w, const VelocityConstraint<Scalar>& c,
                         const PlacedForce<Scalar>& unit, Visit&& visit) {
  if (c.spans.empty()) visit(c.on, c.from, unit);
  for (const CordSpan<Scalar>& span : c.spans) visit(span.to.body(), span.from.body(), span_force(tree, w, span));
}

namespace detail {

// d/dt of u . (v_b - v_a) for the velocities of two bodies where a straight part of a cord touches them.
template <class Scalar>
Scalar bias_of_span(const Model<Scalar>& tree, const Workspace<Scalar>& w, const CordSpan<Scalar>& span) {
  const MovingSpanLine<Scalar> now = moving_line(tree, w, span);
  const auto rate = [&](int body, const Vector3<Scalar>& P, const Vector3<Scalar>& P_rate) -> Vector3<Scalar> {
    return acceleration_at(w, body, P) + cross(angular_velocity(w, body), P_rate - velocity_at(w, body, P));
  };
  const int to = span.to.body(), from = span.from.body();
  return dot(now.along_rate, velocity_at(w, to, now.line.end) - velocity_at(w, from, now.line.start)) +
         dot(now.line.along, rate(to, now.line.end, now.end_rate) - rate(from, now.line.start, now.start_rate));
}

}  // namespace detail

// The unit force of the constraint and its bias, at the point P where it holds. After update_accelerations with the
// known accelerations of the coordinates.
template <class Scalar>
ConstraintLine<Scalar> constraint_line(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                       const VelocityConstraint<Scalar>& c, const Vector3<Scalar>& P) {
  ConstraintLine<Scalar> line;
  if (c.kind != VelocityConstraintKind::touching) line.unit = constraint_force(tree, w, c, P);
  const Vector3<Scalar> w_on = angular_velocity(w, c.on), w_from = angular_velocity(w, c.from);
  switch (c.kind) {
    case VelocityConstraintKind::angular: {
      const Vector3<Scalar>& d = line.unit.couple;
      line.bias = dot(d, angular_acceleration(w, c.on) - angular_acceleration(w, c.from)) +
                  dot(cross(w_from, d), w_on - w_from);
      break;
    }
    case VelocityConstraintKind::point:
    case VelocityConstraintKind::rolling: {
      // The material points at the contact change as the contact moves over the bodies with v_contact.
      const Vector3<Scalar>& d = line.unit.force;
      const Vector3<Scalar> v_on = detail::velocity_at(w, c.on, P), v_from = detail::velocity_at(w, c.from, P);
      const Vector3<Scalar> v_contact =
          c.carried_by ? detail::carried_velocity(tree, w, c, P)
          : c.kind == VelocityConstraintKind::point
              ? detail::velocity_at(w, c.at.body, P)
              : detail::contact_velocity(tree, w, c, Vector3<Scalar>(P - point_position(tree, w, c.on, c.center)));
      const Vector3<Scalar> relative = detail::acceleration_at(w, c.on, P) + cross(w_on, v_contact - v_on) -
                                       detail::acceleration_at(w, c.from, P) - cross(w_from, v_contact - v_from);
      const Vector3<Scalar> w_direction = angular_velocity(w, c.carried_by.value_or(c.along.body));
      line.bias = dot(d, relative) + dot(cross(w_direction, d), v_on - v_from);
      break;
    }
    case VelocityConstraintKind::touching: {
      // The point and the direction move over both surfaces as their geometry has it: their rates are derivatives of
      // where the surfaces touch, while the bodies move.
      using Moving = Dual<1, Scalar>;
      const Touching<Moving> now = detail::touching_as_it_moves(tree, w, c);
      const auto carried = [&](const Vector3<Scalar>& a) {
        const Vector3<Scalar> d = direction_on_ground(tree, w, c.from, a);
        return detail::with_rate<Scalar>(d, cross(w_from, d));
      };
      const Vector3<Moving> d = turned_with_normal(carried(c.surfaces->normal), carried(c.surfaces->tangent),
                                                   now.normal, carried(c.along.vector));
      const Vector3<Scalar> C = detail::value_of(now.on), v_contact = detail::rate_of(now.on);
      line.unit = {C, detail::value_of(d), Vector3<Scalar>::zero()};
      const Vector3<Scalar> v_on = detail::velocity_at(w, c.on, C), v_from = detail::velocity_at(w, c.from, C);
      const Vector3<Scalar> relative = detail::acceleration_at(w, c.on, C) + cross(w_on, v_contact - v_on) -
                                       detail::acceleration_at(w, c.from, C) - cross(w_from, v_contact - v_from);
      line.bias = dot(line.unit.force, relative) + dot(detail::rate_of(d), v_on - v_from);
      break;
    }
    case VelocityConstraintKind::cord_length: {
      const Vector3<Scalar>& u = line.unit.force;
      const Vector3<Scalar> Q = point_position(tree, w, c.toward.body, c.toward.point);
      const Vector3<Scalar> relative = detail::velocity_at(w, c.on, P) - detail::velocity_at(w, c.from, Q);
      const Scalar lengthening = dot(u, relative);
      line.bias = dot(u, detail::acceleration_at(w, c.on, P) - detail::acceleration_at(w, c.from, Q)) +
                  (norm_squared(relative) - lengthening * lengthening) / norm(P - Q);
      break;
    }
    case VelocityConstraintKind::led_cord:
      for (const CordSpan<Scalar>& span : c.spans) line.bias += detail::bias_of_span(tree, w, span);
      break;
  }
  return line;
}
template <class Scalar>
ConstraintLine<Scalar> constraint_line(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                       const VelocityConstraint<Scalar>& c) {
  // Where surfaces are curved, the point is found together with its rate.
  if (c.kind == VelocityConstraintKind::touching) return constraint_line(tree, w, c, Vector3<Scalar>::zero());
  return constraint_line(tree, w, c, constraint_point(tree, w, c));
}

// The axis, on the axes of `from`, about which a joint that closes a loop lets the bodies turn. The joint has two
// angular constraints perpendicular to it. Nothing if the joint forbids other rotations than these two.
template <class Scalar>
std::optional<Vector3<Scalar>> axis_left_free(const std::vector<VelocityConstraint<Scalar>>& constraints,
                                              std::size_t index) {
  const VelocityConstraint<Scalar>& own = constraints[index];
  const auto of_joint = [&](const VelocityConstraint<Scalar>& c) {
    return c.kind == VelocityConstraintKind::angular && c.on == own.on && c.from == own.from &&
           c.action == own.action && norm_squared(plain(c.at.point - own.at.point)) == 0;
  };
  std::optional<Vector3<Scalar>> axis;
  int others = 0;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (i == index || !of_joint(constraints[i])) continue;
    axis = normalized(cross(own.along.vector, constraints[i].along.vector));
    ++others;
  }
  return others == 1 ? axis : std::nullopt;
}

// By how much a constraint is open, m or rad. Where it is closed, the derivative is the constraint's rate. free_axis:
// the result of axis_left_free, for angular constraints. After update_poses.
template <class Scalar>
Scalar constraint_gap(const Model<Scalar>& tree, const Workspace<Scalar>& w, const VelocityConstraint<Scalar>& c,
                      const std::optional<Vector3<Scalar>>& free_axis) {
  using std::atan2;
  using std::sqrt;
  switch (c.kind) {
    case VelocityConstraintKind::angular: {
      // The smallest rotation vector from the closed to the present pose. As drawn, the axes of the bodies coincide.
      const Matrix3<Scalar> R = transpose(body_rotation(tree, w, c.from)) * body_rotation(tree, w, c.on);
      Vector3<Scalar> turn;  // its direction, of length sine
      Scalar cosine;
      if (free_axis) {
        turn = cross(*free_axis, R * *free_axis);
        cosine = dot(*free_axis, R * *free_axis);
      } else {
        turn = Scalar(0.5) * Vector3<Scalar>{R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
        cosine = Scalar(0.5) * (R(0, 0) + R(1, 1) + R(2, 2) - Scalar(1));
      }
      Scalar along = dot(c.along.vector, turn);
      if (norm(plain(turn)) < 1e-12) return along;
      const Scalar sine = norm(turn);
      return (atan2(sine, cosine) / sine) * along;
    }
    case VelocityConstraintKind::point: {
      const Vector3<Scalar> d = direction_on_ground(tree, w, c.along.body, c.along.vector);
      return dot(
          d, point_position(tree, w, c.at.body, c.at.point) - point_position(tree, w, c.toward.body, c.toward.point));
    }
    case VelocityConstraintKind::cord_length:
      return norm(point_position(tree, w, c.at.body, c.at.point) -
                  point_position(tree, w, c.toward.body, c.toward.point)) -
             c.length;
    case VelocityConstraintKind::led_cord: {
      Scalar length = -c.length;
      std::optional<Vector3<Scalar>> before;
      for (const CordSpan<Scalar>& span : c.spans) {
        const SpanLine<Scalar> line = line_of(tree, w, span);
        length += line.length;
        if (before) length += taken_up(tree, w, span, *before, line.along);
        before = line.along;
      }
      return length;
    }
    case VelocityConstraintKind::rolling: {
      const Vector3<Scalar> n = direction_on_ground(tree, w, c.along.body, c.along.vector);
      Scalar reach = c.radius;
      if (norm_squared(plain(c.axis)) > 0) {
        // Of the circle's sine to the surface.
        const Vector3<Scalar> across = cross(n, direction_on_ground(tree, w, c.on, c.axis));
        if (norm(plain(across)) < detail::flat_sine)
          reach = Scalar(0);
        else
          reach = reach * norm(across);
      }
      const Scalar height =
          dot(n, point_position(tree, w, c.on, c.center) - point_position(tree, w, c.toward.body, c.toward.point));
      return plain(height) < 0 ? height + reach : height - reach;
    }
    case VelocityConstraintKind::touching: {
      const Touching<Scalar> now = detail::touching_now(tree, w, c);
      return dot(now.normal, now.on - now.from);
    }
  }
  return Scalar(0);
}

}  // namespace poinsot
