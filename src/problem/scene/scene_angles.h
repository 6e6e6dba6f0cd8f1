// The angles of a figure that data name.
#pragma once

#include <string>

#include "problem/scene/scene_figure.h"

namespace poinsot::problem {

// An angle's datum, letter or unknown with the text beside the arc.
struct NamedAngle {
  std::string name, text;
  double value = 0;
};

// Adds the arc of an angle where a direction, a segment between points, a load or the coordinate of a joint makes it;
// nothing where none does.
void add_angle(SceneFigure& figure, const NamedAngle& angle);

}  // namespace poinsot::problem
