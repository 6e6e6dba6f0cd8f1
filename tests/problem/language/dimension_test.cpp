#include "problem/language/dimension.h"

#include <gtest/gtest.h>

namespace poinsot::problem {
namespace dimension_test {

using namespace dimensions;

TEST(Dimension, ProductsAndQuotients) {
  EXPECT_EQ(mass * acceleration, force);
  EXPECT_EQ(force * length, moment);
  EXPECT_EQ(moment, energy) << "a moment and an energy are of one dimension";
  EXPECT_EQ(length / dimensions::time, velocity);
  EXPECT_EQ(moment_of_inertia * angular_velocity, angular_momentum * dimensions::angle);
  EXPECT_EQ(force / force, none);
}

TEST(Dimension, PowersAreRational) {
  EXPECT_EQ(problem::power(length, 2), area);
  EXPECT_EQ(problem::power(area, 1, 2), length);
  EXPECT_EQ(problem::power(velocity, -2), Dimension::of(-2, 0, 2));
  EXPECT_EQ(problem::power(length, 1, 12), (Dimension{1, 0, 0, 0}));
  EXPECT_EQ(problem::power(length, 1, 5), std::nullopt);
  EXPECT_EQ(problem::power(none, 1, 5), none);
  EXPECT_EQ(problem::power(length, 1, 0), std::nullopt);
}

TEST(Dimension, HugeExponentsNeitherOverflowNorPassAsReasonable) {
  Dimension d = length;
  for (int i = 0; i < 100; ++i) d = d * d;
  EXPECT_FALSE(reasonable(d));
  EXPECT_FALSE(reasonable(none / d));
  EXPECT_FALSE(reasonable(*problem::power(length, 2'000'000'000)));
  EXPECT_TRUE(reasonable(*problem::power(length, 100)));
  EXPECT_FALSE(reasonable(*problem::power(length, 101)));
}

TEST(Dimension, TheAngleIsSoft) {
  EXPECT_TRUE(same_kind(angular_velocity, frequency));
  EXPECT_TRUE(same_kind(velocity, velocity * dimensions::angle));
  EXPECT_FALSE(same_kind(velocity, acceleration));
  EXPECT_TRUE(is_pure(dimensions::angle));
  EXPECT_FALSE(is_pure(frequency));
}

TEST(Dimension, InWords) {
  EXPECT_EQ(to_string(force), "a force");
  EXPECT_EQ(to_string(length), "a length");
  EXPECT_EQ(to_string(none), "a pure number");
  EXPECT_EQ(to_string(dimensions::angle), "an angle");
  EXPECT_EQ(to_string(angular_velocity), "an angular velocity");
  EXPECT_EQ(to_string(frequency), "a frequency");
  EXPECT_EQ(to_string(angular_momentum), "an angular momentum");
  EXPECT_EQ(to_string(angular_momentum * dimensions::angle), "an angular momentum") << "the radian idles";
  EXPECT_EQ(to_string(moment), "a moment or an energy");
  EXPECT_EQ(to_string(moment / dimensions::angle), "a torsional stiffness");
  EXPECT_EQ(to_string(Dimension::of(5, 1, -3)), "a quantity in kg*m^5/s^3");
  EXPECT_EQ(to_string(dimensions::angle * dimensions::angle), "a quantity in rad^2");
}

TEST(Dimension, InBaseUnits) {
  EXPECT_EQ(base_units(force), "kg*m/s^2");
  EXPECT_EQ(base_units(none), "1");
  EXPECT_EQ(base_units(frequency), "1/s");
  EXPECT_EQ(base_units(angular_velocity), "rad/s");
  EXPECT_EQ(base_units(none / length / mass), "1/kg/m");
  EXPECT_EQ(base_units(*problem::power(length, 1, 2)), "m^(1/2)");
  EXPECT_EQ(base_units(*problem::power(length, -3, 2)), "1/m^(3/2)");
}

}  // namespace dimension_test
}  // namespace poinsot::problem
