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
  bool of_event = false;                 // whether it is the time of an event, which happens where that is positive
  std::vector<std::size_t> at_events{};  // the places of the times of the events at which it is asked
};

struct LawReach {
  std::vector<Formula> positive;        // wherever the law holds: 4*g - L*w^2
  bool told = true;                     // whether it holds wherever all of these are positive
  std::optional<LetterValues> fails;    // where the answer is another one
  std::string hangs_on{};               // the letter that alone is another one there, if it is one
  std::vector<LetterValues> not_there;  // where there is no answer, since something does not happen
  // A letter that the law leaves out though there was no answer where it is much larger or smaller: it may matter
  // there.
  std::string untried{};
};

// What laws are held against.
struct ReachTask {
  const std::vector<HeldLaw>& laws;
  const std::vector<Letter>& letters;
  const LetterValues& base;
  const ScalingTrials::Solve& solve;
  double tolerance = 0;
  Work most = 0, each = 0;  // the work that all of this may take, and a point; points that take more are left out
  // Whether the problem is none of those of which laws are told, so that they need not hold there.
  std::function<bool(const LetterValues&)> is_beyond;
  // How far it was looked, in s, where an answer is missing because something does not happen; nothing where it is
  // missing for another reason.
  std::function<std::optional<double>(std::size_t answer, const LetterValues&)> sought_in_vain;
  bool by_dimensions = false;  // whether dimensions alone tell all laws, and the letters make no group: few points do
};

// Solves the problem at letters far from the base: each a hundred times larger and smaller, of the other sign, and all
// together over six decades. Where a law fails, or tells something that does not happen there, it looks for the
// condition under which it holds: the time of an event that is positive, a group of letters without dimension that is
// on one side of a bound wherever the law holds and on the other wherever it fails, or the sign of a letter. The bound
// is closed in and the condition tried at other letters. misfit: the largest relative difference where the laws hold.
// A letter that a law leaves out is tried in any case, since near the base it may matter less than the answers are
// exact.
std::vector<LawReach> reach_of(const ReachTask& task, double& misfit);

}  // namespace poinsot::problem
