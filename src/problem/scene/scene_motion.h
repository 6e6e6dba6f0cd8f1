// The motion of a scene: poses, plots and events over time, and the paths of what moves.
#pragma once

#include "problem/results/solution.h"
#include "problem/scene/scene_figure.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// Follows the motion of a situation for as long as is asked about it, and adds it to the scene of the figure. Throws
// StatementError if it cannot begin.
void add_motion(SceneFigure& figure, Sample& sample, std::size_t situation, const Solution& solution);

}  // namespace poinsot::problem
