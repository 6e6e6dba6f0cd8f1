#include "poinsot/engine/solve/linear/exact_solution.h"

#include <algorithm>
#include <map>
#include <optional>

namespace poinsot::solve {
namespace {

struct Row {
  std::map<std::size_t, Formula> coefficients;  // none is zero
  Formula right_side;
};

struct Pivot {
  std::size_t row, column;
};

// Chooses the pivot for which the elimination stays short: few terms in the entry, and few new entries by Markowitz's
// count (the other entries of its row times those of its column).
std::optional<Pivot> best_pivot(const std::vector<Row>& rows, const std::vector<bool>& used) {
  std::map<std::size_t, std::size_t> in_column;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!used[i])
      for (const auto& [column, coefficient] : rows[i].coefficients) ++in_column[column];
  std::optional<Pivot> best;
  std::size_t least = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (used[i]) continue;
    for (const auto& [column, coefficient] : rows[i].coefficients) {
      const std::size_t fill = (rows[i].coefficients.size() - 1) * (in_column[column] - 1);
      const std::size_t cost = (1 + fill) * (coefficient.is_rational() ? 1 : 1 + coefficient.terms());
      if (best && cost >= least) continue;
      best = Pivot{i, column};
      least = cost;
    }
  }
  return best;
}

void subtract(Row& row, const Row& pivot, std::size_t column) {
  const auto found = row.coefficients.find(column);
  if (found == row.coefficients.end()) return;
  const Formula factor = found->second / pivot.coefficients.at(column);
  row.coefficients.erase(found);
  for (const auto& [other, coefficient] : pivot.coefficients) {
    if (other == column) continue;
    Formula& entry = row.coefficients[other];
    entry -= factor * coefficient;
    if (entry.is_zero()) row.coefficients.erase(other);
  }
  row.right_side -= factor * pivot.right_side;
}

}  // namespace

ExactSolution solve_exactly(const LinearSystemOf<Formula>& system, const std::function<Formula(std::size_t)>& open) {
  const std::size_t n = system.unknowns();
  std::vector<Row> rows(system.equations());
  const auto coefficients = system.coefficients();
  const auto right_sides = system.right_sides();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < n; ++k)
      if (!coefficients[i][k].is_zero()) rows[i].coefficients[k] = coefficients[i][k];
    rows[i].right_side = right_sides[i];
  }
  std::vector<bool> used(rows.size(), false);
  std::vector<Pivot> pivots;
  while (const std::optional<Pivot> pivot = best_pivot(rows, used)) {
    used[pivot->row] = true;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!used[i]) subtract(rows[i], rows[pivot->row], pivot->column);
    pivots.push_back(*pivot);
  }
  ExactSolution solution{std::vector<Formula>(n), std::vector<bool>(n, false), {}};
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!used[i] && !rows[i].right_side.is_zero()) solution.remainders.push_back(rows[i].right_side);
  if (open) {
    std::vector<bool> fixed(n, false);
    for (const Pivot& pivot : pivots) fixed[pivot.column] = true;
    for (std::size_t k = 0; k < n; ++k)
      if (!fixed[k]) solution.value[k] = open(k);
  }
  for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
    const Row& row = rows[pivot->row];
    Formula rest = row.right_side;
    bool determined = true;
    for (const auto& [column, coefficient] : row.coefficients) {
      if (column == pivot->column) continue;
      rest -= coefficient * solution.value[column];
      determined = determined && solution.determined[column];
    }
    solution.value[pivot->column] = rest / row.coefficients.at(pivot->column);
    solution.determined[pivot->column] = determined;
  }
  return solution;
}

}  // namespace poinsot::solve
