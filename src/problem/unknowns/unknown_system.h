// A system of unknowns that are sought together and of the conditions on them.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// What conditions are about. Those of one aspect are evaluated together: positions, velocities or forces of a
// situation, or the motion that follows.
enum class Aspect { positions, velocities, forces, later };

struct ConditionGroup {
  std::size_t situation = 0;
  Aspect aspect = Aspect::velocities;
  bool operator==(const ConditionGroup&) const = default;
};

// One number that is sought: an unknown or a component of one.
struct UnknownSlot {
  Unknown unknown;
  std::size_t component;
};

struct UnknownSystem {
  std::vector<Unknown> unknowns;
  std::vector<ConditionGroup> groups;

  std::vector<std::size_t> situations() const;
  bool has(const ConditionGroup& group) const;
  bool seeks(const std::string& name) const;
  std::vector<UnknownSlot> slots(const Statement& statement) const;
  bool operator==(const UnknownSystem& other) const;  // whether unknowns and groups are the same, in the same order
};

// The groups of conditions that a situation has.
std::vector<ConditionGroup> groups_of(const Statement& statement, std::size_t situation);
Aspect aspect_of(const Situation& situation, const Instant& instant, const Fact& fact);

// Whether an unknown has one value for all situations; whether it belongs to one situation.
bool is_common(const Statement& statement, const std::string& name);
bool is_own(const Statement& statement, std::size_t situation, const std::string& name);

// The unknowns in the data of an impulse, a load or an added mass.
std::set<std::string> unknowns_of_amount(const Statement& statement, const std::string& name);

// The conditions that the author has stated for the unknowns.
std::string conditions_in_words(const Statement& statement, const UnknownSystem& system);

}  // namespace poinsot::problem
