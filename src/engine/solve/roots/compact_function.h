// The equations of a root problem for one or two unknowns, made a function on a finite square.
#pragma once

#include <optional>
#include <vector>

#include "engine/solve/roots/chebyshev_pieces.h"
#include "engine/solve/roots/compact_range.h"
#include "engine/solve/roots/root_function.h"

namespace poinsot::solve {

// The equations as a function of t in the square |t_k| <= 1, see CompactRange; with one unknown t_1 plays no part.
class CompactFunction {
 public:
  // Measures how the equations grow towards infinite ends. The function must outlive this object.
  CompactFunction(RootFunction& function, double reach);

  RootFunction& function() const { return function_; }
  int unknowns() const { return static_cast<int>(ranges_.size()); }
  Piece whole() const;

  std::optional<RootSample> at(const Pair& t) const;  // the values times their weights, and the size of their terms
  Eigen::VectorXd u(const Pair& t) const;
  // Turns slopes of the weighted values by t into d r / d u. This holds where the values are zero.
  Eigen::MatrixXd unweighted(const Pair& t, const Eigen::MatrixXd& slopes) const;

 private:
  void measure_growth(std::size_t variable, double reach);

  RootFunction& function_;
  std::vector<CompactRange> ranges_;
};

}  // namespace poinsot::solve
