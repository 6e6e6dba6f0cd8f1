#include "problem/answers/watched_values.h"

#include <algorithm>
#include <string_view>

namespace poinsot::problem {
namespace {

class Watch {
 public:
  Watch(const Situation& situation, const Ask& ask) : situation_(situation) {
    for (const Expression& expression : ask.of) look_at(expression);
  }
  std::vector<Expression> deciding;

  void operator()(const Comparison& comparison) {
    const bool identity = std::all_of(comparison.relations.begin(), comparison.relations.end(),
                                      [](Relation relation) { return relation == Relation::equal; });
    for (const Expression& operand : comparison.operands) {
      if (!identity) deciding.push_back(operand);
      look_at(operand);
    }
  }
  void operator()(const Call& call) {
    const std::string_view f = call.function;
    if (is_motion_feature(call)) return;
    if (f == "min" || f == "max") {
      for (const Argument& argument : call.arguments)
        if (const List* list = argument.value.as<List>())
          deciding.insert(deciding.end(), list->items.begin(), list->items.end());
        else
          deciding.push_back(argument.value);
    }
    if (f == "stable" || f == "stability") add_of(call, {"growth_rate(", "frequencies("});
    if (f == "precession_sense" || f == "polhode" || f == "axis_stability")
      add_of(call, {"angular_velocity(", "principal_moments("});
    if (f == "taut") add_of(call, {"tension("});
    if (f == "touching" && !call.arguments.empty())
      for (const Contact& contact : situation_.contacts)
        if (to_string(call.arguments.front().value) == contact.name)
          add("force(" + contact.name + " on " + contact.of + ")", call.arguments.front().value.mark());
    for (const Argument& argument : call.arguments) look_at(argument.value);
  }
  void operator()(const Name& name) {
    if (name.primes > 0 || ++depth_ > 200) return;
    for (const NamedExpression& item : situation_.define)
      if (item.name == name.name) look_at(item.value);
  }
  void operator()(const Member& member) { look_at(member.object); }
  void operator()(const Unary& unary) { look_at(unary.operand); }
  void operator()(const Binary& binary) {
    look_at(binary.left);
    look_at(binary.right);
  }
  void operator()(const List& list) {
    for (const Expression& item : list.items) look_at(item);
  }
  // What is asked at another instant is decided by values at that instant.
  void operator()(const At& at) {
    const std::size_t before = deciding.size();
    look_at(at.expression);
    for (std::size_t k = before; k < deciding.size(); ++k) {
      At moved = at;
      moved.expression = deciding[k];
      const Mark mark = deciding[k].mark();
      deciding[k] = Expression{std::make_shared<const Node>(Node{std::move(moved), mark, deciding[k]->height + 1})};
    }
  }
  template <class Other>
  void operator()(const Other&) {}

 private:
  void look_at(const Expression& expression) { std::visit(*this, expression->content); }
  void add(const std::string& text, const Mark& mark) {
    deciding.push_back(parse_expression(text, situation_.file, mark));
  }
  void add_of(const Call& call, std::initializer_list<const char*> functions) {
    if (call.arguments.size() != 1) return;
    const Expression& of = call.arguments.front().value;
    for (const std::string function : functions) {
      const std::string rest =
          function == "principal_moments(" ? " about center(" + to_string(of) + "))" : std::string(")");
      add(function + to_string(of) + rest, of.mark());
    }
  }

  const Situation& situation_;
  int depth_ = 0;
};

}  // namespace

WatchedValue watched_value(const Statement& statement, Sample& sample, const Ask& ask) {
  WatchedValue result{sample.value(ask), {}};
  const Watch watch(statement.situations.front(), ask);
  for (const Expression& expression : watch.deciding) {
    Ask one;
    one.of = {expression};
    one.axes = ask.axes;
    one.mark = ask.mark;
    try {
      result.deciding.push_back(sample.value(one));
    } catch (const StatementError&) {
      // The expression has no value here, which itself may decide the answer.
      result.deciding.push_back(Value<double>::of_text("none"));
    }
  }
  return result;
}

}  // namespace poinsot::problem
