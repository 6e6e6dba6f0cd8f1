// Numbers rounded for a reader, without superfluous zeros.
#pragma once

#include <string>
#include <vector>

namespace poinsot::document {

// The number with so many significant digits, trailing zeros dropped: 0.236, -12.5, 2.16884e22. An exponent is written
// for magnitudes below 1e-4 and from 10^digits on.
std::string rounded(double number, int digits);

// The components of one vector or matrix, rounded to the place that is the last of `digits` significant digits of the
// largest: a component that is nothing but rounding error beside the others reads 0.
std::vector<std::string> rounded_together(const std::vector<double>& components, int digits);

// The numbers of one column of a table: as rounded_together(), with the same number of decimals in every row. Where
// that would leave less than three digits of a row, each row has its own.
std::vector<std::string> rounded_column(const std::vector<double>& numbers, int digits);

// A relative misfit, with one digit: 2e-14.
std::string rounded_residual(double residual);

}  // namespace poinsot::document
