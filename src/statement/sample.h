// The instants of a statement, solved for one choice of everything that it leaves open.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "statement/instant.h"
#include "statement/reader.h"

namespace poinsot::statement {

// Whether an expression asks anything of the model: a quantity function, a coordinate or an unknown, also by define:.
// What stands before an @ counts only if `into_at`.
inline bool asks_model(const Problem& problem, const Expression& expression, bool into_at = true, int depth = 0) {
  std::set<std::string> functions;
  collect_functions(expression, functions, into_at);
  for (const FunctionForm& form : quantity_functions())
    if (functions.contains(form.name)) return true;
  std::set<std::string> names;
  collect_names(expression, names, into_at);
  for (const std::string& name : names) {
    if (std::any_of(problem.find.begin(), problem.find.end(),
                    [&](const Unknown& unknown) { return unknown.name == name; }))
      return true;
    if (std::any_of(problem.choose.begin(), problem.choose.end(),
                    [&](const Choice& choice) { return choice.name == name; }))
      return true;
    // A point that rides with a body: A of plate.
    if (std::any_of(problem.bodies.begin(), problem.bodies.end(), [&](const Body& body) { return body.name == name; }))
      return true;
    for (const Joint& joint : problem.joints)
      for (const Freedom& freedom : joint.freedoms)
        if (freedom.position && freedom.position->as<Name>() && freedom.position->as<Name>()->name == name) return true;
    for (const NamedExpression& item : problem.define)
      if (item.name == name && depth < 50 && asks_model(problem, item.value, into_at, depth + 1)) return true;
  }
  return false;
}

// What has a value from outside the file or is found, in each situation.
using AllSettings = std::vector<Settings>;

// The situation that an extremum is sought in. Throws StatementError if it is not named or not known.
std::size_t situation_of(const Statement& statement, const Ask& ask);

// One choice of everything that the statement leaves open, and the instants solved for it so far.
class Sample {
 public:
  Sample(const Statement& statement, AllSettings settings, const OpenChoice& choice)
      : statement_(statement), settings_(std::move(settings)), choice_(choice) {}

  Value<double> value(const Ask& ask) {
    std::vector<Value<double>> items;
    for (const Expression& expression : ask.of)
      items.push_back(value_at(home(expression, ask.mark), expression, ask.axes));
    return ask.is_list ? Value<double>::of_list(std::move(items)) : items.front();
  }
  // At the instant of a situation at which it is meant.
  Value<double> value_in(std::size_t situation, const Expression& expression) {
    return value_at({situation, statement_.situations[situation].problem.has_blow() ? 1u : 0u}, expression,
                    std::nullopt);
  }
  const std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<SolvedInstant>>& instants() const {
    return instants_;
  }
  SolvedInstant& instant_of(const Ask& ask) {
    const auto [situation, stage] = home_of(ask);
    return instant(situation, stage);
  }
  const Problem& problem_of(const Ask& ask) { return statement_.situations[home_of(ask).first].problem; }

  // Where something is asked: the situation, and its instant as a number (see when()).
  using Home = std::pair<std::size_t, std::size_t>;
  static When when(const Problem& problem, std::size_t instant) {
    return problem.has_blow() ? When{0, instant == 1} : When{instant, false};
  }

  // What a name after @ means.
  Home resolve(const std::string& name, const Mark& mark) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      const Situation& situation = statement_.situations[i];
      if (situation.name == name && !name.empty()) return {i, situation.problem.has_blow() ? 1u : 0u};
      if (!situation.name.empty()) known.push_back(situation.name);
      const bool only = statement_.situations.size() == 1;
      if (situation.problem.has_blow()) {
        const std::string prefix = only ? "" : situation.name + ".";
        if (name == prefix + "before") return {i, 0};
        if (name == prefix + "after") return {i, 1};
        known.push_back(prefix + "before");
        known.push_back(prefix + "after");
      }
      for (std::size_t k = 0; k < situation.problem.stages.size(); ++k) {
        const std::string& stage = situation.problem.stages[k].name;
        const std::string prefix = only ? "" : situation.name + ".";
        if (name == prefix + stage || name == prefix + stage + ".start") return {i, k};
        if (name == prefix + stage + ".end" && k + 1 < situation.problem.stages.size()) return {i, k + 1};
        known.push_back(prefix + stage);
      }
      if (situation.problem.stages.empty() && only && !situation.problem.has_blow())
        for (const Instant& instant : situation.problem.instants) {
          if (instant.name == name) return {i, 0};
          known.push_back(instant.name);
        }
    }
    std::string all;
    for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
    const std::string hint = did_you_mean(name, known);
    fail(statement_.file, mark, "there is no instant, stage or situation '" + name + "'",
         !hint.empty() ? hint
         : all.empty() ? ""
                       : "known: " + all);
  }

 private:
  Value<double> value_at(const Home& place, const Expression& expression, const std::optional<Expression>& axes) {
    return instant(place.first, place.second).ask(expression, axes, [&](const At& at, const Mark& mark) {
      const auto [other, other_stage] = resolve(at.instant, mark);
      return instant(other, other_stage).raw(at.expression, axes, nullptr);
    });
  }
  Home home_of(const Ask& ask) const {
    if (!ask.extremum) return home(ask.of.front(), ask.mark);
    const std::size_t situation = situation_of(statement_, ask);
    return {situation, statement_.situations[situation].problem.has_blow() ? 1u : 0u};
  }
  // Where what stands without @ is meant: in the only situation and stage there is, after a blow if there is one. An
  // expression all of whose quantities have an @ is at home at the first of these.
  Home home(const Expression& expression, const Mark& mark) const {
    const bool one = statement_.situations.size() == 1 && statement_.situations.front().problem.stages.size() <= 1;
    if (const At* at = first_at(expression); at && !one) {
      if (asks_model(statement_.situations.front().problem, expression, false))
        fail(statement_.file, mark, "a part of this stands without @: when is it meant?",
             "write @ " + at->instant + " or another instant behind every quantity");
      return resolve(at->instant, at->instant_mark);
    }
    if (statement_.situations.size() > 1 && !asks_instant(expression) && !asks_own_unknown(expression))
      return {0, statement_.situations.front().problem.has_blow() ? 1u : 0u};
    if (statement_.situations.size() > 1) {
      std::string names;
      for (const Situation& situation : statement_.situations) names += (names.empty() ? "" : ", ") + situation.name;
      fail(statement_.file, mark, "in which situation is this asked?",
           "write " + to_string(expression) + " @ one of " + names);
    }
    const auto& stages = statement_.situations.front().problem.stages;
    if (stages.size() > 1) {
      std::string names;
      for (const Stage& stage : stages) names += (names.empty() ? "" : ", ") + stage.name;
      fail(statement_.file, mark, "in which stage is this asked?",
           "write " + to_string(expression) + " @ one of " + names);
    }
    return {0, statement_.situations.front().problem.has_blow() ? 1u : 0u};
  }

  // Whether an expression names a quantity of the model and not only unknowns.
  bool asks_instant(const Expression& expression) const {
    Problem bare = statement_.situations.front().problem;
    bare.find.clear();
    bare.choose.clear();
    return asks_model(bare, expression);
  }

  bool asks_own_unknown(const Expression& expression) const {
    std::set<std::string> names;
    collect_names(expression, names, false);
    for (const Situation& situation : statement_.situations)
      for (const std::string& name : situation.own_unknowns)
        if (names.contains(name)) return true;
    return false;
  }

  struct AtFinder {
    const At* operator()(const At& at) const { return &at; }
    const At* operator()(const Member& member) const { return first_at(member.object); }
    const At* operator()(const Unary& unary) const { return first_at(unary.operand); }
    const At* operator()(const Binary& binary) const {
      const At* left = first_at(binary.left);
      return left ? left : first_at(binary.right);
    }
    const At* operator()(const Call& call) const {
      for (const Argument& argument : call.arguments)
        if (const At* at = first_at(argument.value)) return at;
      return nullptr;
    }
    const At* operator()(const List& list) const { return in(list.items); }
    const At* operator()(const Comparison& comparison) const { return in(comparison.operands); }
    template <class Other>
    const At* operator()(const Other&) const {
      return nullptr;
    }
    static const At* in(const std::vector<Expression>& items) {
      for (const Expression& item : items)
        if (const At* at = first_at(item)) return at;
      return nullptr;
    }
  };
  static const At* first_at(const Expression& expression) { return std::visit(AtFinder{}, expression->content); }

  SolvedInstant& instant(std::size_t situation, std::size_t stage) {
    auto& found = instants_[{situation, stage}];
    if (!found)
      found = std::make_unique<SolvedInstant>(statement_.situations[situation].problem, settings_[situation],
                                              when(statement_.situations[situation].problem, stage), choice_);
    return *found;
  }

  const Statement& statement_;
  AllSettings settings_;
  OpenChoice choice_;
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<SolvedInstant>> instants_;
};

}  // namespace poinsot::statement
