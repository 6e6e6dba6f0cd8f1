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

  // Before factor: the matrix to be factored, each of its entries.
  void resize(int rows, int columns);
  double& entry(int i, int j) { return row(i)[j]; }

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
  double R(int i, int k) const { return matrix_[static_cast<std::size_t>(i * stride_ + k)]; }
  // The smallest pivot relative to the largest; 1 without pivots.
  double least_pivot() const;

  // x = Q x and x = Q^T x for a vector of `rows` numbers.
  void apply(double* x) const;
  void apply_transposed(double* x) const;
  // X = Q^T X for a matrix of `rows` rows, row after row: each of its columns to the last bit as it is alone.
  void apply_transposed(double* X, int columns);
  // The leading rank by rank block of R: x = R^-1 x and x = R^-T x.
  void solve_upper(double* x) const;
  void solve_transposed(double* x) const;

 private:
  double* row(int i) { return matrix_.data() + i * stride_; }
  const double* reflector(int k) const { return reflectors_.data() + k * rows_; }
  void choose(int k, int pivot);
  void find_what_is_left(int k);
  // Reflects x by the reflector of step k.
  void reflect_at(int k, double* x) const;

  int rows_ = 0, columns_ = 0, rank_ = 0;
  int stride_ = 0;                  // from row to row: columns, filled up with zeros to whole strips
  std::vector<double> matrix_;      // its columns as they stand in A P; R above, zeros below
  std::vector<double> reflectors_;  // of each step, without the leading entry: rows below the step count
  std::vector<double> leading_;     // of each reflector
  std::vector<double> factor_;      // 2 / (reflector . reflector)
  std::vector<double> left_;        // the square of the norm of what is left of each column of A P
  std::vector<double> strip_;       // columns that are reflected together
  std::vector<int> order_;
};

}  // namespace poinsot::detail
