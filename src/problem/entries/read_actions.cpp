#include "problem/entries/read_actions.h"

#include "problem/entries/reader.h"

namespace poinsot::problem {
namespace {

std::string name_of(const Members& members, std::string_view key, const char* otherwise) {
  return members.find(key) ? members.text(key) : otherwise;
}

}  // namespace

Frame read_frame(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"frame"});
  Frame frame;
  frame.name = name.text;
  frame.mark = name.mark;
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

Contact read_contact(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"contact"});
  Contact contact;
  contact.name = name.text;
  contact.mark = name.mark;
  contact.of = scalar_text(members.require("of", "of: disk"), file, "the name of a body");
  contact.of_mark = members.mark_of("of");
  contact.against = name_of(members, "against", "ground");
  contact.against_mark = members.mark_of("against");
  contact.at = members.require_expression("at", "at: C");
  contact.normal = members.require_expression("normal", "normal: +y");
  contact.no_slip = members.boolean("no_slip").value_or(false);
  if (members.find("carries")) contact.carries = members.list("carries");
  return contact;
}

Cord read_cord(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"cord"});
  Cord cord;
  cord.name = name.text;
  cord.mark = name.mark;
  if (members.find("holds")) {
    for (const char* key : {"to", "end", "from"})
      if (members.find(key))
        fail(file, members.mark_of(key), "cord '" + name.text + "' states both holds and " + key,
             "a long cord has holds, at and pulls; a cord between two points from, at, to and end");
    cord.from = "ground";
    cord.to = members.text("holds");
    cord.to_mark = members.mark_of("holds");
    cord.end = members.require_expression("at", "at: A");
    cord.direction = members.require_expression("pulls", "pulls: +y");
  } else {
    cord.from = name_of(members, "from", "ground");
    cord.to = scalar_text(members.require("to", "to: rod"), file, "the name of a body");
    cord.from_mark = members.mark_of("from");
    cord.to_mark = members.mark_of("to");
    cord.at = members.require_expression("at", "at: C");
    cord.end = members.require_expression("end", "end: B");
  }
  return cord;
}

Spring read_spring(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"spring"});
  Spring spring;
  spring.name = name.text;
  spring.mark = name.mark;
  spring.from = name_of(members, "from", "ground");
  spring.to = scalar_text(members.require("to", "to: yoke"), file, "the name of a body");
  spring.from_mark = members.mark_of("from");
  spring.to_mark = members.mark_of("to");
  spring.about = members.expression("about");
  for (const char* key : {"at", "end", "free_length", "tension"})
    if (spring.about && members.find(key))
      fail(file, members.mark_of(key), "a torsional spring has no '" + std::string(key) + "'",
           "it has from, to, about, stiffness, free_angle and damping");
  if (!spring.about && members.find("free_angle"))
    fail(file, members.mark_of("free_angle"), "a spring between two points has no 'free_angle'",
         "write free_length:, or about: with the axis of a torsional spring");
  if (!spring.about) {
    spring.at = members.require_expression("at", "at: C");
    spring.end = members.require_expression("end", "end: A");
  }
  spring.stiffness = members.expression("stiffness");
  spring.free_length = members.expression("free_length");
  spring.free_angle = members.expression("free_angle");
  spring.tension = members.expression("tension");
  spring.damping = members.expression("damping");
  if (!spring.stiffness && !spring.damping)
    fail(file, name.mark, "spring '" + name.text + "' has neither stiffness nor damping");
  if (spring.free_angle && !spring.stiffness)
    fail(file, members.mark_of("free_angle"), "spring '" + name.text + "' has a free angle but no stiffness");
  if (!spring.about && spring.stiffness && spring.free_length.has_value() == spring.tension.has_value())
    fail(file, name.mark, "spring '" + name.text + "' needs its free_length or its tension as drawn, one of them");
  return spring;
}

Load read_load(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"load"});
  Load load;
  load.name = name.text;
  load.mark = name.mark;
  load.force = members.expression("force");
  load.couple = members.expression("couple");
  if (load.force.has_value() == load.couple.has_value())
    fail(file, name.mark, "load '" + name.text + "' needs a force or a couple, one of them");
  for (const auto& [key, owner] : {std::pair{"along", "couple"}, std::pair{"about", "force"}})
    if (members.find(key) && members.find(owner))
      fail(file, members.mark_of(key), std::string("a ") + owner + " has no '" + key + "'",
           load.force ? "a force acts along a direction" : "a couple acts about an axis");
  load.direction = load.force ? members.expression("along") : members.expression("about");
  load.at = members.expression("at");
  if (load.couple && load.at) fail(file, members.mark_of("at"), "a couple has no point", "remove at:");
  load.body = scalar_text(members.require("body", "body: shaft"), file, "the name of a body");
  load.body_mark = members.mark_of("body");
  load.axes = name_of(members, "axes", "ground");
  load.axes_mark = members.mark_of("axes");
  return load;
}

Impulse read_impulse(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"impulse"});
  Impulse impulse;
  impulse.name = name.text;
  impulse.mark = name.mark;
  impulse.body = scalar_text(members.require("body", "body: plate"), file, "the name of a body");
  impulse.body_mark = members.mark_of("body");
  impulse.axes = name_of(members, "axes", "ground");
  impulse.axes_mark = members.mark_of("axes");
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
  Impact impact;
  impact.name = name.text;
  impact.mark = name.mark;
  impact.of = scalar_text(members.require("of", "of: plate"), file, "the name of a body");
  impact.of_mark = members.mark_of("of");
  impact.against = name_of(members, "against", "ground");
  impact.against_mark = members.mark_of("against");
  impact.at = members.require_expression("at", "at: B");
  impact.pushes = members.require_expression("pushes", "pushes: +z");
  impact.restitution = members.expression("restitution");
  return impact;
}

Strike read_strike(const Key& name, const Entry& entry, const std::string& file) {
  const Members members(entry, file, {"strike"});
  Strike strike;
  strike.name = name.text;
  strike.mark = name.mark;
  strike.amount.mass = members.expression("mass");
  strike.amount.weight = members.expression("weight");
  if (strike.amount.mass.has_value() == strike.amount.weight.has_value())
    fail(file, name.mark, "strike '" + name.text + "' needs the mass or the weight of its particle");
  strike.hits = scalar_text(members.require("hits", "hits: satellite"), file, "the name of a body");
  strike.hits_mark = members.mark_of("hits");
  strike.relative_to = name_of(members, "relative_to", "ground");
  strike.relative_to_mark = members.mark_of("relative_to");
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
