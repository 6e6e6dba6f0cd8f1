// The equations of a root problem as a function of its unknowns in natural sizes, u = x / scale.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/solve/roots/roots.h"
#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

struct RootSample {
  Eigen::VectorXd values;  // of the smooth equations, if the problem has them, else of the equations
  double size = 0;         // the size of the largest term in them
  // The misfit of the equations and how large it may be, where the values are those of smooth equations in their
  // place, or of different sizes: then it is the largest as a part of its own.
  double misfit = 0, allowed = std::numeric_limits<double>::infinity();
};

class RootFunction {
 public:
  // The problem must outlive the function.
  RootFunction(const RootProblem& problem, Work most);

  const RootProblem& problem() const { return problem_; }
  Eigen::Index unknowns() const { return unknowns_; }

  // Returns nothing where the equations have no value, or values that are not finite.
  std::optional<RootSample> at(const Eigen::VectorXd& u);
  // The same values without the misfit of the equations, for the search of starting places.
  std::optional<RootSample> smooth_at(const Eigen::VectorXd& u);
  // d values / d u: exact where the problem gives slopes; else by differences, which are one-sided at the border of
  // the places that have values.
  std::optional<Eigen::MatrixXd> slopes(const Eigen::VectorXd& u, const RootSample& here);

  // Whether u lies in the ranges, up to rounding.
  bool inside(const Eigen::VectorXd& u) const;
  Eigen::VectorXd clamped(const Eigen::VectorXd& u) const;  // into the closed ranges
  // Whether a root with this misfit lies in the ranges: one that lies beyond their end by what counts as rounding must
  // be as good a root at the end, for beside other unknowns of its kind that may be much.
  bool in_ranges(const Eigen::VectorXd& u, double misfit);
  std::vector<double> unscaled(const Eigen::VectorXd& u) const;

  std::size_t evaluations() const { return evaluations_; }
  bool valued() const { return best_.size() > 0 || !unjudged_.empty(); }  // whether the equations had a value anywhere
  // Of the places within the ranges that were evaluated, the one of the smallest misfit. Where only the smooth
  // equations are known, the most promising places are evaluated in full first. Empty when the equations had no value
  // anywhere.
  const Eigen::VectorXd& best();
  double best_misfit() const { return best_misfit_; }  // the misfit at that place; infinite when there is none

  const WorkLimit& limit() const { return limit_; }

 private:
  void note_evaluation();
  std::optional<RootSample> keep(const Eigen::VectorXd& u, const std::optional<RootEquations>& equations);

  const RootProblem& problem_;
  Eigen::Index unknowns_;
  WorkLimit limit_;
  std::size_t evaluations_ = 0;
  ProgressTeller progress_{"searching the unknowns"};
  // The places in the ranges at which only the smooth equations are known, with their misfit over their size.
  std::vector<std::pair<double, Eigen::VectorXd>> unjudged_;
  Eigen::VectorXd best_;
  double best_misfit_;
};

}  // namespace poinsot::solve
