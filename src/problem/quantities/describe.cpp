#include "problem/quantities/describe.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/language/expression_walk.h"
#include "problem/plane/planar_words.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace {

// The body on which a joint, support or contact acts, and the body from which it acts.
struct Sides {
  std::string on, from;
};
Sides sides_of(const Situation& situation, const std::string& name) {
  for (const Joint& joint : situation.joints) {
    if (joint.name == name) return {joint.to, joint.from};
    for (const Support& support : joint.supports)
      if (support.name == name) return {joint.to, joint.from};
  }
  for (const Contact& contact : situation.contacts)
    if (contact.name == name) return {contact.of, contact.against};
  for (const Cord& cord : situation.cords)
    if (cord.name == name) return {cord.to, cord.from};
  for (const Belt& belt : situation.belts)
    if (belt.name == name) return {belt.over[0].name, belt.over[1].name};
  for (const Gear& gear : situation.gears)
    if (gear.name == name) return {gear.of, gear.against};
  for (const Load& load : situation.loads)
    if (load.name == name) return {load.body, "outside"};
  return {};
}

std::string words_of(const Expression& expression, const Situation& situation);

// What is asked of the motion: "largest theta", "smallest rate of phi", "period of theta".
std::string feature_words(const Call& call, const Situation& situation) {
  const std::string of = words_of(call.arguments.front().value, situation);
  if (call.function == "end_of_bouncing") return "time at which bouncing on " + of + " ends";
  return call.function == "period" ? "period of " + of : (call.function == "max" ? "largest " : "smallest ") + of;
}

std::string call_words(const Expression& expression, const Situation& situation) {
  const Call& call = *expression.as<Call>();
  if (is_motion_feature(call)) return feature_words(call, situation);
  const std::string noun(noun_of(call.function));
  if (noun.empty() || call.arguments.empty()) return to_string(expression);
  const std::string_view f = call.function;
  const std::string first = words_of(call.arguments[0].value, situation);
  std::string rest;
  for (std::size_t i = 1; i < call.arguments.size(); ++i)
    rest += " " + call.arguments[i].preposition + " " + words_of(call.arguments[i].value, situation);
  if (f == "force" || f == "couple") {
    std::string on, about;
    for (const Argument& argument : call.arguments) {
      if (argument.preposition == "on") on = words_of(argument.value, situation);
      if (argument.preposition == "about") about = " about " + words_of(argument.value, situation);
    }
    return noun + " that " + first + " exerts on " + on + about;
  }
  if (f == "reaction" || f == "reaction_couple") {
    const Sides sides = sides_of(situation, first);
    return noun + " at " + first + rest + (sides.on.empty() ? "" : ", exerted on " + sides.on + " by " + sides.from);
  }
  if (f == "drive") {
    const Sides sides = sides_of(situation, first);
    return "drive of " + first + (sides.on.empty() ? "" : ", exerted on " + sides.on + " by " + sides.from);
  }
  if (f == "angle" || f == "acute_angle") {
    std::string to;
    for (const Argument& argument : call.arguments)
      if (argument.preposition == "to") to = words_of(argument.value, situation);
    return noun + " between " + first + " and " + to;
  }
  if (f == "distance") {
    std::string to;
    for (const Argument& argument : call.arguments)
      if (argument.preposition == "to") to = words_of(argument.value, situation);
    return "distance from " + first + " to " + to;
  }
  if (f == "dot" || f == "cross") {
    std::string with;
    for (const Argument& argument : call.arguments)
      if (argument.preposition == "with") with = words_of(argument.value, situation);
    return noun + " of " + first + " and " + with;
  }
  if ((f == "velocity" || f == "acceleration") && call.arguments[0].value.as<Name>())
    return noun + " of the mass center of " + first + rest;
  return noun + " of " + first + rest;
}

// The axis along which an expression takes a component, also `@` an instant; three if it takes none.
std::size_t component_axis(const Expression& expression, const Situation& situation) {
  if (const At* at = expression.as<At>()) return component_axis(at->expression, situation);
  const Member* member = expression.as<Member>();
  return member ? static_cast<std::size_t>(std::ranges::find(situation.axes, member->name) - situation.axes.begin())
                : situation.axes.size();
}
// The same without the component.
Expression whole(const Expression& expression) {
  if (const At* at = expression.as<At>()) {
    At of_whole = *at;
    of_whole.expression = whole(at->expression);
    return built(std::move(of_whole), expression.mark());
  }
  const Member* member = expression.as<Member>();
  return member ? member->object : expression;
}

// In a planar problem a number along the normal stands for what turns, and two components for a vector.
std::optional<std::string> planar_words(const std::vector<Expression>& asked, const Situation& situation) {
  if (!situation.plane || asked.empty() || asked.size() > 2) return std::nullopt;
  const MotionPlane& plane = *situation.plane;
  const auto along = [&](const Expression& one, std::size_t axis) { return component_axis(one, situation) == axis; };
  const Unary* reversed = asked.front().as<Unary>();
  const Expression& first = reversed && reversed->sign == '-' && plane.sign() < 0 ? reversed->operand : asked.front();
  const bool pair = asked.size() == 2 && along(first, component_axes(plane)[0]) &&
                    along(asked[1], component_axes(plane)[1]) && same_tree(whole(first), whole(asked[1]));
  if (!pair && (asked.size() == 2 || !along(first, plane.normal()))) return std::nullopt;
  return words_of(whole(first), situation);
}

// Quantities that are asked for one after the other, or a vector by its components: in the plane those in it.
std::string list_words(const List& list, const Situation& situation) {
  const bool vector = std::ranges::none_of(list.items, [](const Expression& item) {
    const Call* call = item.as<Call>();
    const Name* name = item.as<Name>();
    return (call && !noun_of(call->function).empty()) || (name && name->primes > 0) || item.as<Of>() ||
           item.as<Member>();
  });
  std::string words;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (vector && situation.plane && list.items.size() == 3 && i == situation.plane->normal()) continue;
    words += (words.empty() ? "" : vector ? ", " : "; ") + words_of(list.items[i], situation);
  }
  return vector ? "[" + words + "]" : words;
}

std::string words_of(const Expression& expression, const Situation& situation) {
  if (const auto planar = planar_words({expression}, situation)) return *planar;
  if (expression.as<Call>()) return call_words(expression, situation);
  if (const At* at = expression.as<At>(); at && !at->expression.as<Binary>())
    return words_of(at->expression, situation) + " @ " + at->instant;
  if (const Of* of = expression.as<Of>())
    return words_of(of->point, situation) + " of " + words_of(of->body, situation);
  if (const List* list = expression.as<List>()) return list_words(*list, situation);
  if (const Member* member = expression.as<Member>();
      member && std::ranges::find(situation.axes, member->name) != situation.axes.end())
    return words_of(member->object, situation) + ", " + member->name + " component";
  if (const Member* member = expression.as<Member>();
      member && (member->name == "amplitude" || member->name == "phase"))
    if (const Call* call = member->object.as<Call>(); call && call->function == "response")
      return member->name + " of " + words_of(member->object, situation);
  if (const Name* name = expression.as<Name>()) {
    if (name->primes == 1) return "rate of " + name->name;
    if (name->primes == 2) return "second derivative of " + name->name;
    return name->name;
  }
  return to_string(expression);
}

// A condition in words; stable(plate) is "plate is stable".
std::string condition_words(const Expression& condition, const Situation& situation) {
  const Call* call = condition.as<Call>();
  // "belt sticks on motor"
  const bool on_wheel = call && call->arguments.size() == 2 && call->arguments[1].preposition == "on";
  if (call && (call->arguments.size() == 1 || on_wheel))
    for (const auto& [function, verb] :
         {std::pair{"stable", " is stable"}, std::pair{"touching", " touches"}, std::pair{"taut", " is taut"},
          std::pair{"sticking", " sticks"}, std::pair{"sliding", " slides"}, std::pair{"parting", " parts"}})
      if (call->function == function)
        return words_of(call->arguments[0].value, situation) + verb +
               (on_wheel ? " on " + words_of(call->arguments[1].value, situation) : "");
  return to_string(condition);
}

}  // namespace

std::string describe(const Ask& ask, const Situation& situation, bool is_vector) {
  std::string words;
  if (ask.extremum) {
    words = std::string(ask.extremum->largest ? "largest " : "smallest ") + ask.extremum->name + " while ";
    for (std::size_t i = 0; i < ask.extremum->conditions.size(); ++i)
      words += (i > 0 ? " and " : "") + condition_words(ask.extremum->conditions[i], situation);
    return words + (ask.extremum->situation.empty() ? "" : " @ " + ask.extremum->situation);
  }
  if (ask.when)
    return std::string(ask.when->first ? "first time when " : "times when ") + to_string(ask.when->condition);
  if (ask.table) return "over " + ask.table->over;
  if (const auto planar = planar_words(ask.of, situation))
    words = *planar;
  else
    for (const Expression& expression : ask.of) words += (words.empty() ? "" : "; ") + words_of(expression, situation);
  if (is_vector) {
    const std::string axes =
        ask.axes ? (ask.axes->as<List>() ? "the axes " + to_string(*ask.axes) : "the axes of " + to_string(*ask.axes))
                 : "";
    if (!axes.empty()) words += ", on " + axes;
  }
  return words;
}

std::string_view noun_of(std::string_view function) {
  if (const QuantityFunction* quantity = find_quantity(function)) return quantity->noun;
  static const std::map<std::string_view, std::string_view> functions{
      {"norm", "magnitude"},          {"abs", "magnitude"},       {"angle", "angle"},
      {"acute_angle", "acute angle"}, {"component", "component"}, {"direction", "direction"},
      {"unit", "direction"},          {"dot", "scalar product"},  {"cross", "vector product"},
  };
  const auto found = functions.find(function);
  return found == functions.end() ? std::string_view() : found->second;
}

}  // namespace poinsot::problem
