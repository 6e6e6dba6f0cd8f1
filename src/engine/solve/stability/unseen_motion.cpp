// With the columns of M scaled to the inertia of each coordinate, and the constraints' rows to length one, motions that
// move no mass and break no constraint make the kernel of both.
#include <algorithm>
#include <cmath>

#include "engine/solve/stability/same_motion.h"
#include "poinsot/engine/solve/stability/linearisation.h"
#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
// A moment of inertia that is less than this part of that about other axes, or a motion whose inertia is less than this
// part of that of its coordinates, is none: rods have some 1e-16 about their own line.
constexpr double no_inertia = 1e-12;

// The inertia of a coordinate; zero if it is none beside the turning of the same ball or free joint about other axes.
double inertia_of(const Model<double>& tree, const Rows<double>& M, std::size_t coordinate) {
  const double own = M[coordinate][coordinate];
  for (const Body<double>& body : tree.bodies()) {
    const auto first = static_cast<std::size_t>(body.v);
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    if (coordinate < first || coordinate >= first + 3) continue;
    const double largest = std::max({M[first][first], M[first + 1][first + 1], M[first + 2][first + 2]});
    return own > no_inertia * largest ? own : 0;
  }
  return own;
}

}  // namespace

std::vector<UnseenMotion> unseen_motions(const Mechanism<double>& mechanism, const std::vector<double>& q,
                                         const std::vector<int>& coordinates) {
  std::vector<UnseenMotion> found;
  if (coordinates.empty()) return found;
  const EquationMatrices<double> matrices = equation_matrices(mechanism, q);
  const auto count = static_cast<Index>(coordinates.size()), constraints = static_cast<Index>(matrices.J.size());
  const auto at = [&](Index i) { return static_cast<std::size_t>(coordinates[static_cast<std::size_t>(i)]); };
  Eigen::VectorXd unit(count);
  for (Index i = 0; i < count; ++i) {
    const double inertia = inertia_of(mechanism.tree, matrices.M, at(i));
    unit[i] = inertia > 0 ? 1 / std::sqrt(inertia) : 1;
  }
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(count + constraints, count);
  for (Index i = 0; i < count; ++i)
    for (Index k = 0; k < count; ++k) both(i, k) = unit[i] * matrices.M[at(i)][at(k)] * unit[k];
  for (Index c = 0; c < constraints; ++c) {
    for (Index k = 0; k < count; ++k) both(count + c, k) = matrices.J[static_cast<std::size_t>(c)][at(k)] * unit[k];
    if (const double length = both.row(count + c).norm(); length > 0) both.row(count + c) /= length;
  }
  Eigen::MatrixXd motions = complement(both.transpose().cast<Real>(), no_inertia).cast<double>();
  const Index left = motions.cols();
  // Each motion gets a coordinate by which it is known: the largest that is left.
  std::vector<Index> pivots;
  for (Index i = 0; i < left; ++i) {
    Index pivot = 0, column = 0;
    motions.rightCols(left - i).cwiseAbs().maxCoeff(&pivot, &column);
    motions.col(i).swap(motions.col(i + column));
    const double most = motions(pivot, i);
    motions.col(i) /= most;
    for (Index k = 0; k < left; ++k)
      if (k != i) motions.col(k) -= motions(pivot, k) * motions.col(i);
    pivots.push_back(pivot);
    found.push_back({static_cast<int>(at(pivot)), std::vector<double>(matrices.M.size())});
  }
  for (Index i = 0; i < left; ++i)
    for (Index k = 0; k < count; ++k)
      found[static_cast<std::size_t>(i)].along[at(k)] =
          unit[k] * motions(k, i) / unit[pivots[static_cast<std::size_t>(i)]];
  return found;
}

}  // namespace poinsot::solve
