#include "engine/solve/roots/compact_function.h"

#include <algorithm>
#include <cmath>

#include "engine/solve/roots/linear_roots.h"

namespace poinsot::solve {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

CompactFunction::CompactFunction(RootFunction& function, double reach) : function_(function) {
  for (const RootRange& range : function.problem().ranges) ranges_.emplace_back(range, reach);
  for (std::size_t k = 0; k < ranges_.size(); ++k)
    if (ranges_[k].infinite()) measure_growth(k, reach);
}

// Compares the values at two places beyond the reach to find the power of |u| with which they grow.
void CompactFunction::measure_growth(std::size_t variable, double reach) {
  const RootRange& range = function_.problem().ranges[variable];
  const VectorXd u = function_.clamped(1.17 * middle_of_ranges(function_.problem()));
  double growth = -8;
  bool known = false;
  for (const bool upward : {true, false}) {
    if (std::isfinite(upward ? range.upper : range.lower)) continue;
    constexpr double ratio = 8;
    VectorXd near_end = u, far_end = u;
    near_end[static_cast<Index>(variable)] = upward ? reach : -reach;
    far_end[static_cast<Index>(variable)] = upward ? ratio * reach : -ratio * reach;
    const auto a = function_.smooth_at(near_end), b = function_.smooth_at(far_end);
    if (!a || !b || a->values.size() != b->values.size()) continue;
    const double first = a->values.norm(), second = b->values.norm();
    if (!(first > 0) || !(second > 0)) continue;
    growth = std::max(growth, std::log(second / first) / std::log(ratio));
    known = true;
  }
  if (known) ranges_[variable].set_growth(static_cast<int>(std::lround(std::min(growth, 12.0))));
}

Piece CompactFunction::whole() const {
  Piece box;
  for (std::size_t k = 0; k < 2; ++k) {
    box.middle[k] = k < ranges_.size() ? (ranges_[k].lower() + ranges_[k].upper()) / 2 : 0;
    box.half[k] = k < ranges_.size() ? (ranges_[k].upper() - ranges_[k].lower()) / 2 : 0;
  }
  return box;
}

VectorXd CompactFunction::u(const Pair& t) const {
  VectorXd u(static_cast<Index>(ranges_.size()));
  for (std::size_t k = 0; k < ranges_.size(); ++k) u[static_cast<Index>(k)] = ranges_[k].u(t[k]);
  return u;
}

std::optional<RootSample> CompactFunction::at(const Pair& t) const {
  auto sample = function_.smooth_at(u(t));
  if (!sample) return std::nullopt;
  double weight = 1;
  for (std::size_t k = 0; k < ranges_.size(); ++k) weight *= ranges_[k].weight(t[k]);
  sample->values *= weight;
  sample->size *= weight;
  if (!sample->values.allFinite()) return std::nullopt;
  return sample;
}

MatrixXd CompactFunction::unweighted(const Pair& t, const MatrixXd& slopes) const {
  MatrixXd J(slopes.rows(), static_cast<Index>(ranges_.size()));
  double weight = 1;
  for (std::size_t k = 0; k < ranges_.size(); ++k) weight *= ranges_[k].weight(t[k]);
  for (std::size_t k = 0; k < ranges_.size(); ++k)
    J.col(static_cast<Index>(k)) = slopes.col(static_cast<Index>(k)) / (weight * ranges_[k].slope(t[k]));
  return J;
}

}  // namespace poinsot::solve
