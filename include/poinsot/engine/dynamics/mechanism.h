// A tree of bodies with all that acts between them: what joints, supports, contacts and cords can carry, the
// constraints beyond the tree, springs, drives and loads.
//
// Bodies are indices into the tree, or `ground`. Points and directions that move with a body: see place.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/dynamics/drive_law.h"
#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/load_law.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/dynamics/spring_law.h"
#include "poinsot/engine/dynamics/torsion_law.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

enum class ActionKind { joint, support, drive, contact, cord, spring, load, impulse, impact };

// Whether a law of force (force_law.h) says what it exerts; a drive's law says a part of it.
constexpr bool has_law(ActionKind kind) { return kind == ActionKind::spring || kind == ActionKind::load; }

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

template <class Scalar>
struct Mechanism {
  Model<Scalar> tree = Model<Scalar>({}, {}, {}, Vector3<Scalar>::zero());
  std::vector<bool> takes_part;  // for each body, whether the forces on it must balance (frames move as stated)
  std::vector<std::string> coordinate_names;  // of each velocity coordinate, in words
  std::vector<Action> actions;
  std::vector<Component<Scalar>> components;
  std::vector<VelocityConstraint<Scalar>> constraints;
  std::vector<Drive<Scalar>> drives;
  // The laws of force, a list of each kind.
  std::vector<KnownForce<Scalar>> forces;
  std::vector<SpringLaw<Scalar>> springs;
  std::vector<TorsionLaw<Scalar>> torsions;
};

// Visits the lists of laws, of several mechanisms side by side: the one place that names them all.
template <class Visit, class... Mechanisms>
void for_each_law_list(Visit&& visit, Mechanisms&... mechanisms) {
  visit(mechanisms.forces...);
  visit(mechanisms.springs...);
  visit(mechanisms.torsions...);
}

// Visits every law of force.
template <class Scalar, class Visit>
void for_each_law(const Mechanism<Scalar>& mechanism, Visit&& visit) {
  for_each_law_list(
      [&]<ForceLaw<Scalar> Law>(const std::vector<Law>& laws) {
        for (const Law& law : laws) visit(law);
      },
      mechanism);
}

}  // namespace poinsot
