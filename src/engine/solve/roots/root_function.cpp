#include "engine/solve/roots/root_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

VectorXd vector_of(const std::vector<double>& v) {
  return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
}

}  // namespace

RootFunction::RootFunction(const RootProblem& problem, Work most)
    : problem_(problem),
      unknowns_(static_cast<Index>(problem.ranges.size())),
      limit_(most),
      best_misfit_(std::numeric_limits<double>::infinity()) {}

std::vector<double> RootFunction::unscaled(const VectorXd& u) const {
  std::vector<double> x(problem_.ranges.size());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = u[static_cast<Index>(k)] * problem_.ranges[k].scale;
  return x;
}

void RootFunction::note_evaluation() {
  constexpr Work beside_the_equations = 500;
  ++evaluations_;
  count_work(beside_the_equations);
  progress_.tell({}, evaluations_);
}

std::optional<RootSample> RootFunction::keep(const VectorXd& u, const std::optional<RootEquations>& equations) {
  note_evaluation();
  if (!equations || !std::isfinite(equations->size)) return std::nullopt;
  RootSample sample{vector_of(equations->values), equations->size};
  if (!sample.values.allFinite()) return std::nullopt;
  const double misfit = sample.values.size() ? sample.values.cwiseAbs().maxCoeff() : 0;
  if (equations->sizes.size() == equations->values.size()) {
    for (std::size_t i = 0; i < equations->sizes.size(); ++i)
      sample.misfit = std::max(sample.misfit, std::abs(equations->values[i]) / std::max(equations->sizes[i], 1e-300));
    sample.allowed = problem_.zero;
  }
  if (!equations->smooth.empty()) {
    sample.misfit = sample.values.norm();
    sample.allowed = problem_.zero * sample.size;
    sample.values = vector_of(equations->smooth);
    sample.size = equations->smooth_size;
    if (!sample.values.allFinite() || !std::isfinite(sample.size)) return std::nullopt;
  }
  if (misfit < best_misfit_ && inside(u)) {
    best_misfit_ = misfit;
    best_ = u;
  }
  return sample;
}

std::optional<RootSample> RootFunction::at(const VectorXd& u) { return keep(u, problem_.equations(unscaled(u))); }

std::optional<RootSample> RootFunction::smooth_at(const VectorXd& u) {
  if (!problem_.smooth) return at(u);
  const auto equations = problem_.smooth(unscaled(u));
  if (!equations || !equations->values.empty()) return keep(u, equations);
  note_evaluation();
  RootSample sample{vector_of(equations->smooth), equations->smooth_size};
  if (!sample.values.allFinite() || !std::isfinite(sample.size)) return std::nullopt;
  if (inside(u)) unjudged_.emplace_back(sample.values.norm() / std::max(sample.size, 1e-300), u);
  return sample;
}

const VectorXd& RootFunction::best() {
  constexpr std::size_t most = 64;
  auto places = std::exchange(unjudged_, {});
  std::ranges::sort(places, {}, &std::pair<double, VectorXd>::first);
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
    if (best_.size() && limit_.spent()) break;
    at(places[i].second);
  }
  return best_;
}

std::optional<MatrixXd> RootFunction::slopes(const VectorXd& u, const RootSample& here) {
  const Index rows = here.values.size();
  MatrixXd J(rows, unknowns_);
  if (problem_.slopes) {
    std::vector<std::vector<double>> exact;
    if (keep(u, problem_.slopes(unscaled(u), &exact)) && exact.size() == static_cast<std::size_t>(rows)) {
      for (Index i = 0; i < rows; ++i)
        for (Index k = 0; k < unknowns_; ++k)
          J(i, k) =
              exact[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] * problem_.ranges[std::size_t(k)].scale;
      if (J.allFinite()) return J;
    }
  }
  const auto values = [&](const VectorXd& v) -> std::optional<VectorXd> {
    const auto sample = at(v);
    if (!sample || sample->values.size() != rows) return std::nullopt;
    return sample->values;
  };
  for (Index k = 0; k < unknowns_; ++k) {
    // The cube root of the machine precision makes the rounding of a central difference as large as its third-order
    // error.
    const double h = 6e-6 * std::max(1.0, std::abs(u[k]));
    VectorXd v = u;
    v[k] = u[k] + h;
    const auto ahead = values(v);
    v[k] = u[k] - h;
    const auto behind = values(v);
    if (ahead && behind) {
      J.col(k) = (*ahead - *behind) / (2 * h);
      continue;
    }
    if (!ahead && !behind) return std::nullopt;
    const double side = ahead ? h : -h;
    v[k] = u[k] + 2 * side;
    const auto further = values(v);
    if (!further) return std::nullopt;
    J.col(k) = (4 * (ahead ? *ahead : *behind) - 3 * here.values - *further) / (2 * side);
  }
  return J;
}

bool RootFunction::inside(const VectorXd& u) const {
  for (Index k = 0; k < unknowns_; ++k) {
    const RootRange& range = problem_.ranges[static_cast<std::size_t>(k)];
    // A root at the end of its range is found to some 1e-11 of its natural size, and lies beyond it as often as not.
    constexpr double beyond = 1e-9;
    const double x = u[k] * range.scale, slack = beyond * range.scale;
    if (!(x >= range.lower - slack && x <= range.upper + slack)) return false;
    if ((range.lower_open && x < range.lower + slack) || (range.upper_open && x > range.upper - slack)) return false;
  }
  return true;
}

bool RootFunction::in_ranges(const VectorXd& u, double misfit) {
  if (!inside(u)) return false;
  const VectorXd end = clamped(u);
  if (end == u) return true;
  constexpr double as_good = 100;
  const double rounding = std::min(1e-12, problem_.zero);
  const auto there = at(end);
  return there && there->values.norm() <= std::max(as_good * misfit, rounding * there->size);
}

VectorXd RootFunction::clamped(const VectorXd& u) const {
  VectorXd v = u;
  for (Index k = 0; k < unknowns_; ++k) {
    const RootRange& range = problem_.ranges[static_cast<std::size_t>(k)];
    v[k] = std::clamp(u[k], range.lower / range.scale, range.upper / range.scale);
  }
  return v;
}

}  // namespace poinsot::solve
