// The values of forces, couples, reactions, drives and impulses.
#include <algorithm>
#include <string_view>

#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::force(const Call& call, const Mark& mark,
                                                 const Evaluator<Scalar>& evaluator) {
  const bool sudden = call.function == "impulse" || call.function == "impulsive_couple";
  if (sudden && !before_ && situation_.has_blow())
    evaluator.fail(mark, call.function + "() is known after the blow, not before it", "state or ask it after the blow");
  if (sudden && !before_)
    evaluator.fail(mark, call.function + "() belongs to a blow, and nothing sudden happens here",
                   "state impulses:, impacts: or strikes:, and ask it after the blow");
  if (!sudden && (!mechanism_state_ || !unknowns_))
    evaluator.fail(mark, call.function + "() cannot stand inside rate() or among what is known of the velocities");
  const std::string_view f = call.function;
  const Mechanism<Base>& mechanism = machine_.mechanism;
  const Expression& what = call.arguments[0].value;
  std::string name, joint;
  Mark name_mark = what.mark();
  if (const Of* of = what.as<Of>(); of && plain_name(of->point) && plain_name(of->body)) {
    name = plain_name(of->point)->name;
    joint = plain_name(of->body)->name;
  } else if (const Name* only = plain_name(what)) {
    name = only->name;
    if (const Expression* owner = call.argument("of")) joint = to_string(*owner);
  } else {
    evaluator.fail(name_mark, "expected the name of a joint, support, contact, cord, spring or load");
  }
  std::vector<std::size_t> actions;
  for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    const bool motor = action.kind == ActionKind::drive, drive = motor || action.kind == ActionKind::friction,
               support = action.kind == ActionKind::support, load = action.kind == ActionKind::load;
    const bool of_joint = (support || drive) && action.joint == name;
    const bool itself = !drive && action.name == name && (joint.empty() || action.joint == joint);
    bool wanted = false;
    if (f == "load")
      wanted = load && itself;
    else if (f == "tension")
      wanted = action.kind == ActionKind::cord && itself;
    else if (f == "drive")
      wanted = motor && (joint.empty() ? action.joint == name : action.name == joint + "." + name);
    else if (sudden)
      wanted = !load && (itself || of_joint);
    else if (f == "reaction" || f == "reaction_couple")
      wanted = !load && ((itself && !drive) || (of_joint && !drive));
    else
      wanted = of_joint || itself;
    if (wanted) actions.push_back(i);
  }
  // A center pulls each body by itself.
  if (actions.size() > 1 && mechanism.actions[actions[0]].kind == ActionKind::attraction)
    if (const Expression* named = call.argument("on")) {
      const int body = body_of(*named, evaluator);
      std::erase_if(actions, [&](std::size_t i) { return mechanism.actions[i].on != body; });
      if (actions.empty()) evaluator.fail(named->mark(), "gravity does not act on '" + to_string(*named) + "'");
    }
  if (actions.empty()) {
    std::vector<std::string> known;
    for (const Action& action : mechanism.actions) {
      const bool fits = f == "load"      ? action.kind == ActionKind::load
                        : f == "tension" ? action.kind == ActionKind::cord
                                         : action.kind != ActionKind::load;
      if (!fits) continue;
      for (const std::string& word : {action.joint, action.name})
        if (!word.empty() && std::find(known.begin(), known.end(), word) == known.end()) known.push_back(word);
    }
    const std::string all = joined(known);
    const std::string hint = did_you_mean(name, known);
    evaluator.fail(name_mark, "nothing named '" + name + "' has a " + call.function,
                   hint.empty() ? (all.empty() ? "" : "known: " + all) : hint);
  }
  // If supports of different joints have the same name, it does not say which one is meant.
  if (f == "reaction" || f == "reaction_couple") {
    for (std::size_t i : actions)
      if (mechanism.actions[i].kind == ActionKind::support && mechanism.actions[i].name == name &&
          mechanism.actions[i].joint != mechanism.actions[actions.front()].joint)
        evaluator.fail(name_mark,
                       "'" + name + "' is a support of the joints '" + mechanism.actions[actions.front()].joint +
                           "' and '" + mechanism.actions[i].joint + "'",
                       "write reaction(" + name + " of " + mechanism.actions[i].joint + ")");
  }
  // Of one straight part, whichever of its ends is asked.
  const auto tell_tension = [&](int part, const Base& tension) {
    if (!tells() || tells_rates) return;
    const Action& action = mechanism.actions[static_cast<std::size_t>(part)];
    told_->push_back({.kind = ToldQuantity::Kind::tension,
                      .body = action.on,
                      .from = action.from,
                      .actions = {static_cast<std::size_t>(part)},
                      .value = {plain(tension), 0, 0},
                      .words = call.function});
  };
  if (const Expression* from = call.argument("from")) {
    const Expression& to = *call.argument("to");
    const auto part = [&](const Expression& begin, const Expression& end) {
      std::vector<int> found;
      for (const CordPart& one : machine_.cord_parts)
        if (one.cord == name && one.from == to_string(begin) && one.to == to_string(end)) found.push_back(one.action);
      return found;
    };
    std::vector<int> found = part(*from, to);
    const bool closed = std::ranges::find(situation_.belts, name, &Belt::name) != situation_.belts.end();
    if (found.empty() && !closed) found = part(to, *from);
    if (found.size() != 1) {
      std::string known;
      for (const CordPart& one : machine_.cord_parts)
        if (one.cord == name) known += (known.empty() ? "known: from " : ", from ") + one.from + " to " + one.to;
      evaluator.fail(from->mark(),
                     "'" + name + "' has " + (found.empty() ? "no" : "several") + " straight part" +
                         (found.empty() ? "" : "s") + " from '" + to_string(*from) + "' to '" + to_string(to) + "'",
                     known);
    }
    const Base tension = tension_of(*mechanism_state_, *unknowns_, found.front());
    tell_tension(found.front(), tension);
    return number_value(lifted<Scalar>(tension), dimensions::force);
  }
  if (const auto belt = std::ranges::find(situation_.belts, name, &Belt::name);
      f == "tension" && belt != situation_.belts.end())
    evaluator.fail(name_mark, belt->words() + " has a tension on each of its sides",
                   "write tension(" + name + " from " + belt->over[0].name + " to " + belt->over[1].name + ")");
  // Of a cord over wheels, what it does to one of the bodies: of its straight parts those that end there, all reversed
  // where they begin there.
  const bool led = actions.size() > 1 && act_together(mechanism.actions[actions[0]], mechanism.actions[actions[1]]);
  std::vector<std::size_t> begin_there;
  if (const Expression* named = call.argument("on"); named && led) {
    const int body = body_of(*named, evaluator);
    std::vector<std::size_t> end_there;
    for (const std::size_t i : actions) {
      const Action& part = mechanism.actions[i];
      if (part.on == part.from) continue;
      if (part.on == body) end_there.push_back(i);
      if (part.from == body) begin_there.push_back(i);
    }
    if (end_there.empty()) std::swap(end_there, begin_there);
    if (end_there.empty()) evaluator.fail(named->mark(), "'" + name + "' does not act on '" + to_string(*named) + "'");
    actions = end_there;
  }
  SpatialForce<Base> wrench = SpatialForce<Base>::zero();
  for (std::size_t i : begin_there)
    wrench += Base(-1) * (sudden ? solve::action_impulse(*before_, *blow_, *impulses_, i)
                                 : solve::action_wrench(*mechanism_state_, *unknowns_, i));
  for (std::size_t i : actions)
    wrench += sudden ? solve::action_impulse(*before_, *blow_, *impulses_, i)
                     : solve::action_wrench(*mechanism_state_, *unknowns_, i);
  // Of what acts far from the ground's origin the moment about that has lost the digits of a couple.
  const auto moment_about = [&](const Vector3<Base>& P) -> Vector3<Base> {
    if (mechanism.actions[actions.front()].kind != ActionKind::attraction)
      return wrench.moment - cross(P, wrench.force);
    return mechanism_state_->known_wrench(static_cast<int>(actions.front()), P).moment;
  };
  const Action& first = mechanism.actions[actions.front()];
  Base sign(1);
  int on = first.on;
  if (const Expression* named = call.argument("on")) {
    const int body = body_of(*named, evaluator);
    on = body;
    for (std::size_t i : actions)
      if (!led && (mechanism.actions[i].on != first.on || mechanism.actions[i].from != first.from))
        evaluator.fail(name_mark, "'" + name + "' means several things between different bodies");
    if (body == first.from && body != first.on)
      sign = Base(-1);
    else if (body != first.on)
      evaluator.fail(named->mark(), "'" + name + "' does not act on '" + to_string(*named) + "'");
  }
  const auto as_vector = [&](const Vector3<Base>& v, const Dimension& dimension) {
    return vector_value(lifted<Scalar>(sign * v), dimension);
  };
  // Where the actions are between different bodies, there is no one body on which they act.
  const bool one_pair = begin_there.empty() && std::ranges::all_of(actions, [&](std::size_t i) {
                          return mechanism.actions[i].on == first.on && mechanism.actions[i].from == first.from;
                        });
  const auto told_along = [&](ToldQuantity::Kind kind, const Vector3<Base>& place, const Vector3<Base>& value,
                              const Dimension& dimension, const Vector3<Base>& along) {
    Result result = as_vector(value, dimension);
    if (tells() && !tells_rates && one_pair)
      told_->push_back({.kind = kind,
                        .body = on,
                        .from = on == first.on ? first.from : first.on,
                        .actions = actions,
                        .place = {plain(place.x), plain(place.y), plain(place.z)},
                        .first = {plain(along.x), plain(along.y), plain(along.z)},
                        .value = plain_vector(result.vector),
                        .words = call.function});
    return result;
  };
  const auto told = [&](ToldQuantity::Kind kind, const Vector3<Base>& place, const Vector3<Base>& value,
                        const Dimension& dimension) {
    return told_along(kind, place, value, dimension, Vector3<Base>::zero());
  };
  // The place at which the first component of these actions is carried.
  const solve::MechanismStateOf<Base>& now = sudden ? *before_ : *mechanism_state_;
  const auto own_place = [&]() -> Vector3<Base> {
    for (const Component<Base>& component : mechanism.components)
      if (component.action == static_cast<int>(actions.front())) return now.position(component.at);
    if (const auto found = machine_.joints.find(name); found != machine_.joints.end())
      return now.position(found->second.at);
    return Vector3<Base>::zero();
  };
  using Kind = ToldQuantity::Kind;
  const Vector3<Base> nowhere = Vector3<Base>::zero();
  const auto leader_of = [&](std::size_t action) {
    for (std::size_t k = 0; k < mechanism.components.size(); ++k)
      if (mechanism.components[k].action == static_cast<int>(action))
        return mechanism.components[k].follows < 0 ? static_cast<int>(k) : mechanism.components[k].follows;
    return -1;
  };
  const auto slips_there = [&](std::size_t action) {
    return std::ranges::any_of(mechanism.components, [&](const Component<Base>& component) {
      return component.action == static_cast<int>(action) && !vanishes(component.gain);
    });
  };
  const auto differ = [&](const std::vector<std::size_t>& some, const std::vector<std::size_t>& others) {
    return std::ranges::any_of(some, slips_there) || std::ranges::any_of(others, slips_there) ||
           std::ranges::any_of(some, [&](std::size_t i) { return leader_of(i) != leader_of(some.front()); }) ||
           std::ranges::any_of(others, [&](std::size_t i) { return leader_of(i) != leader_of(some.front()); });
  };
  if (f == "tangential_force" || f == "radial_force" || f == "axial_force") {
    const auto mesh =
        std::ranges::find(machine_.tooth_meshes, static_cast<int>(actions.front()), &ToothMeshOf<Base>::action);
    if (mesh == machine_.tooth_meshes.end())
      evaluator.fail(name_mark,
                     "'" + name + "' is no place where the teeth of gears meet, of which " + call.function + "() tells",
                     "ask for force(" + name + " on BODY)");
    const auto& side = on == first.on ? mesh->of : mesh->against;
    const Vector3<Base> u = now.direction({mesh->carrier, f == "tangential_force" ? side.tangential
                                                          : f == "radial_force"   ? side.radial
                                                                                  : side.axial});
    return told_along(Kind::force_along, nowhere, dot(wrench.force, u) * u, dimensions::force, u);
  }
  if (f == "tension") {
    // The component is along the cord and may be negative, so that a cord that would have to push shows a negative
    // tension.
    std::vector<int> pulls;
    for (const Component<Base>& component : mechanism.components)
      if (component.one_sided &&
          std::ranges::find(actions, static_cast<std::size_t>(component.action)) != actions.end())
        pulls.push_back(component.action);
    const bool slips = std::ranges::any_of(mechanism.components, [&](const Component<Base>& component) {
      return !vanishes(component.gain) &&
             std::ranges::find(actions, static_cast<std::size_t>(component.action)) != actions.end();
    });
    if (led && (pulls.size() > 1 || slips) && !call.argument("on"))
      evaluator.fail(name_mark, "cord '" + name + "' turns a wheel or has friction, so that it has several tensions",
                     "write tension(" + name + " on BODY), the body that it holds or ends on, or tension(" + name +
                         " from A to B)");
    for (std::size_t k = 0; k < mechanism.components.size(); ++k)
      if (mechanism.components[k].action == static_cast<int>(actions.front())) {
        if (begin_there.size() + actions.size() > 1 && call.argument("on") && differ(actions, begin_there))
          evaluator.fail(name_mark,
                         "on both sides of '" + to_string(*call.argument("on")) + "' cord '" + name +
                             "' has tensions of their own",
                         "ask for one at an end of the cord, or for force(" + name + " on BODY)");
        const Base tension = (*unknowns_)[solve::force_unknowns(mechanism).accelerations + k];
        tell_tension(static_cast<int>(actions.front()), tension);
        return number_value(lifted<Scalar>(tension), dimensions::force);
      }
    return number_value(Scalar(0), dimensions::force);  // slack
  }
  if (f == "load") {
    for (const KnownForce<Base>& force : mechanism.forces)
      if (force.action == static_cast<int>(actions.front()))
        return force.couple ? told(Kind::couple, nowhere, wrench.moment, dimensions::moment)
                            : told(Kind::force, nowhere, wrench.force, dimensions::force);
  }
  if (f == "drive" && actions.size() > 1)
    evaluator.fail(name_mark, "joint '" + name + "' has several freedoms",
                   "write drive(FREEDOM of " + name + "), FREEDOM one of turn, slide, first, second, slide1, slide2");
  if (f == "drive") {
    // The effort along or about the motor's own axis is meant. Gimbals may pass on more than that.
    for (const Drive<Base>& drive : mechanism.drives) {
      if (drive.action != static_cast<int>(actions.front())) continue;
      const Vector3<Base> d = mechanism_state_->direction(drive.along);
      return drive.turning ? told_along(Kind::effort, own_place(), dot(wrench.moment, d) * d, dimensions::moment, d)
                           : told(Kind::force, nowhere, wrench.force, dimensions::force);
    }
  }
  if (f == "force" || f == "reaction") return told(Kind::force, nowhere, wrench.force, dimensions::force);
  if (f == "impulse") return told(Kind::impulse, nowhere, wrench.force, dimensions::momentum);
  if (f == "impulsive_couple") {
    const Expression* about = call.argument("about");
    const Vector3<Base> P = about ? as_base(place(*about, evaluator)) : own_place();
    return told(Kind::impulsive_couple, P, wrench.moment - cross(P, wrench.force), dimensions::angular_momentum);
  }
  require_one_of(f, {"couple", "reaction_couple", "load", "drive"});
  const Vector3<Base> P = f == "couple" ? as_base(place(*call.argument("about"), evaluator)) : own_place();
  return told(Kind::couple, P, moment_about(P), dimensions::moment);
}

template Value<double> QuantityScope<double>::force(const Call&, const Mark&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::force(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::force(const Call&, const Mark&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::force(const Call&, const Mark&,
                                                                                 const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::force(const Call&, const Mark&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::force(const Call&, const Mark&,
                                                                                 const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
