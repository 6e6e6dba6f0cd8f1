// The second road to what rides in an accelerating frame near a steady motion.
#pragma once

#include "poinsot/engine/model/state.h"
#include "problem/entries/statement.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// What rides in a frame that accelerates weighs there what gravity leaves beside the frame's acceleration. This is the
// misfit of what was taken for that acceleration, on ground axes, and of how the frame of the steady motion goes on its
// way from the figure; as a part of what accelerates. Zero if nothing was taken.
double riding_misfit(const Situation& situation, const Machine& machine, const State<double>& state,
                     const Vector3<double>& taken);

}  // namespace poinsot::problem
