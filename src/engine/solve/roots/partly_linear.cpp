#include "engine/solve/roots/partly_linear.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/solve/linear/held_elimination.h"
#include "engine/solve/roots/linear_roots.h"
#include "engine/solve/roots/scattered_starts.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// How far a linear equation may be off the line through two of its values: as a part of its changes, which are known
// from steps of a natural size, and as a part of the terms of all equations, of which some 500 roundings are left.
constexpr double linear_tolerance = 1e-9;
constexpr double rounding_of_all = 1e-13;

using Marks = Eigen::Array<bool, Eigen::Dynamic, 1>;

// Finds by differences which equations have no product of two given unknowns, or no square of one.
class Structure {
 public:
  explicit Structure(RootFunction& function) : function_(function), n_(function.unknowns()) {}

  // Returns whether the equations have values at enough places to tell.
  bool look() {
    int seen = 0;
    const int enough = function_.problem().corners ? 12 : 2;
    std::vector<VectorXd> places = starts_at_random(function_.problem(), function_.problem().corners ? 40 : 8);
    places.insert(places.begin(), middle_of_ranges(function_.problem()));
    for (const VectorXd& u : places) {
      if (seen < enough && look_at(u)) ++seen;
      if (function_.limit().spent()) return false;
    }
    return seen >= std::min(2, enough);
  }

  // The largest set of unknowns that enter linearly together in at least as many equations as there are unknowns in
  // all, and these equations.
  struct Linear {
    std::vector<Index> unknowns, equations;
  };
  Linear linear() const {
    Linear best;
    for (unsigned subset = 1; subset < (1U << n_); ++subset) {
      if (static_cast<std::size_t>(std::popcount(subset)) <= best.unknowns.size()) continue;
      Linear found;
      Marks marks = Marks::Constant(rows_, true);
      for (Index i = 0; i < n_; ++i) {
        if (!(subset >> i & 1)) continue;
        found.unknowns.push_back(i);
        for (Index j = i; j < n_; ++j)
          if (subset >> j & 1) marks = marks && linear_[static_cast<std::size_t>(i * n_ + j)];
      }
      for (Index row = 0; row < rows_; ++row)
        if (marks[row]) found.equations.push_back(row);
      if (static_cast<Index>(found.equations.size()) >= n_) best = std::move(found);
    }
    return best;
  }

 private:
  // Takes mixed differences of second order at a place. Their steps are so large that rounding_of_all does not
  // matter.
  bool look_at(const VectorXd& u) {
    const auto base = function_.smooth_at(u);
    if (!base || (rows_ > 0 && base->values.size() != rows_)) return false;
    if (linear_.empty()) {
      rows_ = base->values.size();
      linear_.assign(static_cast<std::size_t>(n_ * n_), Marks::Constant(rows_, true));
    }
    const auto values = [&](const VectorXd& v) -> std::optional<RootSample> {
      const auto sample = function_.smooth_at(v);
      return sample && sample->values.size() == base->values.size() ? sample : std::nullopt;
    };
    std::vector<double> steps;
    std::vector<RootSample> moved;
    for (Index k = 0; k < n_; ++k) {
      std::optional<RootSample> there;
      double step = 0.37;
      for (const double way : {0.37, -0.37}) {
        VectorXd v = u;
        v[k] += way;
        step = way;
        there = values(v);
        if (there) break;
      }
      if (!there) return false;
      steps.push_back(step);
      moved.push_back(*there);
    }
    for (Index i = 0; i < n_; ++i)
      for (Index j = i; j < n_; ++j) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        VectorXd v = u;
        v[i] += steps[a];
        v[j] += steps[b];
        const auto there = values(v);
        if (!there) return false;
        const VectorXd changes =
            (moved[a].values - base->values).cwiseAbs() + (moved[b].values - base->values).cwiseAbs();
        const VectorXd mixed = there->values - moved[a].values - moved[b].values + base->values;
        const double size = std::max({base->size, moved[a].size, moved[b].size, there->size});
        Marks& marks = linear_[static_cast<std::size_t>(i * n_ + j)];
        marks = marks && mixed.array().abs() <= linear_tolerance * changes.array() + rounding_of_all * size;
      }
    return true;
  }

  RootFunction& function_;
  Index n_, rows_ = 0;
  std::vector<Marks> linear_;  // for each pair of unknowns a mark for each equation
};

// The equations after elimination of the unknowns that enter linearly.
class Elimination {
 public:
  Elimination(RootFunction& function, Structure::Linear structure)
      : function_(function),
        linear_(std::move(structure.unknowns)),
        equations_(std::move(structure.equations)),
        reference_(middle_of_ranges(function.problem())) {
    for (Index k = 0; k < function.unknowns(); ++k)
      if (std::find(linear_.begin(), linear_.end(), k) == linear_.end()) others_.push_back(k);
  }

  const std::vector<Index>& others() const { return others_; }

  // Fixes units and pivots at the best of some places. Returns whether the linear unknowns are determined there.
  bool hold() {
    for (const VectorXd& u : starts_at_random(function_.problem(), 6)) {
      auto rows = rows_at(u(others_));
      if (!rows) continue;
      if (column_.size() == 0) {
        unit_ = std::max(rows->size, 1e-300);
        column_ = VectorXd::Ones(rows->A.cols());
        for (Index k = 0; k < rows->A.cols(); ++k)
          if (const double largest = rows->A.col(k).cwiseAbs().maxCoeff(); largest > 0) column_[k] = unit_ / largest;
        rows->A /= unit_;
      }
      const HeldPivots pivots = pivots_of(rows->A * column_.asDiagonal());
      if (!pivots_ || pivots.rank > pivots_->rank) pivots_ = pivots;
    }
    return pivots_ && pivots_->rank == static_cast<Index>(linear_.size());
  }

  std::optional<Remainder> remainder(const VectorXd& others) {
    const auto rows = rows_at(others);
    if (!rows) return std::nullopt;
    return remainder_of(*pivots_, rows->A * column_.asDiagonal(), rows->b,
                        VectorXd::Constant(rows->b.size(), rows->size));
  }

  // All unknowns in natural sizes, from the others and the solution for the linear ones.
  VectorXd completed(const VectorXd& others, const Remainder& remainder) const {
    VectorXd u = reference_;
    for (std::size_t i = 0; i < others_.size(); ++i) u[others_[i]] = others[static_cast<Index>(i)];
    for (std::size_t i = 0; i < linear_.size(); ++i)
      u[linear_[i]] += column_[static_cast<Index>(i)] * remainder.solution[static_cast<Index>(i)];
    return u;
  }

 private:
  // The equations that are linear in these unknowns u, written as A (u - reference) = b.
  struct Rows {
    MatrixXd A;
    VectorXd b;
    double size = 0;
  };
  std::optional<Rows> rows_at(const VectorXd& others) {
    VectorXd u = reference_;
    for (std::size_t i = 0; i < others_.size(); ++i) u[others_[i]] = others[static_cast<Index>(i)];
    const auto base = function_.smooth_at(u);
    if (!base || base->values.size() <= equations_.back()) return std::nullopt;
    Rows rows{MatrixXd(static_cast<Index>(equations_.size()), static_cast<Index>(linear_.size())),
              -base->values(equations_), base->size};
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      VectorXd moved = u;
      moved[linear_[i]] += 1;
      const auto there = function_.smooth_at(moved);
      if (!there || there->values.size() != base->values.size()) return std::nullopt;
      rows.A.col(static_cast<Index>(i)) = (there->values - base->values)(equations_);
      rows.size = std::max(rows.size, there->size);
    }
    if (unit_ > 0) {
      rows.A /= unit_;
      rows.b /= unit_;
      rows.size /= unit_;
    }
    return rows;
  }

  RootFunction& function_;
  std::vector<Index> linear_, others_, equations_;
  VectorXd reference_, column_;
  double unit_ = 0;
  std::optional<HeldPivots> pivots_;
};

}  // namespace

std::optional<PartlyLinearRoots> partly_linear_roots(RootFunction& function, Work most) {
  constexpr Index most_unknowns = 10, most_left = 2;
  if (function.unknowns() > most_unknowns) return std::nullopt;
  Structure structure(function);
  if (!structure.look()) return std::nullopt;
  Structure::Linear linear = structure.linear();
  const Index left = function.unknowns() - static_cast<Index>(linear.unknowns.size());
  if (linear.unknowns.empty() || left < 1 || left > most_left) return std::nullopt;
  Elimination elimination(function, std::move(linear));
  if (!elimination.hold()) return std::nullopt;
  RootProblem reduced;
  reduced.corners = function.problem().corners;
  for (const Index k : elimination.others()) {
    RootRange range = function.problem().ranges[static_cast<std::size_t>(k)];
    range.lower /= range.scale;
    range.upper /= range.scale;
    range.scale = 1;
    reduced.ranges.push_back(range);
  }
  reduced.equations = [&](const std::vector<double>& x) -> std::optional<RootEquations> {
    const auto rest = elimination.remainder(Eigen::Map<const VectorXd>(x.data(), static_cast<Index>(x.size())));
    if (!rest) return std::nullopt;
    return RootEquations{{rest->values.begin(), rest->values.end()}, rest->size, {}, 0};
  };
  const Roots roots = find_roots(reduced, most);
  if (roots.open) return std::nullopt;
  PartlyLinearRoots result;
  result.complete = roots.search == RootSearch::certified || roots.search == RootSearch::linear;
  result.reach = roots.reach;
  for (const std::vector<double>& point : roots.points) {
    const Eigen::Map<const VectorXd> others(point.data(), static_cast<Index>(point.size()));
    if (const auto rest = elimination.remainder(others)) result.places.push_back(elimination.completed(others, *rest));
  }
  return result;
}

}  // namespace poinsot::solve
