// From where a figure is looked at, as words say it.
#pragma once

#include <optional>
#include <string_view>

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot::problem {

// Unit vectors: to whoever looks at the front of what stands upright along `up`, and to the right of that reader.
struct FrontAndRight {
  Vector3<double> front, right;
};
FrontAndRight front_and_right(const Vector3<double>& up);

// The direction towards the viewer: "front", "back", "left", "right", "top", "bottom"; "azimuth,elevation" in degrees
// from the front, to the right and up; "x,y,z". Nothing if the words are none of these.
std::optional<Vector3<double>> viewing_direction(std::string_view words, const Vector3<double>& up);

// What the words may be, as messages say it.
inline constexpr std::string_view viewing_words =
    "front, back, left, right, top, bottom, AZIMUTH,ELEVATION in degrees or X,Y,Z towards the viewer";

}  // namespace poinsot::problem
