// Finds the values of the unknowns under `find:` from the conditions on them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/unknowns/unknown_equations.h"

namespace poinsot::problem {

// An unknown that the conditions leave open, and the situation whose own it is; none if it is common to all.
struct OpenUnknown {
  std::string name;
  std::optional<std::size_t> situation;
  bool operator==(const OpenUnknown&) const = default;
};

struct RootsFound {
  std::vector<AllSettings> roots;
  std::vector<OpenUnknown> open;
  std::vector<std::string> warnings;
  std::optional<AllSettings> alternative;  // another solution, if some unknowns are open
  // How far the roots are from those to which a scan comes, the largest, as a part of themselves, where there was one.
  std::optional<double> off_by_scan;
};

class UnknownSearch {
 public:
  static constexpr Work most_work = 8'000'000'000;  // of one search, all its parts together

  // statement must outlive the search; `settings` are values from outside the file, which are not sought. most: how
  // much work find() may do.
  UnknownSearch(const Statement& statement, const Settings& settings, Work most = most_work);

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  // Whether an unknown has one value for all situations.
  bool is_common(const std::string& name) const { return problem::is_common(statement_, name); }
  bool is_own(std::size_t situation, const std::string& name) const {
    return problem::is_own(statement_, situation, name);
  }

  // All values of the unknowns that satisfy the conditions, for given values of everything else. The unknowns common
  // to all situations come first, from the situations that have none of their own, and then those of each situation.
  // `choice` says how to take what the statement leaves open. The warnings tell what was left out when the time was
  // over.
  RootsFound find(const Settings& settings, const OpenChoice& choice = {});
  // The same, confirmed by a scan: for what is shown, not for what is only compared with it.
  RootsFound find_confirmed(const Settings& settings);

  // Whether a solution of find() still satisfies the conditions with another choice of what is left open.
  bool still_holds(const AllSettings& root, const OpenChoice& choice);

 private:
  // The same where cords and contacts give way in a blow as choice_ says.
  RootsFound find_as_they_give_way(const Settings& settings);
  // Whether they do so with these values.
  bool gives_way_so(const AllSettings& root) const;
  // The systems that are solved one after the other: that of the common unknowns, then that of each situation.
  std::vector<UnknownSystem> systems() const;
  // Continues every solution so far by another search.
  template <class Find>
  void refine(RootsFound& all, const Find& find) const;
  RootsFound find_with_choices(const UnknownSystem& system, const AllSettings& settings);
  RootsFound find_chosen(const UnknownSystem& system, const AllSettings& settings, const Choice& choice);
  // zero: the part of the size of the terms below which the conditions hold.
  RootsFound find_subset(const UnknownSystem& system, const AllSettings& settings, const Choice& choice,
                         std::size_t subset, double zero);
  // All choices of some of the amounts with which the conditions hold to such a part.
  RootsFound find_subsets(const UnknownSystem& system, const AllSettings& settings, const Choice& choice, double zero);
  void open_a_tie(UnknownEquations& equations, const Choice& choice, RootsFound& all) const;
  // Explains why no choice has a solution.
  std::string nothing_chosen(const UnknownSystem& system, const AllSettings& settings, const Choice& choice) const;
  double total_of(const Choice& choice, const AllSettings& settings) const;
  RootsFound find_by_blocks(const UnknownSystem& system, const AllSettings& settings);
  // explained: whether a warning says why nothing is found.
  // zero: if it is not the usual one, the part of the size of the terms below which the conditions hold.
  RootsFound find_block(const UnknownSystem& system, const AllSettings& settings, bool explained = true,
                        std::optional<double> zero = {});
  RootsFound find_block(UnknownEquations& equations, bool explained = true, std::optional<double> zero = {});
  bool confirmed_where_nothing_was_found(const UnknownEquations& equations, const solve::Roots& result) const;
  std::optional<std::vector<double>> root_below_zero(UnknownEquations& equations, const solve::RootProblem& problem,
                                                     Work most) const;
  std::string nothing_found(UnknownEquations& equations, const solve::Roots& result, bool excluded,
                            const std::optional<std::vector<double>>& beyond) const;
  std::optional<StatementError> objection(const AllSettings& root) const;
  void leave_out_nonsense(RootsFound& found) const;
  UnknownEquations equations_of(const UnknownSystem& system, const AllSettings& settings) const;

  const Statement& statement_;
  std::vector<Unknown> unknowns_;
  std::set<std::string> known_;  // those given from outside the file
  OpenChoice choice_;
  bool confirming_ = false;
  Work most_;
  WorkLimit limit_;  // of the present find()
};

// Whether two solutions give the same values to the unknowns.
bool same_root(const AllSettings& a, const AllSettings& b, const std::vector<Unknown>& unknowns);

// Adds the findings of another search except its roots.
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

}  // namespace poinsot::problem
