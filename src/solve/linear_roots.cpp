#include "solve/linear_roots.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "solve/root_polish.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Steps of half a natural size: exact for linear equations.
std::optional<MatrixXd> wide_slopes(RootFunction& function, const VectorXd& u0, const VectorXd& r0) {
  MatrixXd J(r0.size(), function.unknowns());
  for (Index k = 0; k < function.unknowns(); ++k) {
    VectorXd u = u0;
    u[k] += 0.5;
    const auto r = function.at(u);
    if (!r || r->values.size() != r0.size()) return std::nullopt;
    J.col(k) = 2 * (r->values - r0);
  }
  return J;
}

}  // namespace

VectorXd middle_of_ranges(const RootProblem& problem) {
  VectorXd u(static_cast<Index>(problem.ranges.size()));
  for (std::size_t k = 0; k < problem.ranges.size(); ++k) {
    const RootRange& range = problem.ranges[k];
    const bool low = std::isfinite(range.lower), high = std::isfinite(range.upper);
    const double x = low && high ? 0.45 * range.lower + 0.55 * range.upper
                     : low       ? range.lower + range.scale
                     : high      ? range.upper - range.scale
                                 : 0.7 * range.scale;
    u[static_cast<Index>(k)] = x / range.scale;
  }
  return u;
}

std::optional<Roots> linear_roots(RootFunction& function) {
  const Index n = function.unknowns();
  const VectorXd u0 = middle_of_ranges(function.problem());
  const auto sample = function.at(u0);
  if (!sample) return std::nullopt;
  const VectorXd& r0 = sample->values;
  if (n == 0) {
    Roots roots;
    roots.best_misfit = r0.size() ? r0.cwiseAbs().maxCoeff() : 0;
    if (r0.norm() <= zero_tolerance * sample->size && sample->misfit <= sample->allowed) roots.points.emplace_back();
    return roots;
  }
  const auto J = wide_slopes(function, u0, r0);
  if (!J) return std::nullopt;

  // Two probes nearby and one anywhere in the ranges, far away in infinite ones, where small terms of higher order
  // show.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  for (int probe = 0; probe < 3; ++probe) {
    VectorXd u = u0;
    for (Index k = 0; k < n; ++k) {
      const RootRange& range = function.problem().ranges[static_cast<std::size_t>(k)];
      const bool up = std::isinf(range.upper), down = std::isinf(range.lower);
      double step = part(random);
      if (probe == 2 && (up || down))
        step = (up && (!down || step > 0) ? 1 : -1) * 1e3 * (1 + std::abs(step));
      else if (probe == 2)
        step *= (range.upper - range.lower) / range.scale;
      u[k] += step;
    }
    const auto r = function.at(u);
    if (!r && probe == 2) break;
    if (!r || r->values.size() != r0.size()) return std::nullopt;
    const VectorXd change = *J * (u - u0);
    const double size = r0.norm() + change.norm() + r->values.norm();
    if ((r->values - r0 - change).norm() > 1e-9 * size) return std::nullopt;
  }

  Roots roots;
  roots.search = RootSearch::linear;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(*J);
  qr.setThreshold(1e-10);
  const VectorXd step = qr.solve(-r0), u = u0 + step, misfit = r0 + *J * step;
  roots.best_misfit = misfit.size() ? misfit.cwiseAbs().maxCoeff() : 0;
  const double size = std::max(sample->size, r0.norm() + (*J * step).norm());
  if (misfit.norm() > zero_tolerance * std::max(size, 1e-300)) return roots;
  // Where a smoother function vanishes the equations themselves need not hold.
  if (std::isfinite(sample->allowed)) {
    const auto there = function.at(u);
    if (!there || there->misfit > there->allowed) return roots;
  }
  if (function.inside(u)) roots.points.push_back(function.unscaled(function.clamped(u)));
  if (qr.rank() < n) {
    roots.open = true;
    const MatrixXd kernel = Eigen::FullPivLU<MatrixXd>(*J).setThreshold(1e-10).kernel();
    for (Index k = 0; k < n; ++k)
      if (kernel.row(k).cwiseAbs().maxCoeff() > 1e-9) roots.open_unknowns.push_back(static_cast<std::size_t>(k));
    roots.alternative = function.unscaled(u + 0.7 * kernel.rowwise().sum());
  }
  return roots;
}

}  // namespace poinsot::solve
