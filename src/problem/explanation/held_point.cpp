#include "problem/explanation/held_point.h"

#include <cmath>

#include "engine/solve/linear/decompositions.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::problem {
namespace {

// Of the velocity and the acceleration that a point of this mechanism has where each coordinate moves by about its
// length in a unit of time: a thousand times what closing loops to 1e-12 leaves, and far below any motion that is one.
constexpr double negligible = 1e-9;

// The constraints on the velocities v, J v = 0, and on the accelerations a, J a = -bias(v), in units in which the
// mechanism has length one.
class Constraints {
 public:
  Constraints(const solve::MechanismState& state, double length)
      : mechanism_(state.mechanism()), unit_(Eigen::VectorXd::Ones(mechanism_.tree.velocity_size())) {
    const auto count = static_cast<Eigen::Index>(mechanism_.constraints.size());
    for (Eigen::Index k = 0; k < unit_.size(); ++k)
      if (!solve::coordinate_turns(mechanism_.tree, static_cast<int>(k))) unit_[k] = length;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(count, 1), unit_.size());
    row_ = Eigen::VectorXd::Ones(J.rows());
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto one = solve::constraint_coefficients(state, mechanism_.constraints[static_cast<std::size_t>(i)]);
      for (Eigen::Index k = 0; k < J.cols(); ++k) J(i, k) = one[static_cast<std::size_t>(k)] * unit_[k];
      if (const double size = J.row(i).norm(); size > 0) row_[i] = 1 / size;
    }
    decomposition_.setThreshold(negligible);
    decomposition_.compute(row_.asDiagonal() * J);
    const Eigen::Index rank = decomposition_.rank();
    const Eigen::MatrixXd Z = decomposition_.matrixZ().transpose();
    motions_ = decomposition_.colsPermutation() * Eigen::MatrixXd(Z.rightCols(unit_.size() - rank));
  }

  // A column for each independent motion that they allow.
  const Eigen::MatrixXd& motions() const { return motions_; }

  // The smallest accelerations that go with the velocities of a state.
  Eigen::VectorXd accelerations(const solve::MechanismState& moving) const {
    Eigen::VectorXd bias = Eigen::VectorXd::Zero(row_.size());
    for (std::size_t i = 0; i < mechanism_.constraints.size(); ++i)
      bias[static_cast<Eigen::Index>(i)] = solve::constraint_row(moving, mechanism_.constraints[i]).bias;
    return decomposition_.solve(Eigen::VectorXd(-row_.cwiseProduct(bias)));
  }

  std::vector<double> in_si(const Eigen::VectorXd& rates) const {
    const Eigen::VectorXd scaled = rates.cwiseProduct(unit_);
    return {scaled.begin(), scaled.end()};
  }

 private:
  const Mechanism<double>& mechanism_;
  Eigen::VectorXd unit_, row_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
  Eigen::MatrixXd motions_;
};

}  // namespace

bool is_held(const solve::MechanismState& state, int body, const Vector3<double>& place, double length) {
  solve::MechanismState moving(state.mechanism());
  moving.set_positions(state.state().q);
  const Constraints constraints(moving, length);
  const auto& motion = moving.workspace().motion[static_cast<std::size_t>(body + 1)];
  const Vector3<double> r = place - motion.p;
  const Eigen::MatrixXd& motions = constraints.motions();
  for (Eigen::Index m = 0; m < motions.cols(); ++m) {
    moving.set_velocities(constraints.in_si(motions.col(m)));
    if (norm(Vector3<double>(motion.v + cross(motion.w, r))) > negligible * length) return false;
  }
  // Accelerations are squares of velocities: those of two motions together are not the sum of those of each.
  for (Eigen::Index m = 0; m < motions.cols(); ++m)
    for (Eigen::Index n = m; n < motions.cols(); ++n) {
      moving.set_velocities(constraints.in_si(m == n ? Eigen::VectorXd(motions.col(m))
                                                     : Eigen::VectorXd(motions.col(m) + motions.col(n))));
      moving.set_accelerations(constraints.in_si(constraints.accelerations(moving)));
      const Vector3<double> a = motion.a + cross(motion.alpha, r) + cross(motion.w, cross(motion.w, r));
      if (norm(a) > negligible * length) return false;
    }
  return true;
}

}  // namespace poinsot::problem
