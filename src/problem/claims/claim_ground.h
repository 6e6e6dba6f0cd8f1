// What the claims about one situation share: the statement solved at some values of the letters, and as formulas.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/claims/claim_faults.h"
#include "problem/claims/claim_instant.h"
#include "problem/claims/claim_points.h"
#include "problem/claims/claim_verdict.h"

namespace poinsot::problem {

inline constexpr int most_solved_points = 40;  // at which a claim is tried where each is a statement solved by numbers

class ClaimGround {
 public:
  // settings: values of letters, data and unknowns; exact: those that have one as formulas; unknowns: those that follow
  // letters without value. All must outlive it.
  ClaimGround(const Situation& situation, const Settings& settings, const FormulaValues& exact,
              const FormulaValues& unknowns);

  const Situation& situation() const { return situation_; }
  const std::vector<Letter>& letters() const { return letters_; }  // without value
  const Point& base_point() const { return base_point_; }
  // With what is known at a point. Throws StatementError where an unknown has no value there.
  Settings with_letters(const Point& point) const;
  const FormulaValues& unknowns() const { return unknowns_; }
  // Whether squares of unknowns are left out: then a claim is one of formulas alone, as the numbers keep these squares.
  bool neglects() const { return !situation_.neglect.empty(); }

  // Nothing where it has none: why not. all_poses: see ClaimFormulas.
  ClaimFormulas* formulas(bool all_poses);

  // The statement solved by numbers at the base point; after formulas().
  SolvedInstant& base() { return *base_; }

  // A claim and its assumptions in the statement solved by numbers at a point, in the state that formulas have there;
  // nothing where it cannot be solved.
  std::optional<Verdict> verdict_at(const Claim& claim, const ClaimFormulas& formulas, const Point& point);
  // Why it could not, so far.
  const ClaimFaults& faults() const { return faults_; }

 private:
  void find_base();

  const Situation& situation_;
  const Settings& settings_;
  const FormulaValues& exact_;
  const FormulaValues& unknowns_;
  std::vector<Letter> letters_;
  FormulaValues values_;
  Point base_point_;
  ClaimFaults faults_;
  std::list<Settings> bases_;
  std::unique_ptr<SolvedInstant> base_;
  struct Road {
    bool tried = false;
    std::unique_ptr<ClaimFormulas> formulas;
  };
  Road drawn_, along_;
};

// Contacts and cords that a claim on forces or accelerations takes to hold, in words; none where it is about that.
std::vector<std::string> assumed_holds(const Situation& situation, const Claim& claim);

}  // namespace poinsot::problem
