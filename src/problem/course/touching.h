// When bodies that are apart touch.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace poinsot::problem {

using GapAlongMotion = std::function<double(double time, std::span<const double> q, std::span<const double> v)>;

// The gap, with a little added: bodies that touch and are not pressed stay open, and rounding is no blow. Those that
// are never far apart, but by more than rounding, touch to the digits of how far they were, however small that is
// beside the natural length, of which the last digits are nothing. at_start: the gap where the motion begins.
inline GapAlongMotion gap_beyond_rounding(GapAlongMotion gap, double natural_length, double at_start) {
  constexpr double of_length = 1e-13, apart = 30, near = 1e-4, of_way = 1e-12;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double rounding = of_length * natural_length, last_digits = epsilon * natural_length;
  return [=, gap = std::move(gap), farthest = std::make_shared<double>(at_start)](
             double time, std::span<const double> q, std::span<const double> v) {
    const double open = gap(time, q, v);
    *farthest = std::max(*farthest, open);
    const bool small = *farthest > apart * rounding && *farthest < near * natural_length;
    return open + (small ? std::max(of_way * *farthest, last_digits) : rounding);
  };
}

}  // namespace poinsot::problem
