// A tree of bodies with all that acts between them: what joints, supports, contacts and cords can carry, the
// constraints beyond the tree, springs, drives and loads.
//
// Bodies are indices into the tree, or `ground`. Points and directions that move with a body are given on its axes,
// points from its origin.
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

// What one thing exerts on body `on`, and with opposite sign on body `from`.
struct Action {
  ActionKind kind = ActionKind::load;
  std::string name;   // of the joint, support, contact, cord, spring or load
  std::string joint;  // for supports and drives: the joint that they belong to
  int on = ground;
  int from = ground;
};

// A component that an action may have, of unknown size: a force at a place along a direction, or a couple about it.
template <class Scalar>
struct Component {
  int action = 0;
  std::string axis;  // the name of its direction, for messages
  bool couple = false;
  bool one_sided = false;  // whether it can only be positive, as a cord pulls and a contact pushes
  Place<Scalar> at;
  Direction<Scalar> along;
  std::optional<Place<Scalar>> toward;  // of a cord: the force at `at` is directed towards this place
  Scalar couple_per_force{};            // of a screw: the couple per unit force, m
};

enum class VelocityConstraintKind {
  angular,     // the relative angular velocity about `along` is zero
  point,       // the relative velocity along `along` is zero at a point fixed in body `on`
  rolling,     // the same, where the point of contact moves over a body of revolution
  cord_length  // the distance between `at` and `toward` is constant
};

// One scalar condition on the motion of `on` relative to `from`; `along` moves with `from`.
template <class Scalar>
struct VelocityConstraint {
  VelocityConstraintKind kind = VelocityConstraintKind::point;
  // Whether it is unknown how the point of contact moves, so that this is good for velocities only.
  bool shape_unknown = false;
  // In a steady motion: the body or frame in which the place and the directions of the contact rest, whatever the
  // curvature of the surfaces.
  std::optional<int> carried_by{};
  std::optional<int> carried_along{};  // if that frame only turns: the body with whose mass center the contact moves
  int action = -1;                     // the cord or contact that it belongs to; -1 for a joint
  std::string words;                   // "rolling at floor, along y"
  int on = ground;
  int from = ground;
  Place<Scalar> at;         // moves with `on`
  Direction<Scalar> along;  // moves with `from`
  Place<Scalar> toward;     // the same point, or the other end of the cord; moves with `from`
  Scalar length{};          // of a cord: as drawn, m
  bool normal = false;      // whether it is along the normal of a contact
  // For rolling: the circle of `on` (center, unit axis, radius) that touches, or a sphere (zero axis), and the axis
  // of the surface of revolution on `from` (for a plane its normal).
  Vector3<Scalar> center{}, axis{};
  Scalar radius{};
  Direction<Scalar> surface_axis;
};

// A load: a given force or couple.
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

// One velocity coordinate of a joint, and the effort in it.
template <class Scalar>
struct Drive {
  int action = 0;
  int coordinate = 0;  // velocity coordinate in the tree
  int position = 0;    // position coordinate in the tree
  bool turning = true;
  Place<Scalar> at;
  Direction<Scalar> along;
  // The axes of the other rotations of the joint, at most two. The couple does no work on them, as in gimbals.
  std::vector<Direction<Scalar>> others{};
  bool held = false;  // whether its motion is given, so that the effort is unknown
  Scalar effort{};    // the known couple or force of `from` on `on`
  Scalar stiffness{}, free_position{}, damping{};
};

template <class Scalar>
struct Mechanism {
  Model<Scalar> tree = Model<Scalar>({}, {}, {}, Vector3<Scalar>::zero());
  std::vector<bool> takes_part;  // for each body, whether the forces on it must balance (frames move as stated)
  std::vector<std::string> coordinate_names;  // of each velocity coordinate, in words
  std::vector<Action> actions;
  std::vector<Component<Scalar>> components;
  std::vector<VelocityConstraint<Scalar>> constraints;
  std::vector<KnownForce<Scalar>> forces;
  std::vector<SpringLaw<Scalar>> springs;
  std::vector<Drive<Scalar>> drives;
};

}  // namespace poinsot
