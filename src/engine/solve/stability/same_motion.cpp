#include "engine/solve/stability/same_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;

// A matrix A, and bounds for the error of A x.
class Uncertain {
 public:
  explicit Uncertain(const Doubted& A) : A_(A.value) {
    // Of the terms, beside ten times the bounds of their rounding, which do not know of poses that are solved to 1e-12
    // and of facts that hold to 1e-9.
    constexpr Real closely = 1e-9L;
    doubt_of_terms_ = 10 * A.doubt + closely * A_.cwiseAbs();
    const Index n = A_.rows() / 2;
    const Real stiffness = n > 0 ? A_.bottomLeftCorner(n, n).cwiseAbs().maxCoeff() : 0;
    // A spinning body whose mass center lies on its axis but for rounding is pulled back as it turns, by that
    // rounding times the square of the pace. Such a stiffness must not count, unless it is no small part of the whole
    // stiffness: then it may belong to a slow motion.
    unbalance_ = std::min<Real>(20 * std::numeric_limits<double>::epsilon(), 1e-4L * stiffness);
  }
  Index size() const { return A_.rows(); }
  Matrix times(const Matrix& x) const { return A_ * x; }
  // The error bound of A x, for the sizes of the entries of x.
  Vector uncertainty(const Vector& sizes) const {
    return doubt_of_terms_ * sizes + Vector::Constant(A_.rows(), unbalance_);
  }

 private:
  const Matrix& A_;
  Matrix doubt_of_terms_;
  Real unbalance_ = 0;
};
bool is_within(const Vector& left, const Vector& allowed) { return ((left.cwiseAbs() - allowed).array() <= 0).all(); }
bool is_symmetry(const Uncertain& A, const Vector& x) { return is_within(A.times(x), A.uncertainty(x.cwiseAbs())); }

// By how much a deviation of length one breaks each condition, as far as this exceeds the error of the condition.
Vector breach(const DeviationRows& rows, const Vector& x) {
  const Vector broken = rows.value * x, off = broken.cwiseAbs() - 10 * rows.doubt;
  return (off.array() > within).select(broken, Vector::Zero(off.size()));
}
bool is_possible(const DeviationRows& rows, const Vector& x) { return breach(rows, x).isZero(0); }

// The columns of both, without those that depend on columns before them.
Matrix joined(const Matrix& one, const Matrix& other) {
  Matrix found = one;
  for (Index i = 0; i < other.cols(); ++i) {
    Matrix more(other.rows(), found.cols() + 1);
    more << found, other.col(i);
    Eigen::ColPivHouseholderQR<Matrix> qr(more);
    qr.setThreshold(within);
    if (qr.rank() == more.cols()) found = more;
  }
  return found;
}

// Of the displacements, those that are possible and lead to the same motion again (A x = 0), independent of each
// other. A x is zero only if it is no more than the error of the terms that cancel in it: a slow motion beside a fast
// one has small entries that are not zero.
Matrix symmetries_of(const Uncertain& A, const DeviationRows& rows, const std::vector<Vector>& displacements) {
  const Matrix none(A.size(), 0);
  Matrix found = none, impossible = none;
  for (const Vector& x : displacements) {
    if (!is_symmetry(A, x)) continue;
    Matrix& list = is_possible(rows, x) ? found : impossible;
    list = joined(list, x);
  }
  if (impossible.cols() == 0) return found;
  // Displacements that are impossible each by itself may be possible together, as shifts along and across a slope
  // are.
  Matrix breaches(rows.value.rows(), impossible.cols());
  for (Index i = 0; i < impossible.cols(); ++i) breaches.col(i) = breach(rows, impossible.col(i));
  const Matrix together = (impossible * complement(breaches.transpose())).colwise().normalized();
  return joined(found, together);
}

// Writes A times each deviation as a combination of the columns; returns nothing if it is no combination of them.
std::optional<Matrix> parts_among(const Matrix& columns, const Uncertain& A, const Matrix& deviations) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(columns);
  const Matrix led = A.times(deviations), parts = qr.solve(led), left = led - columns * parts;
  const Index n = columns.cols();
  const Matrix sizes = columns.cwiseAbs();
  const Vector size = sizes.rowwise().sum();
  std::optional<Matrix> inverse_size;
  for (Index i = 0; i < left.cols(); ++i) {
    const Vector rounding = A.uncertainty(size + deviations.col(i).cwiseAbs());
    // The error of the right sides passes into the combination too. A cheap bound mostly shows that it is not enough
    // to explain what is left: the inverse of the factor R is at most sqrt(n) 2^(n-1) / r_nn (Higham, SIAM Review 29,
    // 575, 1987). Only where it does not, the inverse itself is computed.
    const Real most = std::sqrt(Real(n)) * std::ldexp(Real(1), static_cast<int>(n) - 1) * rounding.norm();
    const Real least = std::abs(qr.matrixR()(n - 1, n - 1));
    if (!is_within(least * left.col(i), least * rounding + most * size)) return std::nullopt;
    if (!inverse_size) inverse_size = qr.solve(Matrix::Identity(columns.rows(), columns.rows())).cwiseAbs();
    if (!is_within(left.col(i), rounding + sizes * (*inverse_size * rounding))) return std::nullopt;
  }
  return parts;
}

// Two displacements of length one, perpendicular to each other, and what A makes of them.
struct TurningPair {
  Vector x, u, led_x, led_u;
  Vector rounding;  // a bound for the error of led_x and of led_u
};

// How such a pair turns into itself: the coefficients of A (x u) = (x u) T; nothing if it leads elsewhere too, or does
// not turn.
std::optional<Eigen::Matrix<Real, 2, 2>> turning_of(const TurningPair& pair) {
  Eigen::Matrix<Real, 2, 2> turned;
  turned << pair.x.dot(pair.led_x), pair.x.dot(pair.led_u), pair.u.dot(pair.led_x), pair.u.dot(pair.led_u);
  // Both rates are imaginary. Of a pair that leads steadily away, as the heading of a bicycle and its shift to the side
  // do, both vanish.
  constexpr Real beyond_rounding = 1e-6L;
  if (!(turned.determinant() > beyond_rounding * std::abs(turned(0, 1) * turned(1, 0)))) return std::nullopt;
  // The errors of A x and A u pass into the coefficients too.
  const Vector size = pair.x.cwiseAbs() + pair.u.cwiseAbs();
  const Vector allowed = pair.rounding + pair.rounding.norm() * size;
  for (Index i = 0; i < 2; ++i) {
    const Vector& led = i == 0 ? pair.led_x : pair.led_u;
    if (!is_within(led - turned(0, i) * pair.x - turned(1, i) * pair.u, allowed)) return std::nullopt;
  }
  return turned;
}

// In a frame that turns, displacements across its axis that lead to the same motion elsewhere go round: pairs of them
// turn into each other. If the velocities of such displacements are possible as well, these go round at growing
// distance. Neither says anything about the stability of the motion.
Matrix goings_round(const Uncertain& A, const DeviationRows& rows, const std::vector<Vector>& displacements,
                    std::vector<double>& frequencies) {
  Matrix found(A.size(), 0);
  std::vector<Vector> all = displacements, led, rounding;
  std::erase_if(all, [&](const Vector& x) { return !is_possible(rows, x) || is_symmetry(A, x); });
  for (const Vector& x : all) {
    led.push_back(A.times(x));
    rounding.push_back(A.uncertainty(x.cwiseAbs()));
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const Real common = all[i].dot(all[k]);
      const Vector across = all[k] - common * all[i];
      const Real left = across.norm();
      constexpr Real one_direction = 1e-6L;  // what is left of one beside the other has lost six digits by then
      if (!(left > one_direction)) continue;
      const TurningPair both_displacements{all[i], across / left, led[i], (led[k] - common * led[i]) / left,
                                           (2 * rounding[i] + rounding[k]) / left};
      const auto turned = turning_of(both_displacements);
      if (!turned) continue;
      Matrix pair(A.size(), 2);
      pair << both_displacements.x, both_displacements.u;
      const auto add = [&](const Matrix& more) {
        const Index before = found.cols();
        found = joined(found, more);
        if (found.cols() > before) frequencies.push_back(static_cast<double>(std::sqrt(turned->determinant())));
      };
      add(pair);
      Matrix drifts = Matrix::Zero(A.size(), 2), both(A.size(), 4);
      drifts.bottomRows(A.size() / 2) = pair.topRows(A.size() / 2);
      both << pair, drifts;
      if (!is_possible(rows, drifts.col(0)) || !is_possible(rows, drifts.col(1))) continue;
      // The velocities must go round at the same rate as the displacements. (Velocities of a turned body wobble and
      // do not.)
      const std::optional<Matrix> drifted = parts_among(both, A, drifts);
      constexpr Real same_rate = 1e-6L;  // of entries that are known to `closely` and divided by what is left
      if (drifted && (drifted->bottomRows(2) - *turned).norm() <= same_rate * turned->norm()) add(drifts);
    }
  return found;
}

// Adds to such displacements those that make them change steadily: a disk that rolls in a slightly different
// direction moves farther and farther away.
Matrix leading_to(Matrix elsewhere, const Uncertain& A, const DeviationRows& rows,
                  const std::vector<Vector>& displacements) {
  if (elsewhere.cols() == 0) return elsewhere;
  for (const Vector& x : displacements)
    if (is_possible(rows, x) && parts_among(elsewhere, A, x)) elsewhere = joined(elsewhere, x);
  return elsewhere;
}

}  // namespace

Matrix complement(const Matrix& columns, Real dependent) {
  Eigen::ColPivHouseholderQR<Matrix> qr(columns);
  qr.setThreshold(dependent);
  const Matrix Q = qr.householderQ() * Matrix::Identity(columns.rows(), columns.rows());
  return Q.rightCols(columns.rows() - qr.rank());
}

SameMotion same_motion(const Doubted& doubted, const DeviationRows& rows, const std::vector<Vector>& displacements) {
  const Uncertain A(doubted);
  const Matrix symmetries = symmetries_of(A, rows, displacements);
  SameMotion found;
  const Matrix going = joined(symmetries, goings_round(A, rows, displacements, found.going_round));
  found.elsewhere = leading_to(going, A, rows, displacements);
  found.momenta = symmetries.cols() + found.elsewhere.cols() - going.cols();
  return found;
}

VanishingDirections vanishing_directions(const Doubted& A) {
  if (A.value.rows() == 0) return {A.value, A.value, A};
  const Eigen::JacobiSVD<Matrix> svd(A.value, Eigen::ComputeFullV);
  const Matrix& all = svd.matrixV();
  Eigen::Index count = 0;
  Matrix doubt = A.doubt;
  for (; count < all.cols(); ++count) {
    const Vector n = all.col(all.cols() - 1 - count), left = (A.value * n).cwiseAbs(), size = n.cwiseAbs();
    if (!((left - 10 * (A.doubt * size)).array() <= 0).all()) break;
    doubt += left * size.transpose();
  }
  if (count == 0) return {all.rightCols(0), all, A};
  const Matrix directions = all.rightCols(count), others = complement(directions), size = others.cwiseAbs();
  return {directions, others, {between(others, A.value, others), between(size, doubt, size)}};
}

}  // namespace poinsot::solve
