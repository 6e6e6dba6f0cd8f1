// Linear programs: the largest value of a linear function under equations, of unknowns that are not negative.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace poinsot::solve {

struct LinearOptimum {
  Eigen::VectorXd x;  // where it is taken; if it has no bound, a point from which it grows without end
  double value = 0;   // c . x
  bool bounded = true;
};

// The largest c . x for which A x = b and x >= 0; nothing if no x fulfils these. Coefficients should be near one: what
// is smaller than 1e-11 of the largest counts as zero. By the simplex method in two phases, with Bland's rule, which
// comes to an end also where many bounds meet (R. G. Bland, Math. Oper. Res. 2, 103, 1977).
std::optional<LinearOptimum> maximise(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& c);

}  // namespace poinsot::solve
