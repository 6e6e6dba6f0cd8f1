#include "problem/formulas/letter_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::problem {

LetterScan::LetterScan(std::vector<Letter> letters, LetterValues base)
    : letters_(std::move(letters)), base_(std::move(base)) {
  std::ranges::sort(letters_, {}, &Letter::name);
  double root = 2;
  const double inverse = 1.0 / (static_cast<double>(letters_.size()) + 1);
  // The iteration contracts by less than a half in each step.
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, inverse);
  double step = 1;
  for (std::size_t k = 0; k < letters_.size(); ++k) steps_.push_back(step /= root);
}

LetterValues LetterScan::point(std::size_t index) const {
  constexpr double decades = 3;  // on either side
  LetterValues values = base_;
  for (std::size_t k = 0; k < letters_.size(); ++k) {
    const double turns = 0.5 + static_cast<double>(index + 1) * steps_[k];
    double part = 2 * (turns - std::floor(turns)) - 1;  // from -1 to 1
    double& value = values[letters_[k].name];
    if (letters_[k].unit.dimension == dimensions::angle) {
      value = std::numbers::pi * part;
      continue;
    }
    const bool negative = letters_[k].either_sign && part < 0;
    if (letters_[k].either_sign) part = 2 * std::abs(part) - 1;
    value = (negative ? -1 : 1) * std::abs(value) * std::pow(10.0, decades * part);
  }
  return values;
}

LetterValues LetterScan::near(std::size_t index) const {
  LetterValues values = point(index);
  for (const Letter& letter : letters_) {
    double& value = values[letter.name];
    const double ordinary = std::abs(base_.at(letter.name));
    if (letter.unit.dimension != dimensions::angle && ordinary > 0)
      value = std::copysign(ordinary * std::pow(std::abs(value) / ordinary, 1.0 / 6), value);
  }
  return values;
}

}  // namespace poinsot::problem
