#include "engine/solve/instant/singular_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Singular values as parts of the largest. Those below `none` are rounding. Those from there to `doubtful` may be
// zeros: in a pose that is off by the root of rounding a vanishing singular value looks like that.
constexpr double none = 4e-15, doubtful = 1e-5;

// The gaps of the constraints, and their rates for unit rates of the movable coordinates, in natural units.
struct Loops {
  Eigen::VectorXd gap;
  Eigen::MatrixXd rates;
};

class LoopsInPose {
 public:
  LoopsInPose(const Mechanism<double>& mechanism, const std::vector<std::size_t>& constraints,
              const std::vector<bool>& movable, double length)
      : mechanism_(mechanism), constraints_(constraints), length_(length), mechanism_state_(mechanism) {
    for (std::size_t k = 0; k < movable.size(); ++k) {
      if (!movable[k]) continue;
      columns_.push_back(k);
      units_.push_back(coordinate_turns(mechanism.tree, static_cast<int>(k)) ? 1 : length);
    }
  }

  Loops at(const std::vector<double>& q) {
    mechanism_state_.set_positions(q);
    const auto m = static_cast<Eigen::Index>(constraints_.size());
    Loops loops{Eigen::VectorXd(m), Eigen::MatrixXd(m, static_cast<Eigen::Index>(columns_.size()))};
    for (Eigen::Index i = 0; i < m; ++i) {
      const std::size_t index = constraints_[static_cast<std::size_t>(i)];
      const VelocityConstraint<double>& c = mechanism_.constraints[index];
      const double unit = c.kind == VelocityConstraintKind::angular ? 1 : length_;
      loops.gap[i] = constraint_gap(mechanism_.tree, mechanism_state_.workspace(), c,
                                    axis_left_free(mechanism_.constraints, index)) /
                     unit;
      const std::vector<double> rates = constraint_coefficients(mechanism_state_, c);
      for (std::size_t j = 0; j < columns_.size(); ++j)
        loops.rates(i, static_cast<Eigen::Index>(j)) = rates[columns_[j]] * units_[j] / unit;
    }
    return loops;
  }

  // The size of a gap that is nothing but rounding. A gap is a difference of distances, the farthest of which tells.
  double rounding() const {
    double farthest = length_;
    for (const std::size_t index : constraints_)
      farthest = std::max(farthest, norm(mechanism_state_.position(mechanism_.constraints[index].at)));
    return 16 * epsilon * farthest / length_;
  }

  // The pose after a displacement of the movable coordinates, which is given in their natural units.
  std::vector<double> moved(std::vector<double> q, const Eigen::VectorXd& by) const {
    std::vector<double> displacements(static_cast<std::size_t>(mechanism_.tree.velocity_size()));
    for (std::size_t j = 0; j < columns_.size(); ++j)
      displacements[columns_[j]] = by[static_cast<Eigen::Index>(j)] * units_[j];
    integrate_position<double>(mechanism_.tree, q, displacements, 1.0);
    return q;
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(columns_.size()); }

 private:
  const Mechanism<double>& mechanism_;
  const std::vector<std::size_t>& constraints_;
  double length_;
  MechanismState mechanism_state_;
  std::vector<std::size_t> columns_;
  std::vector<double> units_;
};

// Whether some pivot lies between surely zero and surely not, so that the rank of the rates is open.
bool rank_is_doubtful(const Eigen::MatrixXd& rates, double least) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rates);
  const Eigen::ArrayXd pivots = qr.matrixQR().diagonal().cwiseAbs();
  return ((pivots > least * pivots[0]) && (pivots < doubtful * pivots[0])).any();
}

// One Newton step to the pose where the rates of the gaps J have the given rank. With u, v the left and right
// singular vectors of the singular values that stand for zero, u^T J v must vanish there for all pairs, and the gaps
// along the other left singular vectors must close.
Eigen::VectorXd step_to_rank(LoopsInPose& pose, const std::vector<double>& q, const Loops& loops,
                             const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, Eigen::Index rank) {
  const Eigen::Index n = pose.size(), m = loops.gap.size();
  const Eigen::MatrixXd &U = svd.matrixU(), &V = svd.matrixV();
  const auto U_zero = U.rightCols(m - rank), V_zero = V.rightCols(n - rank);
  const Eigen::Index conditions = (m - rank) * (n - rank);
  Eigen::MatrixXd A(rank + conditions, n);
  Eigen::VectorXd b(rank + conditions);
  A.topRows(rank) = U.leftCols(rank).transpose() * loops.rates;
  b.head(rank) = -U.leftCols(rank).transpose() * loops.gap;
  const Eigen::MatrixXd left = U_zero.transpose() * loops.rates * V_zero;
  b.tail(conditions) = -left.reshaped();
  // Of a radian or the length of the machine: central differences of rates, which are good to 1e-15, have errors of
  // step^2 = 1e-8 and 1e-15/step = 1e-11. Newton's method on the next pose makes up for them.
  constexpr double step = 1e-4;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd by = step * Eigen::VectorXd::Unit(n, k);
    const Eigen::MatrixXd slope = (pose.at(pose.moved(q, by)).rates - pose.at(pose.moved(q, -by)).rates) / (2 * step);
    A.col(k).tail(conditions) = (U_zero.transpose() * slope * V_zero).reshaped();
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least(A.rows(), A.cols());
  // What depends on others but for the errors of those slopes.
  constexpr double repeats = 1e-7;
  least.setThreshold(repeats);
  least.compute(A);
  return least.solve(b);
}

}  // namespace

void settle_on_singular_pose(const Mechanism<double>& mechanism, const std::vector<std::size_t>& constraints,
                             const std::vector<bool>& movable, double length, std::vector<double>& q) {
  LoopsInPose pose(mechanism, constraints, movable, length);
  if (pose.size() == 0) return;
  Loops loops = pose.at(q);
  if (!loops.rates.allFinite() || !rank_is_doubtful(loops.rates, 0.25 * none)) return;
  std::vector<double> there = q;
  std::optional<Eigen::Index> rank;
  double moved = 0;
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(loops.rates, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::ArrayXd sizes = svd.singularValues() / svd.singularValues()[0];
    if (!rank) rank = (sizes > doubtful).count();
    const bool singular = *rank == sizes.size() || sizes[*rank] <= none;
    if (singular && loops.gap.cwiseAbs().maxCoeff() <= pose.rounding()) {
      // If the pose found is only almost singular for all coordinates together, the given coordinates are a little
      // off the singular pose too. Then the stated pose is another one, and q stays.
      LoopsInPose all(mechanism, constraints, std::vector<bool>(movable.size(), true), length);
      if (!rank_is_doubtful(all.at(there).rates, 10 * none)) q = there;
      return;
    }
    const Eigen::VectorXd step = step_to_rank(pose, there, loops, svd, *rank);
    moved += step.cwiseAbs().maxCoeff();
    if (!(moved <= doubtful)) return;
    there = pose.moved(there, step);
    loops = pose.at(there);
  }
}

}  // namespace poinsot::solve
