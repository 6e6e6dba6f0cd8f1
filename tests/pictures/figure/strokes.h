// What a drawing has of strokes of one role.
#pragma once

#include <variant>
#include <vector>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures_test {

inline std::vector<pictures::Point2> points_of(const pictures::Drawing& drawing, pictures::Role role) {
  std::vector<pictures::Point2> points;
  for (const pictures::Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<pictures::Stroke>(&mark); stroke != nullptr && stroke->role == role)
      points.insert(points.end(), stroke->points.begin(), stroke->points.end());
  return points;
}

inline double length_of(const pictures::Drawing& drawing, pictures::Role role) {
  double sum = 0;
  for (const pictures::Mark& mark : drawing.marks)
    if (const auto* stroke = std::get_if<pictures::Stroke>(&mark); stroke != nullptr && stroke->role == role)
      for (std::size_t i = 0; i + 1 < stroke->points.size() + (stroke->closed ? 1 : 0); ++i)
        sum += norm(stroke->points[(i + 1) % stroke->points.size()] - stroke->points[i]);
  return sum;
}

}  // namespace poinsot::pictures_test
