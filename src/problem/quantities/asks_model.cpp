#include "problem/quantities/asks_model.h"

#include <algorithm>
#include <set>
#include <string>

#include "problem/language/expression_walk.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace {

constexpr int most_definitions = 50;  // that stand behind each other; the readers allow no more

template <class Item>
bool is_among(const std::vector<Item>& items, const std::string& name) {
  return std::ranges::any_of(items, [&](const Item& item) { return item.name == name; });
}

bool is_coordinate(const Situation& situation, const std::string& name) {
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (const Name* position = freedom.position ? freedom.position->as<Name>() : nullptr)
        if (position->name == name) return true;
  return false;
}

bool asks_behind(const Situation& situation, const Expression& expression, bool into_at, int depth) {
  std::set<std::string> functions;
  collect_functions(expression, functions, into_at);
  for (const std::string& function : functions)
    if (find_quantity(function)) return true;
  std::set<std::string> names;
  collect_names(expression, names, into_at);
  for (const std::string& name : names) {
    if (is_among(situation.find, name) || is_among(situation.choose, name) || is_coordinate(situation, name))
      return true;
    // `A of plate` is a point that moves with a body.
    if (is_among(situation.bodies, name)) return true;
    // Data may be made of what is to be found.
    for (const auto* list : {&situation.define, &situation.given})
      for (const NamedExpression& item : *list)
        if (item.name == name && depth < most_definitions && asks_behind(situation, item.value, into_at, depth + 1))
          return true;
  }
  return false;
}

}  // namespace

bool asks_model(const Situation& situation, const Expression& expression, bool into_at) {
  return asks_behind(situation, expression, into_at, 0);
}

bool asks_energy(const Expression& expression) {
  std::set<std::string> functions;
  collect_functions(expression, functions, true);
  return std::ranges::any_of(functions, [](const std::string& function) {
    const QuantityFunction* quantity = find_quantity(function);
    return quantity && quantity->energy;
  });
}

}  // namespace poinsot::problem
