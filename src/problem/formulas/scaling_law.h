// The laws by which answers found numerically depend on letters, by dimensional analysis.
//
// Where nothing in the problem fixes the units of length, mass and time, an answer is a number times a product of
// powers of the letters, with exponents that follow from dimensions (Buckingham's theorem). Groups without dimension,
// such as a/L and angles, remain open. They are tried: an answer measured at several values may follow a power of a
// group, or a product of sines and cosines of an angle.
#pragma once

#include <string>
#include <vector>

#include "problem/formulas/scaling_trials.h"

namespace poinsot::problem {

struct ScalingLaw {
  Value<Formula> formula;
  // Letters whose powers follow from dimensions, and those whose part in the law was found by trials.
  std::vector<std::string> by_dimension, by_trial;
  int digits = 0;  // correct digits of its numbers
};

// The law of an answer that depends on the given letters. It agrees with every trial, among them three at random
// values of all letters. Throws NoFormula, which names the group or angle that prevents a law.
ScalingLaw scaling_law(ScalingTrials& trials, std::size_t answer, const std::vector<std::string>& letters);

}  // namespace poinsot::problem
