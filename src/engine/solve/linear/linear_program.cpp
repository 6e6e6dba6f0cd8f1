#include "engine/solve/linear/linear_program.h"

#include <cmath>
#include <limits>
#include <vector>

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;

// Equations solved for one unknown each, the basis; all others are zero. The last column holds the right sides.
class Tableau {
 public:
  Tableau(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) : unknowns_(A.cols()) {
    const Index rows = A.rows();
    // Each equation begins with an unknown of its own, by which it is off; right sides are not negative.
    table_ = Eigen::MatrixXd::Zero(rows, unknowns_ + rows + 1);
    for (Index i = 0; i < rows; ++i) {
      const double sign = b[i] < 0 ? -1 : 1;
      table_.row(i).head(unknowns_) = sign * A.row(i);
      table_(i, unknowns_ + i) = 1;
      table_(i, unknowns_ + rows) = sign * b[i];
      basis_.push_back(unknowns_ + i);
    }
    const double largest = table_.size() > 0 ? table_.cwiseAbs().maxCoeff() : 0;
    largest_right_ = b.size() > 0 ? b.cwiseAbs().maxCoeff() : 0;
    zero_ = nothing * std::max(largest, std::numeric_limits<double>::min());
  }

  // Whether the equations can be fulfilled; then no unknown of an equation's own is left in the basis, or it is zero.
  bool find_start() {
    Eigen::VectorXd off = Eigen::VectorXd::Zero(unknowns_ + rows());
    off.tail(rows()).setConstant(-1);
    climb(off, unknowns_ + rows());
    double left = 0;
    for (Index i = 0; i < rows(); ++i)
      if (basis_[static_cast<std::size_t>(i)] >= unknowns_) left += right_side(i);
    if (left > feasible * largest_right_) return false;
    for (Index i = 0; i < rows(); ++i) {
      if (basis_[static_cast<std::size_t>(i)] < unknowns_) continue;
      Index best = 0;
      if (unknowns_ > 0 && table_.row(i).head(unknowns_).cwiseAbs().maxCoeff(&best) > zero_) exchange(i, best);
      // Otherwise the equation repeats others and goes on unused.
    }
    return true;
  }

  // Goes to the largest value of the function of the first `columns` unknowns; false if it grows without end.
  bool climb(const Eigen::VectorXd& function, Index columns) {
    // Bland's rule comes to an end, but for rounding.
    for (Index exchanges = 0; exchanges < 100 * (columns + rows()); ++exchanges) {
      Index entering = -1;
      for (Index k = 0; k < columns && entering < 0; ++k) {
        double slope = function[k];
        for (Index i = 0; i < rows(); ++i) slope -= value_in(function, i) * table_(i, k);
        if (slope > zero_) entering = k;
      }
      if (entering < 0) return true;
      Index leaving = -1;
      double least = std::numeric_limits<double>::infinity();
      for (Index i = 0; i < rows(); ++i) {
        if (!(table_(i, entering) > zero_)) continue;
        const double ratio = right_side(i) / table_(i, entering);
        const bool first =
            leaving < 0 || basis_[static_cast<std::size_t>(i)] < basis_[static_cast<std::size_t>(leaving)];
        if (ratio < least - zero_ || (ratio <= least + zero_ && first)) {
          least = std::min(least, ratio);
          leaving = i;
        }
      }
      if (leaving < 0) return false;
      exchange(leaving, entering);
    }
    return true;
  }

  Eigen::VectorXd solution() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns_);
    for (Index i = 0; i < rows(); ++i)
      if (const Index k = basis_[static_cast<std::size_t>(i)]; k < unknowns_) x[k] = std::max(0.0, right_side(i));
    return x;
  }

 private:
  // Rounding of the sums over a few dozen terms; ten times more would take small forces beside large ones for zero.
  static constexpr double nothing = 1e-11;
  // What is left of the equations where they are fulfilled up to that rounding, as a part of the largest right side:
  // a hundred exchanges may each add the rounding of one.
  static constexpr double feasible = 1e-9;

  Index rows() const { return table_.rows(); }
  double right_side(Index i) const { return table_(i, table_.cols() - 1); }
  double value_in(const Eigen::VectorXd& function, Index i) const {
    const Index k = basis_[static_cast<std::size_t>(i)];
    return k < function.size() ? function[k] : 0;
  }

  void exchange(Index row, Index entering) {
    table_.row(row) /= table_(row, entering);
    for (Index i = 0; i < rows(); ++i)
      if (i != row) table_.row(i) -= table_(i, entering) * table_.row(row).eval();
    basis_[static_cast<std::size_t>(row)] = entering;
  }

  Index unknowns_;
  Eigen::MatrixXd table_;
  std::vector<Index> basis_;
  double zero_ = 0;
  double largest_right_ = 0;  // of the right sides as they were given
};

}  // namespace

std::optional<LinearOptimum> maximise(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& c) {
  Tableau tableau(A, b);
  if (!tableau.find_start()) return std::nullopt;
  const bool bounded = tableau.climb(c, A.cols());
  const Eigen::VectorXd x = tableau.solution();
  return LinearOptimum{x, c.dot(x), bounded};
}

}  // namespace poinsot::solve
