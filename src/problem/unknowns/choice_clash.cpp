#include "problem/unknowns/choice_clash.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of conditions whose rows have the size one: what a choice may leave of them. Slopes come from differences of linear
// functions and keep twelve digits; a condition that cannot hold is off in its first digits.
constexpr double tolerance = 1e-9;
// Of amounts that count as one where they balance a condition alone: what is less is rounding.
constexpr double no_amount = 1e-14;
// Of the slopes of the squares: an amount that makes the misfit less by no more than this makes it less by rounding.
constexpr double no_gain = 1e-12;

// The conditions A x = b, where x >= 0 for all unknowns but those that may have either sign.
struct LinearConditions {
  MatrixXd A;
  VectorXd b;
  std::vector<std::string> words;  // a description of each row
  std::vector<bool> signed_unknown;
};

// The least |A x - b| for x >= 0 (C. L. Lawson and R. J. Hanson, Solving Least Squares Problems, 1974, chapter 23).
double least_misfit(const MatrixXd& A, const VectorXd& b) {
  std::vector<Index> passive;
  VectorXd x = VectorXd::Zero(A.cols());
  for (Index round = 0; round < 10 * A.cols() + 10; ++round) {
    const VectorXd slope = A.transpose() * (b - A * x);
    Index best = -1;
    for (Index k = 0; k < A.cols(); ++k)
      if (std::find(passive.begin(), passive.end(), k) == passive.end() &&
          slope[k] > no_gain * A.norm() * (1 + b.norm()) && (best < 0 || slope[k] > slope[best]))
        best = k;
    if (best < 0) break;
    passive.push_back(best);
    while (!passive.empty()) {
      const VectorXd z = A(Eigen::all, passive).completeOrthogonalDecomposition().solve(b);
      if (z.minCoeff() > 0) {
        x.setZero();
        for (std::size_t i = 0; i < passive.size(); ++i) x[passive[i]] = z[static_cast<Index>(i)];
        break;
      }
      double part = 1;
      for (std::size_t i = 0; i < passive.size(); ++i)
        if (const double to = z[static_cast<Index>(i)]; to <= 0)
          part = std::min(part, x[passive[i]] / (x[passive[i]] - to));
      std::vector<Index> rest;
      for (std::size_t i = 0; i < passive.size(); ++i) {
        double& at = x[passive[i]];
        at += part * (z[static_cast<Index>(i)] - at);
        if (at > no_amount)
          rest.push_back(passive[i]);
        else
          at = 0;
      }
      if (rest.size() == passive.size()) return (A * x - b).norm();
      passive = std::move(rest);
    }
  }
  return (A * x - b).norm();
}

bool feasible(const LinearConditions& conditions, const std::vector<Index>& rows, const std::vector<Index>& columns,
              bool any_sign) {
  const VectorXd b = conditions.b(rows);
  if (b.norm() <= tolerance) return true;
  if (columns.empty()) return false;
  std::vector<VectorXd> list;
  for (const Index k : columns) {
    list.push_back(conditions.A(rows, k));
    if (any_sign || conditions.signed_unknown[static_cast<std::size_t>(k)]) list.push_back(-list.back());
  }
  MatrixXd A(b.size(), static_cast<Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double size = list[k].norm();
    A.col(static_cast<Index>(k)) = size > 0 ? VectorXd(list[k] / size) : list[k];
  }
  return least_misfit(A, b) <= tolerance * std::max(1.0, b.norm());
}

// The conditions on all unknowns, evaluated around a place in their ranges; nothing if they are not linear or have no
// value.
std::optional<LinearConditions> linear_conditions(UnknownEquations& equations) {
  const std::vector<solve::RootRange>& ranges = equations.ranges();
  const std::size_t n = ranges.size();
  const std::vector<double> at = equations.places(1).front();
  const auto values_at = [&](const std::vector<double>& x) -> std::optional<std::pair<VectorXd, VectorXd>> {
    const auto groups = equations.conditions_at(x);
    if (!groups || groups->empty()) return std::nullopt;
    std::vector<double> values, sizes;
    for (const GroupConditions& group : *groups) {
      values.insert(values.end(), group.values.begin(), group.values.end());
      sizes.insert(sizes.end(), group.values.size(), std::max(group.size, 1e-300));
    }
    return std::pair(VectorXd(Eigen::Map<VectorXd>(values.data(), static_cast<Index>(values.size()))),
                     VectorXd(Eigen::Map<VectorXd>(sizes.data(), static_cast<Index>(sizes.size()))));
  };
  const auto base = values_at(at);
  if (!base) return std::nullopt;
  LinearConditions conditions;
  conditions.A = MatrixXd::Zero(base->first.size(), static_cast<Index>(n));
  std::vector<double> far = at;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> moved = at;
    moved[k] += ranges[k].scale;
    far[k] += (k % 2 == 0 ? 3.7 : 1.9) * ranges[k].scale;
    const auto there = values_at(moved);
    if (!there || there->first.size() != base->first.size()) return std::nullopt;
    conditions.A.col(static_cast<Index>(k)) = (there->first - base->first) / ranges[k].scale;
    conditions.signed_unknown.push_back(ranges[k].lower < 0);
  }
  const Eigen::Map<const VectorXd> x(at.data(), static_cast<Index>(n)), y(far.data(), static_cast<Index>(n));
  const auto there = values_at(far);
  if (!there || there->first.size() != base->first.size()) return std::nullopt;
  const VectorXd foretold = base->first + conditions.A * (y - x);
  const VectorXd size = base->second.cwiseMax(there->second);
  // Of the terms, over several natural sizes: conditions that are linear differ by roundings, others in the first
  // digits.
  constexpr double linear = 1e-7;
  if (((there->first - foretold).cwiseAbs().array() > linear * size.array()).any()) return std::nullopt;
  conditions.b = conditions.A * x - base->first;
  const auto groups = equations.conditions_at(at);
  if (!groups) return std::nullopt;
  for (const GroupConditions& group : *groups)
    for (const std::string& words : equations.condition_words(group)) conditions.words.push_back(words);
  // Rows are scaled to one size.
  for (Index i = 0; i < conditions.A.rows(); ++i) {
    double largest = std::abs(conditions.b[i]);
    for (std::size_t k = 0; k < n; ++k)
      largest = std::max(largest, std::abs(conditions.A(i, static_cast<Index>(k))) * ranges[k].scale);
    // A row that is nothing but rounding states nothing.
    if (largest <= 1e-11 * size[i]) {
      conditions.A.row(i).setZero();
      conditions.b[i] = 0;
      continue;
    }
    conditions.A.row(i) /= largest;
    conditions.b[i] /= largest;
  }
  return conditions;
}

}  // namespace

ChoiceClash choice_clash(UnknownEquations& equations, const std::vector<std::set<std::string>>& unknowns_of) {
  ChoiceClash clash;
  const auto conditions = linear_conditions(equations);
  if (!conditions) return clash;
  const std::vector<UnknownSlot>& slots = equations.slots();
  const auto columns_of = [&](std::size_t subset) {
    std::vector<Index> columns;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      bool chosen = true, amount = false;
      for (std::size_t i = 0; i < unknowns_of.size(); ++i)
        if (unknowns_of[i].contains(slots[k].unknown.name)) {
          chosen = amount ? chosen || (subset >> i & 1) : (subset >> i & 1);
          amount = true;
        }
      if (chosen) columns.push_back(static_cast<Index>(k));
    }
    return columns;
  };
  const std::size_t everything = (std::size_t{1} << unknowns_of.size()) - 1;
  const std::vector<Index> all = columns_of(everything);
  std::vector<std::string> facts;
  for (const std::string& words : conditions->words) add_once(facts, words);
  const auto rows_of = [&](const std::vector<std::string>& wanted) {
    std::vector<Index> rows;
    for (std::size_t i = 0; i < conditions->words.size(); ++i)
      if (std::find(wanted.begin(), wanted.end(), conditions->words[i]) != wanted.end())
        rows.push_back(static_cast<Index>(i));
    return rows;
  };
  clash.told = true;
  if (feasible(*conditions, rows_of(facts), all, false)) {
    for (std::size_t subset = 0; subset <= everything; ++subset) {
      const bool fewer =
          clash.would_do.empty() || static_cast<std::size_t>(std::popcount(subset)) < clash.would_do.size();
      if (!fewer || !feasible(*conditions, rows_of(facts), columns_of(subset), false)) continue;
      clash.would_do.clear();
      for (std::size_t i = 0; i < unknowns_of.size(); ++i)
        if (subset >> i & 1) clash.would_do.push_back(i);
    }
    clash.told = !clash.would_do.empty();
    return clash;
  }
  // A condition is left out if the others clash without it too.
  for (std::size_t i = 0; i < facts.size();) {
    std::vector<std::string> others = facts;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (feasible(*conditions, rows_of(others), all, false))
      ++i;
    else
      facts = std::move(others);
  }
  clash.by_sign = feasible(*conditions, rows_of(facts), all, true);
  clash.conditions = std::move(facts);
  return clash;
}

}  // namespace poinsot::problem
