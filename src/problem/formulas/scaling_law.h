// How numbers that are found by following a motion, or by searching, depend on letters: dimensional analysis.
//
// Lengths, masses and times may be measured in other units: where nothing in the problem fixes these, an answer is a
// number times a product of powers of the letters, with exponents that follow from dimensions (Buckingham's theorem).
// What dimensions leave open, groups such as a/L and angles, is tried: an answer measured at several values may follow
// a power of a group, or a product of sines and cosines of an angle.
#pragma once

#include <string>
#include <vector>

#include "problem/formulas/scaling_trials.h"

namespace poinsot::problem {

struct ScalingLaw {
  Value<Formula> formula;
  // Letters whose powers follow from dimensions, and those whose part in the law was tried.
  std::vector<std::string> by_dimension, by_trial;
  int digits = 0;  // of its numbers, none of them wrong
};

// The law of an answer that depends on some of the letters. It agrees with every trial, among them three draws of all
// letters. Throws NoFormula, with the group or angle that stands in the way.
ScalingLaw scaling_law(ScalingTrials& trials, std::size_t answer, const std::vector<std::string>& letters);

}  // namespace poinsot::problem
