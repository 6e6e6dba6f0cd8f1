// The laws of rotations, for matrices and quaternions alike, on zero, tiny and random elements.
#include "poinsot/engine/math/algebra/rotation.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/quaternion.h"

namespace poinsot {
namespace rotation_test {

template <class Scalar>
double defect(const Matrix3<Scalar>& a, const Matrix3<Scalar>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      largest = std::max(largest, std::fabs(static_cast<double>(a(i, j) - b(i, j))));
    }
  }
  return largest;
}
template <class Scalar>
double defect(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return static_cast<double>(norm(a - b));
}

// Rotation vectors: zero, tiny, either side of every switch, random, and several turns.
template <class Scalar>
std::vector<Vector3<Scalar>> turns() {
  std::vector<Vector3<Scalar>> list{Vector3<Scalar>::zero()};
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto direction = [&] {
    return normalized(Vector3<Scalar>{Scalar(uniform(engine)), Scalar(uniform(engine)), Scalar(uniform(engine))});
  };
  for (const double size : {1e-300, 1e-20, 1e-8, 1e-4, 1e-2, 0.5, 1.0, 1.999999, 2.000001, 3.1415926, 3.1415927,
                            3.999999, 4.000001, 6.283185, 20.0}) {
    for (int i = 0; i < 5; ++i) list.push_back(Scalar(size) * direction());
  }
  for (int i = 0; i < 1000; ++i) list.push_back(Scalar(3.2 * uniform(engine)) * direction());
  return list;
}

template <class Scalar>
class RotationLaws : public ::testing::Test {};
using Scalars = ::testing::Types<double, long double>;
TYPED_TEST_SUITE(RotationLaws, Scalars);

TYPED_TEST(RotationLaws, hold_for_all_elements) {
  using Scalar = TypeParam;
  const double few = 16.0 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  const Matrix3<Scalar> one = Matrix3<Scalar>::identity();
  const std::vector<Vector3<Scalar>> list = turns<Scalar>();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Vector3<Scalar>& a = list[k];
    const Vector3<Scalar>& b = list[(k * 7 + 3) % list.size()];
    const double size = 1.0 + static_cast<double>(norm(a) + norm(b));
    const Matrix3<Scalar> A = rotation_exponential(a);
    const Matrix3<Scalar> B = rotation_exponential(b);
    const Quaternion<Scalar> p = quaternion_exponential(a);
    const Quaternion<Scalar> q = quaternion_exponential(b);
    // Orthonormal, right-handed; the inverse is the exponential of the opposite.
    ASSERT_LT(orthonormality_defect(A), few * size);
    ASSERT_LT(defect(A * rotation_exponential(-a), one), few * size);
    ASSERT_LT(static_cast<double>(std::fabs(norm_squared(p) - Scalar(1))), few);
    // Matrices and quaternions tell the same rotation, and multiply alike.
    ASSERT_LT(defect(rotation_matrix(p), A), few * size);
    ASSERT_LT(defect(rotation_matrix(p * q), A * B), few * size);
    ASSERT_LT(defect(rotation_matrix(conjugate(p)), transpose(A)), few * size);
    ASSERT_LT(defect(rotation_matrix(quaternion_of(A)), A), few * size);
    ASSERT_GE(quaternion_of(A).w, Scalar(0));
    // The axis stays; the exponential of a sum along one axis is the product.
    ASSERT_LT(defect(A * a, a), few * size * size);
    ASSERT_LT(defect(rotation_exponential(Scalar(2) * a), A * A), 2.0 * few * size);
    if (norm(a) > Scalar(1e-10)) {
      ASSERT_LT(defect(rotation_about(normalized(a), Scalar(norm(a))), A), few * size);
    }
    // Cross products turn with their factors: A (u x v) = A u x A v.
    ASSERT_LT(defect(A * cross(a, b), cross(A * a, A * b)), few * size * size * size);
    // Tensors turn: R (T v) = (R T R^T) (R v).
    const SymmetricMatrix3<Scalar> T{Scalar(2), Scalar(3), Scalar(4), Scalar(0.3), Scalar(-0.2), Scalar(0.1)};
    ASSERT_LT(defect(A * (T * b), turned(A, T) * (A * b)), 8.0 * few * size * size);
    ASSERT_LT(defect(as_matrix(turned(A, T)), A * as_matrix(T) * transpose(A)), 8.0 * few * size);
  }
}

TEST(Rotation, exponential_keeps_the_digits_of_small_turns) {
  for (double size = 1e-12; size < 3.0; size *= 1.7) {
    const Vector3<double> n = normalized(Vector3<double>{1.0, -2.0, 0.5});
    const Matrix3<double> R = rotation_exponential(size * n);
    const Matrix3<long double> exact = rotation_exponential(Vector3<long double>{static_cast<long double>(size * n.x),
                                                                                 static_cast<long double>(size * n.y),
                                                                                 static_cast<long double>(size * n.z)});
    // Off-diagonal entries to a few units of their own last places.
    EXPECT_NEAR(R.row0.y / static_cast<double>(exact.row0.y), 1.0, 1e-15 * 8);
    EXPECT_NEAR(R.row1.x / static_cast<double>(exact.row1.x), 1.0, 1e-15 * 8);
    const Quaternion<double> q = quaternion_exponential(size * n);
    EXPECT_NEAR(q.x / static_cast<double>(std::sin(size / 2.0L) * n.x), 1.0, 1e-15 * 4);
  }
}

TEST(Rotation, functions_of_squares_agree_with_their_closed_forms) {
  for (long double a = 0.3L; a < 30.0L; a *= 1.01L) {
    const double x = static_cast<double>(a * a);
    const long double b = std::sqrt(static_cast<long double>(x));
    EXPECT_NEAR(sinc_of_square(x), static_cast<double>(std::sin(b) / b), 3e-16);
    // The root of x, rounded, is where the cosine is taken.
    EXPECT_NEAR(cosine_of_square(x), static_cast<double>(std::cos(b)), 2e-16 * (2.0 + static_cast<double>(b)));
    EXPECT_NEAR(cosine_rest_of_square(x), static_cast<double>((1.0L - std::cos(b)) / x), 2e-16);
    EXPECT_NEAR(sine_rest_of_square(x), static_cast<double>((b - std::sin(b)) / (b * x)), 1e-16);
  }
  EXPECT_EQ(sinc_of_square(0.0), 1.0);
  EXPECT_EQ(cosine_rest_of_square(0.0), 0.5);
  EXPECT_EQ(sine_rest_of_square(0.0), 1.0 / 6.0);
}

// Through zero rotation: the derivative of R at a = 0 along e_k is [e_k]x.
TEST(Rotation, exponential_is_smooth_at_zero) {
  using D = Dual<3>;
  const Vector3<D> a{D::variable(0.0, 0), D::variable(0.0, 1), D::variable(0.0, 2)};
  const Matrix3<D> R = rotation_exponential(a);
  const Quaternion<D> q = quaternion_exponential(a);
  for (std::size_t k = 0; k < 3; ++k) {
    const Matrix3<double> expected = cross_matrix(Vector3<double>::unit(k));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(R(i, j).partial[k], expected(i, j));
    }
    EXPECT_EQ(q.w.partial[k], 0.0);
    EXPECT_EQ(vector_part(q)[k].partial[k], 0.5);
  }
}

TEST(Rotation, quaternion_rate_is_the_derivative_of_the_exponential) {
  const Quaternion<double> q = quaternion_exponential(Vector3<double>{0.3, -1.2, 0.7});
  const Vector3<double> w{0.5, 2.0, -1.0};
  using D = Dual<1>;
  const D t = D::variable(0.0, 0);
  const Quaternion<D> moved =
      Quaternion<D>{q.w, q.x, q.y, q.z} * quaternion_exponential(Vector3<D>{t * D(w.x), t * D(w.y), t * D(w.z)});
  const Quaternion<double> rate = quaternion_rate(q, w);
  EXPECT_NEAR(moved.w.partial[0], rate.w, 1e-15);
  EXPECT_NEAR(moved.x.partial[0], rate.x, 1e-15);
  EXPECT_NEAR(moved.y.partial[0], rate.y, 1e-15);
  EXPECT_NEAR(moved.z.partial[0], rate.z, 1e-15);
}

TEST(Rotation, axes_with_z_along_any_direction_are_a_rotation) {
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vector3<double>> directions{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.0, 0.0, -1.0}};
  directions.push_back(normalized(Vector3<double>{1e-9, 1e-12, -1.0}));
  directions.push_back(normalized(Vector3<double>{1e-160, 1.0, -1e-300}));
  for (int i = 0; i < 1000; ++i) {
    directions.push_back(normalized(Vector3<double>{uniform(engine), uniform(engine), uniform(engine)}));
  }
  for (const Vector3<double>& n : directions) {
    const Matrix3<double> R = axes_with_z_along(n);
    EXPECT_LT(orthonormality_defect(R), 1e-15);
    EXPECT_EQ(defect(R.column(2), n), 0.0);
  }
}

TEST(Rotation, turning_about_z_is_a_product) {
  const Matrix3<double> R = rotation_exponential(Vector3<double>{0.3, -1.2, 0.7});
  const Matrix3<double> expected = R * rotation_about(Vector3<double>::unit(2), 0.8);
  EXPECT_LT(defect(turned_about_z(R, sine_cosine(0.8)), expected), 1e-15);
}

TEST(Rotation, defect_tells_reflections_stretchings_and_nan) {
  Matrix3<double> mirror = Matrix3<double>::identity();
  mirror.row2.z = -1.0;
  EXPECT_EQ(orthonormality_defect(mirror), 2.0);
  EXPECT_NEAR(orthonormality_defect(1.5 * Matrix3<double>::identity()), 1.25, 1e-15);
  mirror.row0.x = NAN;
  EXPECT_FALSE(orthonormality_defect(mirror) < 1e300);
}

}  // namespace rotation_test
}  // namespace poinsot
