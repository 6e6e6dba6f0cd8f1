// How wide letters are, so that the boxes of labels are right wherever the drawing is shown.
#pragma once

#include <string_view>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures {

// The width of UTF-8 text in a face and size. Letters that the table lacks count as the widest ones do.
double text_width(std::string_view text, Face face, double size);

// Of the size of a face: how far letters reach above and below their base line.
constexpr double ascent = 0.70, descent = 0.22, height_of_x = 0.46, height_of_capitals = 0.66;

}  // namespace poinsot::pictures
