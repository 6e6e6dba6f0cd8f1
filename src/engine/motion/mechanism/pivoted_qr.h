// Householder QR with column pivoting of small matrices, in memory made once: A P = Q R.
//
// For a handful of rows and columns, where a call must allocate nothing and cost well under a microsecond.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace poinsot::detail {

class PivotedQr {
 public:
  // The largest matrix that will be factored.
  void reserve(int most_rows, int most_columns);

  // Before factor: the matrix to be factored, column after column.
  void resize(int rows, int columns) {
    rows_ = rows;
    columns_ = columns;
  }
  double* column(int j) { return matrix_.data() + j * rows_; }

  // Columns are chosen by the largest part left, those of the higher class before all others while more than tolerance
  // is left of one (classes: one number per column, 0 or 1; empty: all alike). Stops when no column has more left than
  // tolerance, an absolute size, or most_rank are chosen.
  void factor(double tolerance, std::span<const char> classes = {}, int most_rank = std::numeric_limits<int>::max());

  int rank() const { return rank_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  // The column that stands at place k of A P.
  int chosen(int k) const { return order_[static_cast<std::size_t>(k)]; }
  // Entry of R; k >= rank: columns not chosen.
  double R(int i, int k) const { return matrix_[static_cast<std::size_t>(chosen(k) * rows_ + i)]; }
  // The smallest pivot relative to the largest; 1 without pivots.
  double least_pivot() const;

  // x = Q x and x = Q^T x for a vector of `rows` numbers.
  void apply(double* x) const;
  void apply_transposed(double* x) const;
  // The leading rank by rank block of R: x = R^-1 x and x = R^-T x.
  void solve_upper(double* x) const;
  void solve_transposed(double* x) const;

 private:
  // Reflects x by the reflector of step k.
  void reflect_at(int k, double* x) const;

  int rows_ = 0, columns_ = 0, rank_ = 0;
  std::vector<double> matrix_;   // R above, below the reflectors without their leading entry
  std::vector<double> leading_;  // of each reflector
  std::vector<double> factor_;   // 2 / (reflector . reflector)
  std::vector<double> left_;     // norm of what is left of each column
  std::vector<int> order_;
};

}  // namespace poinsot::detail
