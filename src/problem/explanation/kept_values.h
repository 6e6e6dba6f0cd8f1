// What keeps its value along a motion: energy, angular momenta, spins.
#pragma once

#include <string>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct KeptValue {
  std::string words, symbol;
  Dimension dimension;
  double value = 0;  // SI
};

// The energy of all bodies together, their angular momenta about joints with the ground and the spins of bodies of
// revolution, as far as they keep their values along the motion of a situation up to a time (s).
std::vector<KeptValue> kept_values(const Situation& situation, std::size_t situation_index, Sample& sample, double end);

}  // namespace poinsot::problem
