// From a stated problem with values to a mechanism: bodies, frames and joints become a tree, everything else acts on
// it.
//
// Scalar: double, or Dual<1> to know how everything varies with one number of the statement. What is decided on the way
// is decided on plain numbers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/model/mechanism.h"
#include "poinsot/engine/solve/instant/impulse.h"
#include "poinsot/engine/solve/instant/particle_check.h"
#include "problem/machine/data.h"
#include "problem/machine/masses.h"

namespace poinsot::problem {

// A coordinate that has a name in the statement, or belongs to a joint of one freedom.
struct NamedCoordinate {
  std::string name;  // "" if only its joint names it
  std::string joint;
  int position = 0;  // in q
  int velocity = 0;  // in v
  bool turning = true;
  Mark mark;
};

// The rate or acceleration of a coordinate as the statement gives it.
template <class Scalar>
struct StatedRateOf {
  std::string words;
  int velocity = 0;
  Scalar value{};
  bool turning = true;
  Mark mark;
};
using StatedRate = StatedRateOf<double>;

template <class Scalar>
struct JointPlaceOf {
  Place<Scalar> at;  // rides with the held body
  std::optional<Direction<Scalar>> axis;
  int from = ground, to = ground;
};
using JointPlace = JointPlaceOf<double>;

// An impulse on a body in any pose; `absorbed`: mass of a particle that stays in the body at the place.
template <class Scalar>
struct StatedImpulseOf {
  int action = 0;
  int on = ground;
  bool couple = false;
  Place<Scalar> at;
  Vector3<Scalar> vector{};  // on the axes of `axes`
  int axes = ground;
  Scalar absorbed{};
  Scalar particle_mass{};          // of a strike
  std::optional<int> relative_to;  // of a strike: the vector is the particle's mass times its velocity relative to this
  Scalar kept{};                   // of a strike: the part of its momentum relative to the body that it keeps
};
using StatedImpulse = StatedImpulseOf<double>;

// Where a contact is good, on the axes of its body as drawn.
struct ContactLimit {
  std::string contact, body, against;
  std::string place;  // as the statement names it
  int action = 0;
  Mark mark;
  Vector3<double> middle{};               // of a round surface that ends, seen from its center; zero: it has no end
  double cosine = -1;                     // of the angle from there to where it ends
  std::vector<Vector3<double>> straight;  // in which directions the body is straight at the contact and lies on a plane
};

template <class Scalar>
struct MachineOf {
  Mechanism<Scalar> mechanism;
  std::vector<solve::CheckLink> links;                     // of each body of the tree, as drawn; for the check
  std::map<std::string, int> index;                        // of bodies and frames, and "ground"
  std::map<int, Vector3<Scalar>> drawn_origin;             // of each tree body, on ground axes
  std::vector<std::pair<int, BodyMassOf<Scalar>>> masses;  // of each body of the statement
  std::vector<NamedCoordinate> coordinates;
  std::vector<Scalar> q;             // positions that the data give; the rest as drawn
  std::vector<bool> position_given;  // of each entry of q
  std::vector<StatedRateOf<Scalar>> rates, accelerations;
  std::vector<StatedImpulseOf<Scalar>> impulses;
  std::vector<solve::ImpactOf<Scalar>> impacts;
  // The tree after a blow in which particles stay: they belong to their bodies. Its bodies and coordinates are the
  // same.
  std::optional<Model<Scalar>> struck_tree;
  std::vector<ContactLimit> contact_limits;
  std::map<std::string, JointPlaceOf<Scalar>> joints;
  std::vector<std::string> loop_joints;  // joints that close loops

  const Model<Scalar>& tree_after_blow() const { return struck_tree ? *struck_tree : mechanism.tree; }
  // The place that a point as drawn takes on a body.
  Place<Scalar> place(int body, const Vector3<Scalar>& drawn) const;
  const NamedCoordinate* coordinate(const std::string& name) const;
  // The actions that the name stands for: joints with their supports and drives, supports, contacts, cords, springs.
  std::vector<std::size_t> actions_of(const std::string& name, const std::string& joint = "") const;
};
using Machine = MachineOf<double>;

struct MachineOptions {
  bool lenient = false;                           // unknowns have trial values
  double time = 0;                                // s
  Vector3<double> open_gravity{};                 // taken if the statement says nothing of gravity
  std::optional<std::vector<std::string>> loads;  // those that act; all when left out
};

// The mass properties of the bodies, in the order of the file. Throws StatementError.
template <class Scalar>
std::vector<BodyMassOf<Scalar>> body_masses(const Situation& situation, DataScope<Scalar>& data, const AnyValue& any,
                                            const MachineOptions& options);
// data and timed must have been made for the same problem and time, and vary in the same way. Throws StatementError.
template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, DataScope<Scalar>& data,
                                DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options);
// The same with masses that are known already.
template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, std::vector<BodyMassOf<Scalar>> masses,
                                DataScope<Scalar>& data, DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options);

extern template struct MachineOf<double>;
extern template struct MachineOf<Dual<1>>;

}  // namespace poinsot::problem
