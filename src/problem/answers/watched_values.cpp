#include "problem/answers/watched_values.h"

#include <algorithm>
#include <string_view>

#include "problem/language/expression_walk.h"
#include "problem/unknowns/asked_value.h"

namespace poinsot::problem {
namespace {

class Watch {
 public:
  Watch(const Situation& situation, const Ask& ask) : situation_(situation) {
    for (const Expression& expression : ask.of) look_at(expression);
  }
  std::vector<Expression> deciding;

 private:
  void look_at(const Expression& expression) {
    const Call* call = expression.as<Call>();
    if (call && is_motion_feature(*call)) return;
    if (call) note(*call);
    if (const Comparison* comparison = expression.as<Comparison>()) note(*comparison);
    if (const Name* name = expression.as<Name>()) look_behind(*name);
    const std::size_t before = deciding.size();
    for_each_child(expression, [&](const Expression& part) { look_at(part); });
    if (const At* at = expression.as<At>()) move_from(before, *at);
  }
  // What is compared decides, but for an identity.
  void note(const Comparison& comparison) {
    if (std::ranges::any_of(comparison.relations, [](Relation relation) { return relation != Relation::equal; }))
      deciding.insert(deciding.end(), comparison.operands.begin(), comparison.operands.end());
  }
  void note(const Call& call) {
    const std::string_view f = call.function;
    if (f == "min" || f == "max") {
      for (const Argument& argument : call.arguments)
        if (const List* list = argument.value.as<List>())
          deciding.insert(deciding.end(), list->items.begin(), list->items.end());
        else
          deciding.push_back(argument.value);
    }
    if (call.arguments.size() != 1) return;
    const Expression& of = call.arguments.front().value;
    if (f == "stable" || f == "stability") {
      add("growth_rate", {{"", of}});
      add("frequencies", {{"", of}});
    }
    if (f == "precession_sense" || f == "polhode" || f == "axis_stability") {
      add("angular_velocity", {{"", of}});
      add("principal_moments", {{"", of}, {"about", called("center", {{"", of}}, of.mark())}});
    }
    if (f == "taut") add("tension", {{"", of}});
    if (const Name* name = of.as<Name>(); name && f == "touching")
      for (const Contact& contact : situation_.contacts)
        if (name->name == contact.name) add("force", {{"", of}, {"on", built(Name{contact.of}, of.mark())}});
  }
  void look_behind(const Name& name) {
    if (name.primes > 0 || ++depth_ > 200) return;
    for (const NamedExpression& item : situation_.define)
      if (item.name == name.name) look_at(item.value);
  }
  // What is asked at another instant is decided by values at that instant.
  void move_from(std::size_t first, const At& at) {
    for (std::size_t k = first; k < deciding.size(); ++k) {
      At moved = at;
      moved.expression = deciding[k];
      const Mark mark = deciding[k].mark();
      deciding[k] = built(std::move(moved), mark);
    }
  }
  static Expression called(const char* function, std::vector<Argument> arguments, const Mark& mark) {
    return built(Call{function, std::move(arguments)}, mark);
  }
  void add(const char* function, std::vector<Argument> arguments) {
    const Mark mark = arguments.front().value.mark();
    deciding.push_back(called(function, std::move(arguments), mark));
  }

  const Situation& situation_;
  int depth_ = 0;
};

}  // namespace

WatchedValue watched_value(const Statement& statement, Sample& sample, const Ask& ask) {
  WatchedValue result{asked_value(sample, ask), {}};
  const Watch watch(statement.situations.front(), ask);
  for (const Expression& expression : watch.deciding) {
    Ask one;
    one.of = {expression};
    one.axes = ask.axes;
    one.mark = ask.mark;
    try {
      result.deciding.push_back(asked_value(sample, one));
    } catch (const StatementError&) {
      // The expression has no value here, which itself may decide the answer.
      result.deciding.push_back(Value<double>::of_text("none"));
    }
  }
  return result;
}

}  // namespace poinsot::problem
