// The laws of spatial vectors, transforms and inertias.
#include "poinsot/engine/math/algebra/spatial.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace poinsot {
namespace spatial_test {

class SpatialLaws : public ::testing::Test {
 protected:
  double number() { return uniform_(engine_); }
  Vector3<double> vector() { return {number(), number(), number()}; }
  SpatialMotion<double> motion() { return {vector(), vector()}; }
  SpatialForce<double> force() { return {vector(), vector()}; }
  SpatialTransform<double> transform() { return {rotation_exponential(3.0 * vector()), vector()}; }
  SpatialInertia<double> inertia() {
    SpatialInertia<double> sum = SpatialInertia<double>::zero();
    for (int i = 0; i < 4; ++i) sum += SpatialInertia<double>::of(1.0 + number() / 2.0, vector(), {});
    return sum;
  }
  ArticulatedInertia<double> articulated() {
    ArticulatedInertia<double> I = ArticulatedInertia<double>::of(inertia());
    const SpatialForce<double> U = force();
    return reduced(I, U, 0.1);
  }
  static Eigen::Matrix<double, 6, 1> column(const SpatialMotion<double>& m) {
    return {m.angular.x, m.angular.y, m.angular.z, m.linear.x, m.linear.y, m.linear.z};
  }
  static Eigen::Matrix<double, 6, 1> column(const SpatialForce<double>& f) {
    return {f.moment.x, f.moment.y, f.moment.z, f.force.x, f.force.y, f.force.z};
  }
  static double difference(const SpatialMotion<double>& a, const SpatialMotion<double>& b) {
    return (column(a) - column(b)).norm();
  }
  static double difference(const SpatialForce<double>& a, const SpatialForce<double>& b) {
    return (column(a) - column(b)).norm();
  }
  // The 6x6 matrix of a linear map from motions to forces, column by column.
  template <class Inertia>
  static Eigen::Matrix<double, 6, 6> matrix(const Inertia& I) {
    Eigen::Matrix<double, 6, 6> A;
    for (int k = 0; k < 6; ++k) {
      SpatialMotion<double> unit = SpatialMotion<double>::zero();
      (k < 3 ? unit.angular : unit.linear)[static_cast<std::size_t>(k % 3)] = 1.0;
      A.col(k) = column(I * unit);
    }
    return A;
  }

  std::mt19937_64 engine_{5};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  static constexpr double few = 2e-14;
};

TEST_F(SpatialLaws, transforms_form_a_group_that_keeps_power) {
  for (int trial = 0; trial < 1000; ++trial) {
    const SpatialTransform<double> X = transform();
    const SpatialTransform<double> Y = transform();
    const SpatialMotion<double> v = motion();
    const SpatialForce<double> f = force();
    const Vector3<double> point = vector();
    ASSERT_LT(difference((X * Y) * v, X * (Y * v)), few);
    ASSERT_LT(difference((X * Y) * f, X * (Y * f)), few);
    ASSERT_LT(norm((X * Y) * point - X * (Y * point)), few);
    ASSERT_LT(difference(inverse_times(X, X * v), v), few);
    ASSERT_LT(difference(inverse_times(X, X * f), f), few);
    ASSERT_LT(difference(inverse(X) * (X * v), v), few);
    ASSERT_LT(norm(inverse(X) * (X * point) - point), few);
    ASSERT_NEAR(dot(X * v, X * f), dot(v, f), few);
    // Products go over into products of the transformed.
    const SpatialMotion<double> m = motion();
    ASSERT_LT(difference(X * cross_motion(v, m), cross_motion(X * v, X * m)), 4.0 * few);
    ASSERT_LT(difference(X * cross_force(v, f), cross_force(X * v, X * f)), 4.0 * few);
  }
}

TEST_F(SpatialLaws, cross_products_are_dual_and_obey_jacobi) {
  for (int trial = 0; trial < 1000; ++trial) {
    const SpatialMotion<double> a = motion();
    const SpatialMotion<double> b = motion();
    const SpatialMotion<double> c = motion();
    const SpatialForce<double> f = force();
    ASSERT_NEAR(dot(cross_motion(a, b), f), -dot(b, cross_force(a, f)), few);
    ASSERT_LT(difference(cross_motion(a, b), -1.0 * cross_motion(b, a)), few);
    ASSERT_LT(difference(cross_motion(a, cross_motion(b, c)) + cross_motion(b, cross_motion(c, a)) +
                             cross_motion(c, cross_motion(a, b)),
                         SpatialMotion<double>::zero()),
              few);
  }
}

TEST_F(SpatialLaws, inertia_is_that_of_its_particles) {
  for (int trial = 0; trial < 300; ++trial) {
    const SpatialMotion<double> v = motion();
    SpatialInertia<double> I = SpatialInertia<double>::zero();
    SpatialForce<double> momentum = SpatialForce<double>::zero();
    for (int i = 0; i < 5; ++i) {
      const double m = 1.0 + number() / 2.0;
      const Vector3<double> r = vector();
      I += SpatialInertia<double>::of(m, r, {});
      const Vector3<double> L = m * (v.linear + cross(v.angular, r));
      momentum += {cross(r, L), L};
    }
    ASSERT_LT(difference(I * v, momentum), few);
    const Eigen::Matrix<double, 6, 6> A = matrix(I);
    ASSERT_LT((A - A.transpose()).norm(), few);
    ASSERT_GT(A.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -few);
    ASSERT_LT((matrix(ArticulatedInertia<double>::of(I)) - A).norm(), few);
  }
}

TEST_F(SpatialLaws, inertias_transform_with_their_motions) {
  for (int trial = 0; trial < 1000; ++trial) {
    const SpatialTransform<double> X = transform();
    const SpatialInertia<double> I = inertia();
    const SpatialMotion<double> v = motion();
    ASSERT_LT(difference((X * I) * (X * v), X * (I * v)), 10.0 * few);
    const Vector3<double> r = vector();
    const SpatialTransform<double> shift = SpatialTransform<double>::translation(r);
    ASSERT_LT(difference(shifted(I, r) * (shift * v), shift * (I * v)), 10.0 * few);
    const ArticulatedInertia<double> J = articulated();
    ASSERT_LT(difference(shifted(J, r) * (shift * v), shift * (J * v)), 10.0 * few);
    const Eigen::Matrix<double, 6, 6> A = matrix(shifted(J, r));
    ASSERT_LT((A - A.transpose()).norm(), 10.0 * few);
  }
}

TEST_F(SpatialLaws, reduced_takes_away_a_dyad) {
  for (int trial = 0; trial < 300; ++trial) {
    const ArticulatedInertia<double> J = articulated();
    const SpatialForce<double> U = force();
    const double s = number();
    const Eigen::Matrix<double, 6, 6> expected = matrix(J) - s * column(U) * column(U).transpose();
    ASSERT_LT((matrix(reduced(J, U, s)) - expected).norm(), few);
  }
}

TEST_F(SpatialLaws, inverse_of_a_symmetric_matrix) {
  for (int trial = 0; trial < 300; ++trial) {
    const SymmetricMatrix3<double> A = inertia().inertia;
    const Matrix3<double> one = as_matrix(A) * as_matrix(inverse(A));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) ASSERT_NEAR(one(i, j), i == j ? 1.0 : 0.0, 1e-11);
    }
  }
}

}  // namespace spatial_test
}  // namespace poinsot
