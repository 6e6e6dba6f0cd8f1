// How contacts that stick share a load that the statement does not divide among them: within their cones of friction.
//
// The forces are y = y0 + Z t. A contact with the push N and the friction F sticks while m N - e . F >= 0 for every
// direction e: a cone, which is met from outside by more and more of these planes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::problem {

// The push and the components of the friction of a contact that sticks, by their places among the unknowns.
struct FrictionCone {
  std::size_t push = 0, first = 0;
  std::optional<std::size_t> second{};  // none in a planar problem
  double coefficient = 0;
};

// Moves a solution along its open directions to one in which no one-sided force is negative and every contact sticks,
// each as far from its limit as can be; where there is none, to the one that fails least. Moves none of the first
// `fixed` unknowns.
void share_within_cones(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                        const std::vector<FrictionCone>& cones, std::size_t fixed);

// As largest_over_shares() (one_sided_shares.h), with every contact within its cone.
std::optional<double> largest_within_cones(const solve::LinearSolution& solution,
                                           const std::vector<std::size_t>& one_sided,
                                           const std::vector<FrictionCone>& cones, std::size_t fixed,
                                           const std::vector<double>& slopes);

// Shortens the way from one solution to another so far that no contact leaves its cone.
void keep_sticking(const std::vector<double>& from, const std::vector<FrictionCone>& cones, std::vector<double>& to);

}  // namespace poinsot::problem
