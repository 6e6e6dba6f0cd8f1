#include "problem/entries/read_actions.h"

#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

// What stands below a key that names it.
template <class Thing>
Thing begun(const Key& name) {
  Thing thing;
  thing.name = name.text;
  thing.mark = name.mark;
  return thing;
}

// The body that a key names, and where it does.
void take_body(const Members& members, std::string_view key, std::string_view example, const std::string& file,
               std::string& name, Mark& mark) {
  name = scalar_text(members.require(key, example), file, "the name of a body");
  mark = members.mark_of(key);
}

// The body or frame that a key names; the ground if it is left out.
void take_holder(const Members& members, std::string_view key, std::string& name, Mark& mark) {
  name = members.find(key) ? members.text(key) : "ground";
  mark = members.mark_of(key);
}

}  // namespace

Frame read_frame(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"frame"});
  auto frame = begun<Frame>(name);
  frame.origin = members.expression("origin");
  frame.velocity = members.expression("velocity");
  frame.acceleration = members.expression("acceleration");
  if (const auto rides_on = members.expression("rides_on")) {
    const Call* call = rides_on->as<Call>();
    const Name* body = call && call->function == "center" && call->arguments.size() == 1
                           ? call->arguments[0].value.as<Name>()
                           : nullptr;
    if (!body)
      fail(file, rides_on->mark(), "a frame rides on the mass center of a body", "write rides_on: center(projectile)");
    frame.rides_on = body->name;
    frame.rides_on_mark = rides_on->mark();
    if (frame.origin || frame.velocity || frame.acceleration)
      fail(file, name.mark, "frame '" + name.text + "' rides on a body and states its own motion as well",
           "state one of them");
  }
  frame.turns = members.expression("turns");
  frame.rate = members.expression("rate");
  frame.accel = members.expression("accel");
  if (frame.turns.has_value() != frame.rate.has_value())
    fail(file, name.mark,
         "frame '" + name.text + "' states " + (frame.turns ? "an axis but no rate" : "a rate but no axis"),
         "write turns: y, rate: 3 rad/s");
  return frame;
}

Friction read_friction(const Entry& entry, const Mark& mark, const std::string& file) {
  if (entry.is_scalar()) {
    const Expression both = parse_expression(entry, file);
    return {both, both, mark};
  }
  const Members members(entry, file, {"friction"});
  return {members.require_expression("static", "static: 0.4"), members.require_expression("kinetic", "kinetic: 0.35"),
          mark};
}

Contact read_contact(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"contact"});
  auto contact = begun<Contact>(name);
  take_body(members, "of", "of: disk", file, contact.of, contact.of_mark);
  take_holder(members, "against", contact.against, contact.against_mark);
  contact.at = members.require_expression("at", "at: C");
  contact.normal = members.require_expression("normal", "normal: +y");
  if (const Entry* no_slip = members.find("no_slip"); no_slip && no_slip->is_list())
    contact.no_slip_along = members.list("no_slip");
  else
    contact.no_slip = members.boolean("no_slip").value_or(false);
  contact.inside = members.text("inside");
  if (!contact.inside.empty()) {
    contact.inside_mark = members.mark_of("inside");
    if (contact.inside != contact.of && contact.inside != contact.against)
      fail(file, contact.inside_mark,
           "contact '" + name.text + "' is inside '" + contact.inside + "', which does not take part in it",
           "name the body whose hollow side touches: inside: " +
               (contact.against == "ground" ? std::string("bowl, with against: bowl") : contact.against));
  }
  if (members.find("carries")) contact.carries = members.list("carries");
  if (const Entry* friction = members.find("friction")) {
    contact.friction = read_friction(*friction, members.mark_of("friction"), file);
    for (const char* key : {"no_slip", "carries"})
      if (members.find(key))
        fail(file, members.mark_of(key),
             "contact '" + name.text + "' states friction and " + key + ": whether it slips follows from the friction",
             "leave out one of them");
  }
  contact.open = members.boolean("open").value_or(false);
  contact.surface = members.expression("surface");
  contact.restitution = members.expression("restitution");
  if (contact.surface && !contact.open)
    fail(file, members.mark_of("surface"),
         "contact '" + name.text + "' touches at the start, and its surface goes through the point under at:",
         "leave out surface:, or write open: true");
  if (contact.restitution && members.find("no_slip"))
    fail(file, members.mark_of("restitution"), "contact '" + name.text + "' states no_slip and restitution",
         "state friction: what rebounds slips or sticks by its law");
  if (contact.open && !contact.inside.empty())
    fail(file, contact.inside_mark, "contact '" + name.text + "' is open, and meets a plane: no hollow side",
         "leave out open: true, or inside:");
  if (contact.friction && contact.restitution && !contact.open)
    fail(
        file, members.mark_of("restitution"),
        "contact '" + name.text + "' has friction and touches at the start: motions in which it parts are not followed",
        "write open: true if it does not touch at the start, or leave out the friction");
  if (contact.friction && contact.open) {
    if (contact.friction->falls())
      fail(file, contact.friction->mark, "in a blow there is one coefficient of friction, not two",
           "write friction: 0.3 at a contact that is open");
    contact.blow_friction = contact.friction->sliding;
    contact.friction.reset();
  }
  return contact;
}

namespace {

// A wheel by its name alone, or a map from its name to what is said of it.
CordWheel read_wheel(const Entry& entry, const std::string& file, const char* key) {
  CordWheel wheel;
  wheel.mark = entry.mark;
  if (!entry.is_map()) {
    wheel.name = scalar_text(entry, file, std::string("the name of a wheel or point under ") + key);
    wheel.named = parse_expression(entry, file);
    return wheel;
  }
  if (entry.members.size() != 1)
    fail(file, entry.mark, "each wheel stands by itself",
         std::string("write ") + key + ": [{pulley: {side: +y}}, ...]");
  const auto& [name, said] = entry.members.front();
  const Members members(said, file, {"cord_wheel"});
  wheel.name = name.text;
  wheel.named = parse_expression(name.text, file, name.mark);
  wheel.mark = name.mark;
  wheel.at = members.expression("at");
  wheel.radius = members.expression("radius");
  wheel.side = members.expression("side");
  wheel.smooth = members.boolean("smooth").value_or(false);
  return wheel;
}

// An end that winds on a wheel: the key gives a map in place of a name.
std::optional<CordWheel> read_winding(const Members& members, const char* key, const char* point, Cord& cord,
                                      const std::string& file) {
  const Entry* entry = members.find(key);
  if (!entry || !entry->is_map()) return std::nullopt;
  if (members.find(point))
    fail(file, members.mark_of(point),
         "cord '" + cord.name + "' winds on a wheel of '" + key + ":' and is tied to a point there as well",
         std::string("remove ") + point + ":, or write " + key + ": with a name alone");
  CordWheel wheel = read_wheel(*entry, file, key);
  if (wheel.smooth)
    fail(file, wheel.mark, "a cord that winds on '" + wheel.name + "' does not slide over it", "remove smooth:");
  return wheel;
}

}  // namespace

Cord read_cord(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"cord"});
  auto cord = begun<Cord>(name);
  if (members.find("holds")) {
    for (const char* key : {"to", "end", "from", "over"})
      if (members.find(key))
        fail(file, members.mark_of(key), "cord '" + name.text + "' states both holds and " + key,
             "a long cord has holds, at and pulls; a cord between two points from, at, to and end");
    cord.from = "ground";
    cord.to = members.text("holds");
    cord.to_mark = members.mark_of("holds");
    cord.end = members.require_expression("at", "at: A");
    cord.direction = members.require_expression("pulls", "pulls: +y");
  } else {
    cord.off_from = read_winding(members, "from", "at", cord, file);
    cord.on_to = read_winding(members, "to", "end", cord, file);
    if (cord.off_from) {
      cord.from = cord.off_from->name;
      cord.from_mark = cord.off_from->mark;
    } else {
      take_holder(members, "from", cord.from, cord.from_mark);
      cord.at = members.require_expression("at", "at: C");
    }
    if (cord.on_to) {
      cord.to = cord.on_to->name;
      cord.to_mark = cord.on_to->mark;
    } else {
      take_body(members, "to", "to: rod", file, cord.to, cord.to_mark);
      cord.end = members.require_expression("end", "end: B");
    }
    if (const Entry* over = members.find("over")) {
      if (!over->is_list())
        fail(file, over->mark, "what a cord is led over is a list, in the order of the cord", "write over: [pulley]");
      for (const Entry& one : over->items) cord.over.push_back(read_wheel(one, file, "over"));
    }
  }
  return cord;
}

Gear read_gear(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"gear"});
  auto gear = begun<Gear>(name);
  take_body(members, "of", "of: pinion", file, gear.of, gear.of_mark);
  take_holder(members, "against", gear.against, gear.against_mark);
  gear.at = members.require_expression("at", "at: P");
  return gear;
}

Impulse read_impulse(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"impulse"});
  auto impulse = begun<Impulse>(name);
  take_body(members, "body", "body: plate", file, impulse.body, impulse.body_mark);
  take_holder(members, "axes", impulse.axes, impulse.axes_mark);
  impulse.value = members.expression("value");
  impulse.force = members.expression("force");
  impulse.couple = members.expression("couple");
  impulse.lasts = members.expression("lasts");
  impulse.direction = members.expression("along");
  impulse.at = members.expression("at");
  if (impulse.value.has_value() + impulse.force.has_value() + impulse.couple.has_value() != 1)
    fail(file, name.mark, "impulse '" + name.text + "' needs one of value, force (with lasts) and couple");
  if (impulse.force && !impulse.lasts)
    fail(file, name.mark, "impulse '" + name.text + "' does not say how long its force lasts",
         "write lasts: 0.1 s, or value: with an impulse");
  if (impulse.value && impulse.lasts)
    fail(file, members.mark_of("lasts"), "an impulse given by its value has no duration", "remove lasts:");
  if (impulse.couple && impulse.at) fail(file, members.mark_of("at"), "a couple has no point", "remove at:");
  return impulse;
}

Impact read_impact(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"impact"});
  auto impact = begun<Impact>(name);
  take_body(members, "of", "of: plate", file, impact.of, impact.of_mark);
  take_holder(members, "against", impact.against, impact.against_mark);
  impact.at = members.require_expression("at", "at: B");
  impact.pushes = members.require_expression("pushes", "pushes: +z");
  impact.restitution = members.expression("restitution");
  impact.friction = members.expression("friction");
  const std::string hypothesis = members.text("hypothesis");
  if (hypothesis == "newton")
    impact.hypothesis = solve::RestitutionLaw::newton;
  else if (hypothesis == "poisson")
    impact.hypothesis = solve::RestitutionLaw::poisson;
  else if (!hypothesis.empty() && hypothesis != "energetic")
    fail(file, members.mark_of("hypothesis"), "'" + hypothesis + "' is no hypothesis of restitution",
         "write energetic, newton or poisson");
  if (!hypothesis.empty() && !(impact.restitution && impact.friction))
    fail(file, members.mark_of("hypothesis"),
         "impact '" + name.text + "' states a hypothesis, and no " + (impact.friction ? "restitution" : "friction"),
         "leave it out: hypotheses differ only where there are both");
  return impact;
}

Strike read_strike(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"strike"});
  auto strike = begun<Strike>(name);
  strike.amount.mass = members.expression("mass");
  strike.amount.weight = members.expression("weight");
  if (strike.amount.mass.has_value() == strike.amount.weight.has_value())
    fail(file, name.mark, "strike '" + name.text + "' needs the mass or the weight of its particle");
  take_body(members, "hits", "hits: satellite", file, strike.hits, strike.hits_mark);
  take_holder(members, "relative_to", strike.relative_to, strike.relative_to_mark);
  strike.at = members.require_expression("at", "at: C");
  strike.velocity = members.require_expression("velocity", "velocity: [0, 0, 2000 m/s]");
  strike.stays = members.boolean("stays").value_or(false);
  strike.loses = members.expression("loses");
  const std::string added = members.text("mass_added");
  if (!added.empty() && added != "neglected")
    fail(file, members.mark_of("mass_added"), "'" + added + "' is not understood",
         "write mass_added: neglected, or leave it out");
  strike.mass_neglected = added == "neglected";
  if (strike.stays == strike.loses.has_value())
    fail(file, name.mark, "strike '" + name.text + "' must say what becomes of the particle",
         "write stays: true, or loses: 20 %");
  return strike;
}

}  // namespace poinsot::problem
