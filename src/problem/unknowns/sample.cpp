#include "problem/unknowns/sample.h"

#include <algorithm>
#include <set>

#include "problem/instant/contact_state_search.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/quantities/asks_model.h"

namespace poinsot::problem {

SolvedInstant& Sample::instant(const Home& home) {
  if (const auto known = instants_.find(home); known != instants_.end()) return *known->second;
  std::unique_ptr<SolvedInstant> found;
  const Situation& situation = statement_.situations[home.situation];
  const Settings& settings = settings_[home.situation];
  const auto in_motion = [&](auto&& state_in) {
    Course& moving = motion(home.situation);
    const MotionState state = state_in(moving);
    found = std::make_unique<SolvedInstant>(moving.situation_of(state), settings, state, choice_);
  };
  const std::size_t stage = home.instant - (situation.has_blow() && home.instant > 0 ? 1 : 0);
  if (home.ending)
    in_motion([&](Course& moving) { return moving.end_of(home.instant); });
  else if (home.time)
    in_motion([&](Course& moving) { return moving.at(*home.time); });
  else if (stage > 0)
    in_motion([&](Course& moving) { return moving.at(moving.stage_start(stage)); });
  else
    found = std::make_unique<SolvedInstant>(situation, settings, When{0, situation.has_blow() && home.instant == 1},
                                            choice_);
  if (writes_told_) found->write_down_what_is_told();
  return *(instants_[home] = std::move(found));
}

Course& Sample::motion(std::size_t situation_index) {
  const auto known = motions_.find(situation_index);
  if (known != motions_.end()) return *known->second;
  auto motion =
      std::make_unique<Course>(statement_.situations[situation_index], settings_[situation_index], choice_, true);
  return *(motions_[situation_index] = std::move(motion));
}

Value<double> Sample::value_at(const Home& place, const Expression& expression, const std::optional<Expression>& axes) {
  SolvedInstant& here = instant(place);
  const auto elsewhere = [&](const At& at, const Mark& mark) {
    const Home other = resolve(at, mark);
    SolvedInstant& there = instant(other);
    return there.raw(at.expression, axes, nullptr, features_in(other, at.expression, axes));
  };
  return here.ask(expression, axes, elsewhere, features_in(place, expression, axes));
}

MotionFeatureValues Sample::features_in(const Home& place, const Expression& expression,
                                        const std::optional<Expression>& axes) {
  // A situation is followed in time only where something is asked of its motion.
  if (motion_features_in(statement_.situations[place.situation], expression).empty()) return {};
  return motion(place.situation).features_in({expression}, axes);
}

Sample::Home Sample::resolve(const At& at, const Mark& mark) {
  std::vector<std::string> known;
  const bool only = statement_.situations.size() == 1, is_time = at.when.as<Number>() != nullptr;
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Situation& situation = statement_.situations[i];
    if (situation.name == at.instant && !situation.name.empty()) return start_of(i);
    if (!situation.name.empty()) known.push_back(situation.name);
    const std::span<const std::string> names(at.names);
    const bool of_this =
        names.size() > (is_time ? 0U : 1U) && !situation.name.empty() && names.front() == situation.name;
    if (!only && !of_this) continue;
    if (const auto found = resolve_in(i, at, of_this ? names.subspan(1) : names, mark, known)) return *found;
  }
  if (is_time && at.names.empty())
    fail(statement_.file, mark, "in which situation is it " + at.instant + "?",
         "write @ " + at.instant + " @ one of " + joined(names_of(statement_.situations)));
  const std::string all = joined(known);
  const std::string hint = did_you_mean(at.instant, known);
  fail(statement_.file, mark, "there is no instant, stage or situation '" + at.instant + "'",
       !hint.empty() ? hint
       : all.empty() ? ""
                     : "known: " + all);
}

std::optional<Sample::Home> Sample::resolve_in(std::size_t i, const At& at, std::span<const std::string> names,
                                               const Mark& mark, std::vector<std::string>& known) {
  const Situation& situation = statement_.situations[i];
  const std::string prefix = statement_.situations.size() == 1 ? "" : situation.name + ".";
  const std::string name = joined({names.begin(), names.end()}, ".");
  const auto is = [&](const std::string& first) { return names.size() == 1 && names[0] == first; };
  const auto is_dotted = [&](const std::string& first, const char* second) {
    return names.size() == 2 && names[0] == first && names[1] == second;
  };
  if (situation.has_blow()) {
    if (is("before")) return Home{i, 0, std::nullopt};
    if (is("after")) return Home{i, 1, std::nullopt};
    known.push_back(prefix + "before");
    known.push_back(prefix + "after");
  }
  for (std::size_t k = 0; k < situation.stages.size(); ++k) {
    const std::string& stage = situation.stages[k].name;
    if (is(stage) || is_dotted(stage, "start")) return Home{i, k + (situation.has_blow() ? 1 : 0), std::nullopt};
    if (is_dotted(stage, "end")) {
      if (const std::optional<double> end = motion(i).stage_end(k)) return Home{i, k, end, true};
      fail(situation.file, mark, "stage '" + stage + "' has no end", "write lasts: or until:");
    }
    known.push_back(prefix + stage);
  }
  DataScope<double> data(situation, settings_[i]);
  if (at.when.as<Number>() && !names.empty()) return std::nullopt;
  if (at.when.as<Number>()) return Home{i, 0, data.number(at.when, dimensions::time)};
  for (const Instant& instant : situation.instants) {
    if (instant.name != name) {
      if (!situation.has_blow()) known.push_back(prefix + instant.name);
      continue;
    }
    if (instant.found_when)
      return Home{i, 0, motion(i).times(*instant.found_when, std::nullopt, 0, std::nullopt).front()};
    if (!is_later(situation, instant)) return start_of(i);
  }
  if (is("start")) return start_of(i);
  if (names.size() == 1 && data.knows(names[0])) {
    const Value<double> value = data.value(at.when);
    if (value.is_number() && same_kind(value.dimension, dimensions::time)) return Home{i, 0, value.number};
  }
  return std::nullopt;
}

Sample::Home Sample::home(const Expression& expression, const Mark& mark) {
  const bool one = statement_.situations.size() == 1 && statement_.situations.front().stages.size() <= 1;
  if (const At* at = first_at(expression)) {
    const bool elsewhere = !asks_model(statement_.situations.front(), expression, false);
    if (elsewhere) return resolve(*at, at->instant_mark);
    // What stands without @ is meant where everything begins: with what comes later it would make no sense.
    if (!one || at->when.as<Number>() || resolve(*at, at->instant_mark).time)
      fail(statement_.file, mark, "a part of this stands without @: when is it meant?",
           "write @ " + at->instant + " or another instant behind every quantity, or behind the whole in parentheses");
  }
  if (statement_.situations.size() > 1 && !asks_instant(expression) && !asks_own_unknown(expression))
    return start_of(0);
  if (statement_.situations.size() > 1) {
    fail(statement_.file, mark, "in which situation is this asked?",
         "write " + to_string(expression) + " @ one of " + joined(names_of(statement_.situations)));
  }
  const auto& stages = statement_.situations.front().stages;
  if (stages.size() > 1 && !statement_.situations.front().has_blow() && !asks_motion_feature(expression) &&
      asks_instant(expression)) {
    fail(statement_.file, mark, "in which stage is this asked?",
         "write " + to_string(expression) + " @ one of " + joined(names_of(stages)));
  }
  return start_of(0);
}

// Whether an expression asks for a quantity of the model, and not for unknowns only.
bool Sample::asks_instant(const Expression& expression) const {
  Situation bare = statement_.situations.front();
  bare.find.clear();
  bare.choose.clear();
  return asks_model(bare, expression);
}

bool Sample::asks_own_unknown(const Expression& expression) const {
  std::set<std::string> names;
  collect_names(expression, names, false);
  for (const Situation& situation : statement_.situations)
    for (const std::string& name : situation.own_unknowns)
      if (names.contains(name)) return true;
  return false;
}

bool Sample::contact_states_hold() {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    // In a blow they were found by impulses.
    if (!statement_.situations[i].has_friction() || statement_.situations[i].has_blow()) continue;
    SolvedInstant& start = instant(start_of(i));
    start.solve_forces();
    if (!start.one_sided_faults().empty() || !leaves_limits(statement_.situations[i], settings_[i])) return false;
  }
  return true;
}

void Sample::hold_forces_at_starts() {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Situation& situation = statement_.situations[i];
    if (situation.has_blow() || !situation.neglect.empty()) continue;
    const std::vector<const Instant*> starts = instants_at_start(situation);
    const bool stated = std::ranges::any_of(starts, [&](const Instant* start) {
      return std::ranges::any_of(start->facts, [&](const Fact& fact) {
        return level_of(situation, fact.quantity) == Level::force && !is_any(fact.value);
      });
    });
    if (!stated) continue;
    try {
      instant(start_of(i)).solve_forces();
    } catch (const UnansweredError&) {
      // What has no forces has none that could contradict.
    }
  }
}

// An expression that asks for nothing of the model has the same value in every situation.
Situated Sample::situated_in(const Expression& expression, std::size_t otherwise) const {
  if (!asks_model(statement_.situations[otherwise], expression)) return {otherwise, expression};
  return situated(statement_, expression);
}

Sample::Home Sample::home_of(const Ask& ask) {
  if (ask.when) return start_of(situated(statement_, ask.when->condition).situation);
  if (ask.table) {
    // What happens in the rows need not happen at the value that the datum has here.
    const std::vector<std::string> data = settable_names(statement_.situations.front());
    if (std::ranges::find(data, ask.table->over) != data.end())
      return start_of(situated_in(ask.table->columns.front().value, 0).situation);
    for (const NamedExpression& column : ask.table->columns)
      if (const std::size_t situation_index = situated_in(column.value, 0).situation; situation_index > 0)
        return start_of(situation_index);
    return start_of(0);
  }
  if (ask.extremum) return start_of(situation_of(statement_, ask));
  return home(ask.of.front(), ask.mark);
}

}  // namespace poinsot::problem
