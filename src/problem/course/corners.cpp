#include "problem/course/corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "problem/language/expression_walk.h"

namespace poinsot::problem {
namespace {

// They are roots of squares, or angles whose cosine is smooth.
constexpr std::array<std::string_view, 10> sharp{"norm", "sqrt", "distance",  "angle",      "acute_angle",
                                                 "acos", "asin", "body_cone", "space_cone", "precession_rate"};

// The numbers of which min() and max() take one; empty for other calls, and for extremes over a motion.
std::vector<Expression> compared_in(const Call& call) {
  if (call.function != "min" && call.function != "max") return {};
  const List* list = call.arguments.front().value.as<List>();
  if (call.arguments.size() == 1) return list ? list->items : std::vector<Expression>();
  std::vector<Expression> numbers;
  for (const Argument& argument : call.arguments) numbers.push_back(argument.value);
  return numbers;
}

class CornerWalk {
 public:
  explicit CornerWalk(const Situation& situation) : situation_(situation) {}

  void look_into(const Expression& expression) {
    // What is asked of an instant does not change along the motion.
    if (!expression || expression.as<At>()) return;
    if (const Name* name = expression.as<Name>()) {
      for (const auto* items : {&situation_.define, &situation_.given}) {
        const auto found = std::ranges::find(*items, name->name, &NamedExpression::name);
        if (found != items->end() && !is_known(found->name)) look_into(found->value);
      }
      return;
    }
    const Mark& mark = expression.mark();
    // What shows a notch within comes first: a look at it shows those that it is part of.
    for_each_child(expression, [&](const Expression& child) { look_into(child); });
    if (const Call* call = expression.as<Call>()) {
      if (call->function == "abs") {
        turns.push_back({call->arguments.front().value, true});
        zeros.push_back({call->arguments.front().value, false});
      } else if (std::ranges::find(sharp, call->function) != sharp.end()) {
        turns.push_back({expression, true});
      }
      const std::vector<Expression> compared = compared_in(*call);
      compares = compares || !compared.empty();
      for (std::size_t i = 0; i < compared.size(); ++i) {
        turns.push_back({compared[i], true});
        for (std::size_t k = i + 1; k < compared.size(); ++k)
          zeros.push_back({built(Binary{'-', compared[i], compared[k]}, mark), false});
      }
    }
    // (x^2)^(1/2)
    if (const Binary* power = expression.as<Binary>(); power && power->operation == '^') {
      const Number* exponent = power->right.as<Number>();
      if (!exponent || exponent->value != std::floor(exponent->value)) turns.push_back({expression, true});
    }
  }

  std::vector<CornerOf> turns{}, zeros{};
  bool compares = false;  // whether one of several numbers is taken

 private:
  // Each definition is looked into once.
  bool is_known(const std::string& name) { return !known_.insert(name).second; }

  const Situation& situation_;
  std::set<std::string> known_;
};

constexpr std::array<std::string_view, 8> of_places{"position",  "center", "distance", "norm",
                                                    "component", "abs",    "min",      "max"};

class PlaceWalk {
 public:
  explicit PlaceWalk(const Situation& situation) : situation_(situation) {}

  bool holds(const Expression& expression) {
    if (!expression) return true;
    if (expression.as<At>()) return false;
    if (const Name* name = expression.as<Name>()) {
      if (name->primes > 0) return false;
      for (const auto* items : {&situation_.define, &situation_.given}) {
        const auto found = std::ranges::find(*items, name->name, &NamedExpression::name);
        if (found != items->end() && known_.insert(found->name).second && !holds(found->value)) return false;
      }
      return true;
    }
    const Call* call = expression.as<Call>();
    if (call && std::ranges::find(of_places, call->function) == of_places.end()) return false;
    const Binary* quotient = expression.as<Binary>();
    if (quotient && (quotient->operation == '/' || quotient->operation == '^') && !quotient->right.as<Number>())
      return false;
    return !any_child(expression, [&](const Expression& child) { return !holds(child); });
  }

 private:
  const Situation& situation_;
  std::set<std::string> known_;
};

}  // namespace

bool is_of_places(const Situation& situation, const Expression& expression) {
  return PlaceWalk(situation).holds(expression);
}

std::vector<CornerOf> corners_of(const Situation& situation, const Expression& expression) {
  CornerWalk walk(situation);
  walk.look_into(expression);
  // A number by itself is seen to come near to zero. Only another one may hide that, and extremes take long to find.
  if (!walk.compares) return walk.zeros;
  walk.turns.insert(walk.turns.end(), walk.zeros.begin(), walk.zeros.end());
  return walk.turns;
}

}  // namespace poinsot::problem
