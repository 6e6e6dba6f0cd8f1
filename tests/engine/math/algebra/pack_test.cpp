// The laws of packs: every operation works lane by lane.
#include "poinsot/engine/math/algebra/pack.h"

#include <gtest/gtest.h>

#include <random>

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot {
namespace pack_test {

template <class P>
class PackLaws : public ::testing::Test {};
using Packs = ::testing::Types<Pack<4>, Pack<8>>;
TYPED_TEST_SUITE(PackLaws, Packs);

TYPED_TEST(PackLaws, operations_work_lane_by_lane) {
  using P = TypeParam;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> uniform(0.1, 3.0);
  for (int trial = 0; trial < 500; ++trial) {
    const P a = P::from_lanes([&](int) { return uniform(engine); });
    const P b = P::from_lanes([&](int) { return uniform(engine); });
    P sum = a;
    sum += b;
    P difference = a;
    difference -= b;
    P product = a;
    product *= b;
    P quotient = a;
    quotient /= b;
    for (int i = 0; i < P::width; ++i) {
      const double x = a.lane(i);
      const double y = b.lane(i);
      ASSERT_EQ((a + b).lane(i), x + y);
      ASSERT_EQ((a - b).lane(i), x - y);
      ASSERT_EQ((a * b).lane(i), x * y);
      ASSERT_EQ((a / b).lane(i), x / y);
      ASSERT_EQ(sum.lane(i), x + y);
      ASSERT_EQ(difference.lane(i), x - y);
      ASSERT_EQ(product.lane(i), x * y);
      ASSERT_EQ(quotient.lane(i), x / y);
      ASSERT_EQ((-a).lane(i), -x);
      ASSERT_EQ((+a).lane(i), x);
      ASSERT_EQ((2.0 * a + 1).lane(i), 2.0 * x + 1.0);
      ASSERT_EQ(sqrt(a).lane(i), std::sqrt(x));
      ASSERT_EQ(fma(a, b, a).lane(i), std::fma(x, y, x));
      ASSERT_NEAR(sin(a).lane(i), std::sin(x), 2.3e-16);
      ASSERT_NEAR(cos(a).lane(i), std::cos(x), 2.3e-16);
      ASSERT_EQ(sinc_of_square(a).lane(i), sinc_of_square(x));
      ASSERT_EQ(cosine_of_square(a).lane(i), cosine_of_square(x));
      ASSERT_EQ(cosine_rest_of_square(a).lane(i), cosine_rest_of_square(x));
      ASSERT_EQ(sine_rest_of_square(a).lane(i), sine_rest_of_square(x));
      ASSERT_EQ(positive_sign(b - a).lane(i), std::copysign(1.0, y - x));
    }
  }
}

// The right side of an assignment is read whole before the left side is written.
TYPED_TEST(PackLaws, vectors_may_be_assigned_from_their_own_components) {
  using P = TypeParam;
  Vector3<P> v{P(1), P(2), P(3)};
  v = {v.y, v.z, v.x};
  EXPECT_EQ(v.x.lane(0), 2.0);
  EXPECT_EQ(v.y.lane(0), 3.0);
  EXPECT_EQ(v.z.lane(0), 1.0);
  Matrix3<P> m = cross_matrix(v);
  m = {m.row1, m.row2, m.row0};
  EXPECT_EQ(m.row0.x.lane(1), 1.0);
  EXPECT_EQ(m.row2.y.lane(1), -1.0);
}

TYPED_TEST(PackLaws, numbers_fill_all_lanes_and_lanes_are_set_one_by_one) {
  using P = TypeParam;
  P a(2.5);
  a.set_lane(1, 7.0);
  for (int i = 0; i < P::width; ++i) EXPECT_EQ(a.lane(i), i == 1 ? 7.0 : 2.5);
  EXPECT_EQ(P().lane(0), 0.0);
  EXPECT_TRUE(every_value(a, [](double x) { return x > 2.0; }));
  EXPECT_FALSE(every_value(a, [](double x) { return x < 5.0; }));
}

TYPED_TEST(PackLaws, vectors_and_matrices_of_packs_work_lane_by_lane) {
  using P = TypeParam;
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto pack = [&] { return P::from_lanes([&](int) { return uniform(engine); }); };
  const Vector3<P> a{pack(), pack(), pack()};
  const Vector3<P> b{pack(), pack(), pack()};
  const Vector3<P> c = cross(a, cross_matrix(b) * a);
  for (int i = 0; i < P::width; ++i) {
    const Vector3<double> x{a.x.lane(i), a.y.lane(i), a.z.lane(i)};
    const Vector3<double> y{b.x.lane(i), b.y.lane(i), b.z.lane(i)};
    const Vector3<double> z = cross(x, cross_matrix(y) * x);
    EXPECT_NEAR(c.x.lane(i), z.x, 1e-15);
    EXPECT_NEAR(c.y.lane(i), z.y, 1e-15);
    EXPECT_NEAR(c.z.lane(i), z.z, 1e-15);
  }
}

}  // namespace pack_test
}  // namespace poinsot
