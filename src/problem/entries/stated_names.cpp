#include <algorithm>
#include <string>
#include <vector>

#include "problem/entries/name_checks.h"
#include "problem/keys/reader.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {

void check_stated_names(const Situation& situation) {
  const std::vector<std::string> bodies = names_of(situation.bodies);
  std::vector<std::string> holders{"ground"};
  holders.insert(holders.end(), bodies.begin(), bodies.end());
  for (const Frame& frame : situation.frames) {
    if (std::find(bodies.begin(), bodies.end(), frame.name) != bodies.end())
      fail(situation.file, frame.mark, "'" + frame.name + "' is both a body and a frame", "rename one of them");
    holders.push_back(frame.name);
  }
  const auto check = [&](const std::string& name, Mark mark, const std::vector<std::string>& known, const char* what) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string near = nearest(name, known);
    const std::string all = joined(known);
    fail(situation.file, mark, "there is no " + std::string(what) + " '" + name + "'",
         !near.empty() ? "did you mean '" + near + "'?"
         : all.empty() ? "the problem has none"
                       : "known: " + all);
  };
  const auto body = [&](const std::string& name, Mark mark) { check(name, mark, bodies, "body"); };
  const auto holder = [&](const std::string& name, Mark mark) { check(name, mark, holders, "body or frame"); };
  const auto not_itself = [&](const std::string& words, const std::string& one, const std::string& other, Mark mark) {
    if (one == other)
      fail(situation.file, mark, words + " is between '" + one + "' and itself", "name two bodies, or ground");
  };
  for (const Frame& frame : situation.frames)
    if (!frame.rides_on.empty()) body(frame.rides_on, frame.rides_on_mark);
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms) {
      const std::string position = freedom.position ? to_string(*freedom.position) : "";
      if (std::ranges::find(situation.axes, position) != situation.axes.end())
        fail(situation.file, freedom.position->mark(),
             "'" + position + "' is an axis of the figure, and so cannot be the name of a coordinate",
             "give the coordinate another name");
    }
  if (situation.steady) {
    holder(situation.steady->frame, situation.steady->frame_mark);
    for (const Spin& spin : situation.steady->spins) body(spin.body, spin.mark);
  }
  for (const Joint& joint : situation.joints) {
    holder(joint.from, joint.from_mark);
    if (joint.to == "ground")
      fail(situation.file, joint.to_mark, "joint '" + joint.name + "' holds the ground",
           "the ground holds and is not held: write it under from:");
    body(joint.to, joint.to_mark);
    if (joint.from == joint.to)
      fail(situation.file, joint.mark, "joint '" + joint.name + "' joins '" + joint.to + "' to itself");
  }
  for (const Contact& contact : situation.contacts) {
    if (contact.on_cord) continue;
    body(contact.of, contact.of_mark);
    holder(contact.against, contact.against_mark);
    not_itself(contact.words(), contact.of, contact.against, contact.mark);
  }
  for (const Cord& cord : situation.cords) {
    holder(cord.from, cord.from_mark);
    if (cord.to == "ground")
      fail(situation.file, cord.to_mark, "cord '" + cord.name + "' ends on the ground, where a cord begins",
           "turn it round: from: ground, at: the point there, over: the other way, to: and end: of the body");
    body(cord.to, cord.to_mark);
    if (!cord.is_led()) not_itself("cord '" + cord.name + "'", cord.to, cord.from, cord.mark);
    std::vector<std::string> leads = holders;
    for (const NamedExpression& point : situation.points) leads.push_back(point.name);
    for (const CordWheel& wheel : cord.over) check(wheel.name, wheel.mark, leads, "body or point");
  }
  for (const Belt& belt : situation.belts) {
    for (const Cord& cord : situation.cords)
      if (cord.name == belt.name)
        fail(situation.file, belt.mark, "a cord has the name of " + belt.words(), "rename one of them");
    for (const CordWheel& wheel : belt.over) holder(wheel.name, wheel.mark);
  }
  for (const Gear& gear : situation.gears) {
    body(gear.of, gear.of_mark);
    holder(gear.against, gear.against_mark);
    if (gear.of == gear.against) fail(situation.file, gear.mark, "gear '" + gear.of + "' meets itself");
  }
  for_each_stated_law(situation, [&](const auto& law) {
    for (const LawBody& named : law.bodies())
      named.may_be_frame ? holder(named.name, named.mark) : body(named.name, named.mark);
  });
  if (situation.central_gravity) {
    // Written as the body itself, its center or a point of it.
    const std::string toward = to_string(situation.central_gravity->toward);
    for (const std::string& name : bodies)
      if (toward == name || toward == "center(" + name + ")" || toward.ends_with(" of " + name))
        fail(situation.file, situation.central_gravity->toward.mark(),
             "gravity points towards a point of the ground, which rests, and '" + name + "' is a body that moves",
             "state the point at which it rests, toward: O; of two bodies that pull each other the pull is stated by "
             "loads that depend on the motion: force: -G*m*M*(center(a) - center(b))/norm(center(a) - center(b))^3");
    const auto keep_free = [&](const auto& list) {
      for (const auto& one : list)
        if (one.name == name_of_gravity)
          fail(situation.file, one.mark, "'gravity' is the name of the pull of the center", "rename this");
    };
    keep_free(situation.joints);
    keep_free(situation.contacts);
    keep_free(situation.cords);
    keep_free(situation.gears);
    for_each_law_list(situation, keep_free);
  }
  for (const Impulse& impulse : situation.impulses) {
    body(impulse.body, impulse.body_mark);
    holder(impulse.axes, impulse.axes_mark);
  }
  for (const Impact& impact : situation.impacts) {
    body(impact.of, impact.of_mark);
    holder(impact.against, impact.against_mark);
    not_itself("impact '" + impact.name + "'", impact.of, impact.against, impact.mark);
  }
  for (const Strike& strike : situation.strikes) {
    body(strike.hits, strike.hits_mark);
    holder(strike.relative_to, strike.relative_to_mark);
  }
  for (const Excitation& shakes : situation.excitations) {
    if (shakes.body.empty()) continue;
    body(shakes.body, shakes.body_mark);
    holder(shakes.axes, shakes.axes_mark);
  }
  for (const Stage& stage : situation.stages)
    for (const std::string& load : stage.loads.value_or(std::vector<std::string>{}))
      check(load, stage.mark, names_of(situation.loads), "load");
}

}  // namespace poinsot::problem
