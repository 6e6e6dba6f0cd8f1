// The laws of duals: derivatives of every function against numerical differentiation, and of nested duals.
#include "poinsot/engine/math/algebra/dual.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {
namespace dual_test {

using D = Dual<2>;

// A function of two variables over duals and over long double.
struct Law {
  const char* name;
  std::function<D(const D&, const D&)> dual;
  std::function<long double(long double, long double)> plain;
};

template <class F>
Law law(const char* name, F f) {
  return {name, [f](const D& x, const D& y) { return D(f(x, y)); },
          [f](long double x, long double y) { return static_cast<long double>(f(x, y)); }};
}

std::vector<Law> laws() {
  return {law("sum", [](auto x, auto y) { return x + y; }),
          law("difference", [](auto x, auto y) { return x - y; }),
          law("product", [](auto x, auto y) { return x * y; }),
          law("quotient", [](auto x, auto y) { return x / y; }),
          law("negative", [](auto x, auto y) { return -x + 2 * y - 3.0 * x + 1; }),
          law("assignments",
              [](auto x, auto y) {
                auto z = x;
                z += y;
                z *= x;
                z -= y;
                z /= y;
                return z;
              }),
          law("sqrt",
              [](auto x, auto y) {
                using std::sqrt;
                return sqrt(x * y);
              }),
          law("sin",
              [](auto x, auto y) {
                using std::sin;
                return sin(x * y);
              }),
          law("cos",
              [](auto x, auto y) {
                using std::cos;
                return cos(x + y);
              }),
          law("tan",
              [](auto x, auto y) {
                using std::tan;
                return tan(x * y * 0.3);
              }),
          law("asin",
              [](auto x, auto y) {
                using std::asin;
                return asin(x * y * 0.2);
              }),
          law("acos",
              [](auto x, auto y) {
                using std::acos;
                return acos(x * y * 0.2);
              }),
          law("atan",
              [](auto x, auto y) {
                using std::atan;
                return atan(x / y);
              }),
          law("atan2",
              [](auto x, auto y) {
                using std::atan2;
                return atan2(x, -y);
              }),
          law("exp",
              [](auto x, auto y) {
                using std::exp;
                return exp(x - y);
              }),
          law("log",
              [](auto x, auto y) {
                using std::log;
                return log(x * y);
              }),
          law("abs",
              [](auto x, auto y) {
                using std::abs;
                return abs(x - 3 * y) + abs(y);
              }),
          law("constant power",
              [](auto x, auto y) {
                using std::pow;
                return pow(x, 2.5) * pow(y, -3.0) + pow(x, 0.0);
              }),
          law("power",
              [](auto x, auto y) {
                using std::pow;
                return pow(x, y);
              }),
          law("norm", [](auto x, auto y) {
            return norm(Vector3<decltype(x)>{x, y, x * y});
          })};
}

TEST(DualLaws, derivatives_agree_with_numerical_differentiation) {
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> uniform(0.4, 1.9);
  for (const Law& each : laws()) {
    for (int trial = 0; trial < 200; ++trial) {
      const double x = uniform(engine);
      const double y = uniform(engine);
      const D found = each.dual(D::variable(x, 0), D::variable(y, 1));
      const long double h = 1e-4L;
      const auto slope = [h](auto f) {
        return static_cast<double>((8.0L * (f(h) - f(-h)) - (f(2.0L * h) - f(-2.0L * h))) / (12.0L * h));
      };
      const double by_x = slope([&](long double t) { return each.plain(x + t, y); });
      const double by_y = slope([&](long double t) { return each.plain(x, y + t); });
      EXPECT_NEAR(found.value, static_cast<double>(each.plain(x, y)), 1e-14 * (1.0 + std::fabs(found.value)))
          << each.name;
      EXPECT_NEAR(found.partial[0], by_x, 1e-11 * (1.0 + std::fabs(by_x))) << each.name;
      EXPECT_NEAR(found.partial[1], by_y, 1e-11 * (1.0 + std::fabs(by_y))) << each.name;
    }
  }
}

TEST(DualLaws, comparisons_look_at_the_value) {
  const D a = D::variable(1.0, 0);
  const D b(1.0);
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a != b);
  EXPECT_TRUE(a <= b && a >= b);
  EXPECT_TRUE(a < D(2) && D(2) > a);
  EXPECT_FALSE(a < b);
  EXPECT_TRUE(a < 2.0);
}

TEST(DualLaws, finite_only_if_all_parts_are) {
  EXPECT_TRUE(isfinite(D::variable(1.0, 0)));
  EXPECT_FALSE(isfinite(sqrt(D::variable(0.0, 1))));
  EXPECT_FALSE(isfinite(D(NAN)));
}

TEST(DualLaws, nested_duals_give_second_derivatives) {
  using Inner = Dual<2>;
  using Outer = Dual<2, Inner>;
  const double x = 0.7;
  const double y = 1.3;
  const Outer X = Outer::variable(Inner::variable(x, 0), 0);
  const Outer Y = Outer::variable(Inner::variable(y, 1), 1);
  const Outer f = sin(X * Y) + X * X / Y;
  const double s = std::sin(x * y);
  const double c = std::cos(x * y);
  EXPECT_NEAR(f.partial[0].partial[0], -y * y * s + 2.0 / y, 1e-14);
  EXPECT_NEAR(f.partial[0].partial[1], c - x * y * s - 2.0 * x / (y * y), 1e-14);
  EXPECT_NEAR(f.partial[1].partial[0], f.partial[0].partial[1], 1e-14);
  EXPECT_NEAR(f.partial[1].partial[1], -x * x * s + 2.0 * x * x / (y * y * y), 1e-14);
}

}  // namespace dual_test
}  // namespace poinsot
