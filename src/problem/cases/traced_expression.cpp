#include "problem/cases/traced_expression.h"

#include <cmath>
#include <numbers>

#include "problem/language/diagnostic.h"
#include "problem/language/expression.h"

namespace poinsot::problem {
namespace {

using Letters = std::function<std::optional<Traced>(const std::string&)>;

std::optional<Traced> traced_sum(const Expression& expression, const Letters& letter);

std::optional<Traced> traced_power(const Traced& base, const Expression& exponent) {
  const auto* number = exponent.as<Number>();
  constexpr double most = 100;
  if (number == nullptr || number->has_unit || number->value != std::round(number->value) || number->value > most)
    return std::nullopt;
  Traced power(1);
  for (int i = 0; i < static_cast<int>(number->value); ++i) power *= base;
  return power;
}

std::optional<Traced> traced_call(const Call& call, const Letters& letter) {
  if (call.arguments.empty() || call.arguments.size() > 2) return std::nullopt;
  const std::optional<Traced> first = traced_sum(call.arguments.front().value, letter);
  if (!first) return std::nullopt;
  if (call.arguments.size() == 2) {
    const std::optional<Traced> second = traced_sum(call.arguments.back().value, letter);
    if (!second || call.function != "atan2") return std::nullopt;
    return atan2(*first, *second);
  }
  if (call.function == "sqrt") return sqrt(*first);
  if (call.function == "sin") return sin(*first);
  if (call.function == "cos") return cos(*first);
  if (call.function == "tan") return tan(*first);
  if (call.function == "asin") return asin(*first);
  if (call.function == "acos") return acos(*first);
  if (call.function == "atan") return atan(*first);
  if (call.function == "abs") return abs(*first);
  return std::nullopt;
}

std::optional<Traced> traced_binary(const Binary& binary, const Letters& letter) {
  const std::optional<Traced> left = traced_sum(binary.left, letter);
  if (!left) return std::nullopt;
  if (binary.operation == '^') return traced_power(*left, binary.right);
  const std::optional<Traced> right = traced_sum(binary.right, letter);
  if (!right) return std::nullopt;
  switch (binary.operation) {
    case '+':
      return *left + *right;
    case '-':
      return *left - *right;
    case '*':
      return *left * *right;
    case '/':
      return *left / *right;
    default:
      return std::nullopt;
  }
}

std::optional<Traced> traced_sum(const Expression& expression, const Letters& letter) {
  if (const auto* number = expression.as<Number>())
    return number->has_unit ? std::nullopt : std::optional(Traced(number->value));
  if (const auto* name = expression.as<Name>()) {
    const std::string text = name->name + std::string(static_cast<std::size_t>(name->primes), '\'');
    if (const std::optional<Traced> value = letter(text)) return value;
    return text == "pi" ? std::optional(Traced(std::numbers::pi)) : std::nullopt;
  }
  if (const auto* unary = expression.as<Unary>()) {
    const std::optional<Traced> value = traced_sum(unary->operand, letter);
    return value && unary->sign == '-' ? std::optional(-*value) : value;
  }
  if (const auto* call = expression.as<Call>()) return traced_call(*call, letter);
  if (const auto* binary = expression.as<Binary>()) return traced_binary(*binary, letter);
  return std::nullopt;
}

}  // namespace

std::optional<Traced> traced_condition(const std::string& words, const Letters& letter) {
  try {
    const Expression expression = parse_expression(words, "condition");
    const auto* comparison = expression.as<Comparison>();
    if (comparison == nullptr || comparison->operands.size() != 2) return std::nullopt;
    const std::optional<Traced> left = traced_sum(comparison->operands[0], letter);
    const std::optional<Traced> right = traced_sum(comparison->operands[1], letter);
    if (!left || !right) return std::nullopt;
    switch (comparison->relations[0]) {
      case Relation::greater:
      case Relation::greater_equal:
        return *left - *right;
      case Relation::less:
      case Relation::less_equal:
        return *right - *left;
      case Relation::equal:
        return std::nullopt;
    }
    return std::nullopt;
  } catch (const StatementError&) {
    return std::nullopt;  // Words for people.
  } catch (const std::domain_error&) {
    return std::nullopt;  // A division by zero everywhere.
  }
}

}  // namespace poinsot::problem
