// The values of what a statement asks for by `find:`, from its conditions.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "statement/unknown_equations.h"

namespace poinsot::statement {

struct RootsFound {
  std::vector<AllSettings> roots;
  std::vector<std::string> open, warnings;
  std::optional<AllSettings> alternative;  // another solution, where unknowns stay open
};

class UnknownSearch {
 public:
  // statement must outlive the search; `settings` are values from outside the file, which are not sought.
  UnknownSearch(const Statement& statement, const Settings& settings);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  // Whether an unknown has one value for all situations.
  bool is_common(const std::string& name) const { return statement::is_common(statement_, name); }
  bool is_own(std::size_t situation, const std::string& name) const {
    return statement::is_own(statement_, situation, name);
  }

  // All values of the unknowns that satisfy what is stated, with the given values of everything else. First the
  // unknowns common to all situations, from the situations that have none of their own, then those of each situation.
  // Everything that the statement leaves open is taken as `choice` says. Ends within a few seconds.
  RootsFound find(const Settings& settings, const OpenChoice& choice = {});

 private:
  // Every solution so far, refined by one more search.
  template <class Find>
  void refine(RootsFound& all, const Find& find) const;
  RootsFound find_with_choices(const UnknownSystem& system, const AllSettings& settings);
  RootsFound find_chosen(const UnknownSystem& system, const AllSettings& settings, const Choice& choice);
  RootsFound find_subset(const UnknownSystem& system, const AllSettings& settings, const Choice& choice,
                         std::size_t subset);
  double total_of(const Choice& choice, const AllSettings& settings) const;
  RootsFound find_by_blocks(const UnknownSystem& system, const AllSettings& settings);
  RootsFound find_block(const UnknownSystem& system, const AllSettings& settings);
  std::string nothing_found(UnknownEquations& equations, const solve::Roots& result, bool excluded) const;
  std::optional<StatementError> objection(const AllSettings& root) const;
  void leave_out_nonsense(RootsFound& found) const;
  UnknownEquations equations_of(const UnknownSystem& system, const AllSettings& settings) const;
  double seconds_left() const;

  const Statement& statement_;
  std::vector<Unknown> unknowns_;
  std::set<std::string> known_;  // given from outside
  OpenChoice choice_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

// Adds what another search found, but for its roots.
void merge(RootsFound& all, const RootsFound& more);

template <class Find>
void UnknownSearch::refine(RootsFound& all, const Find& find) const {
  std::vector<AllSettings> refined;
  for (const AllSettings& root : all.roots) {
    const RootsFound found = find(root);
    refined.insert(refined.end(), found.roots.begin(), found.roots.end());
    merge(all, found);
  }
  all.roots = std::move(refined);
}

}  // namespace poinsot::statement
