// The springs of a machine.
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

void refuse_own_body(const Situation& situation, const Spring& spring) {
  if (spring.to != spring.from) return;
  fail(situation.file, spring.mark, "spring '" + spring.name + "' joins '" + spring.to + "' to itself",
       "name two bodies, or ground, under from: and to:");
}

template <class Scalar>
void add_torsional_spring(MachineDraft<Scalar>& draft, const Spring& spring) {
  const int on = draft.body(spring.to), from = draft.body(spring.from);
  refuse_own_body(draft.situation, spring);
  TorsionLaw<Scalar> law;
  law.action = draft.add_action(ActionKind::spring, spring.name, "", on, from);
  law.on = on;
  law.along = {from, draft.data.direction(*spring.about)};
  require_along_normal(draft, law.along.vector, spring.about->mark(), "the axis of spring '" + spring.name + "'");
  set_resistance(draft, spring, dimensions::moment, dimensions::angle, law);
  if (spring.free_angle) law.free_angle = draft.data.number(*spring.free_angle, dimensions::angle);
  draft.machine.mechanism.torsions.push_back(law);
}

}  // namespace

template <class Scalar>
void add_law(MachineDraft<Scalar>& draft, const Spring& spring) {
  if (spring.about) return add_torsional_spring(draft, spring);
  SpringLaw<Scalar> law;
  const int on = draft.body(spring.to), from = draft.body(spring.from);
  refuse_own_body(draft.situation, spring);
  law.action = draft.add_action(ActionKind::spring, spring.name, "", on, from);
  const Vector3<Scalar> start = draft.data.place(*spring.at), end = draft.data.place(*spring.end);
  law.at = draft.machine.place(on, end);
  law.toward = draft.machine.place(from, start);
  if (!(norm(plain(end - start)) > 0))
    fail(draft.situation.file, spring.mark,
         "spring '" + spring.name + "' has length zero as drawn: it has no direction");
  require_in_plane<Scalar>(draft, end - start, spring.mark, "spring '" + spring.name + "'");
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

template void add_law(MachineDraft<double>&, const Spring&);
template void add_law(MachineDraft<Dual<1>>&, const Spring&);
template void add_law(MachineDraft<Formula>&, const Spring&);

}  // namespace poinsot::problem
