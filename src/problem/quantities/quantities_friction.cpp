// Dry friction: how contacts slip, stick and part, and what rubs.
#include <algorithm>

#include "problem/entries/read_joints.h"
#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/quantities/cord_grip.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {
namespace {

// Whether it is the name of a contact or joint, or of one freedom of a joint, slide of post.
bool is_named(const Expression& what) {
  const Of* of = what.as<Of>();
  return plain_name(what) || (of && plain_name(of->point) && plain_name(of->body));
}

// Whether it names one freedom of a joint whose friction is against several of them together, slide of post.
template <class Base>
bool is_way_of(const Expression& what, const RoughContactOf<Base>& contact) {
  const Of* of = what.as<Of>();
  return contact.all_ways && of && plain_name(of->point) && plain_name(of->body) &&
         plain_name(of->body)->name == contact.name;
}

// That freedom among the ways of the joint; null if it is none of them.
template <class Base>
const RubbingWay<Base>* way_named(const Situation& situation, const RoughContactOf<Base>& contact,
                                  const Expression& what) {
  if (!is_way_of(what, contact)) return nullptr;
  const Joint& joint = rubbing_joint(situation.joints, contact.name).joint;
  std::size_t way = 0;
  for (const Freedom& freedom : joint.freedoms) {
    if (joint.kind->common_slip == CommonSlip::along_plane && freedom.turning) continue;
    if (freedom.name == plain_name(what.as<Of>()->point)->name) return &contact.ways[way];
    ++way;
  }
  return nullptr;
}

}  // namespace

// The part of a contact's force along its normal, which is that of its constraint in this pose.
template <class Scalar, class Base>
std::optional<Value<Scalar>> QuantityScope<Scalar, Base>::push_of_smooth(const std::string& name, const Call& call,
                                                                         const Evaluator<Scalar>& evaluator) {
  const Mechanism<Base>& mechanism = machine_.mechanism;
  const auto action = std::ranges::find_if(
      mechanism.actions, [&](const Action& one) { return one.kind == ActionKind::contact && one.name == name; });
  if (action == mechanism.actions.end()) return std::nullopt;
  const std::size_t number = static_cast<std::size_t>(action - mechanism.actions.begin());
  if (!mechanism_state_ || !unknowns_)
    evaluator.fail(call.arguments[0].value.mark(),
                   call.function + "() cannot stand inside rate() or among what is known");
  const auto touching = std::ranges::find_if(mechanism.constraints, [&](const VelocityConstraint<Base>& c) {
    return c.normal && c.action >= 0 && static_cast<std::size_t>(c.action) == number;
  });
  // What has parted, or touches later, has no normal and no force.
  if (touching == mechanism.constraints.end()) return number_value(Scalar(0), dimensions::force);
  const Vector3<Base> n = mechanism_state_->direction(touching->along);
  const Base push = dot(solve::action_wrench(*mechanism_state_, *unknowns_, number).force, n);
  if (tells() && !tells_rates)
    told_->push_back({.kind = ToldQuantity::Kind::normal_force,
                      .body = action->on,
                      .from = action->from,
                      .actions = {number},
                      .first = plain_vector(lifted<Scalar>(n)),
                      .value = Vector3<double>{plain(push), 0, 0},
                      .words = call.function});
  return number_value(lifted<Scalar>(push), dimensions::force);
}

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::friction(const Call& call, const Evaluator<Scalar>& evaluator) {
  const Expression& what = call.arguments[0].value;
  const std::vector<RoughContactOf<Base>>& rough = machine_.rough_contacts;
  const auto found = std::ranges::find_if(rough, [&](const RoughContactOf<Base>& contact) {
    return (is_named(what) && is_about(call, contact.name)) ||
           (call.function == "friction" && way_named(situation_, contact, what));
  });
  const auto flying = std::ranges::find_if(situation_.contacts, [&](const Contact& contact) {
    return contact.flies && plain_name(what) && plain_name(what)->name == contact.name;
  });
  if (found == rough.end() && flying != situation_.contacts.end()) {
    if (call.function == "slip_velocity")
      evaluator.fail(what.mark(), "contact '" + flying->name + "' does not touch, and nothing slips there",
                     "ask when it touches, or for the velocity of a point");
    if (call.function == "normal_force") return number_value(Scalar(0), dimensions::force);
    if (call.function == "friction") return vector_value(Vector::zero(), dimensions::force);
    return Result::of_truth(call.function == "parting");
  }
  if (found == rough.end()) {
    if (call.function == "normal_force" && plain_name(what))
      if (const auto push = push_of_smooth(plain_name(what)->name, call, evaluator)) return *push;
    std::vector<std::string> known;
    for (const RoughContactOf<Base>& contact : rough) known.push_back(contact.name);
    const std::string all = joined(known);
    const std::string hint = did_you_mean(to_string(what), known);
    const auto smooth = std::ranges::find_if(situation_.contacts, [&](const Contact& contact) {
      return plain_name(what) && plain_name(what)->name == contact.name;
    });
    if (smooth != situation_.contacts.end())
      evaluator.fail(what.mark(),
                     "contact '" + smooth->name + "' has no friction stated, of which " + call.function + "() tells",
                     "ask for normal_force(" + smooth->name + ") or force(" + smooth->name + " on " + smooth->of +
                         "), or state friction: 0.3");
    evaluator.fail(what.mark(), "there is no contact or joint '" + to_string(what) + "' with friction",
                   !hint.empty() ? hint
                   : all.empty() ? "state it at a contact, friction: 0.3, or at a joint, friction: 2 N*m"
                                 : "known: " + all);
  }
  const RoughContactOf<Base>& contact = *found;
  if (contact.on_cord()) {
    if (std::ranges::count_if(rough, [&](const auto& one) { return is_about(call, one.name); }) > 1)
      evaluator.fail(what.mark(), "cord '" + to_string(what) + "' has friction in several places",
                     "say on what: " + call.function + "(" + contact.name + ")");
    if (call.function == "slip_velocity" || call.function == "normal_force" || call.function == "friction")
      evaluator.fail(
          what.mark(), "'" + contact.name + "' is the friction of a cord, which has no " + call.function,
          "ask for its tensions on both sides, tension(CORD from A to B), or the force on what it is led over");
  } else if (call.argument("on") && call.function != "friction") {
    evaluator.fail(call.argument("on")->mark(),
                   "'" + contact.name + "' " + "is not the friction of a cord on something",
                   "write " + call.function + "(" + contact.name + ")");
  }
  const Action& action = machine_.mechanism.actions[static_cast<std::size_t>(contact.action)];
  if (contact.in_joint() && (call.function == "slip_velocity" || call.function == "normal_force"))
    evaluator.fail(what.mark(), "'" + contact.name + "' is a joint, whose friction has no " + call.function,
                   "ask for friction(" + contact.name + " on ...) or for the rate of the joint");
  if (call.function == "slip_velocity") {
    const Place<Base>& at = place_of(machine_.mechanism, contact);
    const Vector P = point_position(model_, workspace_, at.body, lifted<Scalar>(at.point));
    const auto velocity_at = [&](int body) -> Vector {
      const BodyMotion<Scalar>& motion = workspace_.motion[static_cast<std::size_t>(body + 1)];
      return motion.v + cross(motion.w, P - motion.p);
    };
    const Vector slip = velocity_at(action.on) - velocity_at(action.from);
    if (tells())
      told_->push_back({.kind = ToldQuantity::Kind::velocity,
                        .body = action.on,
                        .from = action.from,
                        .place = plain_vector(P),
                        .value = plain_vector(slip),
                        .words = call.function,
                        .as_rate = tells_rates,
                        .place_rate = rate_of(P),
                        .value_rate = rate_of(slip)});
    return vector_value(slip, dimensions::velocity);
  }
  if (!mechanism_state_ || !unknowns_)
    evaluator.fail(what.mark(), call.function + "() cannot stand inside rate() or among what is known");
  const RoughForce<Base> force = rough_force(*mechanism_state_, *unknowns_, contact);
  const auto told = [&](ToldQuantity::Kind kind, int on, const Value<Scalar>& value) {
    if (tells() && !tells_rates)
      told_->push_back(
          {.kind = kind,
           .body = on,
           .from = on == action.on ? action.from : action.on,
           .actions = {static_cast<std::size_t>(contact.action)},
           .first = plain_vector(lifted<Scalar>(direction_now(*mechanism_state_, contact, contact.normal))),
           .value = value.is_number() ? Vector3<double>{plain(value.number), 0, 0} : plain_vector(value.vector),
           .words = call.function});
    return value;
  };
  if (call.function == "normal_force")
    return told(ToldQuantity::Kind::normal_force, action.on,
                number_value(lifted<Scalar>(force.push), dimensions::force));
  if (call.function == "friction") {
    int body = action.on;
    if (const Expression* on = call.argument("on")) {
      body = body_of(*on, evaluator);
      if (body != action.on && body != action.from)
        evaluator.fail(on->mark(), "'" + contact.name + "' does not act on '" + to_string(*on) + "'");
    }
    const Base sign(body == action.on ? 1 : -1);
    if (contact.in_joint()) {
      const RubbingWay<Base>* way = way_named(situation_, contact, what);
      const auto& drives = machine_.mechanism.drives;
      const auto turns = [&](const RubbingWay<Base>& one) { return drives[one.drive].turning; };
      const bool couple = way ? turns(*way) : contact.turning;
      if (!way && !contact.turning && std::ranges::any_of(contact.ways, turns))
        evaluator.fail(what.mark(), "'" + contact.name + "' has friction along its axis and round it",
                       "ask for the force, friction(slide of " + contact.name +
                           " on ...), or the couple, friction(turn of " + contact.name + " on ...)");
      const Vector3<Base> effort = way ? way->arm * dot(force.friction, mechanism_state_->direction(way->along)) *
                                             mechanism_state_->direction(drives[way->drive].along)
                                       : force.friction;
      return vector_value(lifted<Scalar>(sign * effort), couple ? dimensions::moment : dimensions::force);
    }
    return told(ToldQuantity::Kind::friction, body,
                vector_value(lifted<Scalar>(sign * force.friction), dimensions::force));
  }
  require_one_of(call.function, {"sticking", "sliding", "parting"});
  const Grip asked = call.function == "sticking"  ? Grip::sticks
                     : call.function == "sliding" ? Grip::slides
                                                  : Grip::parts;
  // A contact is in its state only if all others are in theirs.
  const double size = largest_force(*mechanism_state_, *unknowns_);
  const auto slips = [&](const RoughContactOf<Base>& one) {
    return slips_in_truth(*mechanism_state_, *unknowns_, one, size);
  };
  return Result::of_truth(contact.grip == asked && all_stay_in_state(*mechanism_state_, *unknowns_, rough) &&
                          std::ranges::none_of(rough, slips));
}

template Value<double> QuantityScope<double>::friction(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::friction(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::friction(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::friction(const Call&,
                                                                                    const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::friction(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::friction(const Call&,
                                                                                    const Evaluator<Dual<1, Formula>>&);
template std::optional<Value<double>> QuantityScope<double>::push_of_smooth(const std::string&, const Call&,
                                                                            const Evaluator<double>&);
template std::optional<Value<Dual<1>>> QuantityScope<Dual<1>, double>::push_of_smooth(const std::string&, const Call&,
                                                                                      const Evaluator<Dual<1>>&);
template std::optional<Value<Dual<1>>> QuantityScope<Dual<1>>::push_of_smooth(const std::string&, const Call&,
                                                                              const Evaluator<Dual<1>>&);
template std::optional<Value<Dual<1, Dual<1>>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::push_of_smooth(
    const std::string&, const Call&, const Evaluator<Dual<1, Dual<1>>>&);
template std::optional<Value<Formula>> QuantityScope<Formula>::push_of_smooth(const std::string&, const Call&,
                                                                              const Evaluator<Formula>&);
template std::optional<Value<Dual<1, Formula>>> QuantityScope<Dual<1, Formula>, Formula>::push_of_smooth(
    const std::string&, const Call&, const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
