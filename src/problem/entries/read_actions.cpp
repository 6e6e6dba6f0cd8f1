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
  contact.corner = members.find("corner") != nullptr;
  if (contact.corner && members.find("at"))
    fail(file, members.mark_of("at"), "contact '" + name.text + "' states its place twice, under corner: and at:",
         "corner: is the point of '" + contact.of + "' that touches: leave out at:");
  contact.at =
      contact.corner ? members.require_expression("corner", "corner: C") : members.require_expression("at", "at: C");
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
  if (contact.friction && contact.friction->falls() && contact.strikes_later())
    fail(file, contact.friction->mark, "in a blow there is one coefficient of friction, not two",
         "write friction: 0.3 at a contact that is struck");
  if (contact.friction && contact.open) {
    contact.flies = true;
    contact.grip = Grip::parts;
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
  if (const Entry* friction = members.find("friction"))
    wheel.friction = read_friction(*friction, members.mark_of("friction"), file);
  wheel.turns = members.expression("turns");
  if (wheel.friction && wheel.smooth)
    fail(file, wheel.friction->mark, "'" + wheel.name + "' is smooth and has friction", "leave out one of them");
  if (wheel.turns && !wheel.friction)
    fail(file, wheel.turns->mark(), "how often a cord goes round '" + wheel.name + "' matters for its friction alone",
         "state friction: 0.3 beside it, or leave out turns:");
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
  if (wheel.smooth || wheel.friction)
    fail(file, wheel.mark, "a cord that winds on '" + wheel.name + "' does not slide over it",
         std::string("remove ") + (wheel.smooth ? "smooth:" : "friction:"));
  return wheel;
}

// What a cord or belt does on one of its wheels is said there.
void refuse_at_wheels(const Entry& entry, const std::string& words, const std::string& file) {
  if (entry.kind != Entry::Kind::map) return;
  for (const auto& [key, value] : entry.members)
    for (const char* of_wheel : {"friction", "radius", "side", "smooth", "turns"})
      if (key.text == of_wheel)
        fail(file, key.mark, words + " has no " + key.text + ": on each wheel its " + key.text + " may be another",
             "state it at the wheel: over: [{wheel: {" + key.text + ": ...}}]");
}

// What is no property of a cord: it does not rebound, and keeps its length.
void refuse_of_cords(const Entry& entry, const std::string& words, const std::string& file) {
  for (const auto& [key, value] : entry.members) {
    if (key.text == "restitution")
      fail(file, key.mark, words + " that goes taut does not rebound: it has no restitution",
           "state the jerk by itself, impacts: {jerk: {of: bob, at: A, pushes: A->O, restitution: 0.5}}");
    if (key.text == "stiffness" || key.text == "free_length" || key.text == "damping")
      fail(file, key.mark, words + " keeps its length: it has no " + key.text,
           "state what stretches under springs:, where it pushes as well when it is shorter than its free_length");
  }
}

}  // namespace

Cord read_cord(const Key& name, const Entry& entry, const std::string& file) {
  refuse_at_wheels(entry, "cord '" + name.text + "'", file);
  refuse_of_cords(entry, "cord '" + name.text + "'", file);
  const Members members(entry, file, {"cord"});
  auto cord = begun<Cord>(name);
  if (members.find("holds")) {
    for (const char* key : {"to", "end", "from", "over", "length"})
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
    cord.length = members.expression("length");
    if (cord.length && (cord.off_from || cord.on_to))
      fail(file, members.mark_of("length"),
           "cord '" + name.text +
               "' winds on a wheel, so that it is of no one length: what it does slack is not followed",
           "remove length:; it is then as long as drawn at the start");
  }
  return cord;
}

Belt read_belt(const Key& name, const Entry& entry, const std::string& file, bool chain) {
  refuse_at_wheels(entry, std::string(chain ? "chain" : "belt") + " '" + name.text + "'", file);
  const Members members(entry, file, {chain ? "chain" : "belt"});
  auto belt = begun<Belt>(name);
  belt.chain = chain;
  const Entry& over = members.require("over", "over: [motor, fan]");
  if (!over.is_list())
    fail(file, over.mark, "what " + belt.words() + " goes round is a list, in its order", "write over: [motor, fan]");
  for (const Entry& one : over.items) belt.over.push_back(read_wheel(one, file, "over"));
  if (belt.over.size() < 2)
    fail(file, over.mark, belt.words() + " goes round one wheel only", "name two or more: over: [motor, fan]");
  if (!chain) {
    belt.tension = members.expression("tension");
    belt.crossed = members.boolean("crossed").value_or(false);
  }
  if (belt.crossed && belt.over.size() != 2)
    fail(file, members.mark_of("crossed"), belt.words() + " is crossed and goes round more than two wheels",
         "state on which side of each wheel it comes there: over: [{a: {side: +y}}, ...]");
  for (const CordWheel& wheel : belt.over) {
    if (wheel.friction && chain)
      fail(file, wheel.friction->mark, "a chain does not slip on '" + wheel.name + "'", "remove friction:");
    if (wheel.turns)
      fail(file, wheel.turns->mark(), "a closed belt goes round '" + wheel.name + "' as the figure tells",
           "remove turns:");
  }
  return belt;
}

std::vector<Contact> frictions_on(const Situation& situation) {
  std::vector<Contact> found;
  const auto add = [&](const std::string& name, const CordWheel& wheel, bool of_belt) {
    if (!wheel.friction) return;
    Contact friction;
    friction.name = name + " on " + wheel.name;
    friction.of = name;
    friction.against = wheel.name;
    friction.of_mark = friction.against_mark = friction.mark = wheel.mark;
    // Its slip has two senses: the way the cord is led and back.
    friction.normal = parse_expression("[1, 0, 0]", situation.file, wheel.mark);
    friction.friction = wheel.friction;
    friction.on_cord = true;
    friction.of_belt = of_belt;
    if (std::ranges::find(found, friction.name, &Contact::name) != found.end())
      fail(
          situation.file, wheel.mark, "cord '" + name + "' has friction on '" + wheel.name + "' twice",
          "name the posts by their points, so that each can be asked for: over: [{P: {radius: r, friction: mu}}, ...]");
    found.push_back(std::move(friction));
  };
  for (const Cord& cord : situation.cords)
    for (const CordWheel& wheel : cord.over) add(cord.name, wheel, false);
  for (const Belt& belt : situation.belts)
    for (const CordWheel& wheel : belt.over) add(belt.name, wheel, true);
  return found;
}

Gear read_gear(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"gear"});
  auto gear = begun<Gear>(name);
  take_body(members, "of", "of: pinion", file, gear.of, gear.of_mark);
  take_holder(members, "against", gear.against, gear.against_mark);
  gear.at = members.require_expression("at", "at: P");
  gear.pressure_angle = members.expression("pressure_angle");
  gear.normal_pressure_angle = members.expression("normal_pressure_angle");
  gear.helix_angle = members.expression("helix_angle");
  gear.lead = members.expression("lead");
  for (const auto& [one, other] :
       {std::pair{"pressure_angle", "normal_pressure_angle"}, std::pair{"helix_angle", "lead"}})
    if (members.find(one) && members.find(other))
      fail(file, members.mark_of(other), "gear '" + name.text + "' states both " + one + " and " + other,
           "state one of them; the other follows");
  gear.friction = members.expression("friction");
  const std::string hand = members.text("hand");
  gear.hand_mark = members.find("hand") ? members.mark_of("hand") : name.mark;
  if (hand == "right" || hand == "left" || hand == "both")
    gear.hand = hand == "right" ? Hand::right : hand == "left" ? Hand::left : Hand::both;
  else if (!hand.empty())
    fail(file, gear.hand_mark, "teeth have no hand '" + hand + "'",
         "write right, left, or both for two rows of teeth whose thrusts cancel");
  if (gear.has_helix() && gear.hand == Hand::none)
    fail(file, name.mark, "gear '" + name.text + "' does not say on which side its teeth rise",
         "write hand: right or hand: left, that of '" + gear.of + "', or hand: both for two rows of teeth");
  if (!gear.has_helix() && gear.hand != Hand::none)
    fail(file, gear.hand_mark, "the teeth of gear '" + name.text + "' are straight and have no hand",
         "state helix_angle: or lead:, or remove hand:");
  if (gear.lead && gear.hand == Hand::both)
    fail(file, gear.hand_mark, "a worm is right- or left-handed", "write hand: right or hand: left");
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

Excitation read_excitation(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"excitation"});
  auto shakes = begun<Excitation>(name);
  int kinds = 0;
  for (const char* kind : {"force", "couple", "unbalance", "moves"}) kinds += members.find(kind) ? 1 : 0;
  if (kinds != 1)
    fail(file, name.mark,
         "excitation '" + name.text + "' states " + (kinds == 0 ? "nothing that swings" : "several things that swing"),
         "state one of force:, couple:, unbalance: and moves:");
  shakes.force = members.expression("force");
  shakes.couple = members.expression("couple");
  shakes.unbalance = members.expression("unbalance");
  shakes.by = members.expression("by");
  shakes.frequency = members.expression("frequency");
  const auto leave_out = [&](std::initializer_list<const char*> keys, const std::string& why, const std::string& hint) {
    for (const char* key : keys)
      if (members.find(key)) fail(file, members.mark_of(key), why, hint);
  };
  if (members.find("moves")) {
    shakes.coordinate = scalar_text(members.require("moves", "moves: s"), file, "the name of a coordinate");
    shakes.coordinate_mark = members.mark_of("moves");
    if (!shakes.by)
      fail(file, name.mark, "excitation '" + name.text + "' does not say how far the coordinate swings",
           "write moves: " + shakes.coordinate + ", by: 2 mm");
    leave_out({"body", "at", "along", "about", "axes", "turns"}, "a coordinate that swings has a joint, and no more",
              "leave it out");
    return shakes;
  }
  leave_out({"by"}, "how far something swings is said of a coordinate", "state moves: s, by: 2 mm");
  take_body(members, "body", "body: rotor", file, shakes.body, shakes.body_mark);
  take_holder(members, "axes", shakes.axes, shakes.axes_mark);
  shakes.direction = members.expression(shakes.couple ? "about" : "along");
  leave_out({shakes.couple ? "along" : "about"}, shakes.couple ? "a couple has no 'along'" : "a force has no 'about'",
            shakes.couple ? "a couple acts about an axis" : "a force acts along a direction");
  shakes.at = members.expression("at");
  if (shakes.couple) leave_out({"at"}, "a couple has no point", "remove at:");
  shakes.turns = members.expression("turns");
  if (shakes.unbalance) {
    leave_out({"axes", "turns", "frequency"}, "an unbalance rides with its body and goes round as it spins",
              "leave it out");
    if (!shakes.direction)
      fail(file, name.mark, "excitation '" + name.text + "' does not say on which side the unbalance is",
           "write along: x, from which phases are counted");
  }
  return shakes;
}

}  // namespace poinsot::problem
