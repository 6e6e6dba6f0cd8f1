// Solids that stand for bodies of which only the moments of inertia are known.
#pragma once

#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// To each body without shape whose moments about two axes through its center are equal a cylinder, sphere or rod that
// has these moments; a body that rolls reaches to where it touches. To a top a cone on its tip, to any other body that
// is no link of a mechanism the ellipsoid of its moments, made small enough to leave what holds it outside.
void add_stand_ins(SceneFigure& figure);

}  // namespace poinsot::problem
