// Elliptic integrals against Boost's, in units of the last place, and against their own identities.
#include "poinsot/engine/math/elliptic/elliptic_integrals.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <random>

namespace poinsot {
namespace elliptic_integrals_test {

template <class Real>
class EllipticIntegrals : public ::testing::Test {
 protected:
  // Relative difference in units of the type's epsilon.
  static double units(Real value, Real expected) {
    if (value == expected) return 0;
    return static_cast<double>(std::fabs((value - expected) / expected) / std::numeric_limits<Real>::epsilon());
  }
  Real uniform(double low, double high) {
    return Real(low) + Real(high - low) * static_cast<Real>(std::uniform_real_distribution<double>(0, 1)(engine_));
  }
  Real of_any_size() { return std::pow(Real(10), uniform(-6, 6)); }

  std::mt19937_64 engine_{11};
};
using Reals = ::testing::Types<double, long double>;
TYPED_TEST_SUITE(EllipticIntegrals, Reals);

TYPED_TEST(EllipticIntegrals, symmetric_forms_agree_with_boost) {
  using Real = TypeParam;
  double rf = 0, rc = 0, rd = 0, rj = 0;
  for (int i = 0; i < 5000; ++i) {
    const Real x = i % 7 == 0 ? Real(0) : this->of_any_size();
    const Real y = this->of_any_size(), z = this->of_any_size(), p = this->of_any_size();
    rf = std::max(rf, this->units(carlson_rf(x, y, z), boost::math::ellint_rf(x, y, z)));
    rc = std::max(rc, this->units(carlson_rc(x, y), boost::math::ellint_rc(x, y)));
    rd = std::max(rd, this->units(carlson_rd(x, y, z), boost::math::ellint_rd(x, y, z)));
    rj = std::max(rj, this->units(carlson_rj(x, y, z, p), boost::math::ellint_rj(x, y, z, p)));
  }
  EXPECT_LT(rf, 10);
  EXPECT_LT(rc, 10);
  EXPECT_LT(rd, 20);
  EXPECT_LT(rj, 200);  // both lose digits where p is close to another argument
}

TYPED_TEST(EllipticIntegrals, principal_values_agree_with_boost) {
  using Real = TypeParam;
  double rc = 0, rj = 0;
  for (int i = 0; i < 1000; ++i) {
    const Real x = this->uniform(0.1, 2), y = this->uniform(0.1, 2), z = this->uniform(0.1, 2);
    const Real p = -this->uniform(0.1, 2);
    rc = std::max(rc, this->units(carlson_rc(x, p), boost::math::ellint_rc(x, p)));
    // R_J passes through zero: in units of its terms.
    rj = std::max(rj, static_cast<double>(std::fabs(carlson_rj(x, y, z, p) - boost::math::ellint_rj(x, y, z, p)) /
                                          std::numeric_limits<Real>::epsilon()));
  }
  EXPECT_LT(rc, 10);
  EXPECT_LT(rj, 400);
}

TYPED_TEST(EllipticIntegrals, legendre_forms_agree_with_boost) {
  using Real = TypeParam;
  double first = 0, second = 0, third = 0, complete = 0;
  for (int i = 0; i < 5000; ++i) {
    const Real k = this->uniform(0, 1), phi = this->uniform(-5, 5), n = this->uniform(-1, 1);
    const auto p = EllipticParameter<Real>::of_m(k * k);
    // Conditions of k near one and of phi near a pole stand for some units.
    first = std::max(first, this->units(elliptic_first(phi, p), boost::math::ellint_1(k, phi)));
    second = std::max(second, this->units(elliptic_second(phi, p), boost::math::ellint_2(k, phi)));
    third = std::max(third, this->units(elliptic_third(n, phi, p), boost::math::ellint_3(k, n, phi)));
    complete = std::max({complete, this->units(elliptic_complete_first(p), boost::math::ellint_1(k)),
                         this->units(elliptic_complete_second(p), boost::math::ellint_2(k)),
                         this->units(elliptic_complete_third(n, p), boost::math::ellint_3(k, n))});
  }
  EXPECT_LT(first, 100);
  EXPECT_LT(second, 100);
  EXPECT_LT(third, 400);
  EXPECT_LT(complete, 400);
}

// E(m) K(1-m) + E(1-m) K(m) - K(m) K(1-m) = pi/2, for parameters whose complements are far below an epsilon.
TYPED_TEST(EllipticIntegrals, legendre_relation_holds_at_both_ends) {
  using Real = TypeParam;
  for (int exponent = 0; exponent <= 30; ++exponent) {
    const auto p = EllipticParameter<Real>::of_complement(std::pow(Real(10), Real(-exponent)) / 2);
    const auto q = p.complementary();
    const Real K = elliptic_complete_first(p), K1 = elliptic_complete_first(q);
    const Real E = elliptic_complete_second(p), E1 = elliptic_complete_second(q);
    const Real half_pi = std::numbers::pi_v<Real> / 2;
    EXPECT_NEAR(static_cast<double>((E * K1 + E1 * K - K * K1) / half_pi), 1.0,
                static_cast<double>(200 * std::numeric_limits<Real>::epsilon()));
  }
}

TYPED_TEST(EllipticIntegrals, have_their_limits) {
  using Real = TypeParam;
  const Real half_pi = std::numbers::pi_v<Real> / 2, few = 4 * std::numeric_limits<Real>::epsilon();
  const EllipticParameter<Real> circle{0, 1}, line{1, 0};
  EXPECT_NEAR(static_cast<double>(elliptic_complete_first(circle) - half_pi), 0, static_cast<double>(few));
  EXPECT_EQ(elliptic_complete_first(line), std::numeric_limits<Real>::infinity());
  EXPECT_EQ(elliptic_complete_second(line), Real(1));
  EXPECT_NEAR(static_cast<double>(elliptic_first(Real(0.7L), line) - std::asinh(std::tan(Real(0.7L)))), 0,
              static_cast<double>(few));
  EXPECT_NEAR(static_cast<double>(elliptic_second(Real(3.0L), circle) - 3), 0, static_cast<double>(4 * few));
  EXPECT_EQ(carlson_rf(Real(0), Real(0), Real(1)), std::numeric_limits<Real>::infinity());
  EXPECT_EQ(elliptic_second(Real(0), circle), Real(0));
}

TYPED_TEST(EllipticIntegrals, arguments_out_of_range_give_what_is_not_a_number) {
  using Real = TypeParam;
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_TRUE(std::isnan(carlson_rf(Real(-1), Real(1), Real(1))));
  EXPECT_TRUE(std::isnan(carlson_rf(nan, Real(1), Real(1))));
  EXPECT_TRUE(std::isnan(carlson_rc(Real(-1), Real(1))));
  EXPECT_TRUE(std::isnan(carlson_rc(Real(1), nan)));
  EXPECT_TRUE(std::isnan(carlson_rd(Real(1), Real(1), Real(-1))));
  EXPECT_TRUE(std::isnan(carlson_rj(Real(1), Real(1), Real(1), nan)));
  EXPECT_TRUE(std::isnan(elliptic_complete_first(EllipticParameter<Real>{2, -1})));
}

}  // namespace elliptic_integrals_test
}  // namespace poinsot
