#include "engine/solve/roots/linear_roots.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/solve/linear/decompositions.h"
#include "engine/solve/roots/root_polish.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A slope per natural size below this part of the terms counts as zero: it is what rounding leaves of some thousand
// operations. One ten times larger may be the true slope of an unknown in a unit that is large for it.
constexpr double rounding_of_terms = 1e-12;
// Of columns scaled to the same size. They are known to 1e-12, by steps of a natural size, so that three digits are
// left between what rounding makes of dependent columns and this.
constexpr double rank_tolerance = 1e-9;

struct WideSlopes {
  MatrixXd J;
  double size = 0;  // of the terms, the largest met
};

// Slopes from steps of half a natural size, or wider ones until the equations notice. For linear equations any step
// is exact.
std::optional<WideSlopes> wide_slopes(RootFunction& function, const VectorXd& u0, const RootSample& sample) {
  constexpr double noticed = 1e-6;  // part of the terms, of which a slope keeps six digits
  const VectorXd& r0 = sample.values;
  WideSlopes slopes{MatrixXd::Zero(r0.size(), function.unknowns()), sample.size};
  for (Index k = 0; k < function.unknowns(); ++k) {
    bool any = false;
    for (const double step : {0.5, 500.0, 500e3}) {
      VectorXd u = u0;
      u[k] += step;
      auto r = function.smooth_at(u);
      if (!r || r->values.size() != r0.size()) {
        u[k] = u0[k] - step;
        r = function.smooth_at(u);
      }
      if (!r || r->values.size() != r0.size()) break;
      any = true;
      const VectorXd change = r->values - r0;
      const double size = std::max(sample.size, r->size), largest = change.size() ? change.cwiseAbs().maxCoeff() : 0;
      const double rounding = rounding_of_terms * size * std::max(1.0, u.cwiseAbs().maxCoeff());
      slopes.J.col(k) = (change.array().abs() <= rounding).select(0, change) / (u[k] - u0[k]);
      slopes.size = std::max(slopes.size, size);
      if (largest > noticed * size) break;
    }
    if (!any) return std::nullopt;
  }
  return slopes;
}

bool is_linear(RootFunction& function, const VectorXd& u0, const VectorXd& r0, const MatrixXd& J) {
  // Two probes lie nearby and one anywhere in the ranges, which for infinite ones is far away: there small terms of
  // higher order show. Linear equations miss a probe by the rounding of their terms, or by that of slopes, 1e-12,
  // times the thousand natural sizes to the probe. Beyond corners the equations are others: to meet these takes more
  // probes.
  constexpr double off_the_line = 1e-9, far_away = 1e3;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  const int probes = function.problem().corners ? 40 : 3;
  for (int probe = 0; probe < probes; ++probe) {
    const bool far = probe >= 2;
    VectorXd u = u0;
    for (Index k = 0; k < function.unknowns(); ++k) {
      const RootRange& range = function.problem().ranges[static_cast<std::size_t>(k)];
      const bool up = std::isinf(range.upper), down = std::isinf(range.lower);
      double step = part(random);
      if (far && (up || down))
        step = (up && (!down || step > 0) ? 1 : -1) * far_away * (1 + std::abs(step));
      else if (far)
        step *= (range.upper - range.lower) / range.scale;
      u[k] += step;
    }
    const auto r = function.smooth_at(u);
    if (!r && far) continue;
    if (!r || r->values.size() != r0.size()) return false;
    const VectorXd change = J * (u - u0);
    const double size = r0.norm() + change.norm() + r->values.norm();
    if ((r->values - r0 - change).norm() > off_the_line * size + rounding_of_terms * r->size) return false;
  }
  return true;
}

// A place with each coordinate moved into its range, at a distance from finite ends of some part of the natural size.
VectorXd clamped_inside(const RootProblem& problem, const VectorXd& u, double part) {
  VectorXd v = u;
  for (Index k = 0; k < u.size(); ++k) {
    const RootRange& range = problem.ranges[static_cast<std::size_t>(k)];
    const double lower = range.lower / range.scale, upper = range.upper / range.scale;
    const double in = part * std::min(1.0, upper - lower);
    v[k] = std::clamp(u[k], lower + in, upper - in);
  }
  return v;
}

// A point u + basis t of the plane of solutions that lies within the ranges, if there is one. It is found by
// alternate projections onto the ranges and onto the plane.
std::optional<VectorXd> moved_inside(const RootFunction& function, const VectorXd& u, const MatrixXd& basis) {
  constexpr double arrived = 1e-12;  // of the place, in natural sizes: some thousand roundings of projections
  for (const double part : {1e-2, 1e-6, 0.0}) {
    VectorXd v = u;
    for (int i = 0; i < 5000; ++i) {
      const VectorXd in_ranges = clamped_inside(function.problem(), v, part);
      const VectorXd next = u + basis * (basis.transpose() * (in_ranges - u));
      const bool done = (next - in_ranges).norm() <= arrived * (1 + next.norm());
      v = next;
      if (done) break;
    }
    if (function.inside(v)) return v;
  }
  return std::nullopt;
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
  const auto sample = n == 0 ? function.at(u0) : function.smooth_at(u0);
  if (!sample) return std::nullopt;
  const VectorXd& r0 = sample->values;
  if (n > 0 && n <= 2 && function.problem().corners) return std::nullopt;
  if (n == 0) {
    Roots roots;
    roots.best_misfit = r0.size() ? r0.cwiseAbs().maxCoeff() : 0;
    if (r0.norm() <= function.problem().zero * sample->size && sample->misfit <= sample->allowed)
      roots.points.emplace_back();
    return roots;
  }
  const auto slopes = wide_slopes(function, u0, *sample);
  if (!slopes) return std::nullopt;
  const MatrixXd& J = slopes->J;
  if (!is_linear(function, u0, r0, J)) return std::nullopt;

  // The columns are scaled to one size, so that the rank does not depend on the units of the unknowns.
  Roots roots;
  roots.search = RootSearch::linear;
  VectorXd stretch = VectorXd::Ones(n);
  for (Index k = 0; k < n; ++k)
    if (const double largest = J.rows() ? J.col(k).cwiseAbs().maxCoeff() : 0; largest > 0) stretch[k] = 1 / largest;
  const MatrixXd scaled = J * stretch.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> qr;
  qr.setThreshold(rank_tolerance);
  qr.compute(scaled);
  VectorXd u = u0;
  if (J.rows()) u -= stretch.cwiseProduct(qr.solve(r0));
  VectorXd misfit = r0 + J * (u - u0);
  double size = std::max(slopes->size, r0.norm() + (J * (u - u0)).norm());
  double left = misfit.norm();
  bool holds = misfit.norm() <= function.problem().zero * std::max(size, 1e-300);
  // The solution is refined a few times from where it is: this takes out what rounding has left in the slopes.
  for (int i = 0; holds && i < 3 && J.rows(); ++i) {
    const auto there = function.at(u);
    if (!there || there->values.size() != r0.size()) break;
    size = std::max(size, there->size);
    left = there->values.norm();
    constexpr double last_digits = 1e-15;  // five roundings of the terms, below which no step gets
    if (i == 2 || there->values.norm() <= last_digits * there->size) {
      // The values may be those of a smoother function in place of the equations. Where it vanishes the equations
      // themselves have to be asked.
      holds = there->values.norm() <= function.problem().zero * size && there->misfit <= there->allowed;
      break;
    }
    u -= stretch.cwiseProduct(qr.solve(there->values));
  }
  roots.best_misfit = misfit.size() ? misfit.cwiseAbs().maxCoeff() : 0;
  if (!holds) {
    function.at(function.clamped(u));  // records there how close the equations come
    return roots;
  }
  if (qr.rank() == n) {
    if (function.in_ranges(u, left)) roots.points.push_back(function.unscaled(function.clamped(u)));
    return roots;
  }

  MatrixXd kernel =
      stretch.asDiagonal() * MatrixXd(Eigen::FullPivLU<MatrixXd>(scaled).setThreshold(rank_tolerance).kernel());
  kernel = Eigen::HouseholderQR<MatrixXd>(kernel).householderQ() * MatrixXd::Identity(n, kernel.cols());
  roots.open = true;
  for (Index k = 0; k < n; ++k)
    if (kernel.row(k).cwiseAbs().maxCoeff() > rank_tolerance)
      roots.open_unknowns.push_back(static_cast<std::size_t>(k));
  const auto inside = moved_inside(function, u, kernel);
  if (!inside) {
    roots.open = false;
    roots.open_unknowns.clear();
    return roots;
  }
  roots.points.push_back(function.unscaled(function.clamped(*inside)));
  VectorXd direction = kernel * VectorXd::LinSpaced(kernel.cols(), 1, 1.7);
  direction /= direction.cwiseAbs().maxCoeff();
  for (double step = 0.7; step > 1e-7 && roots.alternative.empty(); step /= 4)
    for (const double way : {step, -step}) {
      const VectorXd other = *inside + way * direction;
      const auto there = function.inside(other) ? function.at(other) : std::nullopt;
      if (!there || there->values.size() != r0.size() || there->misfit > there->allowed) continue;
      if (there->values.norm() > function.problem().zero * std::max(size, there->size)) continue;
      roots.alternative = function.unscaled(other);
      break;
    }
  return roots;
}

}  // namespace poinsot::solve
