// The instants of a statement, solved for one choice of what it leaves open.
#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "problem/course/course.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/unknowns/situated.h"

namespace poinsot::problem {

// Whether an expression asks for anything of the model: a quantity, a coordinate or an unknown, possibly by a name
// under define:. What stands before an @ is looked at only if `into_at`.
inline bool asks_model(const Situation& situation, const Expression& expression, bool into_at = true, int depth = 0) {
  std::set<std::string> functions;
  collect_functions(expression, functions, into_at);
  for (const FunctionForm& form : quantity_functions())
    if (functions.contains(form.name)) return true;
  std::set<std::string> names;
  collect_names(expression, names, into_at);
  for (const std::string& name : names) {
    if (std::any_of(situation.find.begin(), situation.find.end(),
                    [&](const Unknown& unknown) { return unknown.name == name; }))
      return true;
    if (std::any_of(situation.choose.begin(), situation.choose.end(),
                    [&](const Choice& choice) { return choice.name == name; }))
      return true;
    // `A of plate` is a point that moves with a body.
    if (std::any_of(situation.bodies.begin(), situation.bodies.end(),
                    [&](const Body& body) { return body.name == name; }))
      return true;
    for (const Joint& joint : situation.joints)
      for (const Freedom& freedom : joint.freedoms)
        if (freedom.position && freedom.position->as<Name>() && freedom.position->as<Name>()->name == name) return true;
    for (const NamedExpression& item : situation.define)
      if (item.name == name && depth < 50 && asks_model(situation, item.value, into_at, depth + 1)) return true;
  }
  return false;
}

// For each situation the values that come from outside the file or were found.
using AllSettings = std::vector<Settings>;

// The situation in which an extremum is sought. Throws StatementError if it is not named or does not exist.
std::size_t situation_of(const Statement& statement, const Ask& ask);

// One choice of what the statement leaves open, and the instants solved for it so far.
class Sample {
 public:
  Sample(const Statement& statement, AllSettings settings, const OpenChoice& choice)
      : statement_(statement), settings_(std::move(settings)), choice_(choice) {}

  // The situation and the instant for which something is asked.
  struct Home {
    std::size_t situation = 0;
    std::size_t instant = 0;     // the stage whose beginning is meant; with a blow, 0 is before it and 1 after it
    std::optional<double> time;  // along the motion, s
    bool ending = false;         // the end of that stage, while its own loads still act
    bool operator<(const Home& other) const {
      return std::tie(situation, instant, time, ending) <
             std::tie(other.situation, other.instant, other.time, other.ending);
    }
  };

  Value<double> value(const Ask& ask) {
    std::vector<Value<double>> items;
    if (ask.table) return Value<double>::of_list(table(ask));
    if (ask.when) {
      for (double time : times(ask)) items.push_back(Value<double>::of_number(time, dimensions::time));
      return ask.when->first ? items.front() : Value<double>::of_list(std::move(items));
    }
    for (const Expression& expression : ask.of)
      items.push_back(value_at(home(expression, ask.mark), expression, ask.axes));
    return ask.is_list ? Value<double>::of_list(std::move(items)) : items.front();
  }
  // The value at the start of a situation, after its blow if it has one.
  Value<double> value_in(std::size_t situation_index, const Expression& expression) {
    return value_at(start_of(situation_index), expression, std::nullopt);
  }
  const std::map<Home, std::unique_ptr<SolvedInstant>>& instants() const { return instants_; }
  const std::map<std::size_t, std::unique_ptr<Course>>& motions() const { return motions_; }
  // The instant at some time of a motion.
  SolvedInstant& instant_at(std::size_t situation_index, double time) { return instant({situation_index, 0, time}); }
  SolvedInstant& instant_of(const Ask& ask) { return instant(home_of(ask)); }
  const Situation& situation_at(const Ask& ask) { return statement_.situations[home_of(ask).situation]; }

  // The situation and instant that a name after @ means.
  Home resolve(const std::string& name, const Mark& mark) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
      const Situation& situation = statement_.situations[i];
      if (situation.name == name && !name.empty()) return start_of(i);
      if (!situation.name.empty()) known.push_back(situation.name);
      const bool only = statement_.situations.size() == 1;
      const std::string prefix = only ? "" : situation.name + ".";
      if (!only && !name.starts_with(prefix)) continue;
      if (const auto found = resolve_in(i, only ? name : name.substr(prefix.size()), mark, known, prefix))
        return *found;
    }
    std::string all;
    for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
    const std::string hint = did_you_mean(name, known);
    fail(statement_.file, mark, "there is no instant, stage or situation '" + name + "'",
         !hint.empty() ? hint
         : all.empty() ? ""
                       : "known: " + all);
  }

  // The motion of a situation.
  Course& motion(std::size_t situation_index) {
    const auto known = motions_.find(situation_index);
    if (known != motions_.end()) return *known->second;
    auto motion = std::make_unique<Course>(statement_.situations[situation_index], settings_[situation_index], choice_);
    return *(motions_[situation_index] = std::move(motion));
  }

  // The instant that an expression without @ means: it exists if there is only one situation with at most one stage,
  // and is that after a blow if there is one. An expression each of whose quantities has an @ belongs to the first of
  // these instants.
  Home home(const Expression& expression, const Mark& mark) {
    const bool one = statement_.situations.size() == 1 && statement_.situations.front().stages.size() <= 1;
    const At* at = first_at(expression);
    const bool elsewhere = at && !asks_model(statement_.situations.front(), expression, false);
    const bool in_time = at && (std::isdigit(static_cast<unsigned char>(at->instant.front())) != 0);
    if (at && (elsewhere || !one || in_time)) {
      if (!elsewhere)
        fail(statement_.file, mark, "a part of this stands without @: when is it meant?",
             "write @ " + at->instant + " or another instant behind every quantity");
      return resolve(at->instant, at->instant_mark);
    }
    if (statement_.situations.size() > 1 && !asks_instant(expression) && !asks_own_unknown(expression))
      return start_of(0);
    if (statement_.situations.size() > 1) {
      std::string names;
      for (const Situation& situation : statement_.situations) names += (names.empty() ? "" : ", ") + situation.name;
      fail(statement_.file, mark, "in which situation is this asked?",
           "write " + to_string(expression) + " @ one of " + names);
    }
    const auto& stages = statement_.situations.front().stages;
    if (stages.size() > 1 && !statement_.situations.front().has_blow() && !asks_motion_feature(expression)) {
      std::string names;
      for (const Stage& stage : stages) names += (names.empty() ? "" : ", ") + stage.name;
      fail(statement_.file, mark, "in which stage is this asked?",
           "write " + to_string(expression) + " @ one of " + names);
    }
    return start_of(0);
  }
  SolvedInstant& instant(const Home& home);

  // The times that an ask is for; the table of an ask, one list for each column.
  std::vector<double> times(const Ask& ask);
  std::vector<Value<double>> table(const Ask& ask);
  // For tables over a datum, by ask: what is unphysical in the first row in which something is.
  const std::map<std::string, std::string>& unphysical_rows() const { return unphysical_rows_; }

 private:
  Value<double> value_at(const Home& place, const Expression& expression, const std::optional<Expression>& axes) {
    return instant(place).ask(expression, axes, [&](const At& at, const Mark& mark) {
      return instant(resolve(at.instant, mark)).raw(at.expression, axes, nullptr);
    });
  }
  // For a table, the first situation that it asks about.
  Home home_of(const Ask& ask);
  Situated situated_in(const Expression& expression, std::size_t otherwise) const;
  // The only instant, or the one just after the blow.
  Home start_of(std::size_t situation_index) const {
    return {situation_index, statement_.situations[situation_index].has_blow() ? 1u : 0u, std::nullopt};
  }
  void add_row_over_datum(const Ask& ask, const AllSettings& settings, std::vector<Value<double>>& values);
  void note_unphysical(const Ask& ask, const Value<double>& row);
  std::optional<Home> resolve_in(std::size_t i, const std::string& name, const Mark& mark,
                                 std::vector<std::string>& known, const std::string& prefix);
  // Whether an expression asks for a quantity of the model, and not for unknowns only.
  bool asks_instant(const Expression& expression) const {
    Situation bare = statement_.situations.front();
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

  const Statement& statement_;
  AllSettings settings_;
  OpenChoice choice_;
  std::map<Home, std::unique_ptr<SolvedInstant>> instants_;
  std::map<std::size_t, std::unique_ptr<Course>> motions_;
  std::map<std::string, std::string> unphysical_rows_;
};

}  // namespace poinsot::problem
