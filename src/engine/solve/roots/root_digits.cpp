// How many digits of a root rounding leaves.
//
// What is small beside other terms of its equations, as a slow precession beside a fast spin, changes these by little
// more than their last digits. A root is known to a part of itself if the equations are clearly farther from holding
// that far away than anywhere within a tenth of it: along each of the directions in which they change differently, the
// singular vectors of their slopes beside the unknowns themselves.
#include <algorithm>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "engine/solve/roots/root_function.h"
#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Whether the equations tell a root from what lies a part of it away along a direction.
bool told_apart(RootFunction& function, const VectorXd& u, const VectorXd& direction, double part) {
  constexpr double clearly = 3, within[] = {-0.1, -0.07, -0.05, -0.03, -0.01, 0, 0.02, 0.04, 0.06, 0.08, 0.1};
  const auto misfit = [&](double way) -> std::optional<double> {
    const auto there = function.at(u + way * part * direction);
    if (!there) return std::nullopt;
    return there->values.norm();
  };
  double inner = 0;
  for (const double way : within) inner = std::max(inner, misfit(way).value_or(0));
  const auto ahead = misfit(1), behind = misfit(-1);
  return ahead.value_or(INFINITY) > clearly * inner && behind.value_or(INFINITY) > clearly * inner;
}

}  // namespace

std::vector<double> blur_of_root(const RootProblem& problem, const std::vector<double>& point, Work most) {
  // Six digits are shown of an answer.
  constexpr double shown = 1e-6, rounding = 1e-15;
  RootFunction function(problem, most);
  const Index n = function.unknowns();
  std::vector<double> blur(point.size(), 0);
  VectorXd u(n);
  for (Index k = 0; k < n; ++k)
    u[k] = point[static_cast<std::size_t>(k)] / problem.ranges[static_cast<std::size_t>(k)].scale;
  const auto here = function.at(u);
  if (!here || here->values.size() < n) return blur;
  const auto slopes = function.slopes(u, *here);
  if (!slopes) return blur;
  // The largest terms may be others than those in which the unknowns are, so that this is only a suspicion.
  const Eigen::JacobiSVD<MatrixXd> svd(*slopes * u.cwiseAbs().asDiagonal(), Eigen::ComputeFullV);
  for (Index k = 0; k < n; ++k) {
    const VectorXd direction = u.cwiseAbs().cwiseProduct(svd.matrixV().col(k));
    if (direction.isZero(0) || shown * svd.singularValues()[k] > rounding * here->size) continue;
    double part = shown;
    while (part < 1 && !told_apart(function, u, direction, part)) part *= 10;
    if (part == shown) continue;
    for (Index i = 0; i < n; ++i)
      blur[static_cast<std::size_t>(i)] =
          std::max(blur[static_cast<std::size_t>(i)], std::min(part, 1.0) * std::abs(svd.matrixV()(i, k)));
  }
  return blur;
}

}  // namespace poinsot::solve
