#include "problem/explanation/shared_factors.h"

#include <algorithm>

#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot::problem {
namespace {

std::size_t length_of(const std::vector<Formula>& formulas) {
  std::size_t length = 0;
  for (const Formula& one : formulas)
    if (!one.is_zero()) length += text(one).size();
  return length;
}

std::vector<Formula> divided(const std::vector<Formula>& formulas, const Formula& by) {
  std::vector<Formula> result;
  for (const Formula& one : formulas) result.push_back(one.is_zero() ? one : one / by);
  return result;
}

// Whether some formula has a denominator that it did not have before: then it did not share the factor.
bool adds_denominator(const std::vector<Formula>& before, const std::vector<Formula>& after) {
  const auto denominator = [](const Formula& one) { return numerator(one) / one; };
  for (std::size_t k = 0; k < before.size(); ++k)
    if (!before[k].is_zero() && !(denominator(before[k]) - denominator(after[k])).is_zero()) return true;
  return false;
}

bool is_letter(const Formula& factor) { return factor.letters() == std::vector<std::string>{text(factor)}; }

}  // namespace

WithoutShared without_shared_factors(std::vector<Formula> formulas, const std::vector<Formula>& factors) {
  WithoutShared found{std::move(formulas), {}};
  std::size_t length = length_of(found.rest);
  const auto take = [&](const Formula& by) {
    std::vector<Formula> shorter = divided(found.rest, by);
    const std::size_t own = length_of(shorter);
    if (own >= length || (is_letter(by) && adds_denominator(found.rest, shorter))) return false;
    found.rest = std::move(shorter);
    length = own;
    return true;
  };
  constexpr int highest_power = 8;  // of a factor that all share: moments of inertia have fifth powers of lengths
  for (const Formula& factor : factors) {
    for (int power = 0; power < highest_power && take(factor); ++power) found.divided.push_back(factor);
    if (is_letter(factor)) continue;
    // cos(b/2)^6 is as long as its fifth power, and yet not needed.
    int best = 0;
    std::size_t least = length;
    for (int power = 2; power <= highest_power; ++power)
      if (const std::size_t own = length_of(divided(found.rest, pow(factor, power))); own < least) {
        least = own;
        best = power;
      }
    if (best == 0 || !take(pow(factor, best))) continue;
    found.divided.insert(found.divided.end(), static_cast<std::size_t>(best), factor);
  }
  for (const int prime : {2, 3, 5, 7})
    for (const Formula& by : {Formula(prime), Formula(1) / Formula(prime)})
      while (take(by)) {
      }
  return found;
}

std::vector<Formula> possible_factors(const std::vector<Formula>& letters, const std::vector<Formula>& angles) {
  std::vector<Formula> factors = letters;
  for (const Formula& angle : angles) {
    factors.push_back(sin(angle));
    factors.push_back(cos(angle));
    // Numerators are written in tangents of half angles.
    factors.push_back(Formula(1) / cos(angle / Formula(2)));
  }
  return factors;
}

}  // namespace poinsot::problem
