// Accuracies of eigenvalues against eigenvalues of disturbed matrices.
#include "engine/solve/stability/doubted_rates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/solve/stability/same_motion.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace doubted_rates_test {

// A slow oscillation beside a fast one keeps the accuracy of its own entries.
TEST(DoubtedRates, ASlowRateBesideAFastOne) {
  for (const Real slow : {1e-3L, 1e-6L, 1e-9L}) {
    Matrix A = Matrix::Zero(4, 4);
    A(0, 1) = 1;
    A(1, 0) = -slow * slow;
    A(2, 3) = 1;
    A(3, 2) = -1;
    const Rates rates = rates_of({A, 1e-16L * A.cwiseAbs()});
    Real least = 1;
    for (Eigen::Index m = 0; m < 4; ++m) {
      const Real size = std::abs(rates.value[m]);
      least = std::min(least, size);
      EXPECT_LT(rates.doubt[m], 1e-8 * static_cast<double>(size));
    }
    EXPECT_NEAR(static_cast<double>(least / slow), 1, 1e-8);
  }
}

// A drift, two rates of zero that disturb each other, beside a swing and a decay in another basis: without what leads
// nowhere, and what leads into that, the others are known.
TEST(DoubtedRates, BesideADriftAreThoseOfTheRest) {
  std::mt19937_64 random(82);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 30; ++trial) {
    Matrix A = Matrix::Zero(5, 5);
    A(0, 1) = 1;
    A(2, 3) = 1;
    A(3, 2) = -4;
    A(4, 4) = -0.3L;
    const Matrix S = Matrix::NullaryExpr(5, 5, [&] { return Real(number(random)); }) + 2 * Matrix::Identity(5, 5);
    const Matrix inverse = Eigen::PartialPivLU<Matrix>(S).inverse(), turned = S * A;
    Doubted rest{turned * inverse, Matrix::Constant(5, 5, 1e-14L)};
    int taken = 0;
    for (VanishingDirections one = vanishing_directions(rest); one.directions.cols() > 0;
         one = vanishing_directions(rest)) {
      taken += static_cast<int>(one.directions.cols());
      rest = one.rest;
    }
    ASSERT_EQ(taken, 2) << trial;
    const Rates rates = rates_of(rest);
    for (const std::complex<Real> wanted :
         {std::complex<Real>(0, 2), std::complex<Real>(0, -2), std::complex<Real>(-0.3L, 0)}) {
      Real nearest = 1;
      for (Eigen::Index m = 0; m < rates.value.size(); ++m)
        nearest = std::min(nearest, std::abs(rates.value[m] - wanted));
      EXPECT_LT(static_cast<double>(nearest), 1e-11) << trial;
    }
  }
}

// As small disturbances within the doubts do move them.
TEST(DoubtedRates, DisturbancesMoveThemByNoMore) {
  std::mt19937_64 random(81);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    constexpr Eigen::Index n = 5;
    const Matrix A = Matrix::NullaryExpr(n, n, [&] { return Real(number(random)); });
    const Matrix doubt = Matrix::NullaryExpr(n, n, [&] { return Real(1e-10 * std::abs(number(random))); });
    const Matrix other = A + Matrix::NullaryExpr(n, n, [&] { return Real(number(random)); }).cwiseProduct(doubt);
    const Rates rates = rates_of({A, doubt}), moved = rates_of({other, doubt});
    for (Eigen::Index m = 0; m < n; ++m) {
      Real nearest = 1;
      for (Eigen::Index k = 0; k < n; ++k) nearest = std::min(nearest, std::abs(moved.value[k] - rates.value[m]));
      EXPECT_LE(static_cast<double>(nearest), rates.doubt[m] * (1 + 1e-3)) << trial;
    }
  }
}

// Two upright pendulums that know nothing of each other but for rounding: the steps of the QR algorithm go round in a
// circle.
TEST(DoubtedRates, EqualAndOppositeRates) {
  const Real rounding = std::ldexp(Real(1), -58);
  Matrix A = Matrix::Zero(4, 4);
  A << 0, 0, 1, rounding, 0, 0, -rounding, 1, 1, rounding, 0, 0, -rounding, 1, 0, 0;
  EXPECT_NE(Eigen::EigenSolver<Matrix>(A).info(), Eigen::Success);
  const std::optional<Spectrum> spectrum = spectrum_of(A, true);
  ASSERT_TRUE(spectrum);
  Real sum = 0;
  for (Eigen::Index m = 0; m < 4; ++m) {
    const std::complex<Real> rate = spectrum->value[m];
    EXPECT_LT(std::abs(std::abs(rate.real()) - 1) + std::abs(rate.imag()), 1e-15L);
    sum += rate.real();
    const ComplexMatrix motion = spectrum->motion.col(m), led = A.cast<std::complex<Real>>() * motion;
    EXPECT_LT((led - rate * motion).norm(), 1e-15L * motion.norm());
  }
  EXPECT_LT(std::abs(sum), 1e-15L);
}

// Two that meet can be told only to the root of the entries' doubts.
TEST(DoubtedRates, RatesThatMeetAreDoubtful) {
  Matrix A = Matrix::Zero(2, 2);
  A(0, 1) = 1;
  A(1, 0) = -1e-14L;
  Matrix doubt = Matrix::Zero(2, 2);
  doubt(1, 0) = 1e-14L;
  const Rates rates = rates_of({A, doubt});
  for (Eigen::Index m = 0; m < 2; ++m) EXPECT_GT(4 * rates.doubt[m], static_cast<double>(std::abs(rates.value[m])));
}

// Of a matrix that falls apart, in any order of its places: each part has its own rates, and those that two parts have
// in common are as certain as in one.
TEST(DoubtedRates, PartsThatKnowNothingOfEachOtherAreTakenByThemselves) {
  std::mt19937_64 random(82);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 30; ++trial) {
    const Matrix part = Matrix::NullaryExpr(4, 4, [&] { return Real(number(random)); });
    Matrix A = Matrix::Zero(12, 12);
    A.block(0, 0, 4, 4) = A.block(4, 4, 4, 4) = part;
    A.block(8, 8, 4, 4) = 1e-6L * part;
    Eigen::PermutationMatrix<Eigen::Dynamic> order(12);
    order.setIdentity();
    std::shuffle(order.indices().data(), order.indices().data() + 12, random);
    A = (order * A * order.transpose()).eval();
    const Rates alone = rates_of({part, 1e-18L * part.cwiseAbs()}), all = rates_of({A, 1e-18L * A.cwiseAbs()});
    for (Eigen::Index m = 0; m < 12; ++m) {
      const ComplexVector moved = A.cast<std::complex<Real>>() * all.motion.col(m);
      EXPECT_LT((moved - all.value[m] * all.motion.col(m)).norm(), 1e-16L * A.norm() * all.motion.col(m).norm());
    }
    for (Eigen::Index k = 0; k < 4; ++k) {
      int found = 0;
      for (Eigen::Index m = 0; m < 12; ++m)
        for (const Real size : {1.0L, 1e-6L})
          if (std::abs(all.value[m] - size * alone.value[k]) <= 1e-14L * size) {
            EXPECT_LE(all.doubt[m], 10 * static_cast<double>(size) * alone.doubt[k]);
            ++found;
          }
      EXPECT_EQ(found, 3) << trial;
    }
  }
}

// Many rates that coincide and disturb each other, as those of bodies that drift, take little more than the rates
// themselves.
TEST(DoubtedRates, RatesThatMeetTakeNoMoreForBeingMany) {
  std::mt19937_64 random(83);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Eigen::Index half : {10, 20, 30}) {
    const Eigen::Index n = 2 * half;
    Matrix drift = Matrix::Zero(n, n);
    drift.topRightCorner(half, half).setIdentity();
    const Matrix any = Matrix::NullaryExpr(n, n, [&] { return Real(number(random)); });
    const Matrix Q = Eigen::HouseholderQR<Matrix>(any).householderQ();
    const Matrix A = Q.transpose() * drift * Q;
    const Work before = work_done();
    const Rates rates = rates_of({A, 1e-17L * A.cwiseAbs()});
    EXPECT_LT(work_done() - before, 200 * static_cast<Work>(n * n * n)) << n;
    EXPECT_LT(static_cast<double>(rates.value.cwiseAbs().maxCoeff()), 1e-5);
  }
}

}  // namespace doubted_rates_test
}  // namespace poinsot::solve
