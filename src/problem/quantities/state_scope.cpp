#include "problem/quantities/state_scope.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "problem/quantities/quantity_values.h"

namespace poinsot::problem {
namespace {

constexpr std::array<std::string_view, 10> functions{"sqrt", "abs",  "sin",  "cos", "tan",
                                                     "asin", "acos", "atan", "exp", "ln"};

bool names(const std::vector<NamedExpression>& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const NamedExpression& item) { return item.name == name; });
}

struct OfState {
  const Situation& situation;
  const Machine& machine;

  bool of(const Expression& expression) const { return expression && std::visit(*this, expression->content); }

  bool operator()(const Number&) const { return true; }
  bool operator()(const Name& name) const {
    if (names(situation.define, name.name)) return false;
    if (machine.coordinate(name.name)) return name.primes < 2;
    const auto same = [&](const auto& item) { return item.name == name.name; };
    return name.primes == 0 && (name.name == "pi" || names(situation.given, name.name) ||
                                std::any_of(situation.letters.begin(), situation.letters.end(), same) ||
                                std::any_of(situation.find.begin(), situation.find.end(), same));
  }
  bool operator()(const Unary& unary) const { return of(unary.operand); }
  bool operator()(const Binary& binary) const { return of(binary.left) && of(binary.right); }
  bool operator()(const Call& call) const {
    return call.arguments.size() == 1 && call.pattern().empty() &&
           std::find(functions.begin(), functions.end(), call.function) != functions.end() &&
           of(call.arguments.front().value);
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }
};

}  // namespace

bool is_of_state(const Situation& situation, const Machine& machine, const Expression& expression) {
  return OfState{situation, machine}.of(expression);
}

Value<double> StateScope::name(const Name& name, const Mark& mark, const Evaluator<double>& evaluator) {
  const NamedCoordinate* coordinate = machine_.coordinate(name.name);
  if (!coordinate) return data_.name(name, mark, evaluator);
  const Dimension dimension = coordinate->turning ? dimensions::angle : dimensions::length;
  if (name.primes == 0) return number_value(state_.q[static_cast<std::size_t>(coordinate->position)], dimension);
  return number_value(state_.v[static_cast<std::size_t>(coordinate->velocity)], dimension / dimensions::time);
}

Value<double> StateScope::call(const Call& call, const Mark& mark, const Evaluator<double>& evaluator) {
  evaluator.unknown_call(call, mark);
}

}  // namespace poinsot::problem
