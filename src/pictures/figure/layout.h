// Drawings put together: side by side, and with words below.
#pragma once

#include <string>
#include <vector>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures {

// With blanks at which no line ends.
std::string unbroken(const std::string& words);

// Writes words below a drawing, centered, in lines of at most its width or the least one.
void caption(Drawing& drawing, const std::string& words, double least_width);

// Adds the marks of a part, where they are.
void append(Drawing& whole, Drawing part);

// Drawings side by side with signs between, their origins on one line.
Drawing side_by_side(std::vector<Drawing> parts, const std::vector<std::string>& signs,
                     const std::vector<std::string>& captions);

}  // namespace poinsot::pictures
