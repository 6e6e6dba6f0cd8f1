#include "problem/formulas/letter_groups.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "problem/formulas/formula_answers.h"
#include "problem/formulas/law_shape.h"

namespace poinsot::problem {
namespace {

constexpr int largest_exponent = 3;
constexpr std::size_t most_in_a_group = 4;
constexpr std::size_t most_grouped = 8;  // letters that may have a part in groups, by name
constexpr int largest_denominator = 60;  // of a bound that counts as a fraction
constexpr int told_digits = 6;           // of one that does not

struct Draft {
  std::vector<std::pair<Letter, int>> powers;
  int cost = 0;
};

// Adds powers of the letters from `next` on to a draft, and keeps what has no dimension.
void grow(const std::vector<Letter>& letters, std::size_t next, const Dimension& dimension, const Draft& draft,
          std::vector<Draft>& found) {
  if (!draft.powers.empty() && same_kind(dimension, dimensions::none)) {
    found.push_back(draft);
    return;
  }
  if (draft.powers.size() == most_in_a_group) return;
  for (std::size_t k = next; k < letters.size(); ++k) {
    Dimension with = dimension, without = dimension;
    for (int power = 1; power <= largest_exponent; ++power) {
      with = with * letters[k].unit.dimension;
      without = without / letters[k].unit.dimension;
      for (const int signed_power : {power, -power}) {
        // A group and its inverse tell the same.
        if (draft.powers.empty() && signed_power < 0) continue;
        Draft longer = draft;
        longer.powers.emplace_back(letters[k], signed_power);
        longer.cost += 10 + power;
        grow(letters, k + 1, signed_power > 0 ? with : without, longer, found);
      }
    }
  }
}

}  // namespace

double LetterGroup::at(const LetterValues& letters) const {
  double product = 1;
  for (const auto& [letter, power] : powers_) product *= std::pow(letters.at(letter.name), power);
  return product;
}

LetterValues LetterGroup::moved(LetterValues letters, double value) const {
  const auto& [letter, power] = powers_.front();
  letters.at(letter.name) *= std::pow(value / at(letters), 1.0 / power);
  return letters;
}

Formula LetterGroup::part(bool above) const {
  Formula product(1);
  for (const auto& [letter, power] : powers_)
    if ((power > 0) == above) product *= pow(formula_of(letter).number, std::abs(power));
  return product;
}

Formula LetterGroup::below(const Formula& bound) const { return bound * part(false) - part(true); }

std::vector<LetterGroup> groups_of(const std::vector<Letter>& letters) {
  std::vector<Letter> sizes;
  for (const Letter& letter : letters)
    if (!letter.either_sign && letter.unit.dimension != dimensions::angle) sizes.push_back(letter);
  std::ranges::sort(sizes, {}, &Letter::name);
  if (sizes.size() > most_grouped) sizes.erase(sizes.begin() + most_grouped, sizes.end());
  std::vector<Draft> found;
  grow(sizes, 0, dimensions::none, {}, found);
  std::ranges::stable_sort(found, {}, &Draft::cost);
  std::vector<LetterGroup> groups;
  for (Draft& draft : found) groups.emplace_back(std::move(draft.powers));
  // Beside numbers of the file a letter alone may bound: a spring is longer than the 0.1 m by which it swings.
  for (const Letter& size : sizes)
    if (!same_kind(size.unit.dimension, dimensions::none)) groups.emplace_back(std::vector{std::pair(size, 1)});
  return groups;
}

Formula simple_number(double number, double tolerance) {
  for (int below = 1; below <= largest_denominator; ++below) {
    const double above = std::round(number * below);
    if (above != 0 && std::abs(above / below - number) <= tolerance * std::abs(number))
      return Formula(static_cast<std::int64_t>(above)) / Formula(below);
  }
  return rounded(number, number, told_digits);
}

}  // namespace poinsot::problem
