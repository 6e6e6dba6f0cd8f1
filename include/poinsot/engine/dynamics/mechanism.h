// A tree of bodies with all that acts between them: what joints, supports, contacts and cords can carry, the
// constraints beyond the tree, springs, drives and loads.
//
// Bodies are indices into the tree, or `ground`. Points and directions that move with a body: see place.h.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/dynamics/attraction_law.h"
#include "poinsot/engine/dynamics/contact_surface.h"
#include "poinsot/engine/dynamics/cord_span.h"
#include "poinsot/engine/dynamics/drive_law.h"
#include "poinsot/engine/dynamics/force_law.h"
#include "poinsot/engine/dynamics/load_law.h"
#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/dynamics/spring_law.h"
#include "poinsot/engine/dynamics/torsion_law.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

enum class ActionKind {
  joint,
  support,
  drive,
  contact,
  mesh,
  cord,
  spring,
  load,
  impulse,
  impact,
  friction,
  attraction
};

// Whether a law of force (force_law.h) says what it exerts; a drive's law says a part of it.
constexpr bool has_law(ActionKind kind) {
  return kind == ActionKind::spring || kind == ActionKind::load || kind == ActionKind::attraction;
}

// What one thing exerts on body `on`, and with opposite sign on body `from`.
struct Action {
  ActionKind kind = ActionKind::load;
  std::string name;   // of the joint, support, contact, cord, spring or load; "gravity" for the pull of a center
  std::string joint;  // for supports, drives and friction in joints: the joint that they belong to
  int on = ground;
  int from = ground;
};

// Whether two actions hold and give way together: the straight parts of one cord.
inline bool act_together(const Action& a, const Action& b) {
  return a.kind == ActionKind::cord && b.kind == ActionKind::cord && a.name == b.name;
}

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
  // Of a cord led over wheels: its straight part, which pulls `at` towards `toward` where these lie as drawn.
  std::optional<CordSpan<Scalar>> span{};
  // Where its size is a fixed part of another's, as the tension of a cord behind a smooth wheel is the one before it:
  // the index of that component, which stands before it with none but its like between them, and the part.
  int follows = -1;
  Scalar part{1};
  // What it is beyond that part: the sides of a belt together keep its initial tension.
  Scalar offset{};
  // Where it follows across a wheel on which the cord slips (capstan.h): mu, or -mu where it slips back; and the angle
  // round that wheel as drawn.
  Scalar gain{}, wrap{};
  // Of teeth, whose flanks lean and rub, so that what they exert beside the force that turns the wheels is a part of
  // its size, whichever way that acts: the sign of that force, by which it is known which flanks carry. 0 where it is
  // not known: then this one has a size of its own.
  bool parts_wheels = false;
  int flank = 1;
  bool rubs = false;  // whether it is the friction of teeth that slide; what only pushes wheels apart does no work

  // Which part of the other's value its own is.
  Scalar followed_part() const { return parts_wheels ? Scalar(flank) * part : part; }
};

// Calls visit with each component that follows a component, and with that itself.
template <class Scalar, class Visit>
void for_each_follower(const std::vector<Component<Scalar>>& components, std::size_t index, Visit&& visit) {
  visit(index);
  for (std::size_t k = index + 1; k < components.size() && components[k].follows == static_cast<int>(index); ++k)
    visit(k);
}

enum class VelocityConstraintKind {
  angular,      // the relative angular velocity about `along` is zero
  point,        // the relative velocity along `along` is zero at a point, which moves with a body of its own
  rolling,      // the same, where the point of contact moves over a body of revolution
  cord_length,  // the distance between `at` and `toward` is constant
  led_cord,     // the straight parts of a cord grow by nothing together, measured where it touches what it is led over
  touching      // as rolling, where the point moves over two curved surfaces, and `along` turns with their normal
};

// One scalar condition on the motion of `on` relative to `from`. Of contacts `at` moves with `on` and `along` with
// `from`; where teeth of gears meet both move with the arm that carries them, and a knife edge keeps its direction.
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
  Place<Scalar> at;
  Direction<Scalar> along;
  Place<Scalar> toward;  // the same point, or the other end of the cord; moves with `from`
  Scalar length{};       // of a cord: as drawn, m
  bool normal = false;   // whether it is along the normal of a contact
  // For rolling: the circle of `on` (center, unit axis, radius) that touches, or a sphere (zero axis), and the axis
  // of the surface of revolution on `from` (for a plane its normal).
  Vector3<Scalar> center{}, axis{};
  Scalar radius{};
  Direction<Scalar> surface_axis;
  // Of a cord led over wheels: its straight parts in their order. Where no end of it winds on a wheel, `length` is that
  // of all its straight parts as drawn, and stays so but for what the wheels take up.
  std::vector<CordSpan<Scalar>> spans;
  bool keeps_length = false;
  // For touching: the two surfaces; `along` belongs to the normal that stands there.
  std::shared_ptr<const CurvedContact<Scalar>> surfaces;
};

// Whether it is the length of a cord: what grows where the cord is too short.
template <class Scalar>
bool is_cord_length(const VelocityConstraint<Scalar>& c) {
  return c.kind == VelocityConstraintKind::cord_length || c.keeps_length;
}

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
  std::vector<AttractionLaw<Scalar>> attractions;
};

// Visits the lists of laws, of several mechanisms side by side: the one place that names them all.
template <class Visit, class... Mechanisms>
void for_each_law_list(Visit&& visit, Mechanisms&... mechanisms) {
  visit(mechanisms.forces...);
  visit(mechanisms.springs...);
  visit(mechanisms.torsions...);
  visit(mechanisms.attractions...);
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
