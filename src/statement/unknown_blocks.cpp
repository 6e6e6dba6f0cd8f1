#include "statement/unknown_blocks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>

namespace poinsot::statement {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding_of_terms = 1e-12;  // slopes below this part of the terms, per natural size, are none
constexpr double rank_tolerance = 1e-8;      // of columns of the same size

struct GroupSlopes {
  std::vector<MatrixXd> groups;  // of each group: a row for each condition, a column for each slot

  // What is rounding beside the terms of the group is zero.
  void set(std::size_t slot, const std::vector<GroupConditions>& from, const std::vector<GroupConditions>& to,
           double step, double reach) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const double size = std::max({from[g].size, to[g].size, 1e-300});
      for (std::size_t i = 0; i < from[g].values.size(); ++i) {
        const double change = to[g].values[i] - from[g].values[i];
        groups[g](static_cast<Index>(i), static_cast<Index>(slot)) =
            std::abs(change) > rounding_of_terms * size * std::max(1.0, reach) ? change / step / size : 0;
      }
    }
  }
  double largest(std::size_t slot) const {
    double largest = 0;
    for (const MatrixXd& slopes : groups)
      if (slopes.rows() > 0) largest = std::max(largest, slopes.col(static_cast<Index>(slot)).cwiseAbs().maxCoeff());
    return largest;
  }
};

bool same_form(const std::vector<GroupConditions>& a, const std::vector<GroupConditions>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const GroupConditions& x, const GroupConditions& y) {
    return x.group == y.group && x.values.size() == y.values.size();
  });
}

// How the conditions of each group change with each slot, relative to their size, at some values that make sense: by
// steps of a part of the natural size, and wider ones until the conditions notice.
std::vector<MatrixXd> slopes_of(UnknownEquations& equations) {
  constexpr double noticed = 1e-6;
  const std::size_t n = equations.slots().size();
  for (const std::vector<double>& x : equations.places(8)) {
    const auto base = equations.conditions_at(x);
    if (!base || base->size() != equations.system().groups.size()) continue;
    GroupSlopes slopes;
    for (const GroupConditions& group : *base)
      slopes.groups.push_back(MatrixXd::Zero(static_cast<Index>(group.values.size()), static_cast<Index>(n)));
    bool known = true;
    for (std::size_t k = 0; k < n && known; ++k) {
      const double scale = equations.ranges()[k].scale;
      known = false;
      for (double step = 0.03; step < 1e6; step *= 1e3) {
        std::vector<double> moved = x;
        moved[k] += step * scale;
        const auto there = equations.conditions_at(moved);
        if (!there || !same_form(*base, *there)) break;
        known = true;
        slopes.set(k, *base, *there, step, std::abs(moved[k] / scale));
        if (slopes.largest(k) * step > noticed) break;
      }
    }
    if (known) return std::move(slopes.groups);
  }
  return {};
}

Index rank_of(MatrixXd slopes) {
  if (slopes.size() == 0) return 0;
  for (Index k = 0; k < slopes.cols(); ++k) {
    if (const double largest = slopes.col(k).cwiseAbs().maxCoeff(); largest > 0) slopes.col(k) /= largest;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(slopes);
  qr.setThreshold(rank_tolerance);
  return qr.rank();
}

class BlockOrder {
 public:
  BlockOrder(const UnknownEquations& equations, std::vector<MatrixXd> slopes)
      : system_(equations.system()),
        slots_(equations.slots()),
        slopes_(std::move(slopes)),
        used_(system_.groups.size()) {}

  std::vector<UnknownSystem> blocks() {
    std::vector<UnknownSystem> list;
    while (auto block = next()) list.push_back(std::move(*block));
    // The rest together: it is short of conditions, or nothing is left.
    UnknownSystem rest;
    for (const Unknown& unknown : system_.unknowns)
      if (!found_.contains(unknown.name)) rest.unknowns.push_back(unknown);
    for (std::size_t g = 0; g < system_.groups.size(); ++g)
      if (!used_[g]) rest.groups.push_back(system_.groups[g]);
    if (!rest.unknowns.empty()) list.push_back(std::move(rest));
    return list;
  }

 private:
  // The unknowns that a group speaks of and that are not found yet.
  std::set<std::string> fresh(std::size_t group) const {
    std::set<std::string> names;
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      const auto column = slopes_[group].col(static_cast<Index>(k)).cwiseAbs();
      if (column.size() > 0 && column.maxCoeff() > 0 && !found_.contains(slots_[k].unknown.name))
        names.insert(slots_[k].unknown.name);
    }
    return names;
  }
  bool speaks_only_of(std::size_t group, const std::set<std::string>& block) const {
    const std::set<std::string> names = fresh(group);
    return !used_[group] && std::includes(block.begin(), block.end(), names.begin(), names.end());
  }
  // Enough conditions among those that speak of nothing else?
  bool is_fixed(const std::set<std::string>& block) const {
    std::vector<Index> columns;
    for (std::size_t k = 0; k < slots_.size(); ++k)
      if (block.contains(slots_[k].unknown.name)) columns.push_back(static_cast<Index>(k));
    MatrixXd all(0, static_cast<Index>(columns.size()));
    for (std::size_t g = 0; g < slopes_.size(); ++g) {
      if (!speaks_only_of(g, block)) continue;
      MatrixXd more(all.rows() + slopes_[g].rows(), all.cols());
      more << all, slopes_[g](Eigen::all, columns);
      all = std::move(more);
    }
    return rank_of(all) == all.cols();
  }
  // The group with the fewest new unknowns, and more groups until they suffice.
  std::optional<UnknownSystem> next() {
    std::set<std::string> block;
    do {
      std::size_t best = slopes_.size(), fewest = static_cast<std::size_t>(-1);
      for (std::size_t g = 0; g < slopes_.size(); ++g) {
        if (used_[g]) continue;
        std::set<std::string> more = fresh(g);
        std::erase_if(more, [&](const std::string& name) { return block.contains(name); });
        if (more.empty() || more.size() >= fewest) continue;
        fewest = more.size();
        best = g;
      }
      if (best == slopes_.size()) return std::nullopt;
      block.merge(fresh(best));
    } while (!is_fixed(block));
    UnknownSystem one;
    for (const Unknown& unknown : system_.unknowns)
      if (block.contains(unknown.name)) one.unknowns.push_back(unknown);
    for (std::size_t g = 0; g < slopes_.size(); ++g)
      if (speaks_only_of(g, block)) one.groups.push_back(system_.groups[g]);
    for (const ConditionGroup& group : one.groups)
      used_[static_cast<std::size_t>(std::find(system_.groups.begin(), system_.groups.end(), group) -
                                     system_.groups.begin())] = true;
    found_.merge(block);
    return one;
  }

  const UnknownSystem& system_;
  const std::vector<UnknownSlot>& slots_;
  std::vector<MatrixXd> slopes_;
  std::set<std::string> found_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<UnknownSystem> blocks_of(UnknownEquations& equations) {
  const UnknownSystem& system = equations.system();
  if (system.unknowns.size() < 2 || system.groups.size() < 2) return {system};
  std::vector<MatrixXd> slopes = slopes_of(equations);
  if (slopes.empty()) return {system};
  return BlockOrder(equations, std::move(slopes)).blocks();
}

Balance balance_of(UnknownEquations& equations) {
  const std::size_t n = equations.slots().size();
  const std::vector<MatrixXd> slopes = slopes_of(equations);
  if (slopes.empty()) return {n, n, n};
  MatrixXd all(0, slopes.front().cols());
  for (const MatrixXd& part : slopes) {
    MatrixXd more(all.rows() + part.rows(), all.cols());
    more << all, part;
    all = std::move(more);
  }
  Balance balance{n, 0, 0};
  for (Index i = 0; i < all.rows(); ++i) balance.conditions += all.row(i).isZero(0) ? 0 : 1;
  balance.independent = static_cast<std::size_t>(rank_of(std::move(all)));
  return balance;
}

}  // namespace poinsot::statement
