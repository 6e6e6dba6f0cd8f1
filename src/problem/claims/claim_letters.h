// What a claim speaks of: what the statement leaves open becomes a letter, and what kind of claim it is.
#pragma once

#include "problem/entries/statement.h"

namespace poinsot::problem {

// A problem for claims: what is given as `any`, and gravity of which nothing is said, are letters.
Situation with_letters_for_any(const Situation& situation);

// Whether a claim says of a rate that it is zero, or on which side of zero: then it is meant along the motion, in any
// pose, else in the pose as drawn.
bool is_along_motion(const Situation& situation, const Claim& claim);

// Whether what is stated tells of accelerations or forces, so that it may leave no room for all values of the letters.
bool states_forces(const Situation& situation);

// Whether it calls derivative(X by letter), which has no numbers.
bool takes_derivatives(const Situation& situation, const Claim& claim);

}  // namespace poinsot::problem
