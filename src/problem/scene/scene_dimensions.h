// The lengths and angles of a figure that data name.
#pragma once

#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

void add_dimensions(SceneFigure& figure);

}  // namespace poinsot::problem
