// Holds laws that were found near some values of the letters against numbers far from these.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/scaling_trials.h"

namespace poinsot::problem {

// What an answer is said to be: a law, or the same number whatever the letters are.
struct HeldLaw {
  std::size_t answer = 0;  // its place among the answers of the trials
  Value<Formula> law;
};

struct LawReach {
  std::optional<Formula> positive;    // wherever the law holds, and nowhere else: 4*g - L*w^2
  std::optional<LetterValues> fails;  // where it does not hold
  // A letter that the law leaves out though there was no answer where it is much larger or smaller: it may matter
  // there.
  std::string untried{};
};

// Solves the problem at letters far from the base: each a hundred times larger and smaller, of the other sign, and all
// together over six decades. Where a law fails it looks for the condition under which it holds: a group of letters
// without dimension that is on one side of a bound wherever the law holds and on the other wherever it fails, or the
// sign of a letter. The bound is closed in and the condition tried at other letters. misfit: the largest relative
// difference where the laws hold. most: the work that this may take; each: that one point may, others are left out.
// A letter that a law leaves out is tried in any case, since near the base it may matter less than the answers are
// exact. is_beyond: whether the problem is none of those of which laws are told, so that they need not hold there.
// by_dimensions: whether dimensions alone tell all laws, and the letters make no group; two points are enough then.
std::vector<LawReach> reach_of(const std::vector<HeldLaw>& laws, const std::vector<Letter>& letters,
                               const LetterValues& base, const ScalingTrials::Solve& solve, double tolerance, Work most,
                               const std::function<bool(const LetterValues&)>& is_beyond, bool by_dimensions, Work each,
                               double& misfit);

}  // namespace poinsot::problem
