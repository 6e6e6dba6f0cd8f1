// Poses in which two of the three angles of a joint turn about the same line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/machine/machine.h"

namespace poinsot::problem {

// "the angles 'phi' and 'psi' of joint 'tip' turn about the same line (gimbal lock)", if they do in the pose q. sine:
// of the angle between lines that count as the same.
std::optional<std::string> gimbal_lock(const Machine& machine, const std::vector<double>& q, double sine = 1e-9);

// What to do about it.
inline constexpr const char* beside_gimbal_lock =
    "leave the angles of the joint out, or take other axes for them, or another pose";

}  // namespace poinsot::problem
