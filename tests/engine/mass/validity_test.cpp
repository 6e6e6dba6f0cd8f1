#include "poinsot/engine/mass/validity.h"

#include <limits>
#include <numbers>

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace validity_test {

using testing::Random;
using Vector = Vector3<double>;
using Body = MassProperties<double>;
using Tensor = SymmetricMatrix3<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Validity, EveryBodyOfParticlesIsValid) {
  Random<double> random(14);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(validate(random.body(), "body"));
    // Thin bodies on turned axes reach equality up to rounding.
    const Vector A = random.point();
    const Vector B = random.point_apart_from(A);
    EXPECT_FALSE(validate(of_mass(shapes::rod(A, B), 2.0), "rod"));
    EXPECT_FALSE(validate(of_mass(shapes::disk(A, B, 0.5), 2.0), "disk"));
    EXPECT_FALSE(validate(of_mass(shapes::triangle(A, B, random.point()), 2.0), "triangle"));
  }
  EXPECT_FALSE(validate(of_mass(shapes::particle(Vector{1, 2, 3}), 1.0), "particle"));
  EXPECT_FALSE(validate(massless<double>(), "nothing"));
}

TEST(Validity, TriangleInequality) {
  const auto report = validate(Body{1, Vector::zero(), Tensor::diagonal(2, 3, 7)}, "wheel");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rule, MassRule::triangle_inequality);
  EXPECT_EQ(
      report->message,
      "body 'wheel': no rigid body has these moments: I_x + I_y >= I_z is broken: 2 + 3 < 7 kg m^2 (short by 2 kg "
      "m^2)");
  EXPECT_DOUBLE_EQ(report->amount, 2);
  EXPECT_DOUBLE_EQ(report->principal_moments.x, 2);
  EXPECT_DOUBLE_EQ(report->principal_moments.z, 7);

  const auto first = validate(Body{1, Vector::zero(), Tensor::diagonal(9, 3, 4)}, "wheel");
  ASSERT_TRUE(first);
  EXPECT_NE(first->message.find("I_y + I_z >= I_x is broken: 3 + 4 < 9 kg m^2"), std::string::npos) << first->message;
  const auto second = validate(Body{1, Vector::zero(), Tensor::diagonal(3, 9, 4)}, "wheel");
  ASSERT_TRUE(second);
  EXPECT_NE(second->message.find("I_x + I_z >= I_y is broken: 3 + 4 < 9 kg m^2"), std::string::npos) << second->message;
}

TEST(Validity, ImpossibleProductsAreSeenInThePrincipalMoments) {
  // Moments 3, 3, 3 pass by themselves; with I_xy = 2 the principal ones are 1, 3, 5.
  const auto report = validate(Body{1, Vector::zero(), Tensor{3, 3, 3, -2, 0, 0}}, "block");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rule, MassRule::triangle_inequality);
  EXPECT_EQ(
      report->message,
      "body 'block': no rigid body has these moments: I_1 + I_2 >= I_3 is broken: 1 + 3 < 5 kg m^2 (short by 1 kg "
      "m^2) (principal moments of I_x = 3, I_y = 3, I_z = 3, I_xy = 2, I_yz = 0, I_zx = 0 kg m^2)");
  EXPECT_NEAR(report->amount, 1, 1e-14);
}

TEST(Validity, NegativeMoments) {
  const auto report = validate(Body{1, Vector::zero(), Tensor::diagonal(1, -0.5, 1)}, "arm");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rule, MassRule::nonnegative_moments);
  EXPECT_EQ(report->message,
            "body 'arm': no rigid body has these moments: I_y >= 0 is broken: -0.5 < 0 kg m^2 (short by 0.5 kg m^2)");
  const auto mixed = validate(Body{1, Vector::zero(), Tensor{1, 1, 1, 2, 0, 0}}, "arm");
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->rule, MassRule::nonnegative_moments);
  EXPECT_NEAR(mixed->amount, 1, 1e-14);
}

TEST(Validity, MassWithoutInertiaAndInertiaWithoutMass) {
  const auto negative = validate(Body{-2, Vector::zero(), Tensor::diagonal(1, 1, 1)}, "hub");
  ASSERT_TRUE(negative);
  EXPECT_EQ(negative->rule, MassRule::positive_mass);
  EXPECT_EQ(negative->message,
            "body 'hub': the mass is -2 kg; a body's mass must not be negative (only a hole in a larger body has a "
            "negative mass)");
  EXPECT_EQ(negative->amount, 2);
  const auto weightless = validate(Body{0, Vector::zero(), Tensor::diagonal(1, 1, 0.5)}, "hub");
  ASSERT_TRUE(weightless);
  EXPECT_EQ(weightless->rule, MassRule::inertia_needs_mass);
  EXPECT_EQ(weightless->message,
            "body 'hub': the mass is zero but the largest principal moment of inertia is 1 kg m^2; give a mass, or no "
            "inertia");
}

TEST(Validity, EveryValueMustBeFinite) {
  const Body good{1, {0, 0, 0}, Tensor::diagonal(1, 1, 1)};
  for (const double bad : {nan, infinity, -infinity}) {
    Body body = good;
    body.mass = bad;
    auto report = validate(body, "x");
    ASSERT_TRUE(report);
    EXPECT_EQ(report->rule, MassRule::finite_values);
    EXPECT_NE(report->message.find("body 'x': the mass is "), std::string::npos);
    body = good;
    body.center.y = bad;
    report = validate(body, "x");
    ASSERT_TRUE(report);
    EXPECT_NE(report->message.find("the y coordinate of the mass center is "), std::string::npos);
    for (const auto entry : {&Tensor::xx, &Tensor::yy, &Tensor::zz, &Tensor::xy, &Tensor::yz, &Tensor::zx}) {
      body = good;
      body.inertia_center.*entry = bad;
      report = validate(body, "x");
      ASSERT_TRUE(report);
      EXPECT_EQ(report->rule, MassRule::finite_values);
      EXPECT_NE(report->message.find("of inertia I_"), std::string::npos);
    }
  }
}

TEST(Validity, FullMatricesMustBeSymmetric) {
  const Matrix3<double> good{{2, 0.1, 0.2}, {0.1, 3, 0.3}, {0.2, 0.3, 4}};
  EXPECT_FALSE(validate(1, Vector::zero(), good, "link"));
  Matrix3<double> bad = good;
  bad.row2.x = 0.25;
  const auto report = validate(1, Vector::zero(), bad, "link");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rule, MassRule::symmetric_tensor);
  EXPECT_EQ(
      report->message,
      "body 'link': a tensor of inertia is symmetric, but its entry xz is 0.2 and zx is 0.25 kg m^2 (they differ by "
      "0.05)");
  // Rounding is tolerated, and the other rules hold as well.
  Matrix3<double> rounded = good;
  rounded.row2.x += 1e-12;
  EXPECT_FALSE(validate(1, Vector::zero(), rounded, "link"));
  EXPECT_EQ(validate(-1, Vector::zero(), good, "link")->rule, MassRule::positive_mass);
  Matrix3<double> unknown = good;
  unknown.row0.y = nan;
  EXPECT_EQ(validate(1, Vector::zero(), unknown, "link")->rule, MassRule::finite_values);
}

TEST(Validity, ToleranceIsRelativeToTheLargestMoment) {
  const auto plate = [](double excess) {
    return Body{1, Vector::zero(), Tensor::diagonal(1e-6, 2e-6, 3e-6 * (1 + excess))};
  };
  EXPECT_FALSE(validate(plate(1e-10), "plate"));
  EXPECT_TRUE(validate(plate(1e-8), "plate"));
  EXPECT_FALSE(validate(plate(1e-4), "plate", 1e-3));
}

}  // namespace validity_test
}  // namespace poinsot
