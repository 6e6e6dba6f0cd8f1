#include "poinsot/engine/solve/linear/traced_elimination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace poinsot::solve {
namespace {

// Of the size of its equation: a smaller pivot is what rounding leaves of zero, or nearly so.
constexpr double least_pivot = 1e-9;
// Of the largest entry beside it: elimination with smaller pivots would let rounding grow.
constexpr double least_beside = 0.1;

class TracedElimination {
 public:
  TracedElimination(std::vector<TracedEquation> rows, std::size_t unknowns)
      : rows_(std::move(rows)),
        used_(rows_.size(), false),
        row_scale_(rows_.size(), 1),
        column_scale_(unknowns, 1),
        sizes_(rows_.size()) {
    for (TracedEquation& row : rows_)
      std::erase_if(row.coefficients, [](const auto& entry) { return vanishes(entry.second); });
    equilibrate();
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const auto& [column, coefficient] : rows_[i].coefficients)
        sizes_[i] += abs(coefficient) * Traced(column_scale_[column]);
  }

  TracedSolution solution(const std::function<Traced(std::size_t)>& open) {
    TracedSolution found;
    std::vector<Pivot> pivots;
    while (const std::optional<Pivot> pivot = best_pivot()) {
      used_[pivot->row] = true;
      const Traced sound =
          abs(rows_[pivot->row].coefficients.at(pivot->column)) * Traced(column_scale_[pivot->column]) -
          Traced(least_pivot) * sizes_[pivot->row];
      if (!is_constant(sound)) found.sound.push_back(sound);
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!used_[i]) subtract(rows_[i], rows_[pivot->row], pivot->column);
      pivots.push_back(*pivot);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (used_[i]) continue;
      if (!rows_[i].coefficients.empty()) throw std::domain_error("what equations determine is a special case here");
      if (!vanishes(rows_[i].right_side)) found.remainders.push_back(rows_[i].right_side);
    }
    found.value.resize(column_scale_.size());
    std::vector<bool> determined(found.value.size(), false);
    for (const Pivot& pivot : pivots) determined[pivot.column] = true;
    for (std::size_t k = 0; k < determined.size(); ++k)
      if (!determined[k]) found.value[k] = open(k);
    for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
      const TracedEquation& row = rows_[pivot->row];
      Traced rest = row.right_side;
      for (const auto& [column, coefficient] : row.coefficients)
        if (column != pivot->column) rest -= coefficient * found.value[column];
      found.value[pivot->column] = rest / row.coefficients.at(pivot->column);
    }
    return found;
  }

 private:
  struct Pivot {
    std::size_t row, column;
  };

  double scaled(std::size_t row, std::size_t column, const Traced& coefficient) const {
    return std::fabs(plain(coefficient)) * row_scale_[row] * column_scale_[column];
  }

  // Gives rows and columns scales such that the largest entry of each is one at the sample.
  void equilibrate() {
    for (int pass = 0; pass < 3; ++pass) {
      std::vector<double> largest(column_scale_.size(), 0);
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        double in_row = 0;
        for (const auto& [column, coefficient] : rows_[i].coefficients)
          in_row = std::max(in_row, scaled(i, column, coefficient));
        if (in_row > 0) row_scale_[i] /= in_row;
        for (const auto& [column, coefficient] : rows_[i].coefficients)
          largest[column] = std::max(largest[column], scaled(i, column, coefficient));
      }
      for (std::size_t k = 0; k < largest.size(); ++k)
        if (largest[k] > 0) column_scale_[k] /= largest[k];
    }
  }

  // The pivot that fills in least by Markowitz's count among those that are large enough.
  std::optional<Pivot> best_pivot() const {
    std::vector<std::size_t> in_column(column_scale_.size(), 0);
    std::vector<double> largest(column_scale_.size(), 0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!used_[i])
        for (const auto& [column, coefficient] : rows_[i].coefficients) {
          ++in_column[column];
          largest[column] = std::max(largest[column], scaled(i, column, coefficient));
        }
    std::optional<Pivot> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    double size = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (used_[i]) continue;
      for (const auto& [column, coefficient] : rows_[i].coefficients) {
        const double here = scaled(i, column, coefficient);
        if (here < std::max(10 * least_pivot, least_beside * largest[column])) continue;
        const std::size_t fill = (rows_[i].coefficients.size() - 1) * (in_column[column] - 1);
        if (fill > least || (fill == least && here <= size)) continue;
        best = Pivot{i, column};
        least = fill;
        size = here;
      }
    }
    return best;
  }

  static void subtract(TracedEquation& row, const TracedEquation& pivot, std::size_t column) {
    const auto found = row.coefficients.find(column);
    if (found == row.coefficients.end()) return;
    const Traced factor = found->second / pivot.coefficients.at(column);
    row.coefficients.erase(found);
    for (const auto& [other, coefficient] : pivot.coefficients) {
      if (other == column) continue;
      Traced& entry = row.coefficients[other];
      entry -= factor * coefficient;
      if (vanishes(entry)) row.coefficients.erase(other);
    }
    row.right_side -= factor * pivot.right_side;
  }

  std::vector<TracedEquation> rows_;
  std::vector<bool> used_;
  std::vector<double> row_scale_, column_scale_;
  std::vector<Traced> sizes_;  // of each equation as it was given
};

}  // namespace

TracedSolution eliminated(std::vector<TracedEquation> equations, std::size_t unknowns,
                          const std::function<Traced(std::size_t)>& open) {
  return TracedElimination(std::move(equations), unknowns).solution(open);
}

}  // namespace poinsot::solve
