// The constraints of a Mechanism as lines of force: each row of J as the unit force (or couple) that the constraint
// exerts, the rate that the velocities bring, and the gap by which a constraint on positions is open.
//
// A constraint of body `on` relative to body `from` has the rate J v = f . (v_on - v_from) + c . (w_on - w_from), the
// velocities taken at one point: the power of the force f at that point and the couple c, exerted on `on` and reversed
// on `from` (principle of virtual work). Its derivative is J dv/dt + bias.
//
// Decisions look at plain numbers (math/algebra/plain.h).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

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
  return c.action < 0 || c.kind == VelocityConstraintKind::cord_length || c.normal;
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
  const Vector3<Scalar> d = direction_on_ground(tree, w, c.along.body, c.along.vector);
  if (c.kind == VelocityConstraintKind::angular) return {P, none, d};
  return {P, d, none};
}

template <class Scalar>
PlacedForce<Scalar> constraint_force(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                     const VelocityConstraint<Scalar>& c) {
  return constraint_force(tree, w, c, constraint_point(tree, w, c));
}

// The unit force of the constraint and its bias, at the point P where it holds. After update_accelerations with the
// known accelerations of the coordinates.
template <class Scalar>
ConstraintLine<Scalar> constraint_line(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                       const VelocityConstraint<Scalar>& c, const Vector3<Scalar>& P) {
  ConstraintLine<Scalar> line{constraint_force(tree, w, c, P), Scalar(0)};
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
              ? v_on
              : detail::contact_velocity(tree, w, c, Vector3<Scalar>(P - point_position(tree, w, c.on, c.center)));
      const Vector3<Scalar> relative = detail::acceleration_at(w, c.on, P) + cross(w_on, v_contact - v_on) -
                                       detail::acceleration_at(w, c.from, P) - cross(w_from, v_contact - v_from);
      const Vector3<Scalar> w_direction = c.carried_by ? Vector3<Scalar>(angular_velocity(w, *c.carried_by)) : w_from;
      line.bias = dot(d, relative) + dot(cross(w_direction, d), v_on - v_from);
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
  }
  return line;
}
template <class Scalar>
ConstraintLine<Scalar> constraint_line(const Model<Scalar>& tree, const Workspace<Scalar>& w,
                                       const VelocityConstraint<Scalar>& c) {
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
  }
  return Scalar(0);
}

}  // namespace poinsot
