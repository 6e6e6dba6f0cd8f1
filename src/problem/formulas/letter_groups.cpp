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

std::optional<double> flat_edge(double passed, double outwards,
                                const std::function<std::optional<double>(double)>& misfit_at) {
  constexpr int highest_power = 4;
  constexpr double settled = 1e-3;  // of the edge: its error falls as the cube of the way
  double edge = passed, moved = INFINITY;
  for (const double way : {0.05, 0.02, 0.01, 0.005}) {
    double x[3], misfit[3];
    for (int i = 0; i < 3; ++i) {
      x[i] = edge * (1 + outwards * way * (i + 1));
      const std::optional<double> found = misfit_at(x[i]);
      if (!found) return std::nullopt;
      misfit[i] = *found;
    }
    // The power is that with which the straight line through two places and the curve through three agree best.
    double next = NAN, least = INFINITY;
    for (int power = 1; power <= highest_power; ++power) {
      double r[3];
      for (int i = 0; i < 3; ++i) r[i] = std::pow(misfit[i], 1.0 / power);
      const double straight = x[0] - r[0] * (x[1] - x[0]) / (r[1] - r[0]);
      const double curved = x[0] * r[1] * r[2] / ((r[0] - r[1]) * (r[0] - r[2])) +
                            x[1] * r[0] * r[2] / ((r[1] - r[0]) * (r[1] - r[2])) +
                            x[2] * r[0] * r[1] / ((r[2] - r[0]) * (r[2] - r[1]));
      if (!(std::abs(curved - straight) < least)) continue;
      least = std::abs(curved - straight);
      next = curved;
    }
    if (!(next > passed / 2) || !(next < passed * 2)) return std::nullopt;
    moved = std::abs(next - edge);
    edge = next;
  }
  return moved <= settled * edge ? std::optional(edge) : std::nullopt;
}

}  // namespace poinsot::problem
