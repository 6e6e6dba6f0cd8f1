// Where labels stand: near what they name, over nothing else.
#pragma once

#include <functional>
#include <vector>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures {

// A place beside which a label may stand.
struct Anchor {
  Point2 at;
  Point2 preferred{};  // the side on which it reads best; zero if any
  double gap = 5;      // between the place and the label's box
  double cost = 0;     // of this place beside the others
};

struct LabelRequest {
  Label label;
  std::vector<Anchor> anchors;
  double importance = 1;  // the more important are placed first
  bool may_lack = false;  // whether it is left out where there is no room near
  Ink leader = Ink::grey;
  // Where its middle would be read as of something else; nowhere if empty.
  std::function<bool(Point2)> misread{};
};

// Places the labels, with lines to what they name where they stand away from it. `marks` are what is drawn already;
// `over_body` tells whether a point lies over a body. Returns the labels and lines.
std::vector<Mark> place_labels(std::vector<LabelRequest> requests, const std::vector<Mark>& marks,
                               const std::function<bool(Point2)>& over_body);

}  // namespace poinsot::pictures
