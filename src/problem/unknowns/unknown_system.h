// Unknowns that are sought together, and the conditions that they must satisfy.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// What conditions speak of. They are evaluated together: those on the positions of a situation, on its velocities, on
// its forces, and on the motion that follows.
enum class Aspect { positions, velocities, forces, later };

struct ConditionGroup {
  std::size_t situation = 0;
  Aspect aspect = Aspect::velocities;
  bool operator==(const ConditionGroup&) const = default;
};

// One number: an unknown or a component of one.
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
  std::vector<UnknownSlot> slots() const;
  bool operator==(const UnknownSystem& other) const;  // the same unknowns and groups in the same order
};

// The groups of conditions that a situation has.
std::vector<ConditionGroup> groups_of(const Statement& statement, std::size_t situation);
Aspect aspect_of(const Situation& situation, const Instant& instant, const Fact& fact);

// Whether an unknown has one value for all situations, or one of its own in a situation.
bool is_common(const Statement& statement, const std::string& name);
bool is_own(const Statement& statement, std::size_t situation, const std::string& name);

// The unknowns that stand in the data of an impulse, a load or an added mass.
std::set<std::string> unknowns_of_amount(const Statement& statement, const std::string& name);

// The names of unknowns, separated by commas.
std::string listed(const std::vector<Unknown>& unknowns);
// What the author states for the unknowns to satisfy.
std::string conditions_in_words(const Statement& statement, const UnknownSystem& system);

template <class Item>
void add_once(std::vector<Item>& list, const Item& item) {
  for (const Item& known : list)
    if (known == item) return;
  list.push_back(item);
}

}  // namespace poinsot::problem
