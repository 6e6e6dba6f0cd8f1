// What all claims about one situation share: its solution at some values of the letters, and its solution as
// formulas.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/claims/claim_faults.h"
#include "problem/claims/claim_instant.h"
#include "problem/claims/claim_verdict.h"
#include "problem/entries/drawn_letters.h"

namespace poinsot::problem {

// Whether contacts with friction are in the states in which the situation has them, whose claims are decided.
bool is_in_its_states(const Situation& situation, const Settings& settings, SolvedInstant& instant);

// What the bodies as particles say of a point: that its numbers are right, that they are wrong, or neither, where
// letters are so far apart that rounding hides it.
enum class Confirmation { confirmed, open, contradicted };

inline constexpr int most_solved_points = 40;  // at which a claim is tried where each is a statement solved by numbers

class ClaimGround {
 public:
  // settings: values of letters, data and unknowns. exact: those of them that have a formula. unknowns: formulas of
  // the unknowns in the letters without value. All must outlive this object.
  ClaimGround(const Situation& situation, const Settings& settings, const FormulaValues& exact,
              const FormulaValues& unknowns);

  const Situation& situation() const { return situation_; }
  const std::vector<Letter>& letters() const { return letters_; }  // those without value
  const DrawnSizes& sizes() const { return sizes_; }               // at which letters are drawn
  const Point& base_point() const { return base_point_; }
  // The settings, with the values that letters and unknowns have at a point. Throws StatementError where an unknown
  // has no value there.
  Settings with_letters(const Point& point) const;
  const FormulaValues& unknowns() const { return unknowns_; }
  // Whether squares of unknowns are neglected. A claim is then decided by formulas alone, as numbers include these
  // squares.
  bool neglects() const { return !situation_.neglect.empty(); }

  // The situation as formulas; nullptr if it has none. all_poses: see ClaimFormulas.
  ClaimFormulas* formulas(bool all_poses);

  // The situation solved by numbers at the base point. formulas() must be called before.
  SolvedInstant& base() { return *base_; }

  // Whether the claim and its assumptions hold for numbers at a point, in the state that the formulas have there;
  // nothing if the situation cannot be solved there.
  std::optional<Verdict> verdict_at(const Claim& claim, const ClaimFormulas& formulas, const Point& point);
  // Whether the bodies as particles confirm what the numbers of such a point say of the claim.
  Confirmation confirmed_at(const Claim& claim, const ClaimFormulas& formulas, const Point& point);
  // The faults at the points where it could not be solved so far.
  const ClaimFaults& faults() const { return faults_; }

 private:
  static MotionState state_at(const ClaimFormulas& formulas, const Point& point);
  bool is_at_end_of_states(const ClaimFormulas& formulas, const Point& point) const;
  void find_base();

  const Situation& situation_;
  const Settings& settings_;
  const FormulaValues& exact_;
  const FormulaValues& unknowns_;
  std::vector<Letter> letters_;
  DrawnSizes sizes_;
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

// The contacts and cords that a claim on forces or accelerations presumes to hold, in words. There are none if the
// claim is about that.
std::vector<std::string> assumed_holds(const Situation& situation, const Claim& claim);

}  // namespace poinsot::problem
