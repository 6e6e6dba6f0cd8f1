// The impulses, impacts and strikes of a machine.

#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/machine/machine_draft.h"

namespace poinsot::problem {
namespace {

template <class Scalar>
Place<Scalar> impulse_place(const MachineDraft<Scalar>& draft, const std::string& on,
                            const std::optional<Expression>& at, const std::string& owner, const Mark& mark) {
  const std::size_t i = draft.body_number(on);
  if (!at && draft.situation.bodies[i].massless)
    fail(draft.situation.file, mark, owner + " needs the point at which it acts: the body is massless", "write at: P");
  return draft.machine.place(draft.body(on), at ? draft.data.place(*at) : draft.masses[i].properties.center);
}

// Whether a number lies between 0 and 1, up to the rounding of one that was found.
bool is_part(double x) {
  constexpr double found_to = 1e-9;  // by the search for unknowns
  return x >= -found_to && x <= 1 + found_to;
}

std::string number_in_words(double x) { return with_digits(x, 6); }

}  // namespace

template <class Scalar>
void add_impulse(MachineDraft<Scalar>& draft, const Impulse& impulse) {
  StatedImpulseOf<Scalar> stated;
  stated.on = draft.body(impulse.body);
  stated.action = draft.add_action(ActionKind::impulse, impulse.name, "", stated.on, ground);
  stated.axes = draft.body(impulse.axes);
  stated.couple = impulse.couple.has_value();
  const Expression& size = impulse.value ? *impulse.value : impulse.force ? *impulse.force : *impulse.couple;
  const Scalar duration = impulse.lasts ? draft.data.number(*impulse.lasts, dimensions::time) : Scalar(1);
  if (plain(duration) < 0)
    fail(draft.situation.file, impulse.lasts->mark(), "impulse '" + impulse.name + "' lasts a negative time");
  Dimension dimension = stated.couple ? dimensions::moment : dimensions::force;
  if (!impulse.lasts) dimension = dimension * dimensions::time;
  stated.vector =
      duration * (impulse.direction ? draft.data.number(size, dimension) * draft.data.direction(*impulse.direction)
                                    : draft.data.vector(size, dimension));
  if (stated.couple)
    require_along_normal(draft, stated.vector, impulse.mark, "the couple of impulse '" + impulse.name + "'");
  else
    require_in_plane(draft, stated.vector, impulse.mark, "impulse '" + impulse.name + "'");
  if (!stated.couple)
    stated.at = impulse_place(draft, impulse.body, impulse.at, "impulse '" + impulse.name + "'", impulse.mark);
  draft.machine.impulses.push_back(stated);
}

template <class Scalar>
void add_impact(MachineDraft<Scalar>& draft, const Impact& impact) {
  solve::ImpactOf<Scalar> struck;
  struck.name = impact.name;
  struck.on = draft.body(impact.of);
  struck.from = draft.body(impact.against);
  struck.action = draft.add_action(ActionKind::impact, impact.name, "", struck.on, struck.from);
  struck.at = draft.machine.place(struck.on, draft.data.place(impact.at));
  struck.push = {struck.from, draft.data.direction(impact.pushes)};
  require_in_plane(draft, struck.push.vector, impact.pushes.mark(), "the push of impact '" + impact.name + "'");
  if (impact.restitution) struck.restitution = draft.data.number(*impact.restitution, dimensions::none);
  if (!is_part(plain(struck.restitution)))
    fail(draft.situation.file, impact.restitution->mark(),
         "a coefficient of restitution lies between 0 and 1, and that of impact '" + impact.name + "' is " +
             number_in_words(plain(struck.restitution)),
         "correct it, or the velocities from which it follows");
  if (impact.friction) {
    struck.friction = draft.data.number(*impact.friction, dimensions::none);
    struck.hypothesis = impact.hypothesis;
    if (!(plain(*struck.friction) >= 0) && !draft.options.lenient)
      fail(draft.situation.file, impact.friction->mark(),
           "the coefficient of friction of impact '" + impact.name + "' is negative");
  }
  draft.machine.impacts.push_back(struck);
}

template <class Scalar>
void add_strike(MachineDraft<Scalar>& draft, const Strike& strike) {
  const std::string owner = "strike '" + strike.name + "'";
  const Scalar mass = strike.amount.mass
                          ? draft.data.number(*strike.amount.mass, dimensions::mass)
                          : draft.data.number(*strike.amount.weight, dimensions::force) / draft.data.gravity_size();
  if (!(plain(mass) >= 0)) fail(draft.situation.file, strike.mark, owner + ": the mass of the particle is negative");
  StatedImpulseOf<Scalar> stated;
  stated.on = draft.body(strike.hits);
  stated.action = draft.add_action(ActionKind::impulse, strike.name, "", stated.on, ground);
  stated.at = draft.machine.place(stated.on, draft.data.place(strike.at));
  stated.vector = mass * draft.data.vector(strike.velocity, dimensions::velocity);
  require_in_plane(draft, stated.vector, strike.velocity.mark(), "the velocity of " + owner);
  stated.relative_to = draft.body(strike.relative_to);
  if (strike.loses) {
    const Scalar loss = draft.data.number(*strike.loses, dimensions::none);
    if (!is_part(plain(loss)))
      fail(draft.situation.file, strike.loses->mark(),
           owner + ": a particle loses between 0 and 100 % of its speed, not " + number_in_words(100 * plain(loss)) +
               " %");
    stated.kept = Scalar(1) - loss;
  }
  stated.absorbed = strike.stays && !strike.mass_neglected ? mass : Scalar(0);
  stated.particle_mass = mass;
  draft.machine.impulses.push_back(stated);
}

template void add_impulse(MachineDraft<double>&, const Impulse&);
template void add_impact(MachineDraft<double>&, const Impact&);
template void add_strike(MachineDraft<double>&, const Strike&);
template void add_impulse(MachineDraft<Dual<1>>&, const Impulse&);
template void add_impact(MachineDraft<Dual<1>>&, const Impact&);
template void add_strike(MachineDraft<Dual<1>>&, const Strike&);
template void add_impulse(MachineDraft<Formula>&, const Impulse&);
template void add_impact(MachineDraft<Formula>&, const Impact&);
template void add_strike(MachineDraft<Formula>&, const Strike&);

}  // namespace poinsot::problem
