#include "poinsot/engine/mass/principal_axes.h"

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace principal_axes_test {

using testing::near;
using testing::Random;
using Vector = Vector3<double>;
using Tensor = SymmetricMatrix3<double>;

template <class Scalar>
::testing::AssertionResult is_right_handed(const Matrix3<Scalar>& axes) {
  return near(symmetric_part(transpose(axes) * axes), SymmetricMatrix3<Scalar>::diagonal(1, 1, 1), 1e-13) &&
                 std::abs(determinant(axes) - 1) < Scalar(1e-13)
             ? ::testing::AssertionSuccess()
             : ::testing::AssertionFailure() << "not a rotation";
}

template <class Scalar>
void expect_reconstruction(double tolerance) {
  Random<Scalar> random(11);
  for (int i = 0; i < 1000; ++i) {
    const auto tensor = random.body().inertia_center;
    const auto principal = principal_axes(tensor);
    EXPECT_EQ(principal.symmetry, InertiaSymmetry::triaxial);
    EXPECT_LE(principal.moments.x, principal.moments.y);
    EXPECT_LE(principal.moments.y, principal.moments.z);
    EXPECT_TRUE(is_right_handed(principal.axes));
    EXPECT_TRUE(near(principal_tensor(principal.axes, principal.moments), tensor, tolerance));
  }
}
TEST(PrincipalAxes, TensorIsPutTogetherAgain) {
  expect_reconstruction<double>(1e-13);
  expect_reconstruction<long double>(1e-16);
}

TEST(PrincipalAxes, FindsTheAxesABodyWasBuiltOn) {
  Random<double> random(12);
  for (int i = 0; i < 1000; ++i) {
    const auto axes = random.axes();
    const auto principal = principal_axes(principal_tensor(axes, Vector{2, 3, 4.5}));
    EXPECT_TRUE(near(principal.moments, Vector{2, 3, 4.5}, 1e-13));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(dot(principal.axes.column(k), axes.column(k))), 1, 1e-12);
  }
}

TEST(PrincipalAxes, OrderIsAscendingOnCoordinateAxes) {
  const auto principal = principal_axes(Tensor::diagonal(5, 3, 4));
  EXPECT_TRUE(near(principal.moments, Vector{3, 4, 5}, 1e-15));
  EXPECT_TRUE(near(principal.axes.column(0), Vector::unit(1), 1e-15));
  EXPECT_TRUE(near(principal.axes.column(1), Vector::unit(2), 1e-15));
  EXPECT_TRUE(near(principal.axes.column(2), Vector::unit(0), 1e-15));
}

TEST(PrincipalAxes, DisksAndRodsHaveAnAxisOfSymmetry) {
  Random<double> random(13);
  for (int i = 0; i < 1000; ++i) {
    const Vector n = random.unit();
    const auto disk = principal_axes(axisymmetric_tensor(n, 2.0, 1.0));
    EXPECT_EQ(disk.symmetry, InertiaSymmetry::axisymmetric);
    EXPECT_EQ(disk.symmetry_axis, 2u);
    EXPECT_NEAR(std::abs(dot(disk.axes.column(2), n)), 1, 1e-12);
    EXPECT_TRUE(is_right_handed(disk.axes));
    const auto rod = principal_axes(axisymmetric_tensor(n, 0.0, 1.0));
    EXPECT_EQ(rod.symmetry, InertiaSymmetry::axisymmetric);
    EXPECT_EQ(rod.symmetry_axis, 0u);
    EXPECT_NEAR(std::abs(dot(rod.axes.column(0), n)), 1, 1e-12);
    EXPECT_TRUE(is_right_handed(rod.axes));
    // Rounding does not turn the free axes.
    const Tensor noise{3e-16, -2e-16, 1e-16, 2e-16, -1e-16, 3e-16};
    const auto noisy = principal_axes(axisymmetric_tensor(n, 2.0, 1.0) + noise);
    EXPECT_TRUE(near(noisy.axes.column(0), disk.axes.column(0), 1e-12));
  }
  // On coordinate axes the free axes are these.
  EXPECT_TRUE(near(principal_axes(Tensor::diagonal(1, 1, 2)).axes.column(0), Vector::unit(0), 1e-15));
  EXPECT_TRUE(near(principal_axes(Tensor::diagonal(0, 1, 1)).axes.column(1), Vector::unit(1), 1e-15));
}

TEST(PrincipalAxes, SphericalTensorsKeepTheCoordinateAxes) {
  const auto sphere = principal_axes(isotropic_tensor(0.4));
  EXPECT_EQ(sphere.symmetry, InertiaSymmetry::spherical);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(norm(sphere.axes.column(k) - Vector::unit(k)), 0);
  EXPECT_EQ(principal_axes(Tensor::zero()).symmetry, InertiaSymmetry::spherical);
}

TEST(PrincipalAxes, EqualityIsAsCloseAsTheCallerSays) {
  const Tensor nearly = Tensor::diagonal(1, 1.001, 2);
  EXPECT_EQ(principal_axes(nearly).symmetry, InertiaSymmetry::triaxial);
  EXPECT_EQ(principal_axes(nearly, 1e-2).symmetry, InertiaSymmetry::axisymmetric);
}

TEST(PrincipalAxes, NotFiniteTensorsGiveNotFiniteMoments) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(principal_axes(Tensor{1, 1, 1, infinity, 0, 0}).moments.x));
}

}  // namespace principal_axes_test
}  // namespace poinsot
