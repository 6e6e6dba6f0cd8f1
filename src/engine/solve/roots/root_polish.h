// Improves a place near a root to the root, on the equations themselves.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

struct PolishedRoot {
  Eigen::VectorXd u;       // in natural sizes
  Eigen::VectorXd values;  // of the equations there
  Eigen::MatrixXd slopes;
  double size = 0;    // of the terms, at least the sum of |slope * unknown|
  double radius = 0;  // how far from u rounding allows the root to be
  double part = 0;  // the misfit as a part of the size; where equations have sizes of their own, the largest such part
  bool zero = false;  // whether the equations hold
};

// Levenberg and Marquardt's method, ending in plain Gauss-Newton steps. It starts within the ranges and does not
// leave them. The result is a place of a minimum of the misfit, which need not be a root. Returns nothing where the
// equations or their slopes have no value. enough: the part of the size of the terms below which the misfit need not
// fall.
std::optional<PolishedRoot> polish(RootFunction& function, const Eigen::VectorXd& start, double enough = 0);

// The same with slopes known from close by: this takes two or three evaluations.
std::optional<PolishedRoot> polish_with(RootFunction& function, const Eigen::VectorXd& start,
                                        const Eigen::MatrixXd& slopes);

// Another solution, in a direction that the slopes at a root leave free, if the equations hold along the way. The
// unknowns that change on the way are open.
struct RootFamily {
  Eigen::VectorXd other;
  std::vector<std::size_t> open_unknowns;
};
std::optional<RootFamily> family_through(RootFunction& function, const PolishedRoot& root);

// A list of roots without repetition: two roots within the radius of either are one, of which that with the smaller
// misfit is kept.
class RootList {
 public:
  // Returns whether the root is a new one. Roots outside the ranges are not kept.
  bool add(RootFunction& function, PolishedRoot root);
  const std::vector<PolishedRoot>& roots() const { return roots_; }
  // The roots within the ranges, in the units of the problem, in ascending order.
  std::vector<std::vector<double>> points(const RootFunction& function) const;

 private:
  std::vector<PolishedRoot> roots_;
};

}  // namespace poinsot::solve
