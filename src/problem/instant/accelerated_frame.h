// Steady motion in a frame that accelerates without turning, a lift or a train: what rests in it moves near there as if
// the frame rested and gravity were g - a, a the acceleration of the frame, as long as nothing but loads of constant
// direction reaches in from outside.
#pragma once

#include <vector>

#include "problem/instant/instant_conditions.h"

namespace poinsot::problem {

struct AcceleratedFrame {
  Vector3<double> acceleration{};  // ground axes, m/s^2
  std::vector<int> coordinates;    // velocity coordinates by which the frame moves
};

// That of `steady:`; no acceleration and no coordinates if it has none, or turns. Throws UnansweredError where what
// rides in it is joined to what does not, or where the acceleration changes with time.
AcceleratedFrame accelerated_frame(const InstantView<double>& view, const Mark& mark, double pace);

}  // namespace poinsot::problem
