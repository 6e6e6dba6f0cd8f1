// A machine in the making. The steps that build it are in files by subject; each takes the draft and adds to it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/model/builder.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// A value, with its derivatives by time if it depends on the time.
template <class Scalar>
struct TimedNumber {
  Scalar value{};
  std::optional<Scalar> derivative, second_derivative;
};

// A couple or force at a freedom that depends on the motion.
struct EffortByMotion {
  const Joint* joint = nullptr;
  const Freedom* freedom = nullptr;
  std::size_t drive = 0;  // of the mechanism
};

// The scalar is that of the machine. The objects referred to must outlive the draft.
template <class Scalar>
struct MachineDraft {
  const Situation& situation;
  DataScope<Scalar>& data;
  DataScope<TimeJetOf<Scalar>>& timed;
  const AnyValue& any;
  const MachineOptions& options;
  ModelBuilder<Scalar> builder{};
  MachineOf<Scalar> machine{};
  std::vector<BodyMassOf<Scalar>> masses{};  // in the order of the file
  // The link of each freedom, and its parent.
  std::map<std::pair<std::string, std::size_t>, std::pair<int, int>> link_of_freedom{};
  std::vector<const Joint*> loops{};  // joints that close loops
  std::vector<EffortByMotion> efforts{};
  // For joints among them that turn about two axes, the link that turns about the first.
  std::map<std::string, int> cross_of_loop{};

  int body(const std::string& name) const { return machine.index.at(name); }
  // The index of the body in the file.
  std::size_t body_number(const std::string& name) const;
  TimedNumber<Scalar> timed_number(const Expression& expression, const Dimension& dimension) const;
  // The name of a direction of the drawing, if it has a short one.
  std::string direction_name(const Vector3<Scalar>& d) const;

  // The index at which the coordinates of the next link begin.
  std::size_t next_velocity() const { return machine.mechanism.coordinate_names.size(); }
  // Adds a body to the tree with its origin at a place of the drawing. The mass is on the axes of the ground, as
  // drawn.
  int add_link(const std::string& name, int parent, const poinsot::Joint<Scalar>& joint, const Vector3<Scalar>& origin,
               const MassProperties<Scalar>& mass);
  // States the rate or the acceleration of a coordinate.
  void state_rate(const std::string& words, std::size_t velocity, const Scalar& value, bool turning, const Mark& mark) {
    machine.rates.push_back({words, static_cast<int>(velocity), value, turning, mark});
  }
  void state_acceleration(const std::string& words, std::size_t velocity, const Scalar& value, bool turning,
                          const Mark& mark) {
    machine.accelerations.push_back({words, static_cast<int>(velocity), value, turning, mark});
  }
  // Names the coordinates of a free body.
  void name_free(const std::string& owner, std::size_t first, int count);
  int add_action(ActionKind kind, const std::string& name, const std::string& joint, int on, int from);
  // Adds a force or couple along a direction that moves with a body.
  Component<Scalar>& add_component(int action, const std::string& axis, bool couple, const Place<Scalar>& at,
                                   const Direction<Scalar>& along);
  // joint: the joint that closes a loop by the constraint, if one does.
  VelocityConstraint<Scalar>& add_constraint(VelocityConstraintKind kind, const std::string& words, int on, int from,
                                             const Place<Scalar>& at, const Vector3<Scalar>& drawn,
                                             const std::string& joint = "");
};

// Two unit vectors perpendicular to u and to each other, along axes of the figure if possible.
template <class Scalar>
std::pair<Vector3<Scalar>, Vector3<Scalar>> across(const Vector3<Scalar>& u);

// The place of a joint and the directions of its freedoms, as drawn.
template <class Scalar>
struct JointAxes {
  Vector3<Scalar> at;
  std::vector<Vector3<Scalar>> freedom;  // one for each freedom
  std::optional<Vector3<Scalar>> main;   // the joint's axis, normal or direction
  // Which freedoms turn, if there are two: the link between them then carries the couple across both.
  std::optional<std::pair<std::size_t, std::size_t>> two_turnings;
};
template <class Scalar>
JointAxes<Scalar> axes_of(const MachineDraft<Scalar>& draft, const Joint& joint);
// The advance of a screw per angle, m/rad.
template <class Scalar>
Scalar pitch_of(const MachineDraft<Scalar>& draft, const Joint& joint);
template <class Scalar>
Vector3<Scalar> support_place(const MachineDraft<Scalar>& draft, const Support& support);

// The steps in the order in which they are taken. All throw StatementError.
template <class Scalar>
void set_gravity(MachineDraft<Scalar>& draft);
// The pull of a center on each part of each body that has mass.
template <class Scalar>
void add_attractions(MachineDraft<Scalar>& draft);
template <class Scalar>
void add_frame(MachineDraft<Scalar>& draft, const Frame& frame);
// In a planar problem each body is held in the plane: it can be given a force across it and couples about axes in it,
// and a body that no joint holds is kept from moving there. After the tree is built.
template <class Scalar>
void hold_in_plane(MachineDraft<Scalar>& draft);
// Whether a direction of the drawing points along the normal of a planar problem, or lies in its plane; both where
// there is no plane.
template <class Scalar>
bool lies_along_normal(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& direction);
template <class Scalar>
bool lies_in_plane(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& direction);
// Throws StatementError for a vector that does not. what: "the force of load 'push'".
template <class Scalar>
void require_in_plane(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& vector, const Mark& mark,
                      const std::string& what);
template <class Scalar>
void require_along_normal(const MachineDraft<Scalar>& draft, const Vector3<Scalar>& vector, const Mark& mark,
                          const std::string& what);
// Joints that reach new bodies make the tree, beginning with those that state something about their freedoms. All
// others close loops. Bodies that no joint reaches are free.
template <class Scalar>
void add_tree(MachineDraft<Scalar>& draft);
// Adds what a joint carries, its drives, and the constraints if it closes a loop.
template <class Scalar>
void add_joint_actions(MachineDraft<Scalar>& draft, const Joint& joint);
// The coefficients of friction at rest and while it slides, or the couples or forces of a joint.
template <class Scalar>
std::pair<Scalar, Scalar> friction_of(MachineDraft<Scalar>& draft, const Contact& contact, const Dimension& dimension);
template <class Scalar>
void add_friction_in_joint(MachineDraft<Scalar>& draft, const Contact& friction);
template <class Scalar>
void add_contact(MachineDraft<Scalar>& draft, const Contact& contact);
template <class Scalar>
void add_cord(MachineDraft<Scalar>& draft, const Cord& cord);
template <class Scalar>
void add_belt(MachineDraft<Scalar>& draft, const Belt& belt);
template <class Scalar>
void add_gear(MachineDraft<Scalar>& draft, const Gear& gear);
// The laws of force.
template <class Scalar>
void add_law(MachineDraft<Scalar>& draft, const Spring& spring);
template <class Scalar>
void add_law(MachineDraft<Scalar>& draft, const Load& load);
// Those at freedoms that depend on the motion.
template <class Scalar>
void add_efforts_by_motion(MachineDraft<Scalar>& draft);
template <class Scalar>
void add_impulse(MachineDraft<Scalar>& draft, const Impulse& impulse);
template <class Scalar>
void add_impact(MachineDraft<Scalar>& draft, const Impact& impact);
template <class Scalar>
void add_strike(MachineDraft<Scalar>& draft, const Strike& strike);

// Loads that depend on the motion (motion_loads.cpp).
//
// Whether an expression of a load asks anything of the motion: a quantity of a body, or a coordinate or its rate. The
// name of a datum is the datum, also where a coordinate has it. After the tree is built.
template <class Scalar>
bool depends_on_motion(const MachineDraft<Scalar>& draft, const Expression& expression);

// What a load is made of: a vector, or a number along a direction.
struct MotionLoadWords {
  std::string owner;  // "load 'drag'", for messages
  Expression size;
  std::optional<Expression> direction;
  Dimension dimension;
};

// The vector of a load on the axes of a body or frame, on which the vectors of its expression stand too. Throws
// StatementError for what no load can depend on. After the actions of the joints.
template <class Scalar>
MotionExpression<Scalar> motion_load(MachineDraft<Scalar>& draft, const MotionLoadWords& words, int axes);
// The same for a couple or force at a freedom.
template <class Scalar>
MotionExpression<Scalar> motion_effort(MachineDraft<Scalar>& draft, const MotionLoadWords& words,
                                       const Direction<Scalar>& along);

// Throws StatementError if one of these is stated as a function of time, which the equations of motion would not know.
void require_steady_data(const Situation& situation);

extern template struct MachineDraft<double>;
extern template struct MachineDraft<Dual<1>>;

}  // namespace poinsot::problem
