// The values of what a statement asks for by `find:`, from its conditions.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/solve/roots.h"
#include "statement/instant.h"
#include "statement/sample.h"

namespace poinsot::statement {

struct RootsFound {
  std::vector<AllSettings> roots;
  std::vector<std::string> open, warnings;
  std::optional<AllSettings> alternative;  // another solution, where unknowns stay open
};

// `where:` comparisons between one unknown and values narrow its range; slot_of tells which range is that of a name.
using SlotOf = std::function<std::optional<std::size_t>(const std::string& name)>;
void narrow_ranges(const Problem& problem, const Settings& settings, std::vector<solve::RootRange>& ranges,
                   const SlotOf& slot_of);

class UnknownSearch {
 public:
  // statement must outlive the search; `settings` are values from outside the file, which are not sought.
  UnknownSearch(const Statement& statement, const Settings& settings);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  // Whether an unknown has one value for all situations.
  bool is_common(const std::string& name) const;
  bool is_own(std::size_t situation, const std::string& name) const;

  // All values of the unknowns that satisfy what is stated, with the given values of everything else. First the
  // unknowns common to all situations, from the situations that have none of their own, then those of each situation.
  // Everything that the statement leaves open is taken as `choice` says.
  RootsFound find(const Settings& settings, const OpenChoice& choice = {});

 private:
  // Conditions that are evaluated together: those on the velocities of a situation, on its forces, and on the motion
  // that follows.
  enum class Aspect { velocities, forces, later };
  struct Group {
    std::size_t situation = 0;
    Aspect aspect = Aspect::velocities;
    bool operator==(const Group&) const = default;
  };
  // The unknowns of one search and the conditions that they must satisfy.
  struct Search {
    std::vector<Unknown> unknowns;
    std::vector<Group> groups;
  };
  // One number: an unknown or a component of one.
  struct Slot {
    const Unknown* unknown;
    std::size_t component;
  };
  struct Slots {
    std::vector<Slot> slots;
    std::vector<solve::RootRange> ranges;
  };

  std::vector<Group> groups_of(std::size_t situation) const;
  std::vector<std::size_t> situations_of(const Search& search) const;
  RootsFound find_with_choices(const Search& search, const AllSettings& settings);
  RootsFound find_subset(const Search& search, const AllSettings& settings, const Choice& choice, std::size_t subset);
  double total_of(const Choice& choice, const AllSettings& settings) const;
  std::size_t independent_conditions(const Search& search, const AllSettings& settings);
  RootsFound find_by_blocks(const Search& search, const AllSettings& settings);
  std::vector<Search> blocks_of(const Search& search, const AllSettings& settings);
  RootsFound find_block(const Search& search, const AllSettings& settings, bool negative_lengths);
  std::set<std::string> unknowns_of(const std::string& choice) const;
  Slots slots_of(const Search& search, const AllSettings& settings, bool negative_lengths) const;
  AllSettings settings_at(const Search& search, const Slots& slots, const AllSettings& settings,
                          const std::vector<double>& x) const;
  solve::RootProblem equations_of(const Search& search, const Slots& slots, const AllSettings& settings,
                                  RootsFound& found);
  solve::RootEquations misfits(const Search& search, const AllSettings& settings) const;
  Settings with_trial_values(const Settings& settings) const;
  std::string conditions_in_words(const Search& search) const;
  double seconds_left() const;

  const Statement& statement_;
  std::vector<Unknown> unknowns_;
  std::set<std::string> known_;  // given from outside
  OpenChoice choice_;
  std::optional<StatementError> refusal_;
  bool makes_sense_ = false;  // whether the equations had a value anywhere in the last search
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace poinsot::statement
