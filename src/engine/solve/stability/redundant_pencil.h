// With x the displacements of all bodies in the frame of the steady motion, M their inertia, G the slopes of the gaps
// and of what may not slip, and y the forces that these take,
//
//   M x'' + C x' + K x = G^T dy,      gaps: G x = 0,      no slip: G x' + S x = 0,
//
// where K has the slopes of weights, springs and pushes, those of G^T y, and of the inertia that goes round. On a basis
// N of what G allows, N^T takes the unknown dy out. All slopes are differences of energies, gaps and momenta.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/solve/stability/doubted_rates.h"
#include "engine/solve/stability/redundant_bodies.h"
#include "engine/solve/stability/same_motion.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot::solve {

class RedundantPencil {
  using Index = Eigen::Index;

 public:
  // stretched: how many times as long as usual the steps of the differences are, to see what these leave out.
  RedundantPencil(const RedundantBodies& bodies, const SteadyMotion& motion, double pace, double stretched = 1)
      : bodies_(bodies),
        length_(length_of(bodies, motion)),
        pace_(pace),
        step_(usual_step * Real(stretched)),
        small_step_(usual_small_step * Real(stretched)) {
    for (std::size_t i = 0; i < bodies.bodies().size(); ++i)
      if (bodies.bodies()[i].moves) moving_.push_back(i);
    n_ = 6 * static_cast<Index>(moving_.size());
    still_.resize(bodies.bodies().size() + 1);
    find_slopes();
  }

  // x' = A x on a basis of the possible deviations, in natural units; nothing if masses are missing or forces do not
  // balance.
  struct Allowed {
    Matrix A, basis;
  };
  std::optional<Allowed> allowed() const {
    const std::optional<Equations> equations = find_equations();
    if (!equations) return std::nullopt;
    // Where all bodies are carried as stated nothing deviates.
    if (equations->Z.cols() == 0) return Allowed{Matrix(0, 0), equations->Z};
    Eigen::ColPivHouseholderQR<Matrix> qr(equations->E);
    qr.setThreshold(1e-9L);
    if (qr.rank() < equations->Z.cols()) return std::nullopt;
    return Allowed{qr.solve(equations->F), equations->Z};
  }

  // The bodies that swing at one frequency, the real part of x exp(i w t), where forces f act on them and gaps are g,
  // all in natural units.
  struct Forced {
    ComplexVector x;
    Real apart = 0;       // how far i w is from where the equations determine nothing
    Index loose = 0;      // how many displacements at rest nothing holds
    ComplexMatrix needs;  // a column for each body that moves: the force and the couple that its inertia takes
  };
  // Of displacements that nothing holds, as much is taken as leads nearest to `like`.
  std::optional<Forced> forced(const ComplexVector& f, const ComplexVector& g, Real w,
                               const ComplexVector& like) const {
    const std::optional<Equations> equations = find_equations();
    if (!equations) return std::nullopt;
    using Complex = std::complex<Real>;
    const Complex rate(0, w);
    const Index gaps = gap_slopes_.rows(), slips = slip_slopes_.rows(), rows = gaps + slips;
    // One swing of the bodies that makes the gaps what they are to be.
    ComplexVector xp = ComplexVector::Zero(n_);
    if (g.size() > 0 && g.norm() > 0) {
      Matrix both = Matrix::Zero(2 * rows, 2 * n_);
      Vector right = Vector::Zero(2 * rows);
      both.block(0, 0, gaps, n_) = both.block(rows, n_, gaps, n_) = gap_slopes_;
      both.block(gaps, 0, slips, n_) = both.block(rows + gaps, n_, slips, n_) = slip_by_place_;
      both.block(gaps, n_, slips, n_) = -w * slip_slopes_;
      both.block(rows + gaps, 0, slips, n_) = w * slip_slopes_;
      right.head(gaps) = g.real();
      right.segment(rows, gaps) = g.imag();
      const Vector found = Eigen::CompleteOrthogonalDecomposition<Matrix>(both).solve(Matrix(right));
      if ((both * found - right).norm() > 1e-9L * right.norm()) return std::nullopt;
      for (Index k = 0; k < n_; ++k) xp[k] = {found[k], found[n_ + k]};
    }
    const ComplexVector left =
        f - (rate * (rate * complex(inertia_) + complex(gyration_)) + complex(equations->K)) * xp;
    Matrix right = Matrix::Zero(equations->E.rows(), 2);
    const Matrix turned = equations->N.transpose();
    right.block(n_, 0, equations->N.cols(), 1) = turned * Matrix(left.real());
    right.block(n_, 1, equations->N.cols(), 1) = turned * Matrix(left.imag());
    for (Index i = n_; i < right.rows(); ++i) right.row(i) /= equations->sizes[i];
    const Index height = right.rows(), width = equations->Z.cols();
    // What is carried as stated swings as its gaps make it.
    if (width == 0) return Forced{xp, 1, 0, needs_of(xp, rate)};
    Matrix resists(2 * height, 2 * width), driven(2 * height, 1);
    resists << -equations->F, -w * equations->E, w * equations->E, -equations->F;
    driven << right.col(0), right.col(1);
    Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition;
    decomposition.setThreshold(no_size);
    decomposition.compute(resists);
    const Index open = 2 * width - decomposition.rank();
    if (open > 0 && w != 0) return std::nullopt;
    const Matrix inverted = decomposition.solve(Matrix::Identity(2 * height, 2 * height).eval());
    const Matrix z = inverted * driven;
    // What pushes along a displacement that nothing holds is not met at rest.
    constexpr Real left_over = 1e-7L;
    if (open > 0 && (resists * z - driven).norm() > left_over * driven.norm()) return std::nullopt;
    ComplexMatrix own(width, 1);
    for (Index i = 0; i < width; ++i) own(i, 0) = {z(i, 0), z(width + i, 0)};
    Forced result;
    result.apart = 1 / inverted.norm();
    const ComplexMatrix places = complex(equations->Z.topRows(n_));
    result.x = (places * own).col(0) + xp;
    if (open > 0) {
      // At rest the matrix is the same for real and imaginary parts.
      const Matrix held = resists.topLeftCorner(height, width).transpose();
      const ComplexMatrix loose = complex(equations->Z.topRows(n_) * complement(held, no_size));
      result.loose = loose.cols();
      const ComplexMatrix apart = like - result.x;
      result.x += (loose * Eigen::CompleteOrthogonalDecomposition<ComplexMatrix>(loose).solve(apart)).col(0);
    }
    result.needs = needs_of(result.x, rate);
    return result;
  }
  const std::vector<std::size_t>& moving() const { return moving_; }
  // A force and a couple on a body at a place, as the numbers of `f` above.
  Vector forces_of(int body, const Place3& place, const Place3& force, const Place3& couple) const {
    Vector total = Vector::Zero(n_);
    push(total, body, still_, place, force, couple, 1);
    return total / (pace_ * pace_);
  }
  // A gap that is to be `by`, as one of the numbers of `g`.
  Real gap_of(std::size_t gap, Real by) const { return by / gap_size_[static_cast<Index>(gap)]; }
  Index gaps_count() const { return gap_slopes_.rows(); }

  // The displacements of the bodies where the coordinates are displaced, these measured like velocities.
  Vector displacement(const SteadyMotion& motion, const std::vector<double>& along) const {
    const Model<double>& tree = motion.mechanism->tree;
    Workspace<double> w(tree);
    update_velocities<double>(tree, w, State<double>{motion.q, along});
    const auto wide = [](const Vector3<double>& a) { return Place3(a.x, a.y, a.z); };
    Vector all(n_);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
      const BodyMotion<double>& at = w.motion[moving_[m] + 1];
      const Place3 turn = wide(at.w), arm = bodies_.bodies()[moving_[m]].center - wide(at.p);
      const Place3 shift = wide(at.v) + turn.cross(arm);
      all.segment(6 * static_cast<Index>(m), 3) = shift / length_;
      all.segment(6 * static_cast<Index>(m) + 3, 3) = turn;
    }
    return all;
  }

 private:
  // Of a radian or a natural length. In long doubles mixed differences of the second order are good to about 1e-9 with
  // it: smaller steps add rounding, larger ones curvature.
  static constexpr Real usual_step = 1e-5L;
  // The same for the slopes of forces, which are differences of the first order: a force that goes as |v| v has none at
  // rest, and is taken to have one of the size of the step.
  static constexpr Real usual_small_step = 1e-8L;
  // Of the forces and of the stiffness: an imbalance that displaces the motion by less is rounding of the pose, which
  // is off by the root of rounding where two positions of rest nearly meet.
  static constexpr Real in_balance = 1e-6L;
  // Of the largest inertia: what is rounding.
  static constexpr Real no_size = 1e-14L;

  struct Equations {
    Matrix K, N, Z, E, F;  // E z' = F z
    Vector sizes;          // by which the rows of both were divided
  };
  ComplexMatrix needs_of(const ComplexVector& x, const std::complex<Real>& rate) const {
    const ComplexVector needs =
        (rate * (rate * complex(inertia_) + complex(own_gyration_)) + complex(own_stiffness_)) * x;
    ComplexMatrix of_bodies(6, static_cast<Index>(moving_.size()));
    for (Index m = 0; m < of_bodies.cols(); ++m) of_bodies.col(m) = needs.segment(6 * m, 6);
    return of_bodies;
  }
  static ComplexMatrix complex(const Matrix& A) { return A.cast<std::complex<Real>>(); }
  std::optional<Equations> find_equations() const {
    const Index gaps = gap_slopes_.rows(), slips = slip_slopes_.rows();
    Matrix rows = Matrix::Zero(2 * gaps + slips, 2 * n_), all(gaps + slips, n_);
    rows.topLeftCorner(gaps, n_) = rows.block(gaps, n_, gaps, n_) = gap_slopes_;
    rows.bottomLeftCorner(slips, n_) = slip_by_place_;
    rows.bottomRightCorner(slips, n_) = slip_slopes_;
    all << gap_slopes_, slip_slopes_;
    const Matrix transposed = all.transpose();
    // Forces that hold the motion itself: without them it is not steady.
    Vector y = Vector::Zero(gaps + slips);
    if (gaps + slips > 0) y = Eigen::CompleteOrthogonalDecomposition<Matrix>(transposed).solve(Matrix(unbalanced_));
    const Vector left = unbalanced_ - transposed * y;
    if (left.norm() > in_balance * (unbalanced_.norm() + stiffness_.norm())) return std::nullopt;
    const Matrix K = stiffness_ - slopes_of_reactions(y);
    check_budget();
    const Matrix N = all.rows() > 0 ? complement(transposed) : Matrix(Matrix::Identity(n_, n_));
    const Matrix Z = rows.rows() > 0 ? complement(rows.transpose()) : Matrix(Matrix::Identity(2 * n_, 2 * n_));
    check_budget();
    const Matrix x = Z.topRows(n_), u = Z.bottomRows(n_);
    Matrix E(n_ + N.cols(), Z.cols()), F(n_ + N.cols(), Z.cols());
    const Matrix resists = gyration_ * u + K * x, allowed = N.transpose();
    E << x, between(N, inertia_, u);
    F << u, -(allowed * resists);
    // Masses differ by orders: each equation of motion counts by its own size, if it has one.
    Vector sizes = Vector::Ones(E.rows());
    const Real largest = E.bottomRows(N.cols()).norm();
    for (Index i = n_; i < E.rows(); ++i)
      if (const Real size = E.row(i).norm(); size > no_size * largest) {
        sizes[i] = size;
        E.row(i) /= size;
        F.row(i) /= size;
      }
    return Equations{K, N, Z, E, F, sizes};
  }
  // Where bodies go round a far center, midway between their size, or how far they are from each other and from what
  // holds them, and their distance: by either of both alone the inertia of their turns or of their shifts would be
  // rounding beside the other.
  static Real length_of(const RedundantBodies& bodies, const SteadyMotion& motion) {
    const Mechanism<double>& mechanism = *motion.mechanism;
    if (mechanism.attractions.empty()) return Real(motion.length);
    Workspace<double> w(mechanism.tree);
    update_velocities<double>(mechanism.tree, w, State<double>{motion.q, motion.v});
    Real own = 0;
    const std::vector<SteadyBody>& all = bodies.bodies();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].moves || !(all[i].mass > 0)) continue;
      own = std::max(own, std::sqrt(all[i].inertia.trace() / (2 * all[i].mass)));
      const Vector3<double>& p = w.motion[i + 1].p;
      own = std::max(own, (all[i].center - Place3(p.x, p.y, p.z)).norm());
      for (std::size_t k = 0; k < i; ++k)
        if (all[k].moves && all[k].mass > 0) own = std::max(own, (all[i].center - all[k].center).norm());
    }
    return own > 0 ? std::sqrt(own * motion.length) : Real(motion.length);
  }
  Real unit(Index k) const { return k % 6 < 3 ? length_ : 1; }
  // Displaced along one coordinate: a shift or a turn of a body, after those that it has.
  Displacements displaced(Displacements at, Index k, Real by) const {
    Displaced& one = at[moving_[static_cast<std::size_t>(k / 6)]];
    if (k % 6 < 3)
      one.shift[k % 6] += by * length_;
    else
      one.turn = (turned_by(by * Place3::Unit(k % 6 - 3)) * one.turn).eval();
    return at;
  }
  template <class Function>
  auto slope(const Displacements& at, Index k, const Function& function) const {
    return ((function(displaced(at, k, step_)) - function(displaced(at, k, -step_))) / (2 * step_)).eval();
  }
  Vector push_slope_by_place(Index k, const DisplacedRates& resting) const {
    const auto at = [&](Real by) { return pushes(displaced(still_, k, by), resting); };
    return (at(small_step_) - at(-small_step_)) / (2 * small_step_);
  }
  Vector push_slope_by_rate(Index k) const {
    const auto at = [&](Real rate) {
      DisplacedRates rates(still_.size());
      DisplacedRate& one = rates[moving_[static_cast<std::size_t>(k / 6)]];
      (k % 6 < 3 ? one.shift : one.turn)[k % 3] = rate * pace_ * unit(k);
      return pushes(still_, rates);
    };
    return (at(small_step_) - at(-small_step_)) / (2 * small_step_);
  }
  Vector gaps(const Displacements& at) const {
    const std::vector<Real> all = bodies_.gaps(at);
    Vector gaps = Eigen::Map<const Vector>(all.data(), static_cast<Index>(all.size()));
    if (gap_size_.size() > 0) gaps = gaps.cwiseQuotient(gap_size_).eval();
    return gaps;
  }
  // A force and a couple on a body, in natural units.
  void push(Vector& total, int body, const Displacements& at, const Place3& place, const Place3& force,
            const Place3& couple, Real sign) const {
    const auto found = std::ranges::find(moving_, static_cast<std::size_t>(body));
    if (body == ground || found == moving_.end()) return;
    const Index first = 6 * (found - moving_.begin());
    total.segment(first, 3) += sign * length_ * force;
    total.segment(first + 3, 3) += sign * (couple + (place - bodies_.center(body, at)).cross(force));
  }
  // The rows of what may not slip, as forces of size one.
  Matrix slip_rows(const Displacements& at) const {
    const auto touches = bodies_.touches(at);
    Matrix rows(static_cast<Index>(touches.size()), n_);
    for (std::size_t i = 0; i < touches.size(); ++i) {
      Vector row = Vector::Zero(n_);
      push(row, touches[i].on, at, touches[i].place, touches[i].direction, Place3::Zero(), 1);
      push(row, touches[i].from, at, touches[i].place, touches[i].direction, Place3::Zero(), -1);
      rows.row(static_cast<Index>(i)) = row.transpose() / length_;
    }
    return rows;
  }
  // How fast it slips, while places and turns do not change in the frame.
  Vector slips(const Displacements& at) const {
    const auto touches = bodies_.touches(at);
    Vector rates(static_cast<Index>(touches.size()));
    const Place3 none = Place3::Zero();
    for (std::size_t i = 0; i < touches.size(); ++i)
      rates[static_cast<Index>(i)] =
          touches[i].direction.dot(bodies_.velocity(touches[i].on, at, touches[i].place, none, none) -
                                   bodies_.velocity(touches[i].from, at, touches[i].place, none, none)) /
          (pace_ * length_);
    return rates;
  }
  // The forces that do not come from an energy.
  Vector pushes(const Displacements& at, const DisplacedRates& rates) const {
    Vector total = Vector::Zero(n_);
    for (const RedundantBodies::Push& one : bodies_.pushes(at, rates)) {
      push(total, one.on, at, one.place, one.force, one.couple, 1);
      push(total, one.from, at, one.place, one.force, one.couple, -1);
    }
    return total / (pace_ * pace_);
  }
  // Angular momentum about the mass center of a body that is turned by R and turns at `turn` in the frame.
  Place3 momentum(std::size_t i, const Turn3& R, const Place3& turn) const {
    const SteadyBody& body = bodies_.bodies()[i];
    return R * (body.inertia * (R.transpose() * (bodies_.turning() + turn + R * bodies_.spin(i))));
  }

  void find_slopes() {
    const Vector none = gaps(still_);
    gap_slopes_.resize(none.size(), n_);
    slip_slopes_ = slip_rows(still_);
    slip_by_place_.resize(slip_slopes_.rows(), n_);
    inertia_ = gyration_ = stiffness_ = own_gyration_ = own_stiffness_ = Matrix::Zero(n_, n_);
    unbalanced_ = Vector::Zero(n_);
    const auto energy = [&](const Displacements& at) {
      return Eigen::Matrix<Real, 1, 1>::Constant(bodies_.energy(at) / (pace_ * pace_)).eval();
    };
    const DisplacedRates resting(still_.size());
    const Vector pushed = pushes(still_, resting);
    for (Index k = 0; k < n_; ++k) {
      gap_slopes_.col(k) = slope(still_, k, [&](const Displacements& at) { return gaps(at); });
      slip_by_place_.col(k) = slope(still_, k, [&](const Displacements& at) { return slips(at); });
      unbalanced_[k] = slope(still_, k, energy)[0] - pushed[k];
      for (Index j = 0; j < n_; ++j)
        stiffness_(j, k) = slope(still_, k, [&](const Displacements& at) { return slope(at, j, energy); })[0];
      stiffness_.col(k) -= push_slope_by_place(k, resting);
      gyration_.col(k) -= push_slope_by_rate(k);
    }
    // Some gaps are lengths and others angles: each counts by its own size, or at any length of the mechanism but one
    // either kind would be rounding beside the other.
    gap_size_ = gap_slopes_.rowwise().norm();
    for (Real& size : gap_size_)
      if (!(size > 0)) size = 1;
    gap_slopes_ = (gap_size_.cwiseInverse().asDiagonal() * gap_slopes_).eval();
    for (std::size_t m = 0; m < moving_.size(); ++m) add_inertia(m);
    gyration_ += own_gyration_;
    stiffness_ += own_stiffness_;
    const std::vector<std::pair<Real, Real>> dampers = bodies_.damped(still_);
    for (std::size_t d = 0; d < dampers.size(); ++d) {
      Vector along(n_);
      for (Index k = 0; k < n_; ++k)
        along[k] = slope(still_, k, [&](const Displacements& at) {
          return Eigen::Matrix<Real, 1, 1>::Constant(bodies_.damped(at)[d].first).eval();
        })[0];
      gyration_ += dampers[d].second / pace_ * along * along.transpose();
    }
  }

  // m (d'' + 2 W x d' + W x (W x (c + d))) and dH/dt + W x H of one body.
  void add_inertia(std::size_t m) {
    const std::size_t i = moving_[m];
    const SteadyBody& body = bodies_.bodies()[i];
    const Index first = 6 * static_cast<Index>(m);
    const Turn3 W = crossing(bodies_.turning()) / pace_;
    const Real mass = body.mass * length_ * length_;
    inertia_.block(first, first, 3, 3) = mass * Turn3::Identity();
    own_gyration_.block(first, first, 3, 3) += 2 * mass * W;
    own_stiffness_.block(first, first, 3, 3) += mass * W * W;
    unbalanced_.segment(first, 3) += mass / length_ * W * W * (body.center - bodies_.axis_point());
    Turn3 by_turn, by_rate;
    for (Index k = 0; k < 3; ++k) {
      const Place3 e = Place3::Unit(k);
      by_turn.col(k) =
          (momentum(i, turned_by(step_ * e), Place3::Zero()) - momentum(i, turned_by(-step_ * e), Place3::Zero())) /
          (2 * step_ * pace_);
      by_rate.col(k) = momentum(i, Turn3::Identity(), e) - momentum(i, Turn3::Identity(), Place3::Zero());
    }
    const Index turn = first + 3;
    inertia_.block(turn, turn, 3, 3) = by_rate;
    own_gyration_.block(turn, turn, 3, 3) += by_turn + W * by_rate;
    own_stiffness_.block(turn, turn, 3, 3) += W * by_turn;
    unbalanced_.segment(turn, 3) += W * momentum(i, Turn3::Identity(), Place3::Zero()) / pace_;
  }

  // Of G^T y, at fixed y.
  Matrix slopes_of_reactions(const Vector& y) const {
    const Index gaps_count = gap_slopes_.rows();
    const Vector of_gaps = y.head(gaps_count), of_slips = y.tail(y.size() - gaps_count);
    Matrix slopes = Matrix::Zero(n_, n_);
    const auto held = [&](const Displacements& at) {
      return Eigen::Matrix<Real, 1, 1>::Constant(of_gaps.dot(gaps(at))).eval();
    };
    for (Index k = 0; k < n_; ++k) {
      for (Index j = 0; j < n_; ++j)
        slopes(j, k) = slope(still_, k, [&](const Displacements& at) { return slope(at, j, held); })[0];
      slopes.col(k) +=
          slope(still_, k, [&](const Displacements& at) { return Matrix(slip_rows(at).transpose()) * of_slips; });
    }
    return slopes;
  }

  const RedundantBodies& bodies_;
  Real length_, pace_, step_, small_step_;
  Index n_ = 0;
  std::vector<std::size_t> moving_;
  Displacements still_;
  Matrix gap_slopes_, slip_slopes_, slip_by_place_, inertia_, gyration_, stiffness_;
  Matrix own_gyration_, own_stiffness_;  // the parts of inertia
  Vector gap_size_;                      // once it is known: of the slopes of each gap
  Vector unbalanced_;                    // what gaps and contacts must exert
};

}  // namespace poinsot::solve
