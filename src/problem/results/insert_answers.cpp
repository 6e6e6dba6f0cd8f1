#include "problem/results/insert_answers.h"

#include <algorithm>

namespace poinsot::problem {

void insert_answers(Solution& solution, const std::vector<std::size_t>& places, const Solution& more) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (FormulaCondition& ground : solution.grounds)
      for (std::size_t& ask : ground.asks) ask += ask >= places[k] ? 1 : 0;
    solution.asks.insert(solution.asks.begin() + static_cast<std::ptrdiff_t>(places[k]), more.asks[k]);
  }
  for (FormulaCondition ground : more.grounds) {
    for (std::size_t& ask : ground.asks) ask = places.at(ask);
    solution.grounds.push_back(std::move(ground));
  }
  for (const std::string& words : more.assumptions)
    if (std::ranges::find(solution.assumptions, words) == solution.assumptions.end())
      solution.assumptions.push_back(words);
  solution.notes.insert(solution.notes.end(), more.notes.begin(), more.notes.end());
  for (const auto& [name, value] : more.checks) {
    double& check = solution.checks[name];
    check = std::max(check, value);
  }
}

}  // namespace poinsot::problem
