// The diagram of the statement's figure: loads, given motions and given impulses.
#pragma once

#include "problem/instant/instant.h"
#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

scene::Diagram model_diagram(SceneFigure& figure);

}  // namespace poinsot::problem
