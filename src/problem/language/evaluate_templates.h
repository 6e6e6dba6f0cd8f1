// Definitions of evaluate.h, which evaluate.cpp instantiates: the walk over the tree and arithmetic.
// evaluate_functions.h holds the functions.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "poinsot/engine/work/work.h"
#include "problem/language/evaluate.h"
#include "problem/language/evaluate_functions.h"
#include "problem/language/evaluate_support.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// Evaluates one node of the tree. Every operation checks forms and dimensions first and values second.
template <class Scalar>
struct Evaluation {
  using Result = Value<Scalar>;

  const Evaluator<Scalar>& evaluator;
  Scope<Scalar>& scope;
  const Mark& mark;

  Result operator()(const Number& number) const {
    return finite(Result::of_number(literal_value<Scalar>(number), number.unit.dimension, !number.has_unit));
  }

  Result operator()(const Name& name) const {
    if (name.primes == 0 && name.name == "pi") return Result::of_number(pi_value<Scalar>(), dimensions::none);
    if (name.primes == 0 && name.name == "any") return Result::any();
    return scope.name(name, mark, evaluator);
  }

  Result operator()(const Member& member) const { return scope.member(member, mark, evaluator); }
  Result operator()(const Arrow& arrow) const { return scope.arrow(arrow, mark, evaluator); }
  Result operator()(const Of& of) const { return scope.of(of, mark, evaluator); }
  Result operator()(const At& at) const { return scope.at(at, mark, evaluator); }

  Result operator()(const Call& call) const {
    const FunctionContext<Scalar> context{evaluator, mark};
    if (std::optional<Result> result = mathematical_function(call, context)) return finite(*std::move(result));
    return scope.call(call, mark, evaluator);
  }

  Result operator()(const Unary& unary) const {
    Result value = evaluator(unary.operand);
    need_number_or_vector(value, "a sign cannot stand before ");
    if (unary.sign == '-') {
      value.number = -value.number;
      value.vector = -value.vector;
    }
    return value;
  }

  Result operator()(const Binary& binary) const {
    const Result left = evaluator(binary.left);
    const Result right = evaluator(binary.right);
    switch (binary.operation) {
      case '+':
      case '-':
        return finite(sum(binary, left, right));
      case '*':
        return finite(product(left, right));
      case '/':
        return finite(quotient(left, right));
      default:
        return finite(power_of(left, right));
    }
  }

  Result operator()(const Comparison& comparison) const {
    bool holds = true;
    Result left = evaluator(comparison.operands[0]);
    for (std::size_t i = 0; i < comparison.relations.size(); ++i) {
      Result right = evaluator(comparison.operands[i + 1]);
      const Relation relation = comparison.relations[i];
      holds = compare(comparison, i, left, right, relation) && holds;
      left = std::move(right);
    }
    return Result::of_truth(holds);
  }

  Result operator()(const List& list) const {
    std::vector<Result> items;
    items.reserve(list.items.size());
    for (const Expression& item : list.items) items.push_back(evaluator(item));
    return as_vector(Result::of_list(std::move(items)));
  }

  Result operator()(const Range&) const {
    evaluator.fail(mark, "a range is no value", "it stands under 'over:' of a table");
  }

 private:
  Result finite(Result value) const {
    if (!is_finite(value)) {
      throw DomainError(evaluator.file(), mark, "the result is beyond the range of numbers or undefined");
    }
    if (!reasonable(value.dimension)) evaluator.fail(mark, "the dimension of the result is beyond all measure");
    return value;
  }

  void need_number_or_vector(const Result& value, const char* message) const {
    if (!value.is_number() && !value.is_vector()) evaluator.fail(mark, std::string(message) + kind_in_words(value));
  }

  Result sum(const Binary& binary, const Result& left, const Result& right) const {
    const bool minus = binary.operation == '-';
    for (const Result* value : {&left, &right}) {
      need_number_or_vector(*value, minus ? "nothing can be subtracted from or by " : "nothing can be added to ");
    }
    Result negated = right;
    if (minus) {
      negated.number = -negated.number;
      negated.vector = -negated.vector;
    }
    // A bare zero can be added to a vector, where it stands for the zero vector.
    if (left.kind != right.kind && is_bare_zero(left)) return negated;
    if (left.kind != right.kind && is_bare_zero(right)) return left;
    if (left.kind != right.kind) {
      evaluator.fail(mark, minus ? kind_in_words(right) + " cannot be subtracted from " + kind_in_words(left)
                                 : kind_in_words(right) + " cannot be added to " + kind_in_words(left));
    }
    const Dimension dimension =
        fitting(binary.left, left, binary.right, right, minus ? "cannot be subtracted from" : "cannot be added to");
    const bool bare = left.bare && right.bare;
    if (left.is_vector()) return Result::of_vector(left.vector + negated.vector, dimension, bare);
    return Result::of_number(left.number + negated.number, dimension, bare);
  }

  // The dimension of two values that are added or compared; throws if they are of different kinds.
  Dimension fitting(const Expression& left, const Result& a, const Expression& right, const Result& b,
                    const char* cannot) const {
    if (is_bare_zero(a)) return b.dimension;
    if (is_bare_zero(b)) return a.dimension;
    if (!same_kind(a.dimension, b.dimension)) {
      const std::string hint =
          a.bare || b.bare ? "a number without unit is a pure number; a unit stands after it and a blank" : "";
      evaluator.fail(mark, quantity_in_words(b) + " " + cannot + " " + quantity_in_words(a), hint);
    }
    // In `90 - theta` the author thinks of degrees, while the language counts in radians. This is refused.
    const Expression* number = a.bare && is_plain_angle(right, b)  ? &left
                               : b.bare && is_plain_angle(left, a) ? &right
                                                                   : nullptr;
    if (number) {
      const std::string text = to_string(*number);
      evaluator.fail(
          beginning(*number), "a number without unit meets an angle",
          number->as<Number>() ? "write " + text + " deg or " + text + " rad" : "give it the unit deg or rad");
    }
    // Beside a number without unit an angle counts as a pure number: 1 - theta^2/2.
    if (a.bare || b.bare) return dimensions::none;
    return joined_dimension(a.dimension, b.dimension);
  }

  // Whether something is written as an angle: a name, literal or call with that dimension. In a longer expression the
  // radian may come from omega r/v, which is a pure number.
  static bool is_plain_angle(const Expression& expression, const Result& value) {
    if (value.dimension != dimensions::angle) return false;
    if (const Unary* unary = expression.as<Unary>()) return is_plain_angle(unary->operand, value);
    return expression.as<Name>() || expression.as<Number>() || expression.as<Call>();
  }

  Result product(const Result& left, const Result& right) const {
    for (const Result* value : {&left, &right}) need_number_or_vector(*value, "there is no product with ");
    const Dimension dimension = left.dimension * right.dimension;
    const bool bare = left.bare && right.bare;
    if (left.is_vector() && right.is_vector()) {
      evaluator.fail(mark, "two vectors have two products", "write dot(a with b) or cross(a with b)");
    }
    if (left.is_vector()) return Result::of_vector(left.vector * right.number, dimension, bare);
    if (right.is_vector()) return Result::of_vector(left.number * right.vector, dimension, bare);
    return Result::of_number(left.number * right.number, dimension, bare);
  }

  Result quotient(const Result& left, const Result& right) const {
    need_number_or_vector(left, "there is no quotient with ");
    if (!right.is_number()) {
      evaluator.fail(mark, "nothing can be divided by " + kind_in_words(right),
                     right.is_vector() ? "divide by its magnitude, norm(v)" : "");
    }
    if (plain(right.number) == 0) throw DomainError(evaluator.file(), mark, "division by zero");
    const Dimension dimension = left.dimension / right.dimension;
    const bool bare = left.bare && right.bare;
    if (left.is_vector()) return Result::of_vector(left.vector / right.number, dimension, bare);
    return Result::of_number(left.number / right.number, dimension, bare);
  }

  Result power_of(const Result& base, const Result& exponent) const {
    if (base.is_vector()) evaluator.fail(mark, "a vector has no powers", "write dot(v with v) or norm(v)^2");
    if (!base.is_number()) evaluator.fail(mark, kind_in_words(base) + " has no powers");
    if (!exponent.is_number()) evaluator.fail(mark, "an exponent must be a number, not " + kind_in_words(exponent));
    if (!is_pure(exponent.dimension)) {
      evaluator.fail(mark, "an exponent must be a pure number, not " + to_string(exponent.dimension));
    }
    const Dimension dimension = power_dimension(base, exponent);
    const double p = plain(exponent.number);
    const double b = plain(base.number);
    const bool whole = p == std::round(p);
    if (b == 0 && p < 0)
      throw DomainError(evaluator.file(), mark, "division by zero: zero to the power " + number_text(p));
    if (b < 0 && !whole) {
      throw DomainError(evaluator.file(), mark,
                        "the negative number " + number_text(b) + " has no power " + number_text(p));
    }
    return Result::of_number(power_value(base.number, exponent.number), dimension, base.bare && exponent.bare);
  }

  Dimension power_dimension(const Result& base, const Result& exponent) const {
    if (base.dimension == dimensions::none) return dimensions::none;
    const double twelfths = plain(exponent.number) * 12;
    const bool rational = is_constant(exponent.number) && std::abs(twelfths) <= 12 * 100 &&
                          std::abs(twelfths - std::round(twelfths)) < 1e-9;
    const std::optional<Dimension> dimension =
        rational ? power(base.dimension, static_cast<int>(std::lround(twelfths)), 12) : std::nullopt;
    if (dimension) return *dimension;
    if (is_pure(base.dimension)) return dimensions::none;
    evaluator.fail(mark, to_string(base.dimension) + " to the power " + number_text(plain(exponent.number)) +
                             " is no quantity that has a unit");
  }

  static Scalar power_value(const Scalar& base, const Scalar& exponent) {
    using std::exp, std::log, std::pow, std::sqrt;
    const double p = plain(exponent);
    if constexpr (!is_exact<Scalar>) {
      if (!is_constant(exponent)) {
        if (plain(base) > 0) return exp(exponent * log(base));
        return pow(base, p);
      }
    }
    if (p == 0.5) return sqrt(base);
    if (p == std::round(p) && std::abs(p) <= 64) {
      // Repeated squaring is exact for whole numbers, and has derivatives at zero.
      Scalar result(1), square = base;
      for (int n = static_cast<int>(std::abs(p)); n > 0; n /= 2) {
        if (n % 2 == 1) result = result * square;
        if (n > 1) square = square * square;
      }
      return p < 0 ? Scalar(1) / result : result;
    }
    if constexpr (is_exact<Scalar>) {
      // Half-integer powers are roots; other powers that are not whole have no formula.
      if (is_constant(exponent) && 2 * p == std::round(2 * p) && std::abs(p) <= 32)
        return power_value(sqrt(base), Scalar(2) * exponent);
      throw NoFormula("a power that is neither whole nor a half has no formula");
    } else {
      return pow(base, p);
    }
  }

  bool compare(const Comparison& comparison, std::size_t i, const Result& one, const Result& other,
               Relation relation) const {
    const Result left = as_vector(one), right = as_vector(other);
    if (left.is_vector() && right.is_vector() && relation == Relation::equal) {
      fitting(comparison.operands[i], left, comparison.operands[i + 1], right, "cannot be compared with");
      const Vector3<Scalar> difference = left.vector - right.vector;
      return plain(difference.x) == 0 && plain(difference.y) == 0 && plain(difference.z) == 0;
    }
    for (const Result* value : {&left, &right}) {
      if (value->is_number()) continue;
      evaluator.fail(mark, kind_in_words(*value) + " cannot be compared with '" + std::string(symbol(relation)) + "'",
                     value->is_vector() ? "compare components, v.x, or magnitudes, norm(v)" : "");
    }
    fitting(comparison.operands[i], left, comparison.operands[i + 1], right, "cannot be compared with");
    if (is_exact<Scalar> && relation == Relation::equal) return plain(left.number - right.number) == 0;
    const double a = plain(left.number);
    const double b = plain(right.number);
    switch (relation) {
      case Relation::less:
        return a < b;
      case Relation::less_equal:
        return a <= b;
      case Relation::greater:
        return a > b;
      case Relation::greater_equal:
        return a >= b;
      case Relation::equal:
        break;
    }
    return a == b;
  }
};

template <class Scalar>
Value<Scalar> Evaluator<Scalar>::operator()(const Expression& expression) const {
  constexpr Work of_a_node = 100;
  count_work(of_a_node);
  return std::visit(Evaluation<Scalar>{*this, scope_, expression->mark}, expression->content);
}

template <class Scalar>
Value<Scalar> Evaluator<Scalar>::quantity(const Expression& expression, const Dimension& dimension) const {
  Value<Scalar> value = (*this)(expression);
  if (!value.is_number() && !value.is_vector()) return value;
  if (is_bare_zero(value)) {
    value.dimension = dimension;
    return value;
  }
  const bool literal = expression.as<Number>() != nullptr;
  if (!same_kind(value.dimension, dimension)) {
    const std::string unit = si_unit(dimension).text;
    // Who reckons in pounds and feet takes forces for masses: a moment of inertia in lb*ft^2, a density in lb/ft^3.
    const bool weighs = dimension.mass != 0 && same_kind(value.dimension, dimension * dimensions::acceleration);
    const std::string hint =
        value.bare && literal && !unit.empty()
            ? "write its unit after a blank, as in " + to_string(expression) + " " + unit
        : weighs
            ? std::string("a force stands in it in place of a mass: write lbm or ozm for lb or oz") +
                  (dimension == dimensions::moment_of_inertia ? ", lbm*ft^2 or lb*ft*s^2" : "") + ", or divide by g"
        : value.is_vector() && is_pure(value.dimension) && !unit.empty()
            ? "a direction has no size: write one before it, as in 2 " + unit + " * " + to_string(expression)
            : "";
    fail(beginning(expression), "expected " + to_string(dimension) + ", not " + quantity_in_words(value), hint);
  }
  if (value.bare && dimension == dimensions::angle) {
    const std::string text = to_string(expression);
    fail(beginning(expression), "the unit of this angle is missing",
         literal ? "write " + text + " deg or " + text + " rad" : "give it the unit deg or rad");
  }
  return value;
}

template <class Scalar>
Scalar Evaluator<Scalar>::number(const Expression& expression, const Dimension& dimension) const {
  Value<Scalar> value = quantity(expression, dimension);
  if (value.is_number()) return value.number;
  fail(beginning(expression), "expected one number, " + to_string(dimension) + ", not " + kind_in_words(value),
       value.is_vector() ? "take a component, v.x, or the magnitude, norm(v)" : "");
}

template <class Scalar>
Vector3<Scalar> Evaluator<Scalar>::vector(const Expression& expression, const Dimension& dimension) const {
  Value<Scalar> value = quantity(expression, dimension);
  if (value.is_vector()) return value.vector;
  if (is_bare_zero(value)) return Vector3<Scalar>::zero();
  const Mark place = beginning(expression);
  if (value.is_list() && value.items.size() == 3) {
    // The message tells which component does not fit.
    const List* list = expression.as<List>();
    for (std::size_t i = 0; i < 3; ++i) {
      const Value<Scalar>& item = value.items[i];
      if (item.is_number() && (is_bare_zero(item) || same_kind(item.dimension, dimension))) continue;
      fail(list ? beginning(list->items[i]) : place,
           "component " + std::to_string(i + 1) + " of this vector should be " + to_string(dimension) + ", not " +
               (item.is_number() ? quantity_in_words(item) : kind_in_words(item)));
    }
  }
  // What has a name is given elsewhere, and may be meant otherwise there.
  const Name* name = expression.as<Name>();
  fail(place, "expected " + to_string(dimension) + " in three components, a vector, not " + kind_in_words(value),
       name && name->primes == 0 ? "give '" + name->name + "' three components where it is stated, or write [0, 0, " +
                                       name->name + "] for one that has this size"
                                 : "write it as [a, b, c]");
}

template <class Scalar>
void Evaluator<Scalar>::fail(const Mark& mark, std::string message, std::string hint) const {
  throw StatementError(file_, mark, std::move(message), std::move(hint));
}

template <class Scalar>
void Evaluator<Scalar>::unknown_call(const Call& call, const Mark& mark, const std::vector<std::string>& others) const {
  const UnknownCall unknown = describe_unknown_call(call, others);
  fail(mark, unknown.message, unknown.hint);
}

template <class Scalar>
Value<Scalar> Scope<Scalar>::arrow(const Arrow& arrow, const Mark&, const Evaluator<Scalar>& evaluator) {
  const Vector3<Scalar> from = evaluator.vector(arrow.from, dimensions::length);
  return Value<Scalar>::of_vector(evaluator.vector(arrow.to, dimensions::length) - from, dimensions::length);
}

template <class Scalar>
Value<Scalar> Scope<Scalar>::of(const Of&, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  evaluator.fail(mark, "nothing rides on bodies here, so 'of' has no meaning");
}

template <class Scalar>
Value<Scalar> Scope<Scalar>::member(const Member& member, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  const Value<Scalar> object = evaluator(member.object);
  if (is_record(object)) return named_item(object, member.name, mark, evaluator);
  if (!object.is_vector()) {
    evaluator.fail(mark, kind_in_words(object) + " has no component '" + member.name + "'",
                   "a vector has .x, .y and .z");
  }
  const std::size_t i = std::string_view("xyz").find(member.name);
  if (member.name.size() != 1 || i == std::string_view::npos) {
    evaluator.fail(mark, "a vector has no component '" + member.name + "'", "its components are .x, .y and .z");
  }
  return Value<Scalar>::of_number(object.vector[i], object.dimension, object.bare);
}

template <class Scalar>
Value<Scalar> Scope<Scalar>::at(const At&, const Mark& mark, const Evaluator<Scalar>& evaluator) {
  evaluator.fail(mark, "there are no instants here, so '@' has no meaning");
}

template <class Scalar>
Value<Scalar> evaluate(const Expression& expression, Scope<Scalar>& scope, const std::string& file) {
  return Evaluator<Scalar>(scope, file)(expression);
}

}  // namespace poinsot::problem
