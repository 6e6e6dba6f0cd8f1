#include "problem/instant/friction_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/solve/linear/decompositions.h"
#include "engine/solve/linear/linear_program.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the largest force: what sums of a few dozen terms leave of zero.
constexpr double cone_rounding = 1e-10;
constexpr int most_planes = 200;  // that meet one cone; each halves what is left of the last one's error

// Combinations of the open directions that move none of the first `fixed` unknowns, as columns: what else is open, such
// as how a thin rod turns about itself, shares nothing.
MatrixXd share_directions(const solve::LinearSolution& solution, std::size_t fixed) {
  const auto unknowns = static_cast<Index>(solution.value.size()), count = static_cast<Index>(solution.open.size());
  MatrixXd Z(unknowns, count);
  for (Index d = 0; d < count; ++d)
    for (Index k = 0; k < unknowns; ++k)
      Z(k, d) = solution.open[static_cast<std::size_t>(d)][static_cast<std::size_t>(k)];
  const MatrixXd moved = Z.topRows(static_cast<Index>(fixed)).transpose();
  if (!(moved.size() > 0 && moved.cwiseAbs().maxCoeff() > cone_rounding * Z.cwiseAbs().maxCoeff())) return Z;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(moved);
  qr.setThreshold(cone_rounding);
  const MatrixXd Q = qr.householderQ();
  return Z * Q.rightCols(count - qr.rank());
}

std::vector<std::size_t> unknowns_of(const FrictionCone& cone) {
  std::vector<std::size_t> unknowns{cone.push, cone.first};
  if (cone.second) unknowns.push_back(*cone.second);
  return unknowns;
}

// The components of the friction by the forces of the unknowns.
template <class Force>
std::pair<double, double> friction_in(const FrictionCone& cone, const Force& force) {
  return {force(cone.first), cone.second ? force(*cone.second) : 0};
}

// The largest change of a force between bodies in each of the directions, which come in whatever unit their solution
// has. One that changes such forces by no more than rounding has its own size.
VectorXd sizes_of(const MatrixXd& shares, const std::vector<std::size_t>& one_sided,
                  const std::vector<FrictionCone>& cones) {
  VectorXd sizes = VectorXd::Zero(shares.cols());
  const auto look_at = [&](std::size_t k) {
    sizes = sizes.cwiseMax(shares.row(static_cast<Index>(k)).cwiseAbs().transpose());
  };
  for (const std::size_t k : one_sided) look_at(k);
  for (const FrictionCone& cone : cones)
    for (const std::size_t k : unknowns_of(cone)) look_at(k);
  for (Index d = 0; d < sizes.size(); ++d) {
    const double whole = shares.col(d).cwiseAbs().maxCoeff();
    if (!(sizes[d] > cone_rounding * whole)) sizes[d] = whole > 0 ? whole : 1;
  }
  return sizes;
}

// All shares, with forces in units of the largest: unknown t, one for each direction, and the margin by which no force
// pulls and no contact leaves its cone.
class ConeProgram {
 public:
  ConeProgram(const solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
              const std::vector<FrictionCone>& cones, const MatrixXd& shares)
      : solution_(solution),
        sizes_(sizes_of(shares, one_sided, cones)),
        shares_(shares * sizes_.cwiseInverse().asDiagonal()),
        directions_(shares_.cols()) {
    for (const std::size_t k : one_sided) {
      size_ = std::max(size_, std::abs(solution.value[k]));
      if (!moves(k)) continue;
      add(slopes_of(k), solution.value[k], true);
      pushes_.push_back(k);
    }
    for (const FrictionCone& cone : cones) {
      const std::vector<std::size_t> unknowns = unknowns_of(cone);
      for (const std::size_t k : unknowns) size_ = std::max(size_, std::abs(solution.value[k]));
      if (std::ranges::none_of(unknowns, [&](std::size_t k) { return moves(k); })) continue;
      cones_.push_back(cone);
      constexpr int first_planes = 8;
      for (int k = 0; k < first_planes; ++k) add_plane(cone, 2 * std::numbers::pi * k / first_planes);
    }
  }

  bool has_cones() const { return !cones_.empty() && size_ > 0; }
  double size() const { return size_; }

  // The place of the largest margin, up to one, as multiples of the directions.
  VectorXd middle() {
    VectorXd objective = VectorXd::Zero(directions_ + 1);
    objective[directions_] = 1;
    const std::optional<solve::LinearOptimum> found = climb(objective, true);
    // Some margin, however far below zero, is always there: a program without an optimum was lost in its rounding.
    VectorXd t = found ? VectorXd(found->x.head(directions_)) : VectorXd::Zero(directions_);
    const double bound = found ? found->x[directions_] : 1;
    // Where cones are round in many directions planes come to the largest margin slowly.
    if (least_margin(t) < 0 && bound > -cone_rounding)
      if (VectorXd inner = innermost(t); least_margin(inner) > least_margin(t)) t = std::move(inner);
    return VectorXd(size_ * t.cwiseQuotient(sizes_));
  }

  // The largest value of slopes . t without a margin; infinite if nothing bounds it.
  std::optional<double> largest(const std::vector<double>& slopes) {
    VectorXd objective = VectorXd::Zero(directions_ + 1);
    for (Index d = 0; d < directions_; ++d) objective[d] = slopes[static_cast<std::size_t>(d)] / sizes_[d];
    const double scale = objective.cwiseAbs().maxCoeff();
    if (!(scale > 0)) return 0;
    objective /= scale;
    const std::optional<solve::LinearOptimum> found = climb(objective, false);
    if (!found) return std::nullopt;
    if (!found->bounded) return std::numeric_limits<double>::infinity();
    return size_ * scale * found->value;
  }

 private:
  struct Row {
    VectorXd slopes;
    double constant = 0;  // in units of force
    bool margin = false;
  };

  double force_at(std::size_t k, const VectorXd& t) const { return solution_.value[k] / size_ + slopes_of(k).dot(t); }
  double least_margin(const VectorXd& t) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : pushes_) least = std::min(least, force_at(k, t));
    for (const FrictionCone& cone : cones_) {
      const auto [first, second] = friction_in(cone, [&](std::size_t k) { return force_at(k, t); });
      least = std::min(least, cone.coefficient * force_at(cone.push, t) - std::hypot(first, second));
    }
    return least;
  }

  // The place of the largest margin s from within: the least of
  //   -w s - sum log(N - s) - sum log((m N - s)^2 - F^2) - log(1 - s) - log(R^2 - t^2)
  // by Newton's method for larger and larger w, by a start at which s is far below every margin. The place is within
  // all cones by s at least, and s is known to some count/w (Boyd and Vandenberghe, Convex Optimization, ch. 11).
  VectorXd innermost(const VectorXd& start) const {
    struct Barrier {
      double value = 0;
      VectorXd slope;
      MatrixXd bend;
    };
    const Index n = directions_ + 1;
    const double reach = 10 * (1 + start.norm());
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto barrier = [&](const VectorXd& x, double weight) {
      Barrier all{-weight * x[directions_], VectorXd::Zero(n), MatrixXd::Zero(n, n)};
      all.slope[directions_] = -weight;
      const auto t = x.head(directions_);
      const double s = x[directions_];
      // -log u, with the slopes and the bends of u.
      const auto add_log = [&](double u, const VectorXd& slope, const MatrixXd& bend) {
        all.value = u > 0 ? all.value - std::log(u) : infinite;
        all.slope -= slope / u;
        all.bend += slope * slope.transpose() / (u * u) - bend / u;
      };
      const MatrixXd straight = MatrixXd::Zero(n, n);
      const auto slopes = [&](std::size_t k, double factor, double of_margin) {
        VectorXd slope = VectorXd::Zero(n);
        slope.head(directions_) = factor * slopes_of(k);
        slope[directions_] = of_margin;
        return slope;
      };
      for (const std::size_t k : pushes_) add_log(force_at(k, t) - s, slopes(k, 1, -1), straight);
      for (const FrictionCone& cone : cones_) {
        const double limit = cone.coefficient * force_at(cone.push, t) - s, first = force_at(cone.first, t),
                     second = cone.second ? force_at(*cone.second, t) : 0;
        if (!(limit > 0)) all.value = infinite;
        const VectorXd of_limit = slopes(cone.push, cone.coefficient, -1), of_first = slopes(cone.first, 1, 0),
                       of_second = cone.second ? slopes(*cone.second, 1, 0) : VectorXd::Zero(n);
        add_log(limit * limit - first * first - second * second,
                2 * (limit * of_limit - first * of_first - second * of_second),
                2 * (of_limit * of_limit.transpose() - of_first * of_first.transpose() -
                     of_second * of_second.transpose()));
      }
      add_log(1 - s, -VectorXd::Unit(n, directions_), straight);
      VectorXd place = x;
      place[directions_] = 0;
      MatrixXd ball = -2 * MatrixXd::Identity(n, n);
      ball(directions_, directions_) = 0;
      add_log(reach * reach - t.squaredNorm(), -2 * place, ball);
      return all;
    };
    VectorXd x(n);
    x.head(directions_) = start;
    x[directions_] = least_margin(start) - 1;
    constexpr double last_weight = 1e12, well_inside = 1e-6;
    constexpr int most_steps = 40, most_halvings = 40;
    for (double weight = 1; weight <= last_weight && x[directions_] < well_inside; weight *= 5)
      for (int step = 0; step < most_steps; ++step) {
        const Barrier here = barrier(x, weight);
        const VectorXd change = -here.bend.ldlt().solve(here.slope);
        const double gain = -here.slope.dot(change);
        constexpr double settled = 1e-4;
        if (!(gain > settled)) break;
        double part = 1;
        for (int i = 0; i < most_halvings && !(barrier(x + part * change, weight).value < here.value); ++i) part /= 2;
        const VectorXd next = x + part * change;
        if (!(barrier(next, weight).value < here.value)) break;
        x = next;
      }
    return x.head(directions_);
  }

  bool moves(std::size_t k) const { return slopes_of(k).cwiseAbs().maxCoeff() > cone_rounding; }
  VectorXd slopes_of(std::size_t k) const { return shares_.row(static_cast<Index>(k)).transpose(); }
  void add(const VectorXd& slopes, double constant, bool margin) { rows_.push_back({slopes, constant, margin}); }
  void add_plane(const FrictionCone& cone, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), m = cone.coefficient;
    VectorXd slopes = m * slopes_of(cone.push) - c * slopes_of(cone.first);
    double constant = m * solution_.value[cone.push] - c * solution_.value[cone.first];
    if (cone.second) {
      slopes -= s * slopes_of(*cone.second);
      constant -= s * solution_.value[*cone.second];
    }
    add(slopes, constant, true);
  }

  // Meets the cones more and more closely where the optimum lies.
  std::optional<solve::LinearOptimum> climb(const VectorXd& objective, bool with_margin) {
    VectorXd last;
    for (int planes = 0;; ++planes) {
      std::optional<solve::LinearOptimum> found = solve_program(objective, with_margin);
      if (!found || !found->bounded || planes == most_planes) return found;
      // Planes that do not move the optimum are lost in the rounding of the program.
      constexpr double unmoved = 1e-3 * cone_rounding;
      if (planes > 0 && (found->x - last).cwiseAbs().maxCoeff() <= unmoved) return found;
      last = found->x;
      const VectorXd t = found->x.head(directions_);
      bool outside = false;
      double worst = std::numeric_limits<double>::infinity();
      for (const FrictionCone& cone : cones_) {
        const auto force = [&](std::size_t k) { return solution_.value[k] / size_ + slopes_of(k).dot(t); };
        const auto [first, second] = friction_in(cone, force);
        const double margin = cone.coefficient * force(cone.push) - std::hypot(first, second);
        worst = std::min(worst, margin);
        if (margin >= (with_margin ? found->x[directions_] : 0) - 0.01 * cone_rounding) continue;
        add_plane(cone, std::atan2(second, first));
        outside = true;
      }
      // Well inside all cones, or outside whatever else is tried, more planes decide nothing.
      constexpr double well_inside = 1e-6;
      const double bound = found->x[directions_];
      const bool decided = with_margin && (worst > well_inside || bound < -well_inside);
      if (!outside || decided) return found;
    }
  }

  // Each unknown is the difference of two that are not negative, and each row leaves one.
  std::optional<solve::LinearOptimum> solve_program(const VectorXd& objective, bool with_margin) const {
    const Index n = directions_ + 1, rows = static_cast<Index>(rows_.size()) + 1;
    MatrixXd A = MatrixXd::Zero(rows, 2 * n + rows);
    VectorXd b(rows);
    for (Index i = 0; i < rows; ++i) {
      VectorXd slopes = VectorXd::Zero(n);
      double constant = 1;
      if (i + 1 < rows) {
        const Row& row = rows_[static_cast<std::size_t>(i)];
        slopes.head(directions_) = row.slopes;
        constant = row.constant / size_;
        if (row.margin && with_margin) slopes[directions_] = -1;
      } else {
        slopes[directions_] = -1;  // the margin is at most one
      }
      A.row(i).head(n) = slopes;
      A.row(i).segment(n, n) = -slopes;
      A(i, 2 * n + i) = -1;
      b[i] = -constant;
    }
    VectorXd c = VectorXd::Zero(2 * n + rows);
    c.head(n) = objective;
    c.segment(n, n) = -objective;
    std::optional<solve::LinearOptimum> found = solve::maximise(A, b, c);
    if (!found) return std::nullopt;
    const VectorXd x = found->x.head(n) - found->x.segment(n, n);
    found->x = x;
    return found;
  }

  const solve::LinearSolution& solution_;
  const VectorXd sizes_;   // of the directions
  const MatrixXd shares_;  // in units of these
  const Index directions_;
  std::vector<std::size_t> pushes_;  // and cones that open directions move
  std::vector<FrictionCone> cones_;
  std::vector<Row> rows_;
  double size_ = 0;
};

}  // namespace

void share_within_cones(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                        const std::vector<FrictionCone>& cones, std::size_t fixed) {
  if (solution.open.empty() || !solution.conflict.empty()) return;
  const MatrixXd shares = share_directions(solution, fixed);
  if (shares.cols() == 0) return;
  ConeProgram program(solution, one_sided, cones, shares);
  if (!program.has_cones()) return;
  const VectorXd change = shares * program.middle();
  for (std::size_t k = 0; k < solution.value.size(); ++k) solution.value[k] += change[static_cast<Index>(k)];
}

std::optional<double> largest_within_cones(const solve::LinearSolution& solution,
                                           const std::vector<std::size_t>& one_sided,
                                           const std::vector<FrictionCone>& cones, std::size_t fixed,
                                           const std::vector<double>& slopes) {
  if (solution.open.empty() || !solution.conflict.empty()) return std::nullopt;
  const MatrixXd shares = share_directions(solution, fixed);
  if (shares.cols() != static_cast<Index>(solution.open.size())) return std::nullopt;
  ConeProgram program(solution, one_sided, cones, shares);
  if (!program.has_cones()) return std::nullopt;
  return program.largest(slopes);
}

void keep_sticking(const std::vector<double>& from, const std::vector<FrictionCone>& cones, std::vector<double>& to) {
  const auto margin = [&](const FrictionCone& cone, double part) {
    const auto force = [&](std::size_t k) { return from[k] + part * (to[k] - from[k]); };
    const auto [first, second] = friction_in(cone, force);
    return cone.coefficient * force(cone.push) - std::hypot(first, second);
  };
  double part = 1;
  for (const FrictionCone& cone : cones) {
    if (margin(cone, 1) >= 0 || margin(cone, 0) < 0) continue;
    // The margin is concave on the way, so it vanishes once. Half the way to there is gone, clear of the limit: where
    // exactly it lies does not matter.
    double inside = 0, outside = 1;
    while (outside - inside > 1e-3 * outside && outside > 1e-12)
      (margin(cone, (inside + outside) / 2) >= 0 ? inside : outside) = (inside + outside) / 2;
    part = std::min(part, inside / 2);
  }
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[k] + part * (to[k] - from[k]);
}

}  // namespace poinsot::problem
