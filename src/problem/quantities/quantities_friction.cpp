// Dry friction: how contacts slip, stick and part, and what rubs.
#include <algorithm>

#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"
#include "problem/quantities/quantities.h"
#include "problem/quantities/quantity_values.h"
#include "problem/quantities/rough_contact.h"

namespace poinsot::problem {

template <class Scalar, class Base>
Value<Scalar> QuantityScope<Scalar, Base>::friction(const Call& call, const Evaluator<Scalar>& evaluator) {
  const Expression& what = call.arguments[0].value;
  const std::vector<RoughContactOf<Base>>& rough = machine_.rough_contacts;
  const auto found = std::ranges::find_if(rough, [&](const RoughContactOf<Base>& contact) {
    return plain_name(what) && plain_name(what)->name == contact.name;
  });
  if (found == rough.end()) {
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
                     "ask for force(" + smooth->name + " on " + smooth->of + "), or state friction: 0.3");
    evaluator.fail(what.mark(), "there is no contact or joint '" + to_string(what) + "' with friction",
                   !hint.empty() ? hint
                   : all.empty() ? "state it at a contact, friction: 0.3, or at a joint, friction: 2 N*m"
                                 : "known: " + all);
  }
  const RoughContactOf<Base>& contact = *found;
  const Action& action = machine_.mechanism.actions[static_cast<std::size_t>(contact.action)];
  if (contact.coordinate >= 0 && (call.function == "slip_velocity" || call.function == "normal_force"))
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
           .first = plain_vector(lifted<Scalar>(mechanism_state_->direction(contact.normal))),
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
    if (contact.coordinate >= 0) {
      const Vector couple = lifted<Scalar>(sign * force.friction);
      return vector_value(couple, contact.turning ? dimensions::moment : dimensions::force);
    }
    return told(ToldQuantity::Kind::friction, body,
                vector_value(lifted<Scalar>(sign * force.friction), dimensions::force));
  }
  const Grip asked = call.function == "sticking"  ? Grip::sticks
                     : call.function == "sliding" ? Grip::slides
                                                  : Grip::parts;
  // A contact is in its state only if all others are in theirs.
  return Result::of_truth(contact.grip == asked && all_stay_in_state(*mechanism_state_, *unknowns_, rough));
}

template Value<double> QuantityScope<double>::friction(const Call&, const Evaluator<double>&);
template Value<Dual<1>> QuantityScope<Dual<1>, double>::friction(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1>> QuantityScope<Dual<1>>::friction(const Call&, const Evaluator<Dual<1>>&);
template Value<Dual<1, Dual<1>>> QuantityScope<Dual<1, Dual<1>>, Dual<1>>::friction(const Call&,
                                                                                    const Evaluator<Dual<1, Dual<1>>>&);
template Value<Formula> QuantityScope<Formula>::friction(const Call&, const Evaluator<Formula>&);
template Value<Dual<1, Formula>> QuantityScope<Dual<1, Formula>, Formula>::friction(const Call&,
                                                                                    const Evaluator<Dual<1, Formula>>&);

}  // namespace poinsot::problem
