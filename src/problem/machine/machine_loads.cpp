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
  } else if (load.direction) {
    force.vector = draft.data.number(size, dimension) * draft.data.direction(*load.direction);
  } else {
    force.vector = draft.data.vector(size, dimension);
  }
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

template void add_law(MachineDraft<double>&, const Load&);
template void add_law(MachineDraft<Dual<1>>&, const Load&);
template void add_law(MachineDraft<Formula>&, const Load&);

}  // namespace poinsot::problem
