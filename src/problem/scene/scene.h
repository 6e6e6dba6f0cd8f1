// The scene of a solved statement (poinsot/scene.h): what a picture of it shows, as numbers.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/scene.h"
#include "problem/entries/statement.h"
#include "problem/results/solution.h"

namespace poinsot::problem {

// One for each situation, first that about which is asked first. solution: which of the solutions. What cannot be drawn
// is left out, and the scene's notes say why.
std::vector<scene::Scene> scenes_of(const Statement& statement,
                                    const std::vector<std::pair<std::string, std::string>>& sets,
                                    const SolvedStatement& solved, std::size_t solution);

}  // namespace poinsot::problem
