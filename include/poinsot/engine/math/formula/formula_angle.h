// Which angle has a sine and a cosine that are given in letters.
#pragma once

#include <optional>

#include "poinsot/engine/math/formula/formula.h"

namespace poinsot {

// The angle between -pi and pi, if it is a small sum of angles that are letters or products of them, and a part of pi:
// b + pi/2 of cos(b) and -sin(b). That it lies there, as it does at the point of decisions, is recorded
// (formula_decision.h). Nothing of others, of which atan2 is the angle.
std::optional<Formula> letters_of_angle(const Formula& sine, const Formula& cosine);

}  // namespace poinsot
