// How contacts that stick share a load that the statement does not divide among them: within their cones of friction.
//
// The forces are y = y0 + Z t. A contact with the push N and the friction F sticks while |F| <= m N: a cone of forces,
// so that the largest margin is a program within cones (engine/solve/linear/cone_program.h).
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
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

// Weights of the forces that are shared, with which every share has the same sum. Those of a contact lie in a cone
// themselves, limit >= |(first, second)|, so that
//   sum w N + sum (limit m N + first F1 + second F2) >= 0
// wherever all press and stick. Where the sum is below zero, they do so in no share.
struct StickingBound {
  struct OfCone {
    FrictionCone cone;
    double limit = 0, first = 0, second = 0;
  };
  std::vector<std::pair<std::size_t, double>> pushes;
  std::vector<OfCone> cones;
  double most = 0;  // no share has a larger margin, in units of the largest force
};
// Nothing where nothing is shared.
std::optional<StickingBound> bound_on_sticking(const solve::LinearSolution& solution,
                                               const std::vector<std::size_t>& one_sided,
                                               const std::vector<FrictionCone>& cones, std::size_t fixed);

// Shortens the way from one solution to another so far that no contact leaves its cone.
void keep_sticking(const std::vector<double>& from, const std::vector<FrictionCone>& cones, std::vector<double>& to);

}  // namespace poinsot::problem
