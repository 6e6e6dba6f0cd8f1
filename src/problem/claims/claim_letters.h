// Makes letters of what the statement leaves open, and finds out what kind of claim is made.
#pragma once

#include <vector>

#include "problem/entries/drawn_letters.h"
#include "problem/entries/statement.h"

namespace poinsot::problem {

// The situation as claims take it: what is given as `any` is a letter, and so is gravity if nothing is said of it.
Situation with_letters_for_any(const Situation& situation);

// Whether a claim compares a rate with zero. Then it is meant along the motion, in every pose; otherwise in the pose
// as drawn.
bool is_along_motion(const Situation& situation, const Claim& claim);

// Whether the file states accelerations or forces, so that it may not have a solution for all values of the letters.
bool states_forces(const Situation& situation);

// Points where letters of a kind are equal or one is twice the other, all of them or two, and those of either sign
// zero: there differences of what is alike vanish, and strict inequalities end. The other letters are as at a point.
std::vector<Point> alike_points(const std::vector<Letter>& letters, const Point& from);

// Whether one of them has a strict inequality, or one that allows that both sides are equal.
bool is_strict(const std::vector<Expression>& claimed);
bool has_closed_end(const std::vector<Expression>& assumed);

// Whether the claim calls derivative(X by letter), which only formulas have.
bool takes_derivatives(const Situation& situation, const Claim& claim);

}  // namespace poinsot::problem
