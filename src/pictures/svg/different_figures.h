// All figures of a solution that show something of their own.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "poinsot/pictures.h"

namespace poinsot::pictures {

struct DrawnFigure {
  FigureTitle title;
  std::string svg;
};

// The figures that figures() names, in that order, without those of single bodies, which are parts of others, and those
// that are drawn like an earlier one.
std::vector<DrawnFigure> different_figures(const Document& document, std::size_t solution);

}  // namespace poinsot::pictures
