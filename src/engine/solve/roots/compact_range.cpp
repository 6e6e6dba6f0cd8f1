#include "engine/solve/roots/compact_range.h"

#include <cmath>

namespace poinsot::solve {

CompactRange::CompactRange(const RootRange& range, double reach) {
  const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
  begin_ = range.lower / range.scale;
  end_ = range.upper / range.scale;
  kind_ = low && high ? Kind::finite : low ? Kind::up : high ? Kind::down : Kind::line;
  // The ends of t for a reach: (1 + t) / (1 - t) = reach on half a line, t / (1 - t^2) = reach on the whole one.
  const double half = (reach - 1) / (reach + 1), line = 2 * reach / (1 + std::sqrt(1 + 4 * reach * reach));
  lower_ = kind_ == Kind::down ? -half : kind_ == Kind::line ? -line : -1;
  upper_ = kind_ == Kind::up ? half : kind_ == Kind::line ? line : 1;
}

double CompactRange::u(double t) const {
  switch (kind_) {
    case Kind::finite:
      return t < 0 ? begin_ + (end_ - begin_) * (1 + t) / 2 : end_ - (end_ - begin_) * (1 - t) / 2;
    case Kind::up:
      return begin_ + (1 + t) / (1 - t);
    case Kind::down:
      return end_ - (1 - t) / (1 + t);
    case Kind::line:
      return t / ((1 - t) * (1 + t));
  }
  return t;
}

double CompactRange::slope(double t) const {
  switch (kind_) {
    case Kind::finite:
      return (end_ - begin_) / 2;
    case Kind::up:
      return 2 / ((1 - t) * (1 - t));
    case Kind::down:
      return 2 / ((1 + t) * (1 + t));
    case Kind::line:
      return (1 + t * t) / ((1 - t) * (1 - t) * (1 + t) * (1 + t));
  }
  return 1;
}

double CompactRange::weight(double t) const {
  switch (kind_) {
    case Kind::finite:
      return 1;
    case Kind::up:
      return std::pow((1 - t) / 2, growth_);
    case Kind::down:
      return std::pow((1 + t) / 2, growth_);
    case Kind::line:
      return std::pow((1 - t) * (1 + t), growth_);
  }
  return 1;
}

}  // namespace poinsot::solve
