#include "problem/instant/blow_as_loads.h"

#include <algorithm>

#include "problem/entries/absorbed_particles.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/units.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

Expression times(const Expression& one, const Expression& other) { return built(Binary{'*', one, other}, one.mark()); }

// The size of an impulse or of a momentum as that of a force.
Expression in_a_second(const Expression& size) {
  const Expression second = built(Number{1, si_unit(dimensions::time), true, "1 s"}, size.mark());
  return built(Binary{'/', size, second}, size.mark());
}

// Leaves out all forces and what has no impulse; those of constraints stay.
void leave_out_forces(Situation& loads, const Mark& mark) {
  loads.impulses.clear();
  loads.strikes.clear();
  for_each_law_list(loads, [](auto& laws) { laws.clear(); });
  loads.stages.clear();
  std::erase_if(loads.contacts, &Contact::in_joint);
  loads.gravity = built(Name{"none"}, mark);
  loads.central_gravity.reset();
  for (Joint& joint : loads.joints) {
    joint.friction.reset();
    for (Freedom& freedom : joint.freedoms) {
      freedom.effort.reset();
      freedom.stiffness.reset();
      freedom.damping.reset();
      freedom.friction.reset();
    }
  }
}

Load& add_load(Situation& loads, const std::string& name, const std::string& body, const Mark& mark) {
  Load load;
  load.name = name;
  load.body = body;
  load.mark = load.body_mark = load.axes_mark = mark;
  load.axes = "ground";
  loads.loads.push_back(std::move(load));
  return loads.loads.back();
}

}  // namespace

Situation blow_as_loads(const Situation& situation) {
  const auto rough = std::ranges::find_if(situation.contacts, &Contact::rubs);
  const auto refuse = [&](const Mark& mark, const std::string& what, const std::string& hint) {
    fail(situation.file, mark, what + " where contact '" + rough->name + "' has friction", hint);
  };
  if (!situation.impacts.empty())
    refuse(situation.impacts.front().mark, "impacts are not solved", "leave out the friction of the contact");
  if (!situation.frames.empty())
    refuse(situation.frames.front().mark, "blows in frames that move are not solved", "leave out the friction");
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (freedom.rate || freedom.accel)
        refuse(joint.mark, "blows on what moves as stated are not solved", "leave out the friction");
  for (const Instant& instant : situation.instants) {
    if (instant.name == "after" && (instant.rest || !instant.facts.empty()))
      refuse(instant.mark, "nothing is found from what is stated after a blow", "ask for it");
  }
  const std::optional<Situation> changed = with_absorbed_particles(situation);
  Situation loads = changed ? *changed : situation;
  leave_out_forces(loads, rough->mark);
  const auto add = [&](const std::string& name, const std::string& body, const Mark& mark) -> Load& {
    return add_load(loads, name, body, mark);
  };
  for (const Impulse& impulse : situation.impulses) {
    Load& load = add(impulse.name, impulse.body, impulse.mark);
    load.axes = impulse.axes;
    load.direction = impulse.direction;
    load.at = impulse.at;
    const Expression& size = impulse.value ? *impulse.value : impulse.force ? *impulse.force : *impulse.couple;
    (impulse.couple ? load.couple : load.force) = in_a_second(impulse.lasts ? times(size, *impulse.lasts) : size);
  }
  for (const Strike& strike : situation.strikes) {
    if (strike.relative_to != "ground" && strike.relative_to != strike.hits)
      refuse(strike.mark, "strikes relative to other bodies are not solved", "state the velocity of the particle");
    if (!strike.amount.mass)
      refuse(strike.mark, "strikes are not solved of a particle given by its weight", "state its mass");
    Load& load = add(strike.name, strike.hits, strike.mark);
    load.at = strike.at;
    const Expression momentum = times(*strike.amount.mass, strike.velocity);
    load.force = in_a_second(strike.loses ? times(momentum, *strike.loses) : momentum);
  }
  Instant rest;
  rest.name = "now";
  rest.rest = true;
  rest.mark = rough->mark;
  loads.instants = {rest};
  return loads;
}

Situation momenta_as_loads(const Situation& situation, const std::vector<StatedMomentum>& momenta) {
  Situation loads = situation;
  const Mark mark{1, 1};
  leave_out_forces(loads, mark);
  loads.impacts.clear();
  const auto vector = [&](const Vector3<double>& size, const Dimension& dimension) {
    List parts;
    for (std::size_t k = 0; k < 3; ++k)
      parts.items.push_back(built(Number{size[k], si_unit(dimension), true, with_digits(size[k], 17)}, mark));
    return built(std::move(parts), mark);
  };
  for (StatedMomentum one : momenta) {
    // In a plane no other momentum can change: of the rest there is at most rounding, or what holds a body there takes
    // it.
    for (std::size_t k = 0; situation.plane && k < 3; ++k)
      (k == situation.plane->normal() ? one.linear : one.angular)[k] = 0;
    add_load(loads, "momentum of " + one.body, one.body, mark).force = vector(one.linear, dimensions::force);
    add_load(loads, "angular momentum of " + one.body, one.body, mark).couple = vector(one.angular, dimensions::moment);
  }
  return loads;
}

}  // namespace poinsot::problem
