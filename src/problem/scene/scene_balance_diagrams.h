// The diagrams that are equations: what acts on the bodies that a worked solution cuts free, and what it does to their
// momenta.
#pragma once

#include "problem/explanation/explanation_instant.h"
#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// Free-body and kinetic diagram of each system; of a blow the momenta before, the impulses and the momenta after.
// Adds to the scene of the figure. explainer: of the instant of the figure.
void add_balance_diagrams(SceneFigure& figure, const InstantExplainer& explainer);

}  // namespace poinsot::problem
