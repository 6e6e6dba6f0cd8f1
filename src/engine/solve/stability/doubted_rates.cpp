#include "engine/solve/stability/doubted_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "poinsot/engine/work/budget.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

using Index = Eigen::Index;

// Scales A by a diagonal matrix of powers of two, such that rows and columns have similar sizes (Parlett and Reinsch
// 1969).
Vector balanced(Matrix& A) {
  Vector scale = Vector::Ones(A.rows());
  for (bool changed = true; changed;) {
    changed = false;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      const Real own = std::abs(A(i, i));
      const Real column = A.col(i).cwiseAbs().sum() - own, row = A.row(i).cwiseAbs().sum() - own;
      if (!(column > 0) || !(row > 0)) continue;
      const int power = static_cast<int>(std::lround(std::log2(row / column) / 2));
      const Real factor = std::ldexp(Real(1), power);
      if (power == 0 || column * factor + row / factor >= 0.95L * (column + row)) continue;
      A.col(i) *= factor;
      A.row(i) /= factor;
      scale[i] *= factor;
      changed = true;
    }
  }
  return scale;
}

// Rates that coincide without disturbing each other, as those of two bodies that are alike: A = X T W with W X = 1 on
// the space of their motions, and T a multiple of one. Eigenvalue by eigenvalue such motions are badly determined,
// since any combination of them is one too; together they are known well.
class RatesTogether {
 public:
  // Of the eigenvalues with these numbers; the motions of A and of its transpose come from inverse iteration.
  RatesTogether(const Matrix& A, const Rates& rates, const std::vector<Index>& together) {
    const auto count = static_cast<Index>(together.size());
    const auto n = static_cast<Work>(A.rows());
    count_work(20 * n * n * n);
    for (const Index m : together) rate_ += rates.value[m] / Real(count);
    // So far beside the rate that the equations can be solved, and so near that two steps are enough.
    const std::complex<Real> beside = rate_ + std::complex<Real>(0.7L, 0.6L) * (1e-12L * A.norm());
    const ComplexMatrix wide = A.cast<std::complex<Real>>();
    ComplexMatrix shifted = wide;
    shifted.diagonal().array() -= beside;
    motions_ = iterated(shifted, count);
    const ComplexMatrix transposed = shifted.transpose();
    left_ = iterated(transposed, count).transpose();
    const ComplexMatrix overlaps = left_ * motions_, led = wide * motions_;
    left_ = Eigen::PartialPivLU<ComplexMatrix>(overlaps).solve(left_).eval();
    ComplexMatrix T = left_ * led;
    rate_ = T.trace() / Real(count);
    T.diagonal().array() -= rate_;
    apart_ = T.norm();
  }
  std::complex<Real> rate() const { return rate_; }
  // By how much the rates may differ from it: as T is no multiple of one, and as the entries of A are in doubt.
  Real doubt(const Matrix& of_entries, Real solving) const {
    const Matrix W = left_.cwiseAbs(), X = motions_.cwiseAbs();
    return apart_ + (W * of_entries * X).norm() + solving * W.norm() * X.norm();
  }
  // The motions, each with as few parts as possible: those of two bodies that know nothing of each other come out as
  // the motions of one and of the other.
  ComplexMatrix motions() const {
    ComplexMatrix X = motions_;
    for (Index k = 0; k < X.cols(); ++k) {
      Index pivot = 0;
      X.col(k).cwiseAbs().maxCoeff(&pivot);
      const std::complex<Real> most = X(pivot, k);
      X.col(k) /= most;
      for (Index other = 0; other < X.cols(); ++other)
        if (other != k) X.col(other) -= X(pivot, other) * X.col(k);
    }
    return X;
  }

 private:
  static ComplexMatrix iterated(const ComplexMatrix& shifted, Index count) {
    const Eigen::PartialPivLU<ComplexMatrix> solver(shifted);
    // Columns that are not alike and have a part of every motion.
    ComplexMatrix X = ComplexMatrix::NullaryExpr(shifted.rows(), count, [](Index i, Index k) {
      return std::complex<Real>(std::cos(Real(1 + i * (k + 1))), std::sin(Real(2 + k + i * i)));
    });
    // Each step of inverse iteration takes out the part that other motions have, by 1e12 over the distance of their
    // rates: two are enough, and the third is for rates that are in the way.
    for (int step = 0; step < 3; ++step) {
      X = solver.solve(X).eval();
      for (Index k = 0; k < count; ++k) {
        for (int twice = 0; twice < 2; ++twice)
          for (Index j = 0; j < k; ++j) X.col(k) -= X.col(j) * X.col(j).dot(X.col(k));
        X.col(k).normalize();
      }
    }
    return X;
  }

  std::complex<Real> rate_ = 0;
  ComplexMatrix motions_, left_;
  Real apart_ = 0;
};

// Takes rates that coincide together where they are known as well so, with motions of as few parts as possible.
void join_equal(const Matrix& A, const Matrix& doubt, Real solving, Rates& rates) {
  // Of the size of A: far more than the rounding of long doubles, far less than what rates in doubt of doubles that
  // disturb each other lie apart.
  constexpr Real alike = 1e-12L;
  // Of rates that disturb each other each smaller set would be tried anew: few of these are worth it.
  constexpr int most_again = 3;
  int again = 0;
  std::vector<bool> joined(static_cast<std::size_t>(rates.value.size()), false), failed = joined;
  for (Index m = 0; m < rates.value.size(); ++m) {
    if (joined[static_cast<std::size_t>(m)]) continue;
    std::vector<Index> together{m};
    for (Index k = m + 1; k < rates.value.size(); ++k)
      if (std::abs(rates.value[k] - rates.value[m]) <= alike * A.norm()) together.push_back(k);
    if (together.size() == 1) continue;
    const bool has_failed = std::ranges::all_of(together, [&](Index k) { return failed[static_cast<std::size_t>(k)]; });
    if (has_failed && ++again > most_again) continue;
    const RatesTogether all(A, rates, together);
    const auto bound = static_cast<double>(all.doubt(doubt, solving));
    // Not where they disturb each other: then T is far from a multiple of one.
    const auto worse = [&](Index k) { return !(bound < rates.doubt[k]); };
    double largest = 0;
    for (const Index k : together) largest = std::max(largest, rates.doubt[k]);
    const bool better = std::ranges::none_of(together, worse) || (std::isfinite(largest) && bound <= 10 * largest);
    if (!better) {
      for (const Index k : together) failed[static_cast<std::size_t>(k)] = true;
      continue;
    }
    // A real rate stays one: its conjugate is among those that coincide.
    std::complex<Real> rate = all.rate();
    if (std::abs(rate.imag()) <= alike * A.norm()) rate.imag(0);
    const ComplexMatrix motions = all.motions();
    for (std::size_t i = 0; i < together.size(); ++i) {
      const Index k = together[i];
      joined[static_cast<std::size_t>(k)] = true;
      rates.value[k] = rate;
      rates.doubt[k] = bound;
      rates.motion.col(k) = motions.col(static_cast<Index>(i)).normalized();
    }
  }
}

// Of a matrix that does not fall apart.
Rates connected_rates(const Doubted& A) {
  Matrix even = A.value;
  const Vector scale = balanced(even);
  Rates rates;
  const Eigen::Index n = even.rows();
  if (n == 0) return rates;
  const Work cube = static_cast<Work>(n) * static_cast<Work>(n) * static_cast<Work>(n);
  count_work(40 * cube);
  const std::optional<Spectrum> spectrum = spectrum_of(even, true);
  if (!spectrum) {
    rates.value = ComplexVector::Zero(n);
    rates.doubt = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
    rates.motion = ComplexMatrix::Identity(n, n);
    return rates;
  }
  rates.value = spectrum->value;
  count_work(20 * cube);
  const ComplexMatrix &right = spectrum->motion, left = inverse(right);
  check_budget();
  const Matrix doubt = scale.cwiseInverse().asDiagonal() * A.doubt * scale.asDiagonal();
  const Real solving = 8 * static_cast<Real>(n) * std::numeric_limits<Real>::epsilon() * even.norm();
  rates.doubt.resize(n);
  for (Eigen::Index m = 0; m < n; ++m) {
    const Vector w = left.row(m).cwiseAbs().transpose(), x = right.col(m).cwiseAbs();
    const Real most = w.dot(doubt * x) + solving * w.norm() * x.norm();
    rates.doubt[m] = std::isfinite(most) ? static_cast<double>(most) : std::numeric_limits<double>::infinity();
  }
  rates.motion = right;
  join_equal(even, doubt, solving, rates);
  rates.motion = (scale.asDiagonal() * rates.motion).eval();
  return rates;
}

// The places of a matrix that depend on each other, directly or by others: bodies that know nothing of each other come
// apart.
std::vector<std::vector<Index>> connected_places(const Doubted& A) {
  const Index n = A.value.rows();
  std::vector<std::vector<Index>> parts;
  std::vector<bool> reached(static_cast<std::size_t>(n), false);
  for (Index first = 0; first < n; ++first) {
    if (reached[static_cast<std::size_t>(first)]) continue;
    reached[static_cast<std::size_t>(first)] = true;
    std::vector<Index> part{first};
    for (std::size_t next = 0; next < part.size(); ++next)
      for (Index k = 0; k < n; ++k) {
        const auto bound = [&](Index i, Index j) { return A.value(i, j) != 0 || !(A.doubt(i, j) <= 0); };
        if (reached[static_cast<std::size_t>(k)] || !(bound(part[next], k) || bound(k, part[next]))) continue;
        reached[static_cast<std::size_t>(k)] = true;
        part.push_back(k);
      }
    std::ranges::sort(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

Matrix product(const Matrix& A, const Matrix& B) { return Eigen::Product<Matrix, Matrix>(A, B); }
Vector product(const Matrix& A, const Vector& x) { return Eigen::Product<Matrix, Vector>(A, x); }
ComplexMatrix product(const ComplexMatrix& A, const ComplexMatrix& B) {
  return Eigen::Product<ComplexMatrix, ComplexMatrix>(A, B);
}

Matrix between(const Matrix& left, const Matrix& A, const Matrix& right) {
  const Matrix led = A * right, turned = left.transpose();
  return turned * led;
}

ComplexMatrix inverse(const ComplexMatrix& A) {
  return Eigen::PartialPivLU<ComplexMatrix>(A).solve(ComplexMatrix::Identity(A.rows(), A.rows()).eval());
}

std::optional<Spectrum> spectrum_of(const Matrix& A, bool with_motions) {
  // The steps of the QR algorithm may go round in a circle where rates are equal and opposite. In another basis, here
  // after one more reflection, they do not.
  constexpr int bases = 5;
  const Index n = A.rows();
  Matrix turned = A, basis = Matrix::Identity(n, n);
  for (int tried = 1; tried <= bases; ++tried) {
    const Eigen::EigenSolver<Matrix> solver(turned, with_motions);
    if (solver.info() == Eigen::Success) {
      Spectrum found{solver.eigenvalues(), {}};
      if (with_motions)
        found.motion = tried == 1 ? solver.eigenvectors() : basis.cast<std::complex<Real>>() * solver.eigenvectors();
      return found;
    }
    const Vector v = Vector::NullaryExpr(n, [&](Index i) { return std::sin(Real(tried + i * i)); }).normalized();
    const Matrix reflection = Matrix::Identity(n, n) - 2 * v * v.transpose();
    turned = reflection * turned * reflection;
    basis = basis * reflection;
  }
  return std::nullopt;
}

// Part by part: that takes less than all at once, and rates of one part are not in doubt for those of another that are
// the same.
Rates rates_of(const Doubted& A) {
  const std::vector<std::vector<Index>> parts = connected_places(A);
  if (parts.size() < 2) return connected_rates(A);
  const Index n = A.value.rows();
  Rates rates;
  rates.value.resize(n);
  rates.doubt.resize(n);
  rates.motion = ComplexMatrix::Zero(n, n);
  Index first = 0;
  for (const std::vector<Index>& part : parts) {
    const Rates own = connected_rates({A.value(part, part), A.doubt(part, part)});
    const auto count = static_cast<Index>(part.size());
    rates.value.segment(first, count) = own.value;
    rates.doubt.segment(first, count) = own.doubt;
    for (Index k = 0; k < count; ++k)
      for (Index i = 0; i < count; ++i) rates.motion(part[static_cast<std::size_t>(i)], first + k) = own.motion(i, k);
    first += count;
  }
  return rates;
}

}  // namespace poinsot::solve
