// What keeps its value along a motion: energy, angular momenta, spins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/explanation/general_motion.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

struct KeptValue {
  std::string words, symbol;
  Dimension dimension;
  double value = 0;  // SI
  double size = 0;   // natural for it here, at least |value|
  // In the data, the coordinates and their rates: it has this value at every time of the motion.
  std::optional<Formula> formula{};
  std::optional<Formula> at_start{};  // the same at the start, in the data alone
};

// The energy of all bodies together, their angular momenta about joints with the ground and the spins of bodies of
// revolution, as far as they keep their values along the motion of a situation up to a time (s). general: the motion in
// formulas, if it has any.
std::vector<KeptValue> kept_values(const Situation& situation, std::size_t situation_index, Sample& sample, double end,
                                   const GeneralMotion* general);

}  // namespace poinsot::problem
