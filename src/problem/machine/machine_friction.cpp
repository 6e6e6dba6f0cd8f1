// Dry friction: its coefficients, and what it is in joints. In a joint it acts like motors beside those of the joint,
// of unknown effort while it holds or is found with the reactions, else against the rate.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/entries/read_joints.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

// A length by which friction acts in a joint.
template <class Scalar>
Scalar size_in_bearing(MachineDraft<Scalar>& draft, const Contact& contact, const Expression& stated, bool may_vanish) {
  Scalar size = draft.data.number(stated, dimensions::length);
  if (!draft.options.lenient && !(plain(size) > 0 || (may_vanish && plain(size) == 0)))
    fail(draft.situation.file, stated.mark(),
         contact.words() + " has a bearing " + (may_vanish ? "of negative size" : "without size"),
         "write a length above zero");
  return size;
}

// What presses in a joint whose friction follows from a coefficient. A journal of radius r bears the force across its
// axis, a collar that along it, a guide that across its direction, a ball in its socket the whole force, a sleeve on
// its post that across the post, and what slides in a plane that across the plane. Where a length L is stated it bears
// at two ends, with half of the force on each and the couple that it carries divided by L; where supports are, with the
// force on each. Of a thread with the lead h for a radian, t = h/r, a = atan t, and the flank at the angle b to a
// square one, tan b_n = cos a tan b, the push N of the flank and the friction F along it follow from the force X along
// the axis and the friction's own couple M by
//   F = M cos a / r,   N = (X / cos a - M sin a / r) / cos b_n,
// so that |F| = m N is |M| = m |r (1 + t^2) X - t M| / cos b_n.
template <class Scalar>
std::vector<PressingPart<Scalar>> pressing_parts(MachineDraft<Scalar>& draft, const Contact& contact,
                                                 const Joint& joint) {
  using Part = PressingPart<Scalar>;
  const Bearing& bearing = *contact.friction->bearing;
  std::vector<Part> parts;
  const auto size = [&](const std::optional<Expression>& stated, bool may_vanish) {
    return stated ? size_in_bearing(draft, contact, *stated, may_vanish) : Scalar(1);
  };
  const Scalar radius = size(bearing.radius, !joint.kind->advances && !contact.all_ways);
  const std::vector<Action>& actions = draft.machine.mechanism.actions;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const bool whole = actions[i].kind == ActionKind::joint && actions[i].name == joint.name;
    if (!whole && !(actions[i].kind == ActionKind::support && actions[i].joint == joint.name)) continue;
    Part part;
    part.action = static_cast<int>(i);
    if (joint.kind->advances) {
      if (!whole)
        fail(draft.situation.file, contact.friction->mark,
             contact.words() + " is a screw with supports, among which its thread is not told apart",
             "leave out supports:, or the friction");
      const Scalar t = pitch_of(draft, joint) / radius;
      Scalar over_cosine(1);
      if (bearing.thread_angle) {
        const Scalar angle = draft.data.number(*bearing.thread_angle, dimensions::angle);
        if (!draft.options.lenient && !(plain(angle) >= 0 && plain(angle) < std::numbers::pi))
          fail(draft.situation.file, bearing.thread_angle->mark(),
               contact.words() + " has flanks that do not stand between 0 and 180 deg to each other",
               "write the angle between the flanks, such as thread_angle: 29 deg");
        using std::tan, std::sqrt;
        const Scalar flank = tan(angle / Scalar(2));
        over_cosine = sqrt(Scalar(1) + flank * flank / (Scalar(1) + t * t));
      }
      part.form = Part::Form::thread;
      part.lever = over_cosine * radius * (Scalar(1) + t * t);
      part.own = -over_cosine * t;
      parts.push_back(part);
      continue;
    }
    if (bearing.length && !whole)
      fail(draft.situation.file, bearing.length->mark(),
           contact.words() + " states supports and a length between its ends",
           "its supports bear it: leave out length:, or supports:");
    if (contact.all_ways && joint.kind->common_slip != CommonSlip::along_and_round) {
      part.form = joint.kind->common_slip == CommonSlip::turning ? Part::Form::whole : Part::Form::along;
      part.lever = radius;
      parts.push_back(part);
      continue;
    }
    if (bearing.radius || !joint.freedoms.front().turning) {
      // The friction of a sleeve is a force at its surface.
      part.lever = contact.all_ways ? Scalar(1) : radius;
      if (bearing.length) {
        part.form = Part::Form::end;
        part.over_length = Scalar(1) / size(bearing.length, false);
        parts.push_back(part);
        part.over_length = -part.over_length;
      }
      parts.push_back(part);
    }
    if (!bearing.thrust_radius) continue;
    part.form = Part::Form::along;
    part.lever = size(bearing.thrust_radius, true);
    parts.push_back(part);
  }
  return parts;
}

// Like the motor that a joint has in one of its freedoms; null if it has none, as one that closes a loop.
template <class Scalar>
const Drive<Scalar>* motor_of(const MachineDraft<Scalar>& draft, const Joint& joint, std::size_t freedom) {
  const std::string& named = joint.freedoms[freedom].name;
  const std::string driven = joint.name + (named.empty() ? "" : "." + named);
  const std::vector<Drive<Scalar>>& drives = draft.machine.mechanism.drives;
  const auto motor = std::ranges::find_if(drives, [&](const Drive<Scalar>& drive) {
    const Action& action = draft.machine.mechanism.actions[static_cast<std::size_t>(drive.action)];
    return action.kind == ActionKind::drive && action.name == driven;
  });
  return motor == drives.end() ? nullptr : &*motor;
}

// What a joint with friction moves by: a motor as it would have in that way, and how its slip is made of its rate.
template <class Scalar>
struct RubbingMotor {
  Drive<Scalar> drive;
  Direction<Scalar> along;
  Scalar arm{1};
};

// Of a ball: about the axes of the body beyond it, on which its rates are told.
template <class Scalar>
std::vector<RubbingMotor<Scalar>> motors_of_ball(const MachineDraft<Scalar>& draft, const Joint& joint) {
  std::vector<RubbingMotor<Scalar>> motors;
  if (std::ranges::find(draft.loops, &joint) != draft.loops.end()) return motors;
  const Model<Scalar>& tree = draft.machine.mechanism.tree;
  const int to = draft.body(joint.to), from = draft.body(joint.from);
  const bool reversed = to == ground || tree.body(to).parent != from;
  const int child = reversed ? from : to;
  for (int k = 0; k < 3; ++k) {
    const Vector3<Scalar> axis = Vector3<Scalar>::unit(static_cast<std::size_t>(k));
    if (!lies_along_normal(draft, axis)) continue;
    Drive<Scalar> drive;
    drive.coordinate = tree.body(child).v + k;
    drive.position = tree.body(child).q + 1 + k;  // of its quaternion; nothing depends on it
    drive.at = draft.machine.joints.at(joint.name).at;
    drive.along = {child, reversed ? -axis : axis};
    motors.push_back({drive, drive.along, Scalar(1)});
  }
  return motors;
}

template <class Scalar>
std::vector<RubbingMotor<Scalar>> motors_against_friction(MachineDraft<Scalar>& draft, const Contact& contact,
                                                          const RubbingJoint& rubbing) {
  const Joint& joint = rubbing.joint;
  if (rubbing.freedom) {
    const Drive<Scalar>* motor = motor_of(draft, joint, *rubbing.freedom);
    if (!motor) return {};
    return {{*motor, motor->along, Scalar(1)}};
  }
  if (joint.kind->common_slip == CommonSlip::turning) return motors_of_ball(draft, joint);
  std::vector<RubbingMotor<Scalar>> motors;
  const int from = draft.body(joint.from);
  for (std::size_t k = 0; k < joint.freedoms.size(); ++k) {
    const bool turns = joint.freedoms[k].turning;
    if (turns && joint.kind->common_slip == CommonSlip::along_plane) continue;
    const Drive<Scalar>* motor = motor_of(draft, joint, k);
    if (!motor) return {};
    RubbingMotor<Scalar> one{*motor, {from, motor->along.vector}, Scalar(1)};
    if (turns) {
      // A turning slips round: across the axis, in the picture of the surface unrolled.
      one.along.vector = across(motor->along.vector).first;
      one.arm = size_in_bearing(draft, contact, *contact.friction->bearing->radius, false);
    }
    motors.push_back(std::move(one));
  }
  return motors;
}

}  // namespace

template <class Scalar>
void add_friction_in_joint(MachineDraft<Scalar>& draft, const Contact& contact) {
  std::vector<Drive<Scalar>>& drives = draft.machine.mechanism.drives;
  const RubbingJoint rubbing = rubbing_joint(draft.situation.joints, contact.name);
  const Joint& joint = rubbing.joint;
  const std::vector<RubbingMotor<Scalar>> motors = motors_against_friction(draft, contact, rubbing);
  if (motors.empty())
    fail(draft.situation.file, contact.friction->mark,
         contact.words() + " closes a loop, and friction in such a joint is not solved",
         "state the joint before those that hold both its bodies, or the friction at another joint of the loop");
  const bool by_load = contact.friction->bearing.has_value();
  const bool couple = contact.all_ways ? joint.kind->common_slip == CommonSlip::turning : motors.front().drive.turning;
  const auto [resting, sliding] = friction_of(draft, contact,
                                              by_load  ? dimensions::none
                                              : couple ? dimensions::moment
                                                       : dimensions::force);
  RoughContactOf<Scalar> rough;
  rough.name = contact.name;
  rough.action = draft.add_action(ActionKind::friction, contact.name, joint.name, draft.body(contact.of),
                                  draft.body(contact.against));
  rough.grip = contact.grip;
  rough.resting = resting;
  rough.sliding = sliding;
  rough.turning = couple;
  rough.all_ways = contact.all_ways;
  rough.turns = contact.slip_turns;
  rough.at = motors.front().drive.at;
  if (by_load) rough.pressing = pressing_parts(draft, contact, joint);
  const Drive<Scalar>& first = motors.front().drive;
  // The axis of a sleeve or of one freedom, and the normal of a plane. A ball has none.
  const Vector3<Scalar> axis = contact.all_ways && joint.kind->common_slip == CommonSlip::along_plane
                                   ? cross(motors.front().along.vector, motors.back().along.vector)
                                   : first.along.vector;
  const int body = contact.all_ways ? draft.body(joint.from) : first.along.body;
  const auto [one, other] = across(axis);
  rough.motions[1].along = {body, axis};
  rough.motions[2].along = {body, other};
  const bool in_plane = contact.all_ways && motors.size() == 2;
  rough.normal = {body, in_plane ? cross(motors.front().along.vector, motors.back().along.vector) : one};
  if (contact.grip == Grip::slides) {
    const Vector3<Scalar> d = draft.data.direction(*contact.slip);
    const bool forward = plain(dot(d, axis)) > 0;
    rough.slip = Direction<Scalar>{body, contact.all_ways ? d : forward ? axis : -axis};
  }
  for (const RubbingMotor<Scalar>& motor : motors) {
    Drive<Scalar> drive = motor.drive;
    drive.held = contact.grip == Grip::sticks || rough.found_with_reactions();
    drive.effort = drive.stiffness = drive.free_position = drive.damping = Scalar(0);
    drive.action = rough.action;
    rough.ways.push_back({drive.coordinate, drives.size(), motor.along, motor.arm});
    if (contact.grip == Grip::sticks)
      draft.machine.accelerations.push_back(
          {contact.words() + " held by its friction", drive.coordinate, Scalar(0), drive.turning, contact.mark});
    if (contact.grip == Grip::slides && !drive.held)
      drive.effort = plain(dot(rough.slip->vector, axis)) > 0 ? -sliding : sliding;
    drives.push_back(std::move(drive));
  }
  draft.machine.rough_contacts.push_back(std::move(rough));
}

template <class Scalar>
std::pair<Scalar, Scalar> friction_of(MachineDraft<Scalar>& draft, const Contact& contact, const Dimension& dimension) {
  const bool is_coefficient = !contact.in_joint || contact.friction->bearing;
  if (!is_coefficient && draft.data.value(contact.friction->resting).dimension == dimensions::none &&
      draft.data.value(contact.friction->resting).is_number() && !draft.options.lenient)
    fail(draft.situation.file, contact.friction->mark,
         contact.words() + " states a pure number as its friction, which here is a " +
             (dimension == dimensions::moment ? "couple" : "force"),
         dimension == dimensions::moment ? "write a couple, or {coefficient: 0.1, radius: 20 mm}"
                                         : "write a force, or {coefficient: 0.2}");
  const Scalar resting = draft.data.number(contact.friction->resting, dimension),
               sliding = draft.data.number(contact.friction->sliding, dimension);
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    fail(draft.situation.file, contact.friction->mark, contact.words() + " " + message, hint);
  };
  if (!draft.options.lenient) {
    if (!(plain(resting) >= 0) || !(plain(sliding) >= 0))
      refuse(std::string("has a negative ") + (is_coefficient ? "coefficient of friction" : "friction"),
             std::string("friction resists: write ") + (is_coefficient ? "a coefficient" : "one") +
                 " that is zero or positive");
    if (plain(sliding) > plain(resting))
      refuse("has more friction while it slides than at rest",
             "static: is the larger of the two, or both are the same");
  }
  return {resting, sliding};
}

template std::pair<double, double> friction_of(MachineDraft<double>&, const Contact&, const Dimension&);
template std::pair<Dual<1>, Dual<1>> friction_of(MachineDraft<Dual<1>>&, const Contact&, const Dimension&);
template std::pair<Formula, Formula> friction_of(MachineDraft<Formula>&, const Contact&, const Dimension&);
template void add_friction_in_joint(MachineDraft<double>&, const Contact&);
template void add_friction_in_joint(MachineDraft<Dual<1>>&, const Contact&);
template void add_friction_in_joint(MachineDraft<Formula>&, const Contact&);

}  // namespace poinsot::problem
