#include "poinsot/engine/solve/stability/linearisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "engine/solve/stability/acceleration_slopes.h"
#include "engine/solve/stability/doubted_rates.h"
#include "engine/solve/stability/equilibria_beside.h"
#include "engine/solve/stability/later_motion.h"
#include "engine/solve/stability/mode_shapes.h"
#include "engine/solve/stability/same_motion.h"
#include "poinsot/engine/model/state.h"
#include "poinsot/engine/solve/stability/changing_equations.h"
#include "poinsot/engine/solve/stability/near_equations.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// An oscillation is called stable only if its rate is known to this part of itself: the growth is hidden in the error
// else.
constexpr double decisive = 1e-7;
// Of the size of the terms: what cancels in them to less is no force. Poses are found to some 1e-12.
constexpr Real unfelt = 1e-9L;
// Of the pace: what is slower rests. Velocities that are solved for are off by some 1e-15 of it.
constexpr double still = 1e-12;
// Of a mode of length one: a coordinate that moves by less takes no part in it. Modes are known to about the rounding
// of their equations over the distance of the rates, which is seldom below 1e-8.
constexpr double takes_part = 1e-7;

Matrix matrix(const Rows<double>& rows) {
  const auto n = static_cast<Index>(rows.size());
  return Matrix::NullaryExpr(
      n, n, [&](Index i, Index k) { return Real(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]); });
}

bool is_doubtful(const Mode& mode) {
  return is_neutral(mode) || mode.doubt > decisive * std::hypot(mode.growth_rate, mode.frequency);
}

class Lineariser {
 public:
  explicit Lineariser(const SteadyMotion& motion)
      : motion_(motion),
        tree_(motion.mechanism->tree),
        slopes_(acceleration_slopes(motion)),
        n_(static_cast<Index>(motion.v.size())) {}

  // The equations in natural units: deviations are parts of the units of the coordinates, and rates parts of the pace.
  // False if the motion is not steady.
  bool form() {
    // The state is described on axes that follow the frame and not the spin: there the velocities of a steady motion
    // are constant, and deviations obey equations with constant coefficients.
    const auto twists = own_twists(tree_, motion_.v);
    const Matrix spin = matrix(adjoint_rows(tree_, motion_.spins)), drift = matrix(adjoint_rows(tree_, twists));
    pace_ = std::max(pace(), 1e-300);

    A_ = {Matrix::Zero(2 * n_, 2 * n_), Matrix::Zero(2 * n_, 2 * n_)};
    A_.value.topLeftCorner(n_, n_) = spin - drift;
    A_.value.topRightCorner(n_, n_).setIdentity();
    for (const auto part : {&Doubted::value, &Doubted::doubt})
      (A_.*part).bottomRows(n_) << slopes_.by_position.*part, slopes_.by_velocity.*part;
    const std::optional<double> unrest = unrest_of(spin, A_.value, pace_);
    if (!unrest) return false;
    A_.value.bottomRightCorner(n_, n_) += spin;
    A_.doubt += 4 * epsilon * A_.value.cwiseAbs();
    take_out_unseen(A_, drift);
    scale_.resize(2 * n_);
    for (Index k = 0; k < n_; ++k) {
      scale_[k] = unit(k);
      scale_[n_ + k] = unit(k) * pace_;
    }
    for (Matrix* each : {&A_.value, &A_.doubt})
      *each = (scale_.cwiseInverse().asDiagonal() * *each * scale_.asDiagonal()).eval() / Real(pace_);
    // As far as the velocities are not quite constant, the matrix belongs to a steady motion near by, which adds to
    // its doubt.
    A_.doubt.bottomRows(n_).array() += Real(*unrest);
    coupled_ = Vector::Zero(2 * n_);
    rows_ = rows_of(scale_, coupled_);
    return true;
  }

  // The same, on a basis of all deviations that the constraints allow.
  AllowedDeviations allowed() {
    const Matrix basis = deviations(rows_, Matrix(2 * n_, 0), coupled_);
    return {between(basis, A_.value, basis), basis, scale_};
  }

  Linearisation linearise() {
    Linearisation result;
    result.steady = form();
    result.unsteady = unsteady_;
    result.pace = pace_;
    result.length = motion_.length;
    if (!result.steady) return result;
    refuse_changing_equations();
    std::vector<Vector> alone = displacements(scale_);
    find_all_modes(result, alone);
    // Bodies that are coupled, as the wheels of a train, lead to the same motion again only together.
    if (std::ranges::any_of(result.modes, is_neutral)) {
      const std::vector<Vector> together = displacements_together(alone);
      alone.insert(alone.end(), together.begin(), together.end());
      if (!together.empty()) find_all_modes(result, alone);
    }
    return result;
  }

 private:
  void find_all_modes(Linearisation& result, const std::vector<Vector>& to_same_motion) {
    const Doubted& A = A_;
    const DeviationRows& rows = rows_;
    Vector coupled = coupled_;
    SameMotion same = same_motion(A, rows, to_same_motion);
    if (rests(result.pace)) {
      const Matrix beside = equilibria_beside(A, rows, same.elsewhere);
      same.elsewhere.conservativeResize(2 * n_, same.elsewhere.cols() + beside.cols());
      same.elsewhere.rightCols(beside.cols()) = beside;
    }
    const Matrix basis = deviations(rows, same.elsewhere, coupled);
    result.deviations = static_cast<int>(basis.cols() + same.elsewhere.cols());
    // The error of the basis adds to that of the entries.
    const Matrix size = basis.cwiseAbs();
    const Matrix off = coupled.replicate(1, basis.cols());
    const Matrix most = A.value.cwiseAbs();
    Doubted reduced{between(basis, A.value, basis), between(size, A.doubt, size)};
    reduced.doubt += between(off, most, size) + between(size, most, off);
    find_modes(result, reduced, basis);
    // A symmetry brings a conserved momentum, and with it one more eigenvalue zero that says nothing about stability.
    // But where constraints of velocities have no share in a symmetry nothing is conserved by it: there are no more
    // such eigenvalues than steady motions beside this one. Of those that vanish with a slow motion the rest decides
    // nothing.
    Index momenta = same.momenta;
    if (momenta > 0 && std::ranges::any_of(result.modes, is_neutral))
      momenta = std::min(momenta, vanishing_directions(reduced).directions.cols());
    leave_out(result, momenta);
    if (std::ranges::any_of(result.modes, is_doubtful)) look_without_momenta(result, reduced, basis, momenta);
    if (const double slowest = slowest_beside_drifts(result); slowest > 0) {
      const std::vector<Mode> with_drifts = result.modes;
      look_without_drifts(result, reduced, basis, momenta);
      // No rate that was known may be lost, nor a slow one taken for a drift.
      const auto known = [](const std::vector<Mode>& modes) {
        return std::ranges::count_if(modes, std::not_fn(is_neutral));
      };
      if (known(result.modes) != known(with_drifts) || !(std::abs(slowest_rate(result.modes) / slowest - 1) <= 1e-3))
        result.modes = with_drifts;
    }
    for (const double frequency : same.going_round) result.modes.push_back({0, frequency * result.pace, 0, {}});
    std::sort(result.modes.begin(), result.modes.end(), [](const Mode& one, const Mode& other) {
      return one.growth_rate != other.growth_rate ? one.growth_rate > other.growth_rate
                                                  : one.frequency < other.frequency;
    });
  }

  // After a while the equations must be the same, on axes that follow the frame and no spin. Parts of a turn that no
  // symmetry has are looked at for each of the spins.
  void refuse_changing_equations() const {
    constexpr double part_of_turn = 1.2345;
    constexpr Real closely = 1e-7L;
    for (const double spin : uneven_spins(motion_)) {
      const LaterMotion later = later_motion(motion_, part_of_turn / spin);
      Lineariser after(later.motion);
      if (!after.form()) throw ChangingEquations();
      Matrix turned = Matrix::Zero(2 * n_, 2 * n_);
      turned.topLeftCorner(n_, n_) = turned.bottomRightCorner(n_, n_) = later.turned;
      turned = (scale_.cwiseInverse().asDiagonal() * turned * scale_.asDiagonal()).eval();
      Vector coupled = coupled_;
      const Matrix allowed = deviations(rows_, Matrix(2 * n_, 0), coupled), moved = turned * allowed;
      const Real same_pace = Real(after.pace_ / pace_);
      Matrix after_units = Matrix::Identity(2 * n_, 2 * n_);
      after_units.bottomRightCorner(n_, n_) /= same_pace;
      const Matrix A_then = same_pace * after_units.inverse() * after.A_.value * after_units;
      const Matrix change = A_then * moved - turned * (A_.value * allowed);
      const Matrix terms =
          A_then.cwiseAbs() * moved.cwiseAbs() + turned.cwiseAbs() * (A_.value.cwiseAbs() * allowed.cwiseAbs());
      const Matrix doubts = A_.doubt * allowed.cwiseAbs();
      if (((change.cwiseAbs() - closely * terms - computed * doubts).array() > closely * closely).any())
        throw ChangingEquations();
    }
  }

  // Combinations x of displacements at which velocities stay as they are, with A x = 0, that the constraints allow, as
  // places and as velocities. That A x vanishes says so of small displacements only: what is displaced far must have
  // the same accelerations, too.
  std::vector<Vector> displacements_together(const std::vector<Vector>& alone) const {
    Matrix moved(n_, 0);
    for (const Vector& x : alone) {
      if (!x.tail(n_).isZero(0)) continue;
      moved.conservativeResize(n_, moved.cols() + 1);
      moved.rightCols(1) = x.head(n_);
    }
    if (moved.cols() == 0) return {};
    Eigen::ColPivHouseholderQR<Matrix> qr(moved);
    qr.setThreshold(within);
    const Matrix Q = (qr.householderQ() * Matrix::Identity(n_, n_)).leftCols(qr.rank());
    const Index conditions = rows_.value.rows();
    Matrix changes(2 * n_ + 2 * conditions, Q.cols());
    changes.topRows(2 * n_) = A_.value.leftCols(n_) * Q;
    if (conditions > 0) {
      changes.middleRows(2 * n_, conditions) = rows_.value.leftCols(n_) * Q;
      changes.bottomRows(conditions) = rows_.value.rightCols(n_) * Q;
    }
    const Eigen::JacobiSVD<Matrix> svd(changes, Eigen::ComputeFullV);
    std::vector<Vector> found;
    for (Index k = 0; k < Q.cols(); ++k) {
      if (k < svd.singularValues().size() && svd.singularValues()[k] > within) continue;
      Vector x = Vector::Zero(2 * n_);
      x.head(n_) = Q * svd.matrixV().col(k);
      if (is_same_motion_far_away(x)) found.push_back(std::move(x));
    }
    return found;
  }
  bool is_same_motion_far_away(const Vector& x) const {
    constexpr double far = 0.3;  // rad, or of the natural length
    constexpr Real closely = 1e-7L;
    std::vector<double> along(static_cast<std::size_t>(n_));
    for (Index k = 0; k < n_; ++k) along[static_cast<std::size_t>(k)] = static_cast<double>(x[k] * scale_[k]);
    const Vector wide = x.head(n_).cwiseProduct(scale_.head(n_));
    for (const double by : {-far, far}) {
      SteadyMotion moved = motion_;
      integrate_position<double>(tree_, moved.q, along, by);
      const AccelerationSlopes there = acceleration_slopes(moved);
      for (Index k = 0; k < n_; ++k)
        if (std::abs(there.a[k] - slopes_.a[k]) > closely * unit(k) * pace_ * pace_) return false;
      for (Index i = 0; i < there.constraints.value.rows(); ++i) {
        const Vector row = there.constraints.value.row(i).transpose();
        if (std::abs(row.dot(wide)) > closely * row.norm() * wide.norm()) return false;
      }
    }
    return true;
  }

  void find_modes(Linearisation& result, const Doubted& reduced, const Matrix& basis) const {
    const Rates rates = rates_of(reduced);
    result.modes.clear();
    for (Index m = 0; m < rates.value.size(); ++m) {
      const std::complex<Real> rate = rates.value[m];
      if (rate.imag() < 0) continue;  // its conjugate stands for it
      Mode mode;
      mode.growth_rate = static_cast<double>(rate.real() * Real(result.pace));
      mode.frequency = static_cast<double>(rate.imag() * Real(result.pace));
      // Two rates that nearly meet may be off by twice what first order says, and most numbers of a mechanism were
      // rounded more than once before they came here.
      mode.doubt = 4 * rates.doubt[m] * result.pace;
      const ComplexMatrix motion = rates.motion.col(m).normalized();
      const Matrix real = motion.real(), imaginary = motion.imag();
      const Matrix along = basis * real, across = basis * imaginary;
      const Eigen::VectorXd moved = (along.cwiseAbs2() + across.cwiseAbs2()).cwiseSqrt().cast<double>();
      for (int i = 0; i < tree_.body_count(); ++i) mode.moves.push_back(moves(i, moved));
      result.modes.push_back(std::move(mode));
    }
  }

  // Slow modes beside the zero eigenvalues of conserved momenta are known badly, as nearly equal eigenvalues disturb
  // each other. This computes the modes again without the directions n for which A n vanishes within its doubt: these
  // are motions with other momenta, and A has the other eigenvalues on their complement.
  void look_without_momenta(Linearisation& result, const Doubted& A, const Matrix& basis, Index momenta) const {
    const VanishingDirections taken = vanishing_directions(A);
    const Index count = taken.directions.cols();
    // If more directions vanish than there are momenta, some of them are slow motions, and this way is closed.
    if (count == 0 || count > momenta) return;
    find_modes(result, taken.rest, basis * taken.others);
    leave_out(result, momenta - count);
  }

  // Rates that vanish and disturb each other, as those of a sleigh's heading, are known to no digit one by one.
  // What leads nowhere is taken out, then what leads into that, and so on: A has the other rates on what is left.
  void look_without_drifts(Linearisation& result, Doubted A, Matrix basis, Index momenta) const {
    Matrix drifts(basis.rows(), 0);
    for (VanishingDirections taken = vanishing_directions(A); taken.directions.cols() > 0;
         taken = vanishing_directions(A)) {
      const Matrix directions = basis * taken.directions;
      drifts.conservativeResize(Eigen::NoChange, drifts.cols() + directions.cols());
      drifts.rightCols(directions.cols()) = directions;
      basis = basis * taken.others;
      A = taken.rest;
    }
    find_modes(result, A, basis);
    for (Index k = 0; k < drifts.cols(); ++k) {
      const Eigen::VectorXd moved = drifts.col(k).cwiseAbs().cast<double>();
      result.modes.emplace_back();
      for (int i = 0; i < tree_.body_count(); ++i) result.modes.back().moves.push_back(moves(i, moved));
    }
    leave_out(result, momenta);
  }

  // Deviations that differ by an unseen motion are the same. Of these, the one is looked at whose chosen coordinate
  // does not deviate, in position or velocity: along U, the unseen displacements and velocities, A x is brought back to
  // it,
  //
  //   A -> (1 - U (S U)^-1 S) A,     S the rows of the chosen coordinates.
  //
  // That is possible if A U leads to nothing else: no force feels the unseen motion.
  void take_out_unseen(Doubted& A, const Matrix& drift) {
    seen_ = Matrix::Identity(2 * n_, 2 * n_);
    const auto count = static_cast<Index>(motion_.unseen.size());
    if (count == 0) return;
    Matrix U = Matrix::Zero(2 * n_, 2 * count), chosen = Matrix::Zero(2 * count, 2 * n_);
    for (Index i = 0; i < count; ++i) {
      const UnseenMotion& unseen = motion_.unseen[static_cast<std::size_t>(i)];
      const Vector along = Eigen::Map<const Eigen::VectorXd>(unseen.along.data(), n_).cast<Real>();
      // On axes that are displaced along, velocities that stay the same have other components.
      U.col(2 * i) << along, drift * along;
      U.col(2 * i + 1).tail(n_) = along;
      chosen(2 * i, unseen.coordinate) = chosen(2 * i + 1, n_ + unseen.coordinate) = 1;
    }
    const Matrix parts = Eigen::ColPivHouseholderQR<Matrix>(chosen * U).solve(chosen);
    seen_ -= U * parts;
    const Matrix size = seen_.cwiseAbs(), sizes = U.cwiseAbs();
    const Matrix led = seen_ * (A.value * U);
    const Matrix felt = computed * A.doubt + unfelt * A.value.cwiseAbs();
    const Matrix allowed = size * (felt * sizes);
    if (((led.cwiseAbs() - allowed).array() > 0).any())
      throw std::runtime_error("near the steady motion a force acts on what can move and has no mass");
    A = {seen_ * A.value, size * A.doubt};
  }
  bool rests(double pace) const {
    for (Index k = 0; k < n_; ++k)
      if (std::abs(motion_.v[static_cast<std::size_t>(k)]) > still * unit(k) * pace) return false;
    return motion_.spins.empty();
  }

  double unit(Index coordinate) const { return natural_size_of(motion_, coordinate); }
  double pace() const {
    double fastest = 1 / motion_.time;
    for (Index k = 0; k < n_; ++k)
      fastest = std::max(fastest, std::abs(motion_.v[static_cast<std::size_t>(k)]) / unit(k));
    // At rest without weight springs set it. What is that much slower is the rounding of their balance.
    constexpr double unmoved = 1e-6;
    double springs = 0;
    for (Index i = 0; i < n_; ++i)
      for (Index k = 0; k < n_; ++k) {
        const double pull = static_cast<double>(std::abs(slopes_.by_position.value(i, k))) * unit(k) / unit(i);
        const double brake = static_cast<double>(std::abs(slopes_.by_velocity.value(i, k))) * unit(k) / unit(i);
        springs = std::max({springs, std::sqrt(pull), brake});
      }
    return fastest > unmoved * springs ? fastest : springs;
  }
  // The largest change of a velocity in natural units, as a part of the pace; nothing if it exceeds what the errors
  // of the pose and the velocities explain: then the motion is not steady. A: the matrix before the spin is added.
  std::optional<double> unrest_of(const Matrix& spin, const Matrix& A, double pace) {
    // Of the terms. What is stated of a steady motion may be found by a search to 1e-9, and a rate that is solved for
    // at a shallow root a hundred times worse. A precession that is a thousandth too fast is refused all the same.
    constexpr double closely = 1e-7;
    const Vector v = Eigen::Map<const Eigen::VectorXd>(motion_.v.data(), n_).cast<Real>();
    const Eigen::VectorXd change = (slopes_.a + spin * v).cast<double>();
    const Matrix spin_size = spin.cwiseAbs();
    const Vector v_size = v.cwiseAbs();
    const Eigen::VectorXd turned = (spin_size * v_size).cast<double>();
    double largest = 0, most = 1;
    for (Index k = 0; k < n_; ++k) {
      double terms = turned[k] + unit(k) / (motion_.time * motion_.time);
      for (Index j = 0; j < n_; ++j)
        terms += std::abs(static_cast<double>(A(n_ + k, j))) * unit(j) +
                 std::abs(static_cast<double>(A(n_ + k, n_ + j) * v[j]));
      const double allowed = closely * terms + 64 * epsilon * unit(k) * pace * pace;
      if (std::abs(change[k]) > most * allowed) {
        most = std::abs(change[k]) / allowed;
        unsteady_ = static_cast<int>(k);
      }
      largest = std::max(largest, std::abs(change[k]) / unit(k) / (pace * pace));
    }
    return unsteady_ < 0 ? std::optional(largest) : std::nullopt;
  }

  // The conditions that deviations satisfy: held coordinates do not deviate, and constraints go on holding. coupled:
  // receives the possible error of deviations that follow from others.
  DeviationRows rows_of(const Vector& scale, Vector& coupled) const {
    std::vector<Vector> rows;
    std::vector<Real> doubts;
    for (Index k = 0; k < n_; ++k)
      if (motion_.held[static_cast<std::size_t>(k)])
        for (Index part : {k, n_ + k}) {
          Vector row = Vector::Zero(2 * n_);
          row[part] = 1;
          rows.push_back(row);
          doubts.push_back(0);
        }
    for (const UnseenMotion& unseen : motion_.unseen)
      for (const Index part : {Index(unseen.coordinate), n_ + unseen.coordinate}) {
        rows.push_back(Vector::Unit(2 * n_, part));
        doubts.push_back(0);
      }
    const auto add = [&](const Vector& row, const Vector& off) {
      const Vector scaled = row.cwiseProduct(scale);
      const Real size = scaled.norm(), doubt = off.cwiseProduct(scale).norm();
      // Of a constraint that binds nothing only rounding is left.
      if (!(size > computed * doubt)) return;
      mark(coupled, scaled, 8 * epsilon + doubt / size);
      rows.push_back(scaled / size);
      doubts.push_back(doubt / size);
    };
    const Matrix none = Matrix::Zero(slopes_.constraints.value.rows(), n_);
    const auto both = [&](Index i, const Doubted& of_positions, const Doubted& of_velocities) {
      Vector row(2 * n_), off(2 * n_);
      row << of_positions.value.row(i).transpose(), of_velocities.value.row(i).transpose();
      off << of_positions.doubt.row(i).transpose(), of_velocities.doubt.row(i).transpose();
      add(row, off);
    };
    for (Index i = 0; i < slopes_.constraints.value.rows(); ++i) {
      if (slopes_.binds_positions[static_cast<std::size_t>(i)]) both(i, slopes_.constraints, {none, none});
      both(i, slopes_.rates_by_position, slopes_.constraints);
    }
    const auto count = static_cast<Index>(rows.size());
    DeviationRows all{Matrix(count, 2 * n_), Eigen::Map<const Vector>(doubts.data(), count)};
    for (Index i = 0; i < count; ++i) all.value.row(i) = rows[static_cast<std::size_t>(i)].transpose();
    return all;
  }
  static void mark(Vector& coupled, const Vector& row, Real doubt) {
    for (Index k = 0; k < row.size(); ++k)
      if (row[k] != 0) coupled[k] = std::max(coupled[k], doubt);
  }

  // An orthonormal basis of the possible deviations, without those that lead to the same motion elsewhere.
  Matrix deviations(const DeviationRows& rows, const Matrix& elsewhere, Vector& coupled) const {
    for (Index s = 0; s < elsewhere.cols(); ++s)
      if ((elsewhere.col(s).array() != 0).count() > 1) mark(coupled, elsewhere.col(s), 8 * epsilon);
    Matrix kernel = Matrix::Identity(2 * n_, 2 * n_);
    if (rows.value.rows() > 0) kernel = complement(rows.value.transpose());
    if (elsewhere.cols() == 0) return kernel;
    const Matrix turned = kernel.transpose();
    return kernel * complement(turned * elsewhere);
  }
  // The stated symmetries of the motion as displacements of length one, each once: a turn about an axis is the same for
  // every point of it.
  std::vector<Vector> displacements(const Vector& scale) const {
    constexpr Real alike = 1e-14L;  // a few times the rounding of their components, which are doubles
    std::vector<Vector> all;
    for (const std::vector<double>& stated : motion_.symmetries) {
      Vector x = Eigen::Map<const Eigen::VectorXd>(stated.data(), 2 * n_).cast<Real>();
      x = (seen_ * x).cwiseQuotient(scale).eval();
      if (!(x.norm() > 0)) continue;
      x.normalize();
      const bool known =
          std::ranges::any_of(all, [&](const Vector& y) { return (x - y).norm() <= alike || (x + y).norm() <= alike; });
      if (!known) all.push_back(std::move(x));
    }
    return all;
  }
  static void leave_out(Linearisation& result, Index count) {
    for (; count > 0; --count) {
      const auto least = std::min_element(result.modes.begin(), result.modes.end(), [](const Mode& a, const Mode& b) {
        return std::hypot(a.growth_rate, a.frequency) < std::hypot(b.growth_rate, b.frequency);
      });
      if (least == result.modes.end() || !is_neutral(*least)) return;
      result.modes.erase(least);
    }
  }

  // A body moves in a mode if a coordinate of it or of a body that it hangs on does.
  bool moves(int body, const Eigen::VectorXd& size) const {
    for (int i = body; i != ground; i = tree_.body(i).parent)
      for (int k = tree_.body(i).v; k < tree_.body(i).v + velocity_size(tree_.body(i).joint); ++k)
        if (size[k] > takes_part || size[n_ + k] > takes_part) return true;
    return false;
  }

  const SteadyMotion& motion_;
  const Model<double>& tree_;
  AccelerationSlopes slopes_;
  Index n_;
  int unsteady_ = -1;
  Matrix seen_;  // takes unseen motions out of deviations
  double pace_ = 0;
  Doubted A_;
  Vector scale_;
  DeviationRows rows_;
  Vector coupled_;  // the possible error of deviations that follow from others
};

}  // namespace

Linearisation linearise(const SteadyMotion& motion) { return Lineariser(motion).linearise(); }

std::optional<AllowedDeviations> allowed_deviations(const SteadyMotion& motion) {
  Lineariser lineariser(motion);
  if (!lineariser.form()) return std::nullopt;
  return lineariser.allowed();
}

Stability stability(const Linearisation& linearisation, int body) {
  Stability found = Stability::stable;
  for (const Mode& mode : linearisation.modes) {
    if (mode.moves.empty() || (body != everything && !mode.moves[static_cast<std::size_t>(body)])) continue;
    const bool grows = mode.growth_rate > mode.doubt, dies_out = mode.growth_rate < -mode.doubt;
    if (grows)
      found = Stability::unstable;
    else if (found == Stability::stable && !dies_out && is_doubtful(mode))
      found = Stability::undecided;
  }
  return found;
}

}  // namespace poinsot::solve
