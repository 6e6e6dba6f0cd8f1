#include "problem/unknowns/unknown_blocks.h"

#include <algorithm>
#include <set>

#include "engine/solve/linear/decompositions.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Of the terms, for each natural size: a slope below this is rounding, a thousand times that of one operation.
constexpr double rounding_of_terms = 1e-12;
// Of columns scaled to the same size: slopes are taken over steps that terms notice by 1e-6 at least, and keep six
// digits beyond their rounding then. Columns that are meant to be independent differ in their first digits.
constexpr double rank_tolerance = 1e-8;

struct GroupSlopes {
  std::vector<MatrixXd> groups;                      // of each condition
  std::vector<std::vector<std::string>> words = {};  // of each condition

  // Slopes that are rounding beside the terms of their group are set to zero.
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

// The slopes of each group's conditions by each slot, relative to the conditions' size, at a place in the ranges
// where all have values. Steps are a part of the natural size, and wider until the conditions change.
GroupSlopes slopes_of(UnknownEquations& equations) {
  constexpr double noticed = 1e-6;  // of the terms: six digits of the change stand above their rounding then
  const std::size_t n = equations.slots().size();
  for (const std::vector<double>& x : equations.places(8)) {
    const auto base = equations.conditions_at(x);
    if (!base || base->size() != equations.system().groups.size()) continue;
    GroupSlopes slopes;
    for (const GroupConditions& group : *base) {
      slopes.groups.push_back(MatrixXd::Zero(static_cast<Index>(group.values.size()), static_cast<Index>(n)));
      slopes.words.push_back(equations.condition_words(group));
    }
    bool known = true;
    for (std::size_t k = 0; k < n && known; ++k) {
      const double scale = equations.ranges()[k].scale;
      known = false;
      for (const double step : {0.03, 30.0, 30e3}) {
        std::vector<double> moved = x;
        moved[k] += step * scale;
        const auto there = equations.conditions_at(moved);
        if (!there || !same_form(*base, *there)) break;
        known = true;
        slopes.set(k, *base, *there, step, std::abs(moved[k] / scale));
        if (slopes.largest(k) * step > noticed) break;
      }
    }
    if (known) return slopes;
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
    // The rest makes one block: it has too few conditions, or is empty.
    UnknownSystem rest;
    for (const Unknown& unknown : system_.unknowns)
      if (!found_.contains(unknown.name)) rest.unknowns.push_back(unknown);
    for (std::size_t g = 0; g < system_.groups.size(); ++g)
      if (!used_[g]) rest.groups.push_back(system_.groups[g]);
    if (!rest.unknowns.empty()) list.push_back(std::move(rest));
    return list;
  }

 private:
  // The unknowns on which a group depends and that are not found yet.
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
  // Whether the conditions that depend on nothing else suffice to determine the block.
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
  // Takes the group with the fewest new unknowns, and adds groups until they determine these.
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
  GroupSlopes slopes = slopes_of(equations);
  if (slopes.groups.empty()) return {system};
  return BlockOrder(equations, std::move(slopes.groups)).blocks();
}

namespace {

std::string with_conditions(const SystemPart& part, const std::string& relation) {
  return joined(part.unknowns) + ": " + counted(part.numbers, "unknown") + relation +
         (part.conditions.empty() ? "" : ": ") + joined(part.conditions, "; ");
}

}  // namespace

std::string shortage_in_words(const SystemPart& part) {
  return with_conditions(part, ", but " + counted(part.independent, "independent condition") + " on " +
                                   (part.numbers == 1 ? "it" : "them"));
}

std::string surplus_in_words(const SystemPart& part) {
  return with_conditions(part, " in " + counted(part.equations, "condition"));
}

namespace {

// Some rows and columns of the slopes, with their descriptions.
class PartOfSlopes {
 public:
  PartOfSlopes(const UnknownEquations& equations, const MatrixXd& slopes, const std::vector<std::string>& words)
      : slots_(equations.slots()), slopes_(slopes), words_(words) {}

  SystemPart part(const std::vector<Index>& rows, const std::vector<Index>& columns) const {
    SystemPart part;
    for (const Index k : columns) add_once(part.unknowns, slots_[static_cast<std::size_t>(k)].unknown.name);
    for (const Index i : rows) add_once(part.conditions, words_[static_cast<std::size_t>(i)]);
    part.numbers = columns.size();
    part.equations = rows.size();
    part.independent = static_cast<std::size_t>(rank_of(slopes_(rows, columns)));
    return part;
  }
  // The rows that have an entry in one of the columns, and the columns that have one in one of the rows.
  std::vector<Index> rows_with(const std::vector<Index>& columns) const {
    std::vector<Index> rows;
    for (Index i = 0; i < slopes_.rows(); ++i)
      if (!slopes_(i, columns).isZero(0)) rows.push_back(i);
    return rows;
  }
  std::vector<Index> columns_with(const std::vector<Index>& rows) const {
    std::vector<Index> columns;
    for (Index k = 0; k < slopes_.cols(); ++k)
      if (!slopes_(rows, k).isZero(0)) columns.push_back(k);
    return columns;
  }

 private:
  const std::vector<UnknownSlot>& slots_;
  const MatrixXd& slopes_;
  const std::vector<std::string>& words_;
};

// The columns that occur in a vanishing combination of columns.
std::vector<Index> dependent_columns(MatrixXd matrix) {
  std::vector<Index> columns;
  if (matrix.rows() == 0)
    for (Index k = 0; k < matrix.cols(); ++k) columns.push_back(k);
  if (matrix.size() == 0) return columns;
  for (Index k = 0; k < matrix.cols(); ++k)
    if (const double largest = matrix.col(k).cwiseAbs().maxCoeff(); largest > 0) matrix.col(k) /= largest;
  Eigen::FullPivLU<MatrixXd> lu(matrix);
  lu.setThreshold(rank_tolerance);
  if (lu.rank() == matrix.cols()) return columns;
  const MatrixXd kernel = lu.kernel();
  // Of columns of size one, in a combination of size one at least: the rank is told to 1e-8.
  constexpr double takes_part = 1e-6;
  for (Index k = 0; k < matrix.cols(); ++k)
    if (kernel.row(k).cwiseAbs().maxCoeff() > takes_part) columns.push_back(k);
  return columns;
}

}  // namespace

Balance balance_of(UnknownEquations& equations) {
  const std::size_t n = equations.slots().size();
  const GroupSlopes slopes = slopes_of(equations);
  if (slopes.groups.empty()) return {n, n, n, {}, {}};
  // The conditions that change with the unknowns, of all groups.
  MatrixXd all(0, slopes.groups.front().cols());
  std::vector<std::string> words;
  for (std::size_t g = 0; g < slopes.groups.size(); ++g)
    for (Index i = 0; i < slopes.groups[g].rows(); ++i) {
      if (slopes.groups[g].row(i).isZero(0)) continue;
      all.conservativeResize(all.rows() + 1, Eigen::NoChange);
      all.row(all.rows() - 1) = slopes.groups[g].row(i);
      words.push_back(slopes.words[g][static_cast<std::size_t>(i)]);
    }
  Balance balance{n, static_cast<std::size_t>(all.rows()), static_cast<std::size_t>(rank_of(all)), {}, {}};
  const PartOfSlopes parts(equations, all, words);
  if (const std::vector<Index> columns = dependent_columns(all); !columns.empty())
    balance.short_of = parts.part(parts.rows_with(columns), columns);
  if (const std::vector<Index> rows = dependent_columns(all.transpose()); !rows.empty())
    balance.surplus = parts.part(rows, parts.columns_with(rows));
  return balance;
}

}  // namespace poinsot::problem
