// The springs and loads of a machine.
#include <algorithm>

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {

namespace {

// Stiffness and damping of a spring, in units of what it exerts (force or couple) and of what it resists (length or
// angle).
template <class Scalar, class Law>
void set_resistance(MachineDraft<Scalar>& draft, const Spring& spring, const Dimension& effort,
                    const Dimension& position, Law& law) {
  if (spring.stiffness) {
    law.stiffness = draft.data.number(*spring.stiffness, effort / position);
    if (!(plain(law.stiffness) > 0))
      fail(draft.situation.file, spring.stiffness->mark(),
           "the stiffness of spring '" + spring.name + "' must be positive");
  }
  if (spring.damping) {
    law.damping = draft.data.number(*spring.damping, effort / position * dimensions::time);
    if (plain(law.damping) < 0)
      fail(draft.situation.file, spring.damping->mark(), "the damping of '" + spring.name + "' is negative");
  }
}

template <class Scalar>
void add_torsional_spring(MachineDraft<Scalar>& draft, const Spring& spring) {
  const int on = draft.body(spring.to), from = draft.body(spring.from);
  if (on == from)
    fail(draft.situation.file, spring.mark, "spring '" + spring.name + "' joins '" + spring.to + "' to itself");
  TorsionLaw<Scalar> law;
  law.action = draft.add_action(ActionKind::spring, spring.name, "", on, from);
  law.on = on;
  law.along = {from, draft.data.direction(*spring.about)};
  set_resistance(draft, spring, dimensions::moment, dimensions::angle, law);
  if (spring.free_angle) law.free_angle = draft.data.number(*spring.free_angle, dimensions::angle);
  draft.machine.mechanism.torsions.push_back(law);
}

}  // namespace

template <class Scalar>
void add_spring(MachineDraft<Scalar>& draft, const Spring& spring) {
  if (spring.about) return add_torsional_spring(draft, spring);
  SpringLaw<Scalar> law;
  const int on = draft.body(spring.to), from = draft.body(spring.from);
  law.action = draft.add_action(ActionKind::spring, spring.name, "", on, from);
  const Vector3<Scalar> start = draft.data.place(*spring.at), end = draft.data.place(*spring.end);
  law.at = draft.machine.place(on, end);
  law.toward = draft.machine.place(from, start);
  if (!(norm(plain(end - start)) > 0))
    fail(draft.situation.file, spring.mark,
         "spring '" + spring.name + "' has length zero as drawn: it has no direction");
  set_resistance(draft, spring, dimensions::force, dimensions::length, law);
  if (spring.stiffness) {
    law.free_length = spring.free_length
                          ? draft.data.number(*spring.free_length, dimensions::length)
                          : norm(end - start) - draft.data.number(*spring.tension, dimensions::force) / law.stiffness;
    if (!(plain(law.free_length) >= 0))
      fail(draft.situation.file, spring.mark, "spring '" + spring.name + "' has a negative free length");
  }
  draft.machine.mechanism.springs.push_back(law);
}

template <class Scalar>
void add_load(MachineDraft<Scalar>& draft, const Load& load) {
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

template void add_spring(MachineDraft<double>&, const Spring&);
template void add_load(MachineDraft<double>&, const Load&);
template void add_spring(MachineDraft<Dual<1>>&, const Spring&);
template void add_load(MachineDraft<Dual<1>>&, const Load&);
template void add_spring(MachineDraft<Formula>&, const Spring&);
template void add_load(MachineDraft<Formula>&, const Load&);

}  // namespace poinsot::problem
