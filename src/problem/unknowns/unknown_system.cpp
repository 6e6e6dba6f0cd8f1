#include "problem/unknowns/unknown_system.h"

#include <algorithm>

#include "problem/language/expression_walk.h"
#include "problem/language/words.h"
#include "problem/plane/planar_words.h"

namespace poinsot::problem {

std::vector<std::size_t> UnknownSystem::situations() const {
  std::vector<std::size_t> list;
  for (const ConditionGroup& group : groups) add_once(list, group.situation);
  return list;
}

bool UnknownSystem::has(const ConditionGroup& group) const {
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

bool UnknownSystem::seeks(const std::string& name) const {
  return std::any_of(unknowns.begin(), unknowns.end(), [&](const Unknown& u) { return u.name == name; });
}

std::vector<UnknownSlot> UnknownSystem::slots(const Statement& statement) const {
  std::vector<UnknownSlot> list;
  for (const Unknown& unknown : unknowns)
    for (const std::size_t k : sought_components(unknown, statement.situations.front().plane))
      list.push_back({unknown, k});
  return list;
}

bool UnknownSystem::operator==(const UnknownSystem& other) const {
  return groups == other.groups && std::ranges::equal(unknowns, other.unknowns, {}, &Unknown::name, &Unknown::name);
}

Aspect aspect_of(const Situation& situation, const Instant& instant, const Fact& fact) {
  const Level level = level_of(situation, fact.quantity);
  if (level == Level::motion || is_later(situation, instant)) return Aspect::later;
  return level == Level::force ? Aspect::forces : level == Level::velocity ? Aspect::velocities : Aspect::positions;
}

// Whether a joint states its acceleration beside what drives it, which no motor makes true: a condition like a fact.
static bool tests_acceleration(const Joint& joint) {
  return std::ranges::any_of(joint.freedoms, [](const Freedom& freedom) {
    return freedom.accel && (freedom.effort || freedom.stiffness || freedom.damping);
  });
}

std::vector<ConditionGroup> groups_of(const Statement& statement, std::size_t situation_index) {
  const Situation& situation = statement.situations[situation_index];
  bool positions = false,
       forces = situation.steady.has_value() || std::ranges::any_of(situation.joints, tests_acceleration);
  for (const Instant& instant : situation.instants)
    for (const Fact& fact : instant.facts) {
      const Aspect aspect = aspect_of(situation, instant, fact);
      positions = positions || (aspect == Aspect::positions && !fact.quantity.as<Name>());
      forces = forces || aspect == Aspect::forces;
    }
  std::vector<ConditionGroup> groups;
  if (positions) groups.push_back({situation_index, Aspect::positions});
  groups.push_back({situation_index, Aspect::velocities});
  if (forces) groups.push_back({situation_index, Aspect::forces});
  if (has_later_facts(situation)) groups.push_back({situation_index, Aspect::later});
  return groups;
}

bool is_own(const Statement& statement, std::size_t situation_index, const std::string& name) {
  const auto& own = statement.situations[situation_index].own_unknowns;
  return std::find(own.begin(), own.end(), name) != own.end();
}

bool is_common(const Statement& statement, const std::string& name) {
  for (std::size_t i = 0; i < statement.situations.size(); ++i)
    if (is_own(statement, i, name)) return false;
  return true;
}

std::set<std::string> unknowns_of_amount(const Statement& statement, const std::string& name) {
  std::set<std::string> names;
  const auto collect = [&](const std::optional<Expression>& expression) {
    if (expression) collect_names(*expression, names);
  };
  for (const Situation& situation : statement.situations) {
    for (const Impulse& impulse : situation.impulses)
      if (impulse.name == name)
        for (const auto* expression : {&impulse.value, &impulse.force, &impulse.lasts, &impulse.couple})
          collect(*expression);
    for_each_stated_law(situation, [&](const auto& law) {
      if (law.name != name) return;
      law.for_each_part([&](LawPart part, const std::optional<Expression>& expression) {
        if (part == LawPart::effort) collect(expression);
      });
    });
    for (const Body& body : situation.bodies)
      for (const Part& part : body.added)
        if (part.name == name) {
          collect(part.amount.mass);
          collect(part.amount.weight);
        }
  }
  return names;
}

std::string conditions_in_words(const Statement& statement, const UnknownSystem& system) {
  std::vector<std::string> words;
  const bool several = statement.situations.size() > 1;
  for (const ConditionGroup& group : system.groups) {
    const Situation& situation = statement.situations[group.situation];
    const std::string where = several ? " @ " + situation.name : "";
    for (const Instant& instant : situation.instants) {
      if (instant.rest && group.aspect == Aspect::velocities) add_once(words, "rest at '" + instant.name + "'" + where);
      for (const Fact& fact : instant.facts)
        if (group.aspect == aspect_of(situation, instant, fact) &&
            (group.aspect != Aspect::positions || !fact.quantity.as<Name>()))
          add_once(words, to_string(fact.quantity) + " at '" + instant.name + "'" + where);
    }
    for (const Joint& joint : situation.joints)
      if (group.aspect == Aspect::forces && tests_acceleration(joint))
        add_once(words, "accel of joint '" + joint.name + "'" + where);
    if (situation.steady && (group.aspect == Aspect::velocities || group.aspect == Aspect::forces))
      add_once(words, "steady motion in '" + situation.steady->frame + "'" + where);
  }
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < 8; ++i) text += (i == 0 ? "" : "; ") + words[i];
  return text + (words.size() > 8 ? "; ..." : "");
}

}  // namespace poinsot::problem
