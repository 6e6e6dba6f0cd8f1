#include "engine/solve/roots/scattered_starts.h"

#include <cmath>
#include <limits>
#include <random>

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double at_part(const RootRange& range, double part) { return place_in_range(range, part, 3); }

}  // namespace

double place_in_range(const RootRange& range, double part, double decades) {
  const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
  if (low && high) return (range.lower + part * (range.upper - range.lower)) / range.scale;
  if (low || high) {
    const double away = std::pow(10, decades * (2 * part - 1));
    return low ? range.lower / range.scale + away : range.upper / range.scale - away;
  }
  const double side = 2 * part - 1;
  return (side < 0 ? -1 : 1) * std::pow(10, decades * (2 * std::abs(side) - 1));
}

std::vector<VectorXd> starts_on_grid(RootFunction& function) {
  const auto& ranges = function.problem().ranges;
  const int count = ranges.size() == 1 ? 200 : 26, columns = ranges.size() == 1 ? 1 : count;
  std::vector<VectorXd> grid, list;
  std::vector<double> misfit;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < columns; ++j) {
      VectorXd u(function.unknowns());
      u[0] = at_part(ranges[0], (i + 0.5) / count);
      if (ranges.size() == 2) u[1] = at_part(ranges[1], (j + 0.5) / count);
      const auto sample = function.limit().spent() ? std::nullopt : function.smooth_at(u);
      grid.push_back(u);
      misfit.push_back(sample ? sample->values.norm() : std::numeric_limits<double>::infinity());
    }
  const auto at = [&](int i, int j) { return misfit[static_cast<std::size_t>(i * columns + j)]; };
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < columns; ++j) {
      bool lowest = std::isfinite(at(i, j));
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj)
          if (i + di >= 0 && i + di < count && j + dj >= 0 && j + dj < columns)
            lowest = lowest && at(i, j) <= at(i + di, j + dj);
      if (lowest) list.push_back(grid[static_cast<std::size_t>(i * columns + j)]);
    }
  return list;
}

std::vector<VectorXd> starts_at_random(const RootProblem& problem, std::size_t count) {
  std::vector<VectorXd> list;
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> part(0, 1);
  for (std::size_t i = 0; i < count; ++i) {
    VectorXd u(static_cast<Index>(problem.ranges.size()));
    for (std::size_t k = 0; k < problem.ranges.size(); ++k)
      u[static_cast<Index>(k)] = at_part(problem.ranges[k], part(random));
    list.push_back(u);
  }
  return list;
}

}  // namespace poinsot::solve
