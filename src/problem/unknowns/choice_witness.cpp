#include "problem/unknowns/choice_witness.h"

#include <Eigen/QR>
#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/solve/linear/linear_program.h"

namespace poinsot::problem {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Conditions as A x = b, in units in which what was found is of the size of one.
struct AmountEquations {
  MatrixXd A;
  VectorXd b;
};

constexpr double linear_to = 1e-9;  // of the largest term

std::optional<AmountEquations> equations_of_amounts(const AmountConditions& left_of, const std::vector<double>& unit) {
  const std::size_t n = unit.size();
  const auto values_at = [&](const std::vector<double>& parts) -> std::optional<VectorXd> {
    std::vector<double> x(n);
    for (std::size_t k = 0; k < n; ++k) x[k] = parts[k] * unit[k];
    const auto left = left_of(x);
    if (!left) return std::nullopt;
    return VectorXd(Eigen::Map<const VectorXd>(left->data(), static_cast<Index>(left->size())));
  };
  const std::optional<VectorXd> none = values_at(std::vector<double>(n, 0.0));
  if (!none) return std::nullopt;
  AmountEquations found{MatrixXd(none->size(), static_cast<Index>(n)), -*none};
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> parts(n, 0.0);
    parts[k] = 1;
    const std::optional<VectorXd> with = values_at(parts);
    if (!with || with->size() != none->size()) return std::nullopt;
    found.A.col(static_cast<Index>(k)) = *with - *none;
  }
  // Elsewhere they are what these slopes make of them.
  std::vector<double> parts(n);
  for (std::size_t k = 0; k < n; ++k) parts[k] = 0.3 + 0.4 * std::cos(1.0 + 2.0 * static_cast<double>(k));
  const std::optional<VectorXd> there = values_at(parts);
  if (!there) return std::nullopt;
  const VectorXd told = found.A * Eigen::Map<const VectorXd>(parts.data(), static_cast<Index>(n)) - found.b;
  const double size = std::max(found.A.cwiseAbs().maxCoeff(), found.b.cwiseAbs().maxCoeff());
  if (!(size > 0) || (told - *there).cwiseAbs().maxCoeff() > linear_to * size) return std::nullopt;
  found.A /= size;
  found.b /= size;
  return found;
}

}  // namespace

std::optional<std::string> choice_doubt(UnknownEquations& equations,
                                        const std::vector<std::vector<std::size_t>>& amounts,
                                        const ChoicesFound& found) {
  const std::size_t n = equations.slots().size();
  std::vector<bool> is_amount(n, false);
  for (const std::vector<std::size_t>& one : amounts)
    for (const std::size_t k : one) is_amount[k] = true;
  // What may be negative, or is bounded otherwise, is no matter of these programs.
  for (std::size_t k = 0; k < n; ++k) {
    const solve::RootRange& range = equations.ranges()[k];
    if (!is_amount[k] || range.lower != 0 || range.lower_open || std::isfinite(range.upper)) return std::nullopt;
  }
  const AmountConditions conditions = [&](const std::vector<double>& x) -> std::optional<std::vector<double>> {
    const auto left = equations(x);
    return left ? std::optional(left->values) : std::nullopt;
  };
  return choice_doubt(conditions, n, amounts, found);
}

std::optional<std::string> choice_doubt(const AmountConditions& conditions, std::size_t n,
                                        const std::vector<std::vector<std::size_t>>& amounts,
                                        const ChoicesFound& found) {
  constexpr std::size_t most_amounts = 12;  // whose choices are as many as 4096
  if (found.solutions.empty() || amounts.size() > most_amounts) return std::nullopt;
  double largest = 0;
  for (const std::vector<double>& solution : found.solutions)
    for (const double value : solution) largest = std::max(largest, std::abs(value));
  if (!(largest > 0)) return std::nullopt;
  const auto linear = equations_of_amounts(conditions, std::vector<double>(n, largest));
  if (!linear) return std::nullopt;
  const auto& [A, b] = *linear;
  constexpr double same = 1e-6;  // beside the largest amount
  if (!found.exactly) {
    const auto least = solve::maximise(A, b, VectorXd::Constant(static_cast<Index>(n), -1.0));
    double total = 0;
    for (const double value : found.solutions.front()) total += value / largest;
    if (!least || std::abs(total + least->value) > same * std::max(1.0, total))
      return "another choice has a smaller total, as a linear program tells";
    return std::nullopt;
  }
  for (std::size_t subset = 0; subset < (std::size_t{1} << amounts.size()); ++subset) {
    if (std::popcount(subset) != *found.exactly) continue;
    std::vector<Index> columns;
    for (std::size_t i = 0; i < amounts.size(); ++i)
      if (subset >> i & 1)
        for (const std::size_t k : amounts[i]) columns.push_back(static_cast<Index>(k));
    const MatrixXd own = A(Eigen::all, columns);
    // Of what has more than one solution another may have been found.
    if (Eigen::ColPivHouseholderQR<MatrixXd>(own).rank() < own.cols()) continue;
    const auto possible = solve::maximise(own, b, VectorXd::Zero(own.cols()));
    if (!possible || (own * possible->x - b).cwiseAbs().maxCoeff() > linear_to) continue;
    const bool known = std::ranges::any_of(found.solutions, [&](const std::vector<double>& solution) {
      VectorXd off = Eigen::Map<const VectorXd>(solution.data(), static_cast<Index>(n)) / largest;
      for (std::size_t j = 0; j < columns.size(); ++j) off[columns[j]] -= possible->x[static_cast<Index>(j)];
      return off.cwiseAbs().maxCoeff() <= same;
    });
    if (!known) return "another choice fulfils all conditions as well, as a linear program tells";
  }
  return std::nullopt;
}

}  // namespace poinsot::problem
