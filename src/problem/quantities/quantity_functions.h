// The quantity functions of the language: how each is written, and what part of the state its value depends on.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// What the value of an expression depends on: positions only, also velocities, also accelerations and forces, or the
// motion that follows.
enum class Level { position, velocity, force, motion };

// Tells which function of QuantityScope evaluates the quantity.
enum class QuantityKind {
  kinematic,
  momentum,
  inertia,
  free_motion,
  geometry,
  rate,
  force,
  holding,
  friction,
  stability,
  motion_feature
};

struct QuantityFunction {
  const char* name;
  const char* form;  // examples, for messages and the manual
  const char* noun;  // in words, as answers name it: "angular momentum" of a body
  Level level;
  QuantityKind kind;
  std::vector<std::string_view> patterns;  // the prepositions between the arguments, as Call::pattern() gives them
  bool energy = false;                     // whether its unit is the joule
};

const std::vector<QuantityFunction>& quantity_table();
// Null if there is no quantity of this name.
const QuantityFunction* find_quantity(std::string_view name);
// The names and forms only.
const std::vector<FunctionForm>& quantity_functions();

// What stands before an `@` is looked at only if `through_at`.
Level level_of(const Situation& situation, const Expression& expression, bool through_at = false);

// max(frequencies(disk)), also `@` a situation: the largest of a list.
bool is_extreme_of_list(const Call& call);
// Whether a call asks for an extreme or the period of a quantity over the motion.
inline bool is_motion_feature(const Call& call) {
  const std::string_view f = call.function;
  return (f == "min" || f == "max" || f == "period" || f == "end_of_bouncing") && call.pattern().empty() &&
         call.arguments.size() == 1 && !call.arguments.front().value.as<List>() && !is_extreme_of_list(call);
}
bool asks_motion_feature(const Expression& expression);
// A call of min(), max() or period() over the motion, and where it stands.
struct MotionFeatureCall {
  const Call* call = nullptr;
  Mark mark;
};
// Those in an expression, also in names under define:. What stands before an @ is asked at another instant and does not
// count, nor does what stands within such a call.
std::vector<MotionFeatureCall> motion_features_in(const Situation& situation, const Expression& expression);
// The motion answers them before a state is asked, so that nothing that knows one state alone calls back into the
// motion. The calls stand in expressions, whose nodes never change.
using MotionFeatureValues = std::map<const Call*, Value<double>>;
// Whether an expression asks for the motion near a steady one.
bool asks_stability(const Expression& expression);
// Whether an expression asks for forces or accelerations, at any instant or over the motion.
bool asks_forces(const Situation& situation, const Expression& expression);

// The expression stability(X) for a call stable(X), or of another function of the same arguments.
Expression with_function(Call call, const Expression& expression, const std::string& function);

}  // namespace poinsot::problem
