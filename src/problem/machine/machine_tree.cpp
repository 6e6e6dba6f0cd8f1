// Builds the tree of a machine: which joint holds which body, and the coordinates.
#include <algorithm>
#include <set>

#include "poinsot/engine/mass/composition.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

bool states_motion(const Joint& joint) {
  return std::any_of(joint.freedoms.begin(), joint.freedoms.end(), [](const Freedom& freedom) {
    return freedom.position || freedom.rate || freedom.accel || freedom.effort || freedom.stiffness || freedom.damping;
  });
}

template <class Scalar>
poinsot::Joint<Scalar> link_joint(const MachineDraft<Scalar>& draft, const Joint& joint, std::size_t freedom,
                                  const Vector3<Scalar>& direction) {
  if (joint.kind->advances) return poinsot::Joint<Scalar>::screw(direction, pitch_of(draft, joint));
  return joint.freedoms[freedom].turning ? poinsot::Joint<Scalar>::revolute(direction)
                                         : poinsot::Joint<Scalar>::prismatic(direction);
}

template <class Scalar>
void name_coordinate(MachineDraft<Scalar>& draft, const Joint& joint, const Freedom& freedom, std::size_t position,
                     std::size_t velocity) {
  NamedCoordinate coordinate;
  coordinate.joint = joint.name;
  coordinate.position = static_cast<int>(position);
  coordinate.velocity = static_cast<int>(velocity);
  coordinate.turning = freedom.turning;
  coordinate.mark = freedom.mark;
  const std::string owner = "joint '" + joint.name + "'" + (freedom.name.empty() ? "" : ", " + freedom.name);
  if (freedom.position) {
    const Name* name = freedom.position->as<Name>();
    const bool named = name && name->primes == 0 && name->name != "pi" && name->name != "any";
    const bool valued = !named || draft.data.knows(name->name);
    if (named) {
      coordinate.name = name->name;
      coordinate.mark = freedom.position->mark();
      for (const NamedCoordinate& other : draft.machine.coordinates)
        if (other.name == coordinate.name)
          fail(draft.situation.file, coordinate.mark, "two coordinates have the name '" + coordinate.name + "'",
               "rename one of them");
    }
    if (valued) {
      const TimedNumber<Scalar> value =
          draft.timed_number(*freedom.position, freedom.turning ? dimensions::angle : dimensions::length);
      draft.machine.q[position] = value.value;
      draft.machine.position_given[position] = true;
      if (value.derivative) {
        const std::string words = owner + ": position as a function of time";
        draft.state_rate(words, velocity, *value.derivative, freedom.turning, freedom.position->mark());
        draft.state_acceleration(words, velocity, *value.second_derivative, freedom.turning, freedom.position->mark());
      }
    }
  }
  draft.machine.mechanism.coordinate_names[velocity] =
      "the rate of " + (coordinate.name.empty() ? owner : "'" + coordinate.name + "' at " + owner);
  if (freedom.rate) {
    const TimedNumber<Scalar> rate =
        draft.timed_number(*freedom.rate, freedom.turning ? dimensions::angular_velocity : dimensions::velocity);
    draft.state_rate(owner + ": rate", velocity, rate.value, freedom.turning, freedom.rate->mark());
    if (rate.derivative)
      draft.state_acceleration(owner + ": rate as a function of time", velocity, *rate.derivative, freedom.turning,
                               freedom.rate->mark());
  }
  if (freedom.accel)
    draft.state_acceleration(
        owner + ": accel", velocity,
        draft
            .timed_number(*freedom.accel, freedom.turning ? dimensions::angular_acceleration : dimensions::acceleration)
            .value,
        freedom.turning, freedom.accel->mark());
  draft.machine.coordinates.push_back(std::move(coordinate));
}

// Adds the links of a joint. reversed: the body `to` is in the tree already, and `from` becomes its child.
template <class Scalar>
void add_joint(MachineDraft<Scalar>& draft, const Joint& joint, bool reversed) {
  const JointAxes<Scalar> axes = axes_of(draft, joint);
  const std::string& child = reversed ? joint.from : joint.to;
  int parent = draft.body(reversed ? joint.to : joint.from);
  const std::size_t child_index = draft.body_number(child);
  const MassProperties<Scalar>& mass = draft.masses[child_index].properties;
  if (joint.freedoms.empty()) {
    const std::size_t first = draft.next_velocity();
    const bool ball = joint.kind->any_turning;
    // A particle that is welded has its origin where it is. About another one its moment of inertia is not zero, and
    // taken back to the place of the particle it is rounding: two in one place would be spun by that.
    const Body& body = draft.situation.bodies[child_index];
    const bool particle = body.parts.size() == 1 && body.parts.front().shape.kind == "particle";
    draft.machine.index[child] =
        draft.add_link(child, parent, ball ? poinsot::Joint<Scalar>::ball() : poinsot::Joint<Scalar>::weld(),
                       particle && !ball ? draft.masses[child_index].center : axes.at, mass);
    if (ball)
      for (std::size_t k = 0; k < 3; ++k)
        draft.machine.mechanism.coordinate_names[first + k] =
            "angular velocity of " + child + " at " + joint.name + " along " + draft.situation.axes[k];
    return;
  }
  const std::size_t n = joint.freedoms.size();
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t k = reversed ? n - 1 - step : step;
    const Freedom& freedom = joint.freedoms[k];
    const bool last = step + 1 == n;
    const Vector3<Scalar> direction = reversed ? -axes.freedom[k] : axes.freedom[k];
    const std::size_t velocity = draft.next_velocity();
    const std::size_t position = draft.machine.q.size();
    const int link = draft.add_link(last ? child : joint.name + "." + freedom.name, parent,
                                    link_joint(draft, joint, k, direction), axes.at, last ? mass : massless<Scalar>());
    draft.link_of_freedom[{joint.name, k}] = {link, parent};
    name_coordinate(draft, joint, freedom, position, velocity);
    parent = link;
  }
  draft.machine.index[child] = parent;
}

// A joint between two bodies of the tree closes a loop: the motions that it forbids become constraints. The link
// between the two axes about which a universal joint turns becomes a child of `from`, so that its second axis is the
// one that a revolute joint leaves free.
template <class Scalar>
void close_loop(MachineDraft<Scalar>& draft, const Joint& joint) {
  if (states_motion(joint))
    fail(draft.situation.file, joint.mark,
         "joint '" + joint.name + "' closes a loop, and all its bodies are already placed by other joints",
         "state angles, rates and couples at the other joints of the loop");
  draft.machine.loop_joints.push_back(joint.name);
  draft.loops.push_back(&joint);
  const JointAxes<Scalar> axes = axes_of(draft, joint);
  const auto turnings = axes.two_turnings;
  if (!turnings) return;
  const std::size_t velocity = draft.next_velocity();
  const Freedom& first = joint.freedoms[turnings->first];
  const int parent = draft.body(joint.from);
  const int cross =
      draft.add_link(joint.name + "." + first.name, parent,
                     poinsot::Joint<Scalar>::revolute(axes.freedom[turnings->first]), axes.at, massless<Scalar>());
  draft.cross_of_loop[joint.name] = cross;
  draft.link_of_freedom[{joint.name, turnings->first}] = {cross, parent};
  draft.machine.mechanism.coordinate_names[velocity] = "the rate of joint '" + joint.name + "', " + first.name;
}

}  // namespace

template <class Scalar>
void add_tree(MachineDraft<Scalar>& draft) {
  std::set<std::string> placed{"ground"};
  for (const Frame& frame : draft.situation.frames) placed.insert(frame.name);
  std::vector<const Joint*> waiting;
  for (const Joint& joint : draft.situation.joints) waiting.push_back(&joint);
  std::stable_sort(waiting.begin(), waiting.end(),
                   [](const Joint* a, const Joint* b) { return states_motion(*a) > states_motion(*b); });
  while (placed.size() < 1 + draft.situation.frames.size() + draft.situation.bodies.size()) {
    bool grown = false;
    for (auto it = waiting.begin(); it != waiting.end(); ++it) {
      const Joint& joint = **it;
      const bool from = placed.contains(joint.from), to = placed.contains(joint.to);
      if (from == to) continue;
      add_joint(draft, joint, !from);
      placed.insert(from ? joint.to : joint.from);
      waiting.erase(it);
      grown = true;
      break;
    }
    if (grown) continue;
    // The body that holds others is placed as drawn, independent of the order in the file.
    const auto waits = [&](const Body& body) { return !placed.contains(body.name); };
    const auto held = [&](const Body& body) {
      return std::any_of(waiting.begin(), waiting.end(), [&](const Joint* joint) { return joint->to == body.name; });
    };
    auto free = std::find_if(draft.situation.bodies.begin(), draft.situation.bodies.end(),
                             [&](const Body& body) { return waits(body) && !held(body); });
    if (free == draft.situation.bodies.end())
      free = std::find_if(draft.situation.bodies.begin(), draft.situation.bodies.end(), waits);
    const std::size_t first = draft.next_velocity();
    const std::size_t i = static_cast<std::size_t>(free - draft.situation.bodies.begin());
    const Vector3<Scalar> origin = free->massless ? Vector3<Scalar>::zero() : draft.masses[i].center;
    draft.machine.index[free->name] =
        draft.add_link(free->name, ground, poinsot::Joint<Scalar>::free(), origin, draft.masses[i].properties);
    draft.name_free(free->name, first, 6);
    placed.insert(free->name);
  }
  for (const Joint* joint : waiting) close_loop(draft, *joint);
}

template void add_tree(MachineDraft<double>&);
template void add_tree(MachineDraft<Dual<1>>&);
template void add_tree(MachineDraft<Formula>&);

}  // namespace poinsot::problem
