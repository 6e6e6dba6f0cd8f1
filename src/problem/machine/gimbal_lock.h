// Finds poses in which two of the three angles of a joint turn about the same line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/machine/machine.h"

namespace poinsot::problem {

// If this is so in the pose q, the message "the angles 'phi' and 'psi' of joint 'tip' turn about the same line
// (gimbal lock)". sine: lines count as the same if the sine of their angle is less.
std::optional<std::string> gimbal_lock(const Machine& machine, const std::vector<double>& q, double sine = 1e-9);

// What the author can do about it.
inline constexpr const char* beside_gimbal_lock =
    "leave the angles of the joint out, or take other axes for them, or another pose";

}  // namespace poinsot::problem
