// A tree of bodies with all that acts between them: what joints, supports, contacts and cords can carry, the
// constraints beyond the tree, springs, drives and loads.
//
// Bodies are indices into the tree, or `ground`. Points and directions ride with a body: they are given on its axes
// from its origin.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/model/model.h"

namespace poinsot {

template <class Scalar>
struct Place {
  int body = ground;
  Vector3<Scalar> point{};
};

// A unit vector.
template <class Scalar>
struct Direction {
  int body = ground;
  Vector3<Scalar> vector{};
};

enum class ActionKind { joint, support, drive, contact, cord, spring, load, impulse, impact };

// What one thing exerts on body `on` and, reversed, on body `from`.
struct Action {
  ActionKind kind = ActionKind::load;
  std::string name;   // of the joint, support, contact, cord, spring or load
  std::string joint;  // for supports and drives: the joint that they belong to
  int on = ground;
  int from = ground;
};

// A component that an action can have, of unknown size: a force at a place along a direction, or a couple about it.
template <class Scalar>
struct Component {
  int action = 0;
  std::string axis;  // the name of its direction, for messages
  bool couple = false;
  bool one_sided = false;  // it can only be positive: a cord pulls, a contact pushes
  Place<Scalar> at;
  Direction<Scalar> along;
  std::optional<Place<Scalar>> toward;  // a cord: the force acts at `at` towards this place
  Scalar couple_per_force{};            // a screw: the couple that goes with the force, m
};

enum class VelocityConstraintKind {
  angular,     // no relative angular velocity about `along`
  point,       // no relative velocity along `along` at a point fixed in body `on`
  rolling,     // the same where the contact point moves over a body of revolution
  cord_length  // constant distance between `at` and `toward`
};

// One scalar condition on the motion of `on` relative to `from`; `along` rides with `from`.
template <class Scalar>
struct VelocityConstraint {
  VelocityConstraintKind kind = VelocityConstraintKind::point;
  bool shape_unknown = false;  // how the contact point moves cannot be told: good for velocities only
  // In a steady motion: the body or frame in which place and directions of the contact rest, however the surfaces are
  // curved.
  std::optional<int> carried_by{};
  std::optional<int> carried_along{};  // where that only turns: the body whose mass center carries the contact along
  int action = -1;                     // the cord or contact that it belongs to; -1: a joint
  std::string words;                   // "rolling at floor, along y"
  int on = ground;
  int from = ground;
  Place<Scalar> at;         // rides with `on`
  Direction<Scalar> along;  // rides with `from`
  Place<Scalar> toward;     // the same point, or the cord's other end, riding with `from`
  Scalar length{};          // cord_length: as drawn, m
  bool normal = false;      // of a contact: the direction in which it touches
  // rolling: the circle of `on` (center, unit axis, radius) that touches, or a sphere (axis zero), and the axis of the
  // surface of revolution on `from` (a plane's normal).
  Vector3<Scalar> center{}, axis{};
  Scalar radius{};
  Direction<Scalar> surface_axis;
};

// A load or spring force of known law.
template <class Scalar>
struct KnownForce {
  int action = 0;
  bool couple = false;
  Place<Scalar> at;          // for a force
  Vector3<Scalar> vector{};  // size and direction on the axes of `axes`
  int axes = ground;
};
template <class Scalar>
struct SpringLaw {
  int action = 0;
  Place<Scalar> at, toward;  // at on `on`, toward on `from`
  Scalar stiffness{}, free_length{}, damping{};
};

// One velocity coordinate of a joint, with its force side.
template <class Scalar>
struct Drive {
  int action = 0;
  int coordinate = 0;  // velocity coordinate in the tree
  int position = 0;    // position coordinate in the tree
  bool turning = true;
  Place<Scalar> at;
  Direction<Scalar> along;
  // The axes of the other turnings of its joint, at most two: its couple does no work on them, as in gimbals.
  std::vector<Direction<Scalar>> others{};
  bool held = false;  // its motion is given: the effort is unknown
  Scalar effort{};    // known couple or force of `from` on `on`
  Scalar stiffness{}, free_position{}, damping{};
};

template <class Scalar>
struct Mechanism {
  Model<Scalar> tree = Model<Scalar>({}, {}, {}, Vector3<Scalar>::zero());
  std::vector<bool> takes_part;  // of each body: whether forces on it must balance (frames are moved as stated)
  std::vector<std::string> coordinate_names;  // of each velocity coordinate, in words
  std::vector<Action> actions;
  std::vector<Component<Scalar>> components;
  std::vector<VelocityConstraint<Scalar>> constraints;
  std::vector<KnownForce<Scalar>> forces;
  std::vector<SpringLaw<Scalar>> springs;
  std::vector<Drive<Scalar>> drives;
};

}  // namespace poinsot
