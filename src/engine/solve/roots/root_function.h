// The equations of a root problem as a function of its unknowns in natural sizes, u = x / scale.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"

namespace poinsot::solve {

// Misfits below this part of the size of the terms count as zero.
inline constexpr double zero_tolerance = 1e-9;

struct RootSample {
  Eigen::VectorXd values;  // the smooth ones, if there are such
  double size = 0;         // of the largest term in them
  // The misfit of the equations and its allowance, where they are not the values themselves.
  double misfit = 0, allowed = std::numeric_limits<double>::infinity();
};

class RootFunction {
 public:
  // problem must outlive the function.
  RootFunction(const RootProblem& problem, double seconds);

  const RootProblem& problem() const { return problem_; }
  Eigen::Index unknowns() const { return unknowns_; }

  // Nothing where the equations have no value or are no numbers.
  std::optional<RootSample> at(const Eigen::VectorXd& u);
  // The same values without their misfit, to look for places of roots.
  std::optional<RootSample> smooth_at(const Eigen::VectorXd& u);
  // d values / d u: exact where the problem has slopes; else by differences, one-sided at the end of what has values.
  std::optional<Eigen::MatrixXd> slopes(const Eigen::VectorXd& u, const RootSample& here);

  // Whether u lies in the ranges, but for rounding.
  bool inside(const Eigen::VectorXd& u) const;
  Eigen::VectorXd clamped(const Eigen::VectorXd& u) const;  // into the closed ranges
  std::vector<double> unscaled(const Eigen::VectorXd& u) const;

  std::size_t evaluations() const { return evaluations_; }
  bool valued() const { return best_.size() > 0 || !unjudged_.empty(); }  // whether they had a value anywhere
  // Of the places met in the ranges the one of the smallest misfit; of those of which only the smooth equations are
  // known, the most promising are judged for it. Empty when the equations had no value there.
  const Eigen::VectorXd& best();
  double best_misfit() const { return best_misfit_; }  // largest misfit there; infinite when there is none

  bool out_of_time() const { return now() > end_; }
  double seconds_left() const { return end_ - now(); }
  // The part of the allowed time that is spent, 0 to 1.
  double time_spent() const;

 private:
  double now() const;  // s
  std::optional<RootSample> keep(const Eigen::VectorXd& u, const std::optional<RootEquations>& equations);

  const RootProblem& problem_;
  Eigen::Index unknowns_;
  double begin_, end_;  // s
  std::size_t evaluations_ = 0;
  // Places in the ranges of which only the smooth equations are known, with the misfit of these over their size.
  std::vector<std::pair<double, Eigen::VectorXd>> unjudged_;
  Eigen::VectorXd best_;
  double best_misfit_;
};

}  // namespace poinsot::solve
