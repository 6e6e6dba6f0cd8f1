// Polynomials in place of the equations of a root problem for one or two unknowns, on a part of the ranges.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "engine/solve/roots/chebyshev_pieces.h"
#include "engine/solve/roots/chebyshev_series.h"
#include "engine/solve/roots/compact_function.h"

namespace poinsot::solve {

struct Fit {
  enum class Outcome {
    polynomial,  // series stands for the equations in the box, up to error
    no_root,     // the values stay far from zero
    no_value,    // the equations have no value at any place that was tried
    divide,      // no polynomial of moderate degree fits: divide the box at `cut`, across the variable `across`
  };
  Outcome outcome = Outcome::divide;
  ChebyshevSeries series;  // of combinations of the equations, basis^T r
  Eigen::MatrixXd basis;   // orthonormal columns
  double error = 0;        // a bound for its norm
  double largest = 0;      // the largest norm of the values met
  double size = 0;         // the size of their terms
  int across = 0;
  double cut = 0;
};

class ChebyshevFitter {
 public:
  explicit ChebyshevFitter(const CompactFunction& function) : function_(function) {}

  // depth: how often a box was divided to arrive at this one. Deep boxes are tried with lower degrees.
  Fit fit(const Piece& box, int depth);

 private:
  struct Line;
  struct Square {
    Fit fit;
    Pair tail{0, 0};  // sums of the norms of the last coefficients in each variable
    bool valued = false, converged = false, excludes_zero = false;
  };
  Line along(const Piece& box, int variable, double other, int depth);
  Fit fit_line(const Piece& box, int depth);
  Fit fit_square(const Piece& box, int depth);
  Square fit_square_with(const Piece& box, Eigen::Index count0, Eigen::Index count1);
  void finish(Fit& fit, const Eigen::MatrixXd& values, double size) const;
  // The largest difference between the series and the equations at some random places; nothing where these have no
  // value.
  std::optional<double> mismatch(const Piece& box, const Fit& fit, int places);
  bool no_value_anywhere(const Piece& box, int places);
  bool far_from_zero(const Piece& box, double least, double largest) const;
  static bool smooth_inverse(const Eigen::MatrixXd& values, double size);
  Pair random_place(const Piece& box);

  const CompactFunction& function_;
  std::mt19937_64 random_{11};
  double typical_ = 0;  // a norm of the values in the first box, with which others are compared
};

}  // namespace poinsot::solve
