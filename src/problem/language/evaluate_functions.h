// The mathematical functions of expressions, elements of lists by their places, and items by their names.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "poinsot/engine/math/formula/formula_decision.h"
#include "poinsot/engine/math/formula/formula_exponential.h"
#include "problem/language/evaluate.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/words.h"

namespace poinsot::problem {

template <class Scalar>
struct FunctionContext {
  const Evaluator<Scalar>& evaluator;
  const Mark& mark;

  [[noreturn]] void fail(const Expression& argument, std::string message, std::string hint = "") const {
    evaluator.fail(beginning(argument), std::move(message), std::move(hint));
  }
  [[noreturn]] void no_value(std::string message) const {
    throw DomainError(evaluator.file(), mark, std::move(message));
  }

  Value<Scalar> number(const Call& call, const Expression& argument) const {
    Value<Scalar> value = evaluator(argument);
    if (value.is_number()) return value;
    const bool magnitude = value.is_vector() && (call.function == "abs" || call.function == "sqrt");
    fail(argument, call.function + " takes a number, not " + kind_in_words(value),
         magnitude ? "the magnitude of a vector is norm(v)" : "");
  }
  Scalar pure(const Call& call, const Expression& argument) const {
    const Value<Scalar> value = number(call, argument);
    if (is_pure(value.dimension)) return value.number;
    fail(argument, call.function + " takes a pure number, not " + to_string(value.dimension));
  }
  Scalar angle(const Call& call, const Expression& argument) const {
    const Value<Scalar> value = number(call, argument);
    if (!is_pure(value.dimension)) fail(argument, call.function + " takes an angle, not " + to_string(value.dimension));
    if (value.bare && !is_bare_zero(value)) {
      const std::string text = to_string(argument);
      fail(argument, "the unit of the angle is missing in " + call.function + "(" + text + ")",
           argument.template as<Number>() ? "write " + text + " deg or " + text + " rad"
                                          : "give it the unit deg or rad");
    }
    return value.number;
  }
  Value<Scalar> vector(const Call& call, const Expression& argument) const {
    Value<Scalar> value = evaluator(argument);
    if (value.is_vector()) return value;
    if (value.is_list() && value.items.size() == 3) {
      fail(argument, call.function + " takes a vector, and the components of this list are not of one kind");
    }
    fail(argument, call.function + " takes a vector, not " + kind_in_words(value));
  }
  // A vector argument, which must have a direction. Numbers are scaled to a size near one, formulas are left as they
  // are.
  Vector3<Scalar> along(const Call& call, const Expression& argument) const {
    const Value<Scalar> value = vector(call, argument);
    if (is_zero(value)) throw DomainError(evaluator.file(), beginning(argument), "the zero vector has no direction");
    return scaled(value.vector);
  }
  Vector3<Scalar> direction(const Call& call, const Expression& argument) const {
    return normalized(along(call, argument));
  }
  // The vector times the power of two that brings it to a size whose square can neither overflow nor vanish.
  static Vector3<Scalar> scaled(const Vector3<Scalar>& v) {
    if constexpr (is_exact<Scalar>) return v;
    const double largest = std::max({std::abs(plain(v.x)), std::abs(plain(v.y)), std::abs(plain(v.z))});
    return v * Scalar(std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022)));
  }
};

template <class Scalar>
std::optional<Value<Scalar>> function_of_number(const Call& call, const FunctionContext<Scalar>& context) {
  using std::abs, std::acos, std::asin, std::atan, std::cos, std::sin, std::sqrt, std::tan;
  using Result = Value<Scalar>;
  const std::string_view f = call.function;
  const Expression& argument = call.arguments[0].value;
  const auto pure = [](const Scalar& x) { return Result::of_number(x, dimensions::none); };
  const auto angle = [](const Scalar& x) { return Result::of_number(x, dimensions::angle); };

  if (f == "sin") return pure(sin(context.angle(call, argument)));
  if (f == "cos") return pure(cos(context.angle(call, argument)));
  if (f == "tan") return pure(tan(context.angle(call, argument)));
  if (f == "atan") return angle(atan(context.pure(call, argument)));
  if (f == "exp" || f == "ln") {
    const Scalar x = context.pure(call, argument);
    if (f == "ln" && !(plain(x) > 0))
      context.no_value("ln of " + number_text(plain(x)) + " does not exist: the argument must be positive");
    if constexpr (std::is_same_v<Scalar, Formula>) {
      return pure(f == "exp" ? exp(x) : ln(x));
    } else if constexpr (is_exact<Scalar>) {
      throw NoFormula("the rate of " + call.function + "() has no formula");
    } else {
      using std::exp, std::log;
      return pure(f == "exp" ? exp(x) : log(x));
    }
  }
  if (f == "asin" || f == "acos") {
    Scalar x = context.pure(call, argument);
    // An argument that exceeds 1 by rounding counts as 1.
    constexpr double rounding = 1e-12;
    if (std::abs(plain(x)) > 1 + rounding) {
      context.no_value(call.function + " of " + number_text(plain(x)) +
                       " does not exist: the argument must be between -1 and 1");
    }
    if (std::abs(plain(x)) > 1) x = Scalar(plain(x) > 0 ? 1.0 : -1.0);
    return angle(f == "asin" ? asin(x) : acos(x));
  }
  if (f == "sqrt") {
    const Result x = context.number(call, argument);
    if (plain(x.number) < 0) context.no_value("sqrt of the negative number " + number_text(plain(x.number)));
    const std::optional<Dimension> dimension = power(x.dimension, 1, 2);
    if (!dimension) context.fail(argument, "the root of " + to_string(x.dimension) + " is no quantity that has a unit");
    return Result::of_number(sqrt(x.number), *dimension, x.bare);
  }
  if (f == "abs") {
    Result x = context.number(call, argument);
    if constexpr (is_exact<Scalar> && !std::is_same_v<Scalar, Formula> && !Recording<Scalar>)
      x.number = plain(x.number) < 0 ? -x.number : x.number;
    else
      x.number = abs(x.number);
    return x;
  }
  return std::nullopt;
}

template <class Scalar>
std::optional<Value<Scalar>> function_of_vectors(const Call& call, const FunctionContext<Scalar>& context) {
  using std::atan2;
  using Result = Value<Scalar>;
  const std::string_view f = call.function;
  const std::string pattern = call.pattern();
  const Expression& first = call.arguments[0].value;

  if (pattern.empty()) {
    if (f == "norm") {
      const Result v = context.vector(call, first);
      if (is_zero(v)) return Result::of_number(norm(v.vector), v.dimension, v.bare);
      if constexpr (is_exact<Scalar>) return Result::of_number(norm(v.vector), v.dimension, v.bare);
      // With s a power of two near |v|, |v| = (v . v/s)/|v/s| neither overflows nor vanishes.
      const Vector3<Scalar> near_unit = context.scaled(v.vector);
      return Result::of_number(dot(v.vector, near_unit) / norm(near_unit), v.dimension, v.bare);
    }
    if (f == "unit" || f == "direction") return Result::of_vector(context.direction(call, first), dimensions::none);
    return std::nullopt;
  }
  const Expression& second = call.arguments[1].value;
  if ((f == "dot" || f == "cross") && pattern == "with") {
    const Result u = context.vector(call, first);
    const Result v = context.vector(call, second);
    const Dimension dimension = u.dimension * v.dimension;
    const bool bare = u.bare && v.bare;
    if (f == "dot") return Result::of_number(dot(u.vector, v.vector), dimension, bare);
    return Result::of_vector(cross(u.vector, v.vector), dimension, bare);
  }
  if (f == "component" && pattern == "along") {
    const Result v = context.vector(call, first);
    return Result::of_number(dot(v.vector, context.direction(call, second)), v.dimension, v.bare);
  }
  if ((f == "angle" || f == "acute_angle") && pattern == "to") {
    const Vector3<Scalar> u = context.along(call, first);
    const Vector3<Scalar> v = context.along(call, second);
    // The angle follows from its sine and cosine, both times the same factor. This is exact near 0 and 180 degrees,
    // where the arc cosine alone loses half of the digits.
    Scalar cosine = dot(u, v);
    if constexpr (Recording<Scalar>)
      if (f == "acute_angle") cosine = abs(cosine);
    return Result::of_number(atan2(norm(cross(u, v)), f == "angle" || !decided_negative(cosine) ? cosine : -cosine),
                             dimensions::angle);
  }
  return std::nullopt;
}

// min and max of several numbers, and the angle whose legs are given.
template <class Scalar>
std::optional<Value<Scalar>> function_of_several(const Call& call, const FunctionContext<Scalar>& context) {
  using std::atan2;
  using Result = Value<Scalar>;
  const std::string_view f = call.function;
  const std::string pattern = call.pattern();
  std::vector<const Expression*> arguments;
  const List* list = call.arguments[0].value.template as<List>();
  if ((f == "min" || f == "max") && pattern.empty() && list && !list->items.empty()) {
    for (const Expression& item : list->items) arguments.push_back(&item);
  } else if (((f == "min" || f == "max") && pattern == "with") || (f == "atan2" && pattern == "to")) {
    for (const Argument& argument : call.arguments) arguments.push_back(&argument.value);
  } else {
    return std::nullopt;
  }
  std::vector<Result> values;
  for (const Expression* argument : arguments) {
    Result value = context.number(call, *argument);
    const auto known = std::find_if(values.begin(), values.end(), [](const Result& v) { return !is_bare_zero(v); });
    if (known != values.end() && !is_bare_zero(value) && !same_kind(known->dimension, value.dimension)) {
      context.fail(*argument, call.function + " takes quantities of one kind, not " + quantity_in_words(*known) +
                                  " and " + quantity_in_words(value));
    }
    values.push_back(std::move(value));
  }
  if (f == "atan2") {
    if (is_zero(values[0]) && is_zero(values[1])) context.no_value("atan2 of two zeros has no direction");
    return Result::of_number(atan2(values[0].number, values[1].number), dimensions::angle);
  }
  Result best = values[0];
  Dimension dimension = best.dimension;
  bool bare = true;
  for (const Result& value : values) {
    if (!is_bare_zero(value)) dimension = value.dimension;
    bare = bare && value.bare;
    if constexpr (Recording<Scalar>) {
      if (&value != values.data())
        best.number = f == "min" ? smaller(best.number, value.number) : larger(best.number, value.number);
      continue;
    }
    const bool better = decided_negative(f == "min" ? value.number - best.number : best.number - value.number);
    if (better) best = value;
  }
  return Result::of_number(best.number, dimension, bare);
}

// frequencies(disk)[2]
template <class Scalar>
Value<Scalar> element_of(const Call& call, const FunctionContext<Scalar>& context) {
  const Expression &list_expression = call.arguments[0].value, &place_expression = call.arguments[1].value;
  Value<Scalar> list = context.evaluator(list_expression);
  if (is_record(list)) context.fail(list_expression, "one mode has no elements", "it has " + joined(names_in(list)));
  if (!list.is_list())
    context.fail(list_expression, kind_in_words(list) + " has no elements",
                 list.is_vector() ? "a vector has components, v.x" : "lists have, frequencies(disk)[1]");
  const Value<Scalar> place = context.evaluator(place_expression);
  const double number = place.is_number() ? plain(place.number) : 0;
  if (!place.is_number() || !place.bare || number != std::floor(number))
    context.fail(place_expression, "the place of an element is a whole number without unit",
                 "write frequencies(disk)[1]");
  if (number < 1) context.fail(place_expression, "there is no element " + number_text(number), "the first is [1]");
  const std::size_t count = list.items.size();
  if (number > static_cast<double>(count))
    throw UnansweredError(context.evaluator.file(), beginning(place_expression),
                          "there is no element " + number_text(number) + ": " +
                              (count == 0 ? "the list is empty" : "the last is " + std::to_string(count)));
  return std::move(list.items[static_cast<std::size_t>(number) - 1]);
}

// modes(disk)[1].frequency
template <class Scalar>
Value<Scalar> named_item(const Value<Scalar>& record, const std::string& name, const Mark& mark,
                         const Evaluator<Scalar>& evaluator) {
  for (const Value<Scalar>& item : record.items)
    if (item.text == name) return Value<Scalar>::of_number(item.number, item.dimension);
  const std::vector<std::string> names = names_in(record);
  const std::string hint = did_you_mean(name, names);
  evaluator.fail(mark, "a mode has no '" + name + "'", hint.empty() ? "it has " + joined(names) : hint);
}

// Returns nothing if the call is none of these functions in its own form.
template <class Scalar>
std::optional<Value<Scalar>> mathematical_function(const Call& call, const FunctionContext<Scalar>& context) {
  if (call.arguments.empty()) return std::nullopt;
  if (call.function == "element" && call.pattern() == "at") return element_of(call, context);
  if (call.arguments.size() == 1) {
    if (auto result = function_of_number(call, context)) return result;
  }
  if (auto result = function_of_vectors(call, context)) return result;
  return function_of_several(call, context);
}

}  // namespace poinsot::problem
