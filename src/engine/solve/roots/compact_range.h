// The range of an unknown as an interval of a variable t within [-1, 1], infinite ends included.
#pragma once

#include <limits>

#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {

// u = x / scale. A finite range is stretched linearly; u - end = (1 + t) / (1 - t) for half a line, u = t / (1 - t^2)
// for the whole one. Rational functions of u stay rational in t, without poles at infinity after multiplication with
// weight(t).
class CompactRange {
 public:
  // Infinite ends are cut off at `reach` natural sizes.
  CompactRange(const RootRange& range, double reach);

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool infinite() const { return kind_ != Kind::finite; }

  double u(double t) const;
  double slope(double t) const;  // du / dt

  // A function that grows like |u|^growth is multiplied by 1 / |u|^growth far away and by a constant near zero.
  void set_growth(int growth) { growth_ = growth; }
  double weight(double t) const;

 private:
  enum class Kind { finite, up, down, line };
  Kind kind_;
  double begin_ = 0, end_ = 0;  // of a finite range, or its finite end
  double lower_, upper_;        // of t
  int growth_ = 0;
};

}  // namespace poinsot::solve
