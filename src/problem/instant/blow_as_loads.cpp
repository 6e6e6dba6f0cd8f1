#include "problem/instant/blow_as_loads.h"

#include <algorithm>

#include "problem/entries/absorbed_particles.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/units.h"

namespace poinsot::problem {
namespace {

Expression times(const Expression& one, const Expression& other) { return built(Binary{'*', one, other}, one.mark()); }

// The size of an impulse or of a momentum as that of a force.
Expression in_a_second(const Expression& size) {
  const Expression second = built(Number{1, si_unit(dimensions::time), true, "1 s"}, size.mark());
  return built(Binary{'/', size, second}, size.mark());
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
  loads.impulses.clear();
  loads.strikes.clear();
  for_each_law_list(loads, [](auto& laws) { laws.clear(); });
  loads.stages.clear();
  std::erase_if(loads.contacts, &Contact::in_joint);
  loads.gravity = built(Name{"none"}, rough->mark);
  loads.central_gravity.reset();
  for (Joint& joint : loads.joints)
    for (Freedom& freedom : joint.freedoms) {
      freedom.effort.reset();
      freedom.stiffness.reset();
      freedom.damping.reset();
      freedom.friction.reset();
    }
  const auto add = [&](const std::string& name, const std::string& body, const Mark& mark) -> Load& {
    Load load;
    load.name = name;
    load.body = body;
    load.mark = load.body_mark = load.axes_mark = mark;
    load.axes = "ground";
    loads.loads.push_back(std::move(load));
    return loads.loads.back();
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

}  // namespace poinsot::problem
