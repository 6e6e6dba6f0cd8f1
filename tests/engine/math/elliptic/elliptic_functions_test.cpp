// Jacobi's functions against Boost's in fifty digits, and against their definition.
#include "poinsot/engine/math/elliptic/elliptic_functions.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

namespace poinsot {
namespace elliptic_functions_test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

EllipticParameter<long double> parameter_of(int kind, double uniform) {
  switch (kind % 3) {
    case 0:
      return EllipticParameter<long double>::of_m(uniform);
    case 1:
      return EllipticParameter<long double>::of_m(std::pow(10.0L, -18 * static_cast<long double>(uniform)));
    default:
      return EllipticParameter<long double>::of_complement(std::pow(10.0L, -18 * static_cast<long double>(uniform)));
  }
}

TEST(JacobiFunctions, agree_with_fifty_digits_for_all_parameters) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0, worst_dn = 0;
  for (int i = 0; i < 3000; ++i) {
    const EllipticParameter<long double> p = parameter_of(i, uniform(engine));
    const double u = (2 * uniform(engine) - 1) * (i % 2 == 0 ? 3 : 60);
    const Digits50 k = sqrt(1 - Digits50(p.complement));
    Digits50 cn, dn;
    const Digits50 sn = boost::math::jacobi_elliptic(k, Digits50(u), &cn, &dn);
    const JacobiFunctions::Values values = JacobiFunctions(p).at(u);
    worst = std::max(
        {worst, std::fabs(static_cast<double>(values.sn - sn)), std::fabs(static_cast<double>(values.cn - cn))});
    worst_dn = std::max(worst_dn, std::fabs(static_cast<double>((values.dn - dn) / dn)));
  }
  EXPECT_LT(worst, 1e-15);
  // dn falls as exp(-u) near m = 1: its relative error is that of u.
  EXPECT_LT(worst_dn, 1e-14);
  EXPECT_GT(worst, 1e-17);  // the comparison is of numbers with rounding
}

TEST(JacobiFunctions, amplitude_inverts_the_integral_of_the_first_kind) {
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const EllipticParameter<double> p = EllipticParameter<double>::of_m(0.99 * uniform(engine));
    const double phi = 20 * uniform(engine) - 10;
    EXPECT_NEAR(JacobiFunctions(p).amplitude(elliptic_first(phi, p)), phi, 4e-14);
  }
}

TEST(JacobiFunctions, have_their_limits) {
  for (const double u : {-700.0, -3.0, -1e-9, 0.0, 0.4, 2.0, 50.0, 1000.0}) {
    const auto circle = JacobiFunctions(EllipticParameter<double>{0, 1}).at(u);
    EXPECT_NEAR(circle.sn, std::sin(u), 2e-13);  // 2 K is pi rounded
    EXPECT_NEAR(circle.cn, std::cos(u), 2e-13);
    EXPECT_EQ(circle.dn, 1);
    const auto line = JacobiFunctions(EllipticParameter<double>{1, 0}).at(u);
    EXPECT_NEAR(line.sn, std::tanh(u), 3e-16);
    EXPECT_NEAR(line.cn, 1 / std::cosh(u), 3e-16);
    EXPECT_NEAR(line.dn, 1 / std::cosh(u), 3e-16);
  }
}

TEST(JacobiFunctions, keep_small_arguments) {
  for (const double m : {0.1, 0.9}) {
    const JacobiFunctions jacobi(EllipticParameter<double>::of_m(m));
    for (const double u : {1e-300, 1e-20, 1e-8}) {
      EXPECT_NEAR(jacobi.at(u).sn / u, 1, 4e-16);
      EXPECT_NEAR(jacobi.at(-u).sn / u, -1, 4e-16);
    }
  }
}

TEST(JacobiFunctions, pass_on_what_is_not_a_number) {
  const JacobiFunctions jacobi(EllipticParameter<double>::of_m(0.3));
  EXPECT_TRUE(std::isnan(jacobi.at(std::numeric_limits<double>::quiet_NaN()).sn));
  EXPECT_TRUE(std::isnan(JacobiFunctions(EllipticParameter<double>{1.5, -0.5}).at(0.2).sn));
}

}  // namespace elliptic_functions_test
}  // namespace poinsot
