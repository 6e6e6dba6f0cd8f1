// How contacts and cords share a load that the statement does not divide among them: only so that none pulls or pushes
// the wrong way.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "poinsot/engine/solve/linear/linear_system.h"

namespace poinsot::problem {

// Moves a solution, along the directions that its equations leave open, to one in which none of the unknowns named is
// negative and as many as possible are positive, and leaves open only directions in which this stays so. Returns false,
// and changes nothing, where there is none, or if an open direction moves one of the first `fixed` unknowns
// (accelerations, or velocities after a blow): then not only the shares are open.
bool share_without_pull(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided, std::size_t fixed);

// The largest value of slopes . t over all shares value + open t in which none of the unknowns named is negative;
// infinite if nothing bounds it, nothing if there are no such shares or an open direction moves one of the first
// `fixed` unknowns.
std::optional<double> largest_over_shares(const solve::LinearSolution& solution,
                                          const std::vector<std::size_t>& one_sided, std::size_t fixed,
                                          const std::vector<double>& slopes);

// Shortens the way from one solution to another so far that no unknown which pushes comes to pull.
void keep_pushing(const std::vector<double>& from, const std::vector<std::size_t>& one_sided, std::vector<double>& to);

// Where the sides of a chain are open by one tension in all of them, its slackest side has none. sides: of the chain,
// by their places among the unknowns.
void slacken_chain(solve::LinearSolution& solution, const std::vector<std::size_t>& sides);

}  // namespace poinsot::problem
