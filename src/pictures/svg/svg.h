// A drawing as SVG 1.1.
#pragma once

#include <string>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures {

std::string svg_of(const Drawing& drawing);

}  // namespace poinsot::pictures
