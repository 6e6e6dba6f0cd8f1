// The forces and couples that the joints of a machine carry, and their drives.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

// Sine between two directions that were meant as one: both may be stated to nine digits. What hangs on such a pair is
// determined to no digit.
constexpr double same_direction = 1e-9;

// The directions, as drawn, of the forces and couples that a joint can carry.
template <class Scalar>
struct Carried {
  std::vector<Vector3<Scalar>> forces, couples;
  std::optional<Scalar> screw;  // the couple per unit force along the axis of a screw
};

// The directions across all of these, of which none are parallel.
template <class Scalar>
std::vector<Vector3<Scalar>> across_all(const std::vector<Vector3<Scalar>>& moving) {
  if (moving.empty()) return {Vector3<Scalar>::unit(0), Vector3<Scalar>::unit(1), Vector3<Scalar>::unit(2)};
  if (moving.size() == 2) return {normalized(cross(moving[0], moving[1]))};
  if (moving.size() > 2) return {};
  const auto [a, b] = across(moving[0]);
  return {a, b};
}

// A joint carries forces across all directions in which it slides, and couples across all about which it turns.
template <class Scalar>
Carried<Scalar> carried_by(const Joint& joint, const JointAxes<Scalar>& axes, const Scalar& pitch) {
  std::vector<Vector3<Scalar>> sliding, turning;
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k)
    (joint.freedoms[k].turning ? turning : sliding).push_back(axes.freedom[k]);
  if (joint.kind->advances) sliding = turning;
  Carried<Scalar> carried;
  // A normal keeps the sense in which it is stated.
  if (joint.kind->given == JointGiven::normal)
    carried.forces = {*axes.main};
  else
    carried.forces = across_all(sliding);
  if (!joint.kind->any_turning) carried.couples = across_all(turning);
  if (joint.kind->advances) carried.screw = -pitch;
  return carried;
}

// In a planar problem a joint turns about normals and slides in the plane, and carries nothing across it.
template <class Scalar>
void keep_in_plane(const MachineDraft<Scalar>& draft, const Joint& joint, const JointAxes<Scalar>& axes,
                   Carried<Scalar>& carried) {
  if (!draft.situation.plane) return;
  require_in_plane(draft, axes.at, joint.mark, "the place of joint '" + joint.name + "'");
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k) {
    const std::string what =
        "joint '" + joint.name + "'" + (joint.freedoms[k].name.empty() ? "" : ", " + joint.freedoms[k].name + ",");
    if (joint.freedoms[k].turning)
      require_along_normal(draft, axes.freedom[k], joint.place.mark(), "the axis of " + what);
    else
      require_in_plane(draft, axes.freedom[k], joint.place.mark(), "the direction of " + what);
  }
  std::erase_if(carried.forces, [&](const Vector3<Scalar>& d) { return !lies_in_plane(draft, d); });
  std::erase_if(carried.couples, [&](const Vector3<Scalar>& d) { return !lies_along_normal(draft, d); });
}

// The link between the two axes about which a joint turns.
template <class Scalar>
int cross_link(const MachineDraft<Scalar>& draft, const Joint& joint,
               const std::pair<std::size_t, std::size_t>& turnings) {
  if (const auto found = draft.cross_of_loop.find(joint.name); found != draft.cross_of_loop.end()) return found->second;
  const auto& [first, first_parent] = draft.link_of_freedom.at({joint.name, turnings.first});
  const auto& [second, second_parent] = draft.link_of_freedom.at({joint.name, turnings.second});
  return second_parent == first ? first : second;
}

template <class Scalar>
void add_support(MachineDraft<Scalar>& draft, const Joint& joint, const Support& support, const JointAxes<Scalar>& axes,
                 int to, int from) {
  const Place<Scalar> at = draft.machine.place(to, support_place(draft, support));
  const int action = draft.add_action(ActionKind::support, support.name, joint.name, to, from);
  std::vector<std::pair<std::string, Vector3<Scalar>>> forces, couples;
  if (!support.kind) {
    for (const Expression& e : support.forces) {
      forces.emplace_back(to_string(e), draft.data.direction(e));
      require_in_plane(draft, forces.back().second, e.mark(), "this force of support '" + support.name + "'");
    }
    for (const Expression& e : support.couples) {
      couples.emplace_back(to_string(e), draft.data.direction(e));
      require_along_normal(draft, couples.back().second, e.mark(), "this couple of support '" + support.name + "'");
    }
  } else {
    if (!axes.main && !support.kind->needs_no_axis)
      fail(draft.situation.file, support.mark,
           "joint '" + joint.name + "' has no axis: its support '" + support.name + "' cannot be a " +
               support.kind->name,
           "list the directions that it carries");
    std::vector<Vector3<Scalar>> directions{Vector3<Scalar>::unit(0), Vector3<Scalar>::unit(1),
                                            Vector3<Scalar>::unit(2)};
    if (axes.main) {
      const auto [a, b] = across(*axes.main);
      directions = {a, b};
      if (!support.kind->across_only) directions.push_back(*axes.main);
      if (support.kind->couples)
        for (const Vector3<Scalar>& d : {a, b}) couples.emplace_back(draft.direction_name(d), d);
    }
    for (const Vector3<Scalar>& d : directions) forces.emplace_back(draft.direction_name(d), d);
    std::erase_if(forces, [&](const auto& force) { return !lies_in_plane(draft, force.second); });
    std::erase_if(couples, [&](const auto& couple) { return !lies_along_normal(draft, couple.second); });
  }
  const auto add = [&](const std::vector<std::pair<std::string, Vector3<Scalar>>>& list, bool couple) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (norm(plain(cross(list[i].second, list[j].second))) < same_direction)
          fail(draft.situation.file, support.mark,
               "support '" + support.name + "' lists the direction " + list[i].first + " twice");
      draft.add_component(action, list[i].first, couple, at, {from, list[i].second});
    }
  };
  add(forces, false);
  add(couples, true);
}

template <class Scalar>
void add_drives(MachineDraft<Scalar>& draft, const Joint& joint, const JointAxes<Scalar>& axes, const Place<Scalar>& at,
                int to, int from) {
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k) {
    const Freedom& freedom = joint.freedoms[k];
    const auto link = draft.link_of_freedom.find({joint.name, k});
    if (link == draft.link_of_freedom.end()) continue;
    const int moved = link->second.first;
    Drive<Scalar> drive;
    drive.coordinate = draft.machine.mechanism.tree.body(moved).v;
    drive.position = draft.machine.mechanism.tree.body(moved).q;
    drive.turning = freedom.turning;
    drive.at = at;
    // The axis moves with both bodies of its link. It has the sense in which `to` turns relative to `from`, whichever
    // is the child.
    drive.along = {moved, axes.freedom[k]};
    for (std::size_t other = 0; freedom.turning && other < joint.freedoms.size(); ++other) {
      const auto found = draft.link_of_freedom.find({joint.name, other});
      if (other != k && joint.freedoms[other].turning && found != draft.link_of_freedom.end())
        drive.others.push_back({found->second.first, axes.freedom[other]});
    }
    const bool accel_known =
        std::any_of(draft.machine.accelerations.begin(), draft.machine.accelerations.end(),
                    [&](const StatedRateOf<Scalar>& stated) { return stated.velocity == drive.coordinate; });
    const bool sought = freedom.effort && is_any(*freedom.effort);
    const bool resisted = freedom.stiffness || freedom.damping || freedom.friction;
    if (sought && (accel_known || resisted || draft.situation.has_blow()))
      fail(draft.situation.file, freedom.effort->mark(),
           accel_known ? "what drives joint '" + joint.name + "' is found from its stated acceleration already"
           : draft.situation.has_blow()
               ? "what drives joint '" + joint.name + "' cannot be sought beside a blow"
               : "what drives joint '" + joint.name + "' is sought together with its spring, damping and friction",
           draft.situation.has_blow() && !accel_known ? "leave out the blow" : "leave out one of them");
    drive.held = sought || (accel_known && !freedom.effort && !freedom.stiffness && !freedom.damping);
    const Dimension effort = freedom.turning ? dimensions::moment : dimensions::force;
    const Dimension position = freedom.turning ? dimensions::angle : dimensions::length;
    if (freedom.effort && !sought && depends_on_motion(draft, *freedom.effort))
      draft.efforts.push_back({&joint, &freedom, draft.machine.mechanism.drives.size()});
    else if (freedom.effort && !sought)
      drive.effort = draft.timed_number(*freedom.effort, effort).value;
    if (freedom.stiffness) drive.stiffness = draft.data.number(*freedom.stiffness, effort / position);
    if (freedom.free_position) drive.free_position = draft.data.number(*freedom.free_position, position);
    if (freedom.damping) drive.damping = draft.data.number(*freedom.damping, effort / position * dimensions::time);
    for (const auto& [expression, value] :
         {std::pair{&freedom.stiffness, drive.stiffness}, std::pair{&freedom.damping, drive.damping}})
      if (plain(value) < 0)
        fail(draft.situation.file, (*expression)->mark(),
             "joint '" + joint.name + "': stiffness and damping are not negative");
    drive.action = draft.add_action(ActionKind::drive, joint.name + (freedom.name.empty() ? "" : "." + freedom.name),
                                    joint.name, to, from);
    draft.machine.mechanism.drives.push_back(drive);
  }
}

// Two directions across a normal. If it is a coordinate axis, they are the two others in their positive sense.
template <class Scalar>
std::pair<Vector3<Scalar>, Vector3<Scalar>> in_plane(const Vector3<Scalar>& normal) {
  auto [first, second] = across(normal);
  for (std::size_t k = 0; k < 3; ++k)
    if (constexpr double off = 1e-12;  // an angle of a microradian, within which the axes of the drawing are meant
        std::abs(std::abs(plain(normal[k])) - 1) < off) {
      const Vector3<Scalar> one = Vector3<Scalar>::unit(k == 0 ? 1 : 0);
      first = normalized(one - dot(one, normal) * normal);
      second = cross(normal, first);
      if (plain(second[k == 2 ? 1 : 2]) < 0) second = -second;
    }
  return {first, second};
}

// main: the direction that the joint's key gives; listed: the two that it gives instead.
template <class Scalar>
Vector3<Scalar> direction_of(FreedomAxis axis, const std::optional<Vector3<Scalar>>& main,
                             const std::vector<Vector3<Scalar>>& listed) {
  switch (axis) {
    case FreedomAxis::across:
      return in_plane(*main).first;
    case FreedomAxis::across_both:
      return in_plane(*main).second;
    case FreedomAxis::first:
      return listed[0];
    case FreedomAxis::second:
      return listed[1];
    case FreedomAxis::main:
      break;
  }
  return *main;
}

}  // namespace

template <class Scalar>
JointAxes<Scalar> axes_of(const MachineDraft<Scalar>& draft, const Joint& joint) {
  JointAxes<Scalar> axes;
  // A point on the axis: `at`, the start of A->B, or the first support.
  const auto at = [&] {
    if (joint.at) return draft.data.place(*joint.at);
    if (const Arrow* arrow = joint.place.as<Arrow>()) return draft.data.place(arrow->from);
    if (!joint.supports.empty()) return support_place(draft, joint.supports.front());
    if (joint.kind->given == JointGiven::direction) return Vector3<Scalar>::zero();
    fail(draft.situation.file, joint.mark, "joint '" + joint.name + "' has a direction but no place",
         "write at: P, a point of its axis");
  };
  std::vector<Vector3<Scalar>> listed;
  switch (joint.kind->given) {
    case JointGiven::point:
      if (joint.at)
        fail(draft.situation.file, joint.at->mark(), "joint '" + joint.name + "' already has its point", "remove at:");
      axes.at = draft.data.place(joint.place);
      break;
    case JointGiven::two_axes: {
      const std::string& kind = joint.kind->name;
      const List* list = joint.place.as<List>();
      if (!list || list->items.size() != 2)
        fail(draft.situation.file, joint.place.mark(), "a " + kind + " joint has two axes",
             "write " + kind + ": [x, y]");
      axes.at = at();
      for (const Expression& item : list->items) listed.push_back(draft.data.direction(item));
      if (norm(plain(cross(listed[0], listed[1]))) < same_direction)
        fail(draft.situation.file, joint.place.mark(),
             "the axes of the " + kind + " joint '" + joint.name + "' are parallel");
      break;
    }
    case JointGiven::normal:
    case JointGiven::axis:
    case JointGiven::direction:
      axes.at = at();
      axes.main = draft.data.direction(joint.place);
  }
  std::vector<std::size_t> turnings;
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k) {
    const Freedom& freedom = joint.freedoms[k];
    axes.freedom.push_back(freedom.direction ? draft.data.direction(*freedom.direction)
                                             : direction_of(joint.kind->freedoms[k].axis, axes.main, listed));
    if (freedom.turning) turnings.push_back(k);
  }
  if (turnings.size() == 2) axes.two_turnings.emplace(turnings[0], turnings[1]);
  return axes;
}

template <class Scalar>
Scalar pitch_of(const MachineDraft<Scalar>& draft, const Joint& joint) {
  const Value<Scalar> value = draft.data.value(*joint.pitch);
  if (!value.is_number() || !same_kind(value.dimension, dimensions::length))
    fail(draft.situation.file, joint.pitch->mark(), "the pitch of a screw is a length per turn",
         "write pitch: 2 mm/rev");
  if (value.dimension.angle == 0)
    fail(draft.situation.file, joint.pitch->mark(), "is this pitch meant for a turn or for a radian?",
         "write pitch: 2 mm/rev");
  return value.number;
}

template <class Scalar>
Vector3<Scalar> support_place(const MachineDraft<Scalar>& draft, const Support& support) {
  return draft.data.place(*support.at);
}

template <class Scalar>
void add_joint_actions(MachineDraft<Scalar>& draft, const Joint& joint) {
  const JointAxes<Scalar> axes = axes_of(draft, joint);
  const int to = draft.body(joint.to), from = draft.body(joint.from);
  const Place<Scalar> at = draft.machine.place(to, axes.at);
  JointPlaceOf<Scalar> place{at, std::nullopt, from, to};
  if (axes.main) place.axis = Direction<Scalar>{from, *axes.main};
  draft.machine.joints[joint.name] = place;
  const Scalar pitch = joint.kind->advances ? pitch_of(draft, joint) : Scalar(0);
  Carried<Scalar> carried = carried_by(joint, axes, pitch);
  keep_in_plane(draft, joint, axes, carried);
  // The couple across two axes of turning moves with the link between them.
  const int couple_body = axes.two_turnings ? cross_link(draft, joint, *axes.two_turnings) : from;
  if (!joint.supports_stated) {
    const int action = draft.add_action(ActionKind::joint, joint.name, "", to, from);
    for (const Vector3<Scalar>& d : carried.forces)
      draft.add_component(action, draft.direction_name(d), false, at, {from, d});
    for (const Vector3<Scalar>& d : carried.couples)
      draft.add_component(action, draft.direction_name(d), true, at, {couple_body, d});
    if (carried.screw) {
      draft.add_component(action, draft.direction_name(*axes.main), false, at, {from, *axes.main}).couple_per_force =
          *carried.screw;
    }
  } else {
    for (const Support& support : joint.supports) add_support(draft, joint, support, axes, to, from);
  }
  add_drives(draft, joint, axes, at, to, from);
  if (std::find(draft.loops.begin(), draft.loops.end(), &joint) == draft.loops.end()) return;
  for (const Vector3<Scalar>& d : carried.forces)
    draft.add_constraint(VelocityConstraintKind::point, "joint '" + joint.name + "' along " + draft.direction_name(d),
                         to, from, at, d, joint.name);
  std::vector<Vector3<Scalar>> fixed = carried.couples;
  // The body `to` also keeps the second axis of the link between the axes.
  if (axes.two_turnings) fixed.push_back(cross(axes.freedom[axes.two_turnings->second], carried.couples[0]));
  for (const Vector3<Scalar>& d : fixed)
    draft.add_constraint(VelocityConstraintKind::angular, "joint '" + joint.name + "' about " + draft.direction_name(d),
                         to, couple_body, at, d, joint.name);
  if (joint.kind->advances)
    fail(draft.situation.file, joint.mark,
         "joint '" + joint.name + "' closes a loop, which a joint of this kind cannot do here",
         "let it stand first and close the loop with a joint of another kind");
}

template JointAxes<double> axes_of(const MachineDraft<double>&, const Joint&);
template double pitch_of(const MachineDraft<double>&, const Joint&);
template Vector3<double> support_place(const MachineDraft<double>&, const Support&);
template void add_joint_actions(MachineDraft<double>&, const Joint&);
template JointAxes<Dual<1>> axes_of(const MachineDraft<Dual<1>>&, const Joint&);
template Dual<1> pitch_of(const MachineDraft<Dual<1>>&, const Joint&);
template Vector3<Dual<1>> support_place(const MachineDraft<Dual<1>>&, const Support&);
template void add_joint_actions(MachineDraft<Dual<1>>&, const Joint&);
template JointAxes<Formula> axes_of(const MachineDraft<Formula>&, const Joint&);
template Formula pitch_of(const MachineDraft<Formula>&, const Joint&);
template Vector3<Formula> support_place(const MachineDraft<Formula>&, const Support&);
template void add_joint_actions(MachineDraft<Formula>&, const Joint&);

}  // namespace poinsot::problem
