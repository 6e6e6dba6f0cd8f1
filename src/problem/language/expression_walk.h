// The one walk over an expression's tree: everything that looks into expressions or rewrites them goes through it, so
// that a new kind of node is known to all of them at once.
#pragma once

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "problem/language/expression.h"

namespace poinsot::problem {

// Calls `visit` with each expression that a node's content holds, in the order in which the file writes them. With a
// content that may change, `visit` may assign to what it is given.
template <class Content, class Visit>
void for_each_part(Content& content, const Visit& visit) {
  using Kind = std::remove_const_t<Content>;
  if constexpr (std::is_same_v<Kind, Member>) {
    visit(content.object);
  } else if constexpr (std::is_same_v<Kind, Arrow>) {
    visit(content.from);
    visit(content.to);
  } else if constexpr (std::is_same_v<Kind, Of>) {
    visit(content.point);
    visit(content.body);
  } else if constexpr (std::is_same_v<Kind, Call>) {
    for (auto& argument : content.arguments) visit(argument.value);
  } else if constexpr (std::is_same_v<Kind, Unary>) {
    visit(content.operand);
  } else if constexpr (std::is_same_v<Kind, Binary>) {
    visit(content.left);
    visit(content.right);
  } else if constexpr (std::is_same_v<Kind, Comparison>) {
    for (auto& operand : content.operands) visit(operand);
  } else if constexpr (std::is_same_v<Kind, At>) {
    visit(content.expression);
  } else if constexpr (std::is_same_v<Kind, List>) {
    for (auto& item : content.items) visit(item);
  } else if constexpr (std::is_same_v<Kind, Range>) {
    visit(content.from);
    visit(content.to);
    visit(content.step);
  } else {
    static_assert(std::is_same_v<Kind, Number> || std::is_same_v<Kind, Name>, "a kind of node without its parts");
  }
}

// The same for the node of an expression; an expression without node has no children.
template <class Visit>
void for_each_child(const Expression& expression, const Visit& visit) {
  if (!expression) return;
  std::visit([&](const auto& content) { for_each_part(content, visit); }, expression->content);
}

// Whether one of the children passes the test; those after it are not asked.
template <class Test>
bool any_child(const Expression& expression, const Test& test) {
  bool found = false;
  for_each_child(expression, [&](const Expression& child) { found = found || test(child); });
  return found;
}

// The height of the highest tree among the parts of a content.
template <class Content>
int height_below(const Content& content) {
  int height = 0;
  for_each_part(content, [&](const Expression& part) { height = std::max(height, part ? part->height : 0); });
  return height;
}

// The expression of a content whose parts are expressions already.
template <class Content>
Expression built(Content content, const Mark& mark) {
  const int height = height_below(content) + 1;
  return {std::make_shared<const Node>(Node{std::move(content), mark, height})};
}

// The expression with each child replaced by what `change` makes of it; its mark stays.
template <class Change>
Expression transformed(const Expression& expression, const Change& change) {
  return std::visit(
      [&](auto content) {
        for_each_part(content, [&](Expression& child) { child = change(child); });
        return built(std::move(content), expression->mark);
      },
      expression->content);
}

// The first `@` in the order of writing, nullptr if there is none. Those within another `@` do not count.
const At* first_at(const Expression& expression);

// Adds the names after every @ in it.
void collect_instants(const Expression& expression, std::set<std::string>& names);

// Collects the names in an expression; those before an @ only if `into_at`.
void collect_names(const Expression& expression, std::set<std::string>& names, bool into_at = true);

// Collects the functions that an expression calls.
void collect_functions(const Expression& expression, std::set<std::string>& functions, bool into_at = true);

}  // namespace poinsot::problem
