#include "problem/formulas/letter_dimensions.h"

#include <algorithm>

#include "engine/solve/linear/decompositions.h"

namespace poinsot::problem {
namespace {

constexpr double dimension_to = 1e-4;  // how close exponents must come to a dimension, in powers of a unit

Eigen::VectorXd in_units(const Dimension& dimension, const std::vector<Units>& units) {
  Eigen::VectorXd exponents(units.size());
  for (std::size_t row = 0; row < units.size(); ++row)
    exponents(static_cast<Eigen::Index>(row)) = exponent_of(dimension, units[row]);
  return exponents;
}

Eigen::MatrixXd dimensions_of(const std::vector<Letter>& letters, const std::vector<std::size_t>& chosen,
                              const std::vector<Units>& units) {
  Eigen::MatrixXd matrix(units.size(), chosen.size());
  for (std::size_t column = 0; column < chosen.size(); ++column)
    matrix.col(static_cast<Eigen::Index>(column)) = in_units(letters[chosen[column]].unit.dimension, units);
  return matrix;
}

}  // namespace

LetterDimensions::LetterDimensions(const std::vector<Letter>& letters, const std::vector<Units>& units)
    : letters_(letters), units_(units) {
  for (std::size_t i = 0; i < letters_.size() && pivots_.size() < units_.size(); ++i) {
    pivots_.push_back(i);
    const Eigen::FullPivLU<Eigen::MatrixXd> solved(dimensions_of(letters_, pivots_, units_));
    if (solved.rank() < static_cast<Eigen::Index>(pivots_.size())) pivots_.pop_back();
  }
}

bool LetterDimensions::is_pivot(std::size_t letter) const {
  return std::ranges::find(pivots_, letter) != pivots_.end();
}

std::vector<double> LetterDimensions::exponents(const Dimension& dimension) const {
  const char* const other_scales = "it depends on the letters in no way that their dimensions tell";
  const Eigen::VectorXd wanted = in_units(dimension, units_);
  if (pivots_.empty()) {
    if (wanted.size() > 0 && wanted.norm() > dimension_to) throw NoFormula(other_scales);
    return {};
  }
  const Eigen::MatrixXd matrix = dimensions_of(letters_, pivots_, units_);
  const Eigen::VectorXd solved = matrix.colPivHouseholderQr().solve(wanted);
  if ((matrix * solved - wanted).norm() > dimension_to) throw NoFormula(other_scales);
  return {solved.begin(), solved.end()};
}

}  // namespace poinsot::problem
