// From a place near a root to the root: on the equations themselves.
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
  double radius = 0;  // how far rounding lets the root be from u
  bool zero = false;  // whether the equations hold
};

// Levenberg and Marquardt's method, ending in plain Gauss-Newton steps, from within the ranges without leaving them: a
// place where the misfit is smallest, not necessarily zero. Nothing where the equations or their slopes have no value.
// enough: the part of the size of the terms below which a misfit need not become smaller.
std::optional<PolishedRoot> polish(RootFunction& function, const Eigen::VectorXd& start, double enough = 0);

// With slopes that are known already, from close by: two or three evaluations.
std::optional<PolishedRoot> polish_with(RootFunction& function, const Eigen::VectorXd& start,
                                        const Eigen::MatrixXd& slopes);

// Where the slopes at a root leave directions free: another solution that way, if the equations hold along it. Then
// the unknowns that move are open.
struct RootFamily {
  Eigen::VectorXd other;
  std::vector<std::size_t> open_unknowns;
};
std::optional<RootFamily> family_through(RootFunction& function, const PolishedRoot& root);

// Roots without repetition: two within the radius of either are one, and the one of smaller misfit is kept.
class RootList {
 public:
  // Whether it is a new one; roots outside the ranges are not kept.
  bool add(const RootFunction& function, PolishedRoot root);
  const std::vector<PolishedRoot>& roots() const { return roots_; }
  // Ascending, in the units of the problem, within the ranges.
  std::vector<std::vector<double>> points(const RootFunction& function) const;

 private:
  std::vector<PolishedRoot> roots_;
};

}  // namespace poinsot::solve
