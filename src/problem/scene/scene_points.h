// The named points of a figure: on which body each is, and which of them matter.
#pragma once

#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// Takes the points of the situation from which nothing is seen or asked out of the scene: after everything else was
// added, for dimensions run between points of all kinds.
void leave_out_idle_points(SceneFigure& figure, const Statement& statement);

}  // namespace poinsot::problem
