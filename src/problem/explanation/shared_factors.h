// Equations of which only the ratios of the coefficients matter are written without what all coefficients share.
#pragma once

#include <vector>

#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

struct WithoutShared {
  std::vector<Formula> rest;     // in the order given, all of them divided by the same
  std::vector<Formula> divided;  // the factors with letters by which they were divided
};

// factors: by which it may be divided. What makes the whole shorter is taken: these factors, and numbers.
WithoutShared without_shared_factors(std::vector<Formula> formulas, const std::vector<Formula>& factors);

// The letters of the data as such factors, and the sines and cosines of those that are angles.
std::vector<Formula> possible_factors(const std::vector<Formula>& letters, const std::vector<Formula>& angles);

}  // namespace poinsot::problem
