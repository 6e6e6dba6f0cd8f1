// Poinsot's picture of a body that turns freely: its cones if it is axisymmetric, polhode and herpolhode if it is not.
#pragma once

#include "problem/instant/instant.h"
#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// Adds them to the scene of the figure for each body on which nothing acts but gravity. Returns whether there is one
// that turns.
bool add_free_motion(SceneFigure& figure, const MotionState& reached);

// The turning of a body alone on which nothing acts, about its mass center as it is shown: for statements that say how
// it turns and not how its center moves.
void add_turning(SceneFigure& figure, const MotionState& reached);

}  // namespace poinsot::problem
