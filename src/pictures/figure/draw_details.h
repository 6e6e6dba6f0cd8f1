// Enlarged details beside a figure.
#pragma once

#include <string>
#include <vector>

#include "pictures/figure/panel.h"

namespace poinsot::pictures {

// What is too small to be read in a figure, seen along a direction, in units of the paper before it is enlarged.
struct Detail {
  struct Line {
    std::vector<Point2> points;
    std::string name;
    Ink ink = Ink::black;
    Dash dash = Dash::none;
    bool closed = true;
  };
  struct Spot {
    Point2 at;
    std::string symbol;  // TeX
    Ink ink = Ink::black;
  };
  std::vector<Line> lines;
  std::vector<Spot> spots;
  std::string words;
};

// On the right of all that is drawn.
void draw_detail(Panel& panel, const Detail& detail);

}  // namespace poinsot::pictures
