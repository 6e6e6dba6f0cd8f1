#include "problem/instant/friction_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "engine/solve/linear/cone_program.h"
#include "engine/solve/linear/decompositions.h"
#include "engine/solve/linear/linear_program.h"

namespace poinsot::problem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the largest force: what sums of a few dozen terms leave of zero.
constexpr double cone_rounding = 1e-10;

// Combinations of the columns that vanish in some rows.
MatrixXd that_leave(const MatrixXd& Z, const MatrixXd& rows) {
  if (!(rows.size() > 0 && rows.cwiseAbs().maxCoeff() > cone_rounding * Z.cwiseAbs().maxCoeff())) return Z;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(MatrixXd(rows.transpose()));
  qr.setThreshold(cone_rounding);
  const MatrixXd Q = qr.householderQ();
  return Z * Q.rightCols(Z.cols() - qr.rank());
}

// Combinations of the open directions that move none of the first `fixed` unknowns, as columns: what else is open, such
// as how a thin rod turns about itself, shares nothing.
MatrixXd share_directions(const solve::LinearSolution& solution, std::size_t fixed) {
  const auto unknowns = static_cast<Index>(solution.value.size()), count = static_cast<Index>(solution.open.size());
  MatrixXd Z(unknowns, count);
  for (Index d = 0; d < count; ++d)
    for (Index k = 0; k < unknowns; ++k)
      Z(k, d) = solution.open[static_cast<std::size_t>(d)][static_cast<std::size_t>(k)];
  return that_leave(Z, Z.topRows(static_cast<Index>(fixed)));
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

// All shares, with forces in units of the largest: unknown u, the changes of the forces between bodies along
// directions that stand across one another.
class SharesInCones {
 public:
  SharesInCones(const solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                const std::vector<FrictionCone>& cones, const MatrixXd& shares, bool with_unmoved = false)
      : solution_(solution), sizes_(sizes_of(shares, one_sided, cones)) {
    std::vector<std::size_t> between;
    const auto look_at = [&](std::size_t k) {
      size_ = std::max(size_, std::abs(solution.value[k]));
      if (std::ranges::find(between, k) == between.end()) between.push_back(k);
    };
    for (const std::size_t k : one_sided) look_at(k);
    for (const FrictionCone& cone : cones)
      for (const std::size_t k : unknowns_of(cone)) look_at(k);
    MatrixXd changes(static_cast<Index>(between.size()), shares.cols());
    for (Index i = 0; i < changes.rows(); ++i)
      changes.row(i) = shares.row(static_cast<Index>(between[static_cast<std::size_t>(i)]));
    changes = changes * sizes_.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<MatrixXd> qr(changes);
    qr.setThreshold(cone_rounding);
    directions_ = qr.rank();
    changes_ = changes;
    across_ = MatrixXd(qr.householderQ()).leftCols(directions_);
    for (std::size_t i = 0; i < between.size(); ++i)
      slopes_[between[i]] = across_.row(static_cast<Index>(i)).transpose();
    for (const std::size_t k : one_sided)
      if (moves(k) || with_unmoved) pushes_.push_back(k);
    for (const FrictionCone& cone : cones)
      if (with_unmoved || std::ranges::any_of(unknowns_of(cone), [&](std::size_t k) { return moves(k); }))
        cones_.push_back(cone);
  }

  bool has_cones() const { return !cones_.empty() && size_ > 0 && directions_ > 0; }

  // As multiples of the directions: the place of the largest margin.
  VectorXd middle() const { return size_ * along_directions(innermost()); }

  // The place of the largest margin by which no force pulls and no contact leaves its cone, up to one; well inside the
  // cones it is near that.
  VectorXd innermost() const {
    VectorXd best = VectorXd::Zero(directions_);
    double largest = -std::numeric_limits<double>::infinity();
    // The last steps may lose in rounding what those before had.
    const auto enough = [&](const solve::ConeOptimum& found) {
      constexpr double clear = 1e-6, near = 0.1;
      const double margin = least_margin(found.x.head(directions_)), bound = -found.bound;
      if (margin > largest) {
        largest = margin;
        best = found.x.head(directions_);
      }
      return (margin > clear || bound < -clear) && bound - margin <= near * std::abs(bound);
    };
    static_cast<void>(solve::minimise(margin_program(), enough));
    return best;
  }

  // What bounds that margin.
  std::optional<StickingBound> bound() const {
    const std::optional<solve::ConeOptimum> found = solve::minimise(margin_program());
    if (!found) return std::nullopt;
    StickingBound bound{{}, {}, -found->bound};
    Index row = 0;
    for (const std::size_t k : pushes_) bound.pushes.emplace_back(k, found->multipliers[row++]);
    for (const FrictionCone& cone : cones_) {
      const auto next = [&] { return found->multipliers[row++]; };
      if (cone.second) {
        const double limit = next(), first = next();
        bound.cones.push_back({cone, limit, first, next()});
      } else {
        const double forwards = next(), backwards = next();
        bound.cones.push_back({cone, forwards + backwards, backwards - forwards, 0});
      }
    }
    return bound;
  }

  // The largest value of slopes . t; infinite if nothing bounds it, nothing if that is not known.
  std::optional<double> largest(const std::vector<double>& slopes) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    VectorXd g(changes_.cols());
    for (Index d = 0; d < g.size(); ++d) g[d] = slopes[static_cast<std::size_t>(d)] / sizes_[d];
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> of_forces = by_forces();
    const VectorXd seen = of_forces.solve(VectorXd(changes_ * g));
    if ((seen - g).cwiseAbs().maxCoeff() > cone_rounding * g.cwiseAbs().maxCoeff()) return infinite;
    const MatrixXd by_u = of_forces.solve(across_);
    VectorXd objective = by_u.transpose() * g;
    const double scale = objective.size() > 0 ? objective.cwiseAbs().maxCoeff() : 0;
    if (!(scale > 0)) return 0;
    objective /= scale;
    // Where the cones leave hardly any room what bounds the value is lost in rounding, but for planes.
    const bool flat = std::ranges::none_of(cones_, [](const FrictionCone& cone) { return cone.second.has_value(); });
    constexpr double room = 1e-8, grows = 1e-6;
    if (flat) {
      const std::optional<solve::LinearOptimum> found = largest_between_planes(objective);
      if (!found) return std::nullopt;
      return found->bounded ? size_ * scale * found->value : infinite;
    }
    if (!(least_margin(innermost()) > room)) return std::nullopt;
    const auto largest_up_to = [&](double reach) -> std::optional<double> {
      solve::ConeProgram program = margin_program(false);
      program.c = -objective;
      program.reach = reach;
      const std::optional<solve::ConeOptimum> found = solve::minimise(program);
      if (!found) return std::nullopt;
      const double value = objective.dot(found->x);
      constexpr double known = 1e-9;
      if (-found->bound - value > known * std::max(1.0, std::abs(value))) return std::nullopt;
      return value;
    };
    constexpr double reach = 1e2;  // of the largest force
    const std::optional<double> near = largest_up_to(reach), far = largest_up_to(2 * reach);
    if (!near || !far) return std::nullopt;
    return *far > *near + grows ? infinite : size_ * scale * *near;
  }

 private:
  bool moves(std::size_t k) const {
    const VectorXd& slopes = slopes_.at(k);
    return slopes.size() > 0 && slopes.cwiseAbs().maxCoeff() > cone_rounding;
  }
  double force_at(std::size_t k, const VectorXd& u) const { return solution_.value[k] / size_ + slopes_.at(k).dot(u); }
  double least_margin(const VectorXd& u) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : pushes_) least = std::min(least, force_at(k, u));
    for (const FrictionCone& cone : cones_) {
      const auto [first, second] = friction_in(cone, [&](std::size_t k) { return force_at(k, u); });
      least = std::min(least, cone.coefficient * force_at(cone.push, u) - std::hypot(first, second));
    }
    return least;
  }
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> by_forces() const {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(changes_.rows(), changes_.cols());
    decomposition.setThreshold(cone_rounding);
    decomposition.compute(changes_);
    return decomposition;
  }
  VectorXd along_directions(const VectorXd& u) const {
    const VectorXd t = by_forces().solve(VectorXd(across_ * u));
    return t.cwiseQuotient(sizes_);
  }

  // The largest margin s, which is the last unknown and at most one; or without it the shares alone.
  solve::ConeProgram margin_program(bool with_margin = true) const {
    const Index n = directions_ + (with_margin ? 1 : 0);
    std::vector<VectorXd> rows;
    std::vector<double> constants;
    solve::ConeProgram program;
    const auto add = [&](const VectorXd& slopes, double constant, bool margin) {
      VectorXd row = VectorXd::Zero(n);
      row.head(directions_) = -slopes;
      if (margin && with_margin) row[directions_] = 1;
      rows.push_back(std::move(row));
      constants.push_back(constant);
    };
    const auto force = [&](std::size_t k) { return solution_.value[k] / size_; };
    for (const std::size_t k : pushes_) {
      add(slopes_.at(k), force(k), true);
      program.sizes.push_back(1);
    }
    for (const FrictionCone& cone : cones_) {
      const double m = cone.coefficient;
      if (cone.second) {
        add(m * slopes_.at(cone.push), m * force(cone.push), true);
        for (const std::size_t k : {cone.first, *cone.second}) add(slopes_.at(k), force(k), false);
        program.sizes.push_back(3);
        continue;
      }
      for (const int sign : {1, -1}) {
        add(m * slopes_.at(cone.push) - sign * slopes_.at(cone.first), m * force(cone.push) - sign * force(cone.first),
            true);
        program.sizes.push_back(1);
      }
    }
    if (with_margin) {
      add(VectorXd::Zero(directions_), 1, true);
      program.sizes.push_back(1);
    }
    program.G = MatrixXd(static_cast<Index>(rows.size()), n);
    program.h = Eigen::Map<VectorXd>(constants.data(), static_cast<Index>(constants.size()));
    for (Index i = 0; i < program.G.rows(); ++i) program.G.row(i) = rows[static_cast<std::size_t>(i)].transpose();
    program.c = with_margin ? VectorXd(-VectorXd::Unit(n, directions_)) : VectorXd::Zero(n);
    return program;
  }

  // For cones that are two planes each. Each unknown is the difference of two that are not negative, and each row
  // leaves one.
  std::optional<solve::LinearOptimum> largest_between_planes(const VectorXd& objective) const {
    const solve::ConeProgram program = margin_program(false);
    const Index n = directions_, rows = program.G.rows();
    MatrixXd A(rows, 2 * n + rows);
    A << program.G, -program.G, MatrixXd::Identity(rows, rows);
    VectorXd c = VectorXd::Zero(2 * n + rows);
    c.head(n) = objective;
    c.segment(n, n) = -objective;
    return solve::maximise(A, program.h, c);
  }

  const solve::LinearSolution& solution_;
  const VectorXd sizes_;                    // of the directions
  MatrixXd changes_, across_;               // of the forces between bodies, by the directions in these units and by u
  Index directions_ = 0;                    // of u
  std::map<std::size_t, VectorXd> slopes_;  // of each of these forces by u
  std::vector<std::size_t> pushes_;         // and cones that open directions move
  std::vector<FrictionCone> cones_;
  double size_ = 0;
};

// A contact that carries nothing in any share carries nothing, and what is open leaves it so.
void hold_at_apexes(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                    const std::vector<FrictionCone>& cones, std::size_t fixed) {
  constexpr double nothing = 1e-11;  // of the largest force: a hundred times more would move limits of sticking
  double size = 0;
  for (const FrictionCone& cone : cones)
    for (const std::size_t k : unknowns_of(cone)) size = std::max(size, std::abs(solution.value[k]));
  std::vector<std::size_t> none;
  for (const FrictionCone& cone : cones) {
    const std::vector<std::size_t> own = unknowns_of(cone);
    if (std::ranges::any_of(own, [&](std::size_t k) { return std::abs(solution.value[k]) > nothing * size; })) continue;
    std::vector<double> slopes;
    for (const std::vector<double>& direction : solution.open) slopes.push_back(direction[cone.push]);
    const std::optional<double> most = largest_within_cones(solution, one_sided, cones, fixed, slopes);
    if (most && *most <= nothing * size) none.insert(none.end(), own.begin(), own.end());
  }
  if (none.empty()) return;
  const MatrixXd Z = share_directions(solution, 0);
  MatrixXd rows(static_cast<Index>(none.size()), Z.cols());
  for (std::size_t i = 0; i < none.size(); ++i) {
    rows.row(static_cast<Index>(i)) = Z.row(static_cast<Index>(none[i]));
    solution.value[none[i]] = 0;
  }
  const MatrixXd left = that_leave(Z, rows);
  solution.open.clear();
  solution.share.clear();
  for (Index d = 0; d < left.cols(); ++d) {
    const double largest = left.col(d).cwiseAbs().maxCoeff();
    solution.open.emplace_back(solution.value.size());
    solution.share.emplace_back();
    for (std::size_t k = 0; k < solution.value.size(); ++k) {
      solution.open.back()[k] = left(static_cast<Index>(k), d);
      if (std::abs(solution.open.back()[k]) > cone_rounding * largest) solution.share.back().push_back(k);
    }
  }
}

}  // namespace

void share_within_cones(solve::LinearSolution& solution, const std::vector<std::size_t>& one_sided,
                        const std::vector<FrictionCone>& cones, std::size_t fixed) {
  if (solution.open.empty() || !solution.conflict.empty()) return;
  const MatrixXd shares = share_directions(solution, fixed);
  if (shares.cols() == 0) return;
  SharesInCones program(solution, one_sided, cones, shares);
  if (!program.has_cones()) return;
  const VectorXd change = shares * program.middle();
  for (std::size_t k = 0; k < solution.value.size(); ++k) solution.value[k] += change[static_cast<Index>(k)];
  hold_at_apexes(solution, one_sided, cones, fixed);
}

std::optional<double> largest_within_cones(const solve::LinearSolution& solution,
                                           const std::vector<std::size_t>& one_sided,
                                           const std::vector<FrictionCone>& cones, std::size_t fixed,
                                           const std::vector<double>& slopes) {
  if (solution.open.empty() || !solution.conflict.empty()) return std::nullopt;
  const MatrixXd shares = share_directions(solution, fixed);
  if (shares.cols() != static_cast<Index>(solution.open.size())) return std::nullopt;
  SharesInCones program(solution, one_sided, cones, shares);
  if (!program.has_cones()) return std::nullopt;
  return program.largest(slopes);
}

std::optional<StickingBound> bound_on_sticking(const solve::LinearSolution& solution,
                                               const std::vector<std::size_t>& one_sided,
                                               const std::vector<FrictionCone>& cones, std::size_t fixed) {
  if (solution.open.empty() || !solution.conflict.empty()) return std::nullopt;
  const MatrixXd shares = share_directions(solution, fixed);
  if (shares.cols() == 0) return std::nullopt;
  // What no share changes may slide as well.
  const SharesInCones program(solution, one_sided, cones, shares, true);
  if (!program.has_cones()) return std::nullopt;
  return program.bound();
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
