// Eigen's QR decomposition with pivots among the columns, made column by column so that a budget can end it: of a
// thousand unknowns it takes a second.
#pragma once

#include "engine/solve/linear/decompositions.h"

namespace poinsot::solve {

class ColumnPivotedQr : public Eigen::ColPivHouseholderQR<Eigen::MatrixXd> {
 public:
  // To the last bit that of Eigen::ColPivHouseholderQR(A). Throws BudgetEnded.
  explicit ColumnPivotedQr(const Eigen::MatrixXd& A);

 private:
  void choose(Eigen::Index k, double negligible);
  void eliminate(Eigen::Index k);
  void take_from_norms(Eigen::Index k);
};

}  // namespace poinsot::solve
