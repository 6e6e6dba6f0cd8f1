// The loads of a machine.
#include <algorithm>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {

template <class Scalar>
void add_law(MachineDraft<Scalar>& draft, const Load& load) {
  KnownForce<Scalar> force;
  const int on = draft.body(load.body);
  force.action = draft.add_action(ActionKind::load, load.name, "", on, ground);
  force.couple = load.couple.has_value();
  force.axes = draft.body(load.axes);
  const Expression& size = load.couple ? *load.couple : *load.force;
  const Dimension dimension = load.couple ? dimensions::moment : dimensions::force;
  if (draft.options.loads &&
      std::find(draft.options.loads->begin(), draft.options.loads->end(), load.name) == draft.options.loads->end()) {
    force.vector = Vector3<Scalar>::zero();
  } else if (depends_on_motion(draft, size) || (load.direction && depends_on_motion(draft, *load.direction))) {
    force.by_motion = std::make_shared<const MotionExpression<Scalar>>(
        motion_load<Scalar>(draft, {"load '" + load.name + "'", size, load.direction, dimension}, force.axes));
  } else if (load.direction) {
    force.vector = draft.data.number(size, dimension) * draft.data.direction(*load.direction);
  } else {
    if (const Value<Scalar> value = draft.data.value(size);
        value.is_number() && !value.bare && same_kind(value.dimension, dimension))
      fail(draft.situation.file, size.mark(), "load '" + load.name + "' states a size and no direction",
           (load.couple ? "write about: z beside it, or the couple" : "write along: x beside it, or the force") +
               std::string(draft.situation.plane ? " as [a, b]" : " as [a, b, c]"));
    force.vector = draft.data.vector(size, dimension);
  }
  if (force.couple)
    require_along_normal(draft, force.vector, load.mark, "the couple of load '" + load.name + "'");
  else
    require_in_plane(draft, force.vector, load.mark, "the force of load '" + load.name + "'");
  if (!force.couple) {
    const Body& stated = draft.situation.bodies[draft.body_number(load.body)];
    if (!load.at && stated.massless)
      fail(draft.situation.file, load.mark,
           "load '" + load.name + "' needs the point at which it acts: the body is massless", "write at: P");
    force.at = draft.machine.place(
        on, load.at ? draft.data.place(*load.at) : draft.masses[draft.body_number(load.body)].properties.center);
  }
  draft.machine.mechanism.forces.push_back(force);
}

template <class Scalar>
void add_efforts_by_motion(MachineDraft<Scalar>& draft) {
  for (const EffortByMotion& effort : draft.efforts) {
    const Drive<Scalar>& drive = draft.machine.mechanism.drives[effort.drive];
    const std::string owner =
        std::string(drive.turning ? "the couple" : "the force") + " at joint '" + effort.joint->name + "'";
    const Mark mark = effort.freedom->effort->mark();
    // Within gimbals a motor passes on more than a couple about its own axis.
    if (!drive.others.empty())
      fail(draft.situation.file, mark,
           owner + " depends on the motion, which is only possible where a joint turns about a single axis",
           "state a load of the same size on the body, and its reverse on what carries the joint");
    KnownForce<Scalar> force;
    force.action = drive.action;
    force.couple = drive.turning;
    force.at = drive.at;
    force.by_motion = std::make_shared<const MotionExpression<Scalar>>(motion_effort<Scalar>(
        draft, {owner, *effort.freedom->effort, std::nullopt, drive.turning ? dimensions::moment : dimensions::force},
        drive.along));
    draft.machine.mechanism.forces.push_back(force);
  }
}

template void add_law(MachineDraft<double>&, const Load&);
template void add_law(MachineDraft<Dual<1>>&, const Load&);
template void add_law(MachineDraft<Formula>&, const Load&);
template void add_efforts_by_motion(MachineDraft<double>&);
template void add_efforts_by_motion(MachineDraft<Dual<1>>&);
template void add_efforts_by_motion(MachineDraft<Formula>&);

}  // namespace poinsot::problem
