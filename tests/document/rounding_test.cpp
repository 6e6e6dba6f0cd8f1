#include "document/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace poinsot::document {
namespace rounding_test {

using Texts = std::vector<std::string>;
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Rounded, six_digits_without_idle_zeros) {
  EXPECT_EQ(rounded(0.236, 6), "0.236");
  EXPECT_EQ(rounded(-12.5, 6), "-12.5");
  EXPECT_EQ(rounded(1666.0000001, 6), "1666");
  EXPECT_EQ(rounded(100, 6), "100");
  EXPECT_EQ(rounded(123456.7, 6), "123457");
  EXPECT_EQ(rounded(0.000123456789, 6), "0.000123457");
  EXPECT_EQ(rounded(0, 6), "0");
  EXPECT_EQ(rounded(-0.0, 6), "0");
}

TEST(Rounded, exponents_at_both_ends) {
  EXPECT_EQ(rounded(999999.4, 6), "999999");
  EXPECT_EQ(rounded(999999.6, 6), "1e6");
  EXPECT_EQ(rounded(2.168838e22, 6), "2.16884e22");
  EXPECT_EQ(rounded(0.00009999996, 6), "0.0001");
  EXPECT_EQ(rounded(0.0000999, 6), "9.99e-5");
  EXPECT_EQ(rounded(-1.5e-300, 6), "-1.5e-300");
  EXPECT_EQ(rounded(5e-324, 6), "4.94066e-324");
  EXPECT_EQ(rounded(std::numeric_limits<double>::max(), 3), "1.8e308");
}

TEST(Rounded, what_is_no_number_is_shown_as_such) {
  EXPECT_EQ(rounded(infinity, 6), "inf");
  EXPECT_EQ(rounded(std::nan(""), 6), "nan");
}

TEST(Rounded, one_thousand_random_numbers_are_within_half_a_unit_of_the_last_digit) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  std::uniform_int_distribution<int> power(-30, 30);
  for (int i = 0; i < 1000; ++i) {
    const double number = mantissa(random) * std::pow(10.0, power(random));
    EXPECT_NEAR(std::stod(rounded(number, 6)), number, 0.5000001e-5 * std::abs(number)) << number;
  }
}

TEST(RoundedTogether, rounds_to_the_last_place_of_the_largest) {
  EXPECT_EQ(rounded_together({0.2361234567, -0.2681234567, 1e-13}, 6), (Texts{"0.236123", "-0.268123", "0"}));
  EXPECT_EQ(rounded_together({1234.56789, 0.123456, -0.001}, 6), (Texts{"1234.57", "0.12", "0"}));
  EXPECT_EQ(rounded_together({0, 79.073147, 0}, 6), (Texts{"0", "79.0731", "0"}));
  EXPECT_EQ(rounded_together({0, -0.0}, 6), (Texts{"0", "0"}));
  EXPECT_EQ(rounded_together({}, 6), Texts{});
}

TEST(RoundedTogether, with_exponents_too) {
  EXPECT_EQ(rounded_together({1.23456789e8, 2345678, -400, -600, 0}, 6),
            (Texts{"1.23457e8", "2.346e6", "0", "-1e3", "0"}));
  EXPECT_EQ(rounded_together({3e-7, 1e-20, -1.2345678e-9}, 6), (Texts{"3e-7", "0", "-1.235e-9"}));
}

TEST(RoundedTogether, a_component_that_is_not_finite_spoils_no_other) {
  EXPECT_EQ(rounded_together({infinity, 1.5, 0}, 6), (Texts{"inf", "1.5", "0"}));
}

TEST(RoundedColumn, has_the_same_number_of_decimals_in_every_row) {
  EXPECT_EQ(rounded_column({0, 0.2, 0.4}, 6), (Texts{"0.0", "0.2", "0.4"}));
  EXPECT_EQ(rounded_column({10, 20, 180}, 6), (Texts{"10", "20", "180"}));
  EXPECT_EQ(rounded_column({1.25, -100, 3e-15}, 6), (Texts{"1.25", "-100.00", "0.00"}));
  EXPECT_EQ(rounded_column({0, 0}, 6), (Texts{"0", "0"}));
}

// A row is no component of the others: what is not zero is not shown as zero.
TEST(RoundedColumn, shows_small_rows_with_digits_of_their_own) {
  EXPECT_EQ(rounded_column({2e9, 1, 0}, 6), (Texts{"2e9", "1", "0"}));
  EXPECT_EQ(rounded_column({1e-4, 1, 1e6}, 6), (Texts{"0.0001", "1", "1e6"}));
  EXPECT_EQ(rounded_column({628.3185307, 6.283185307, 0.006283185307, 1e-16}, 6),
            (Texts{"628.319", "6.28319", "0.00628319", "0"}));
  EXPECT_EQ(rounded_column({1, 0.00192, 0}, 6), (Texts{"1.00000", "0.00192", "0.00000"}));
}

TEST(RoundedResidual, has_one_digit) {
  EXPECT_EQ(rounded_residual(2.1e-14), "2e-14");
  EXPECT_EQ(rounded_residual(0), "0");
  EXPECT_EQ(rounded_residual(9.6e-10), "1e-9");
  EXPECT_EQ(rounded_residual(infinity), "not formed");
}

}  // namespace rounding_test
}  // namespace poinsot::document
