// Builds the mechanism of a situation: bodies, frames and joints become a tree, and everything else acts on it.
//
// The scalar is double, Formula, or Dual<1> to see how everything varies with one number of the file. Decisions are
// taken on plain numbers.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/solve/instant/impulse.h"
#include "poinsot/engine/solve/instant/particle_check.h"
#include "problem/machine/data.h"
#include "problem/machine/masses.h"

namespace poinsot::problem {

// A coordinate that has a name in the file, or belongs to a joint of one freedom.
struct NamedCoordinate {
  std::string name;  // "" if only its joint names it
  std::string joint;
  int position = 0;  // in q
  int velocity = 0;  // in v
  bool turning = true;
  Mark mark;
};

// The rate or acceleration of a coordinate as it is stated.
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
  Place<Scalar> at;  // moves with the held body
  std::optional<Direction<Scalar>> axis;
  int from = ground, to = ground;
};
using JointPlace = JointPlaceOf<double>;

// An impulse on a body. If `absorbed` is not zero it is the mass of a particle that stays in the body at the place.
template <class Scalar>
struct StatedImpulseOf {
  int action = 0;
  int on = ground;
  bool couple = false;
  Place<Scalar> at;
  Vector3<Scalar> vector{};  // on the axes of the body `axes`
  int axes = ground;
  Scalar absorbed{};
  Scalar particle_mass{};  // if it comes from a strike
  // For a strike: `vector` is the particle's mass times its velocity relative to this body or frame.
  std::optional<int> relative_to;
  Scalar kept{};  // for a strike: the part of its momentum relative to the body that the particle keeps
};
using StatedImpulse = StatedImpulseOf<double>;

// The limits within which a contact holds, on the axes of its body as drawn.
struct ContactLimit {
  std::string contact, body, against;
  std::string place;  // as the statement names it
  int action = 0;
  Mark mark;
  Vector3<double> middle{};  // the direction from the center of a round surface to its middle; zero if it has no end
  double cosine = -1;        // of the angle between the middle and the end
  // The directions in which the body is straight at the contact and lies on a plane.
  std::vector<Vector3<double>> straight;
  // Of a curved surface (contact kind `touching`): the place must lie between this point and as far along the axis, on
  // the body's axes from its origin; and whether the body is the one that the contact is against.
  struct End {
    Vector3<double> point{}, axis{};
    double extent = 0;
    bool of_against = false;
  };
  std::optional<End> end{};

  bool ends() const { return end.has_value() || norm(middle) > 0; }
};

// The name of what holds the bodies of a planar problem in their plane. No file can name it.
inline constexpr const char* hold_of_plane = "the plane";

// What presses in a joint whose friction follows from what it carries: a vector V that is linear in the unknown forces,
// of which the coefficient times |V| resists (quantities/joint_pressing.h).
template <class Scalar>
struct PressingPart {
  enum class Form { across, along, end, thread, whole };
  Form form = Form::across;
  int action = 0;                         // whose forces press
  Scalar lever{1};                        // m for couples; of a guide 1
  Scalar over_length{};                   // of an end at which it bears: 1/L or -1/L, for the couple that it carries
  Scalar own{};                           // of a thread: what the couple of the friction itself adds
  std::optional<Vector3<Scalar>> toward;  // V/|V|, on ground axes, as it was found last
};

// One way in which a joint with friction moves, as fast as a velocity coordinate tells. Its friction is like a motor of
// its own.
template <class Scalar>
struct RubbingWay {
  int coordinate = 0;
  std::size_t drive = 0;    // its place among the drives
  Direction<Scalar> along;  // of its slip; the ways of a joint are across one another
  Scalar arm{1};            // m, for a turning that slips with a slide on one surface
};

// A contact with dry friction, in the state of it that is tried.
template <class Scalar>
struct RoughContactOf {
  std::string name;
  int action = 0;
  Grip grip = Grip::unknown;
  Scalar resting{}, sliding{};  // the coefficients of friction
  Direction<Scalar> normal;
  // How it comes apart along the normal, and how it slips along two directions across it.
  std::array<VelocityConstraint<Scalar>, 3> motions;
  std::optional<Direction<Scalar>> slip;  // of `on` over `from`, if it slides
  bool turns = false;                     // whether that is found anew from the velocities at each instant
  double off_line = 0;                    // m/s: else how fast it may slip across that line for all that a motion tells
  // Of friction in a joint: the ways in which it slips, and whether its friction is a couple. Its coefficients are
  // couples or forces, as of a contact that presses with one unit; its axis stands in the second of `motions`.
  std::vector<RubbingWay<Scalar>> ways{};
  bool turning = false;
  // Whether its friction is against a slip that may take any direction of these ways, and not along one axis.
  bool all_ways = false;
  // Of a cord or belt on a wheel or post (engine/dynamics/capstan.h): the action of its straight part behind that,
  // where `action` is of the part before it; the coefficients of friction, of which `resting` and `sliding` are tanh(mu
  // beta/2) as drawn; and the angle beta as drawn. Its slip, the way the cord is led, is what the spans of the second
  // of `motions` grow by, along the direction there.
  int behind = -1;
  bool of_belt = false;
  Scalar friction_at_rest{}, friction_in_slip{}, wrap{};
  // If the friction follows from what the joint carries: what presses, about or along the axis at this place. Then the
  // coefficients are pure numbers, and what presses altogether stands in place of the unit.
  std::vector<PressingPart<Scalar>> pressing{};
  Place<Scalar> at{};
  std::optional<Scalar> friction_known;  // along its slip while it moves: given in place of the law

  bool on_cord() const { return behind >= 0; }
  bool in_joint() const { return !ways.empty(); }
  // Whether its couple or force while it moves is found with the reactions: by its size, or by its direction, whose
  // parts along its ways turn with them.
  bool found_with_reactions() const { return (!pressing.empty() || all_ways) && grip == Grip::slides; }
};

// A straight part of a cord, belt or chain that is led over wheels, between two of these or of its ends as the
// statement names them.
struct CordPart {
  std::string cord, from, to;
  int action = 0;
};

// Where the teeth of two gears meet. The directions are those as drawn, on the axes of the body that carries both.
template <class Scalar>
struct ToothMeshOf {
  // Of one of the wheels: along the motion of its teeth, away from its axis, and along that.
  struct Side {
    Vector3<Scalar> tangential{}, radial{}, axial{};
    Vector3<Scalar> arm{};  // from its axis to where they meet; zero of a rack
  };
  std::string name;
  int action = 0;
  int carrier = ground;
  Place<Scalar> at;
  Side of, against;
  Vector3<Scalar> thread{};  // along the teeth, where these rub
};

template <class Scalar>
struct MachineOf {
  Mechanism<Scalar> mechanism;
  std::vector<solve::CheckLink> links;          // for each body of the tree as drawn, for the check with particles
  std::map<std::string, int> index;             // of bodies and frames, and "ground"
  std::map<int, Vector3<Scalar>> drawn_origin;  // of each tree body, on ground axes
  std::vector<std::pair<int, BodyMassOf<Scalar>>> masses;  // for each body of the situation
  std::vector<NamedCoordinate> coordinates;
  std::vector<Scalar> q;             // positions given by the data; the others are as drawn
  std::vector<bool> position_given;  // for each entry of q
  std::vector<StatedRateOf<Scalar>> rates, accelerations;
  std::vector<StatedImpulseOf<Scalar>> impulses;
  std::vector<solve::ImpactOf<Scalar>> impacts;
  // The tree after a blow in which particles stay and belong to their bodies. Bodies and coordinates are the same as
  // before.
  std::optional<Model<Scalar>> struck_tree;
  std::vector<ContactLimit> contact_limits;
  std::vector<RoughContactOf<Scalar>> rough_contacts;
  std::vector<CordPart> cord_parts;
  std::vector<int> belt_actions;  // of the straight parts of belts and chains, which must not push
  // Of each chain, the components of its sides: of those that the equations leave open the least is slack.
  std::vector<std::vector<int>> chains;
  std::vector<ToothMeshOf<Scalar>> tooth_meshes;
  std::vector<std::string> line_contacts;  // contacts along a line that are taken as at one point of it
  std::map<std::string, JointPlaceOf<Scalar>> joints;
  std::vector<std::string> loop_joints;        // joints that close loops
  std::vector<std::string> constraint_joints;  // for each constraint the joint that it closes a loop by, "" if none

  const Model<Scalar>& tree_after_blow() const { return struck_tree ? *struck_tree : mechanism.tree; }
  // The place on a body that lies at this point of the drawing.
  Place<Scalar> place(int body, const Vector3<Scalar>& drawn) const;
  const NamedCoordinate* coordinate(const std::string& name) const;
  // The actions that a name stands for: those of a joint with its supports and drives, of a support, contact, cord or
  // spring.
  std::vector<std::size_t> actions_of(const std::string& name, const std::string& joint = "") const;
};
using Machine = MachineOf<double>;

struct MachineOptions {
  bool lenient = false;                           // whether unknowns have trial values
  bool particles = false;                         // whether bodies are made of particles then too, for checks
  double time = 0;                                // s
  Vector3<double> open_gravity{};                 // used if the situation says nothing about gravity
  std::optional<std::vector<std::string>> loads;  // the loads that act; all of them if left out
  bool open_contacts = false;                     // whether those that do not touch at the start are there
};

// The mass properties of the bodies, in the order of the file. Throws StatementError.
template <class Scalar>
std::vector<BodyMassOf<Scalar>> body_masses(const Situation& situation, DataScope<Scalar>& data, const AnyValue& any,
                                            const MachineOptions& options);
// The two scopes must belong to the same situation and time, with the same varying values. Throws StatementError.
template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, DataScope<Scalar>& data,
                                DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options);
// The same for masses that are known already.
template <class Scalar>
MachineOf<Scalar> build_machine(const Situation& situation, std::vector<BodyMassOf<Scalar>> masses,
                                DataScope<Scalar>& data, DataScope<TimeJetOf<Scalar>>& timed, const AnyValue& any,
                                const MachineOptions& options);

extern template struct MachineOf<double>;
extern template struct MachineOf<Dual<1>>;

}  // namespace poinsot::problem
