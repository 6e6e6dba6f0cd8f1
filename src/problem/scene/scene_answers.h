// The diagram of the vectors that are asked for, with the numbers of their answers.
#pragma once

#include "problem/results/solution.h"
#include "problem/scene/scene_figure.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {

// home: the instant of the figure. Adds to the scene of the figure if there are such vectors.
void add_answers(SceneFigure& figure, Sample& sample, const Sample::Home& home, const Solution& solution);

}  // namespace poinsot::problem
