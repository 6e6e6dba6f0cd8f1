#include "poinsot/engine/math/algebra/plain.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace plain_test {

using Jet = Dual<1, Dual<1>>;

TEST(Plain, IsTheValueWithoutDerivatives) {
  EXPECT_EQ(plain(2.5), 2.5);
  EXPECT_EQ(plain(Dual<1>(2.5, {7.0})), 2.5);
  EXPECT_EQ(plain(Jet(Dual<1>(2.5, {7.0}), {Dual<1>(8)})), 2.5);
  const Vector3<Dual<1>> a{Dual<1>(1, {4.0}), Dual<1>(2, {5.0}), Dual<1>(3, {6.0})};
  EXPECT_EQ(plain(a).x, 1);
  EXPECT_EQ(plain(a).y, 2);
  EXPECT_EQ(plain(a).z, 3);
  const Matrix3<double> M = plain(Matrix3<Dual<1>>{a, a + a, a + a + a});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(M(i, j), static_cast<double>((i + 1) * (j + 1)));
  const SymmetricMatrix3<double> I = plain(SymmetricMatrix3<Dual<1>>{a.x, a.y, a.z, a.x, a.y, a.z});
  EXPECT_EQ(I.xx + 10 * I.yy + 100 * I.zz, 321);
  EXPECT_EQ(I.xy + 10 * I.yz + 100 * I.zx, 321);
  EXPECT_EQ(plain(std::vector<Dual<1>>{a.x, a.y}), (std::vector<double>{1, 2}));
}

TEST(Plain, ConstantsHaveNoDerivativesOfAnyOrder) {
  EXPECT_TRUE(is_constant(3.0));
  EXPECT_TRUE(is_constant(Dual<2>(3)));
  EXPECT_FALSE(is_constant(Dual<2>::variable(3, 1)));
  EXPECT_TRUE(is_constant(Jet(3)));
  EXPECT_FALSE(is_constant(Jet(Dual<1>(3, {1.0}))));
  EXPECT_FALSE(is_constant(Jet(Dual<1>(3), {Dual<1>(0, {1.0})})));
}

TEST(Plain, WhatVariesFromZeroDoesNotVanish) {
  EXPECT_TRUE(vanishes(0.0));
  EXPECT_FALSE(vanishes(1e-300));
  EXPECT_TRUE(vanishes(Dual<1>(0)));
  EXPECT_FALSE(vanishes(Dual<1>::variable(0, 0)));
  EXPECT_FALSE(vanishes(Dual<1>(1)));
}

TEST(Plain, LiftedNumbersAreConstantsThatKeepTheirOwnDerivatives) {
  EXPECT_EQ(lifted<Dual<1>>(2.5).value, 2.5);
  EXPECT_TRUE(is_constant(lifted<Dual<1>>(2.5)));
  // A dual as a function of time that does not follow the time.
  using TimeJet = Dual<1, Dual<1, Dual<1>>>;
  const TimeJet x = lifted<TimeJet>(Dual<1>(2.5, {7.0}));
  EXPECT_EQ(x.value.value.value, 2.5);
  EXPECT_EQ(x.value.value.partial[0], 7);
  EXPECT_TRUE(vanishes(x.value.partial[0]));
  EXPECT_TRUE(vanishes(x.partial[0]));
  const Vector3<Dual<1>> a = lifted<Dual<1>>(Vector3<double>{1, 2, 3});
  EXPECT_EQ(a.x.value + 10 * a.y.value + 100 * a.z.value, 321);
}

}  // namespace plain_test
}  // namespace poinsot
