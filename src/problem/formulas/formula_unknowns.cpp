#include "problem/formulas/formula_unknowns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "poinsot/engine/math/formula/formula_sizes.h"
#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/formulas/formula_task.h"

namespace poinsot::problem {
namespace {

constexpr int highest_degree = 4;
// The distance within which a formula belongs to the root that is meant, as a part of the unknown: the search finds
// roots to 1e-9 and worse where they nearly touch. And as a part of its natural size, where it vanishes.
constexpr double near_root = 1e-6, near_nothing = 1e-12;

// A root of a polynomial as a formula; `square` is its square, if only that is needed.
struct Root {
  Formula root;
  std::optional<Formula> square;
  double sign = 1;
  // Of a quadratic with a linear term: its leading coefficient over that of the term. Where it vanishes there is a
  // root, too.
  std::optional<Formula> leading{};
};

// The one of two formulas whose value is closer to a number.
Formula nearer(const Formula& a, const Formula& b, double value) {
  return std::abs(plain(a) - value) <= std::abs(plain(b) - value) ? a : b;
}

// The root of the polynomial that is close to the value.
std::optional<Root> root_of(std::vector<Formula> c, double value) {
  while (c.size() > 1 && c.front().is_zero() && std::abs(value) > 0) c.erase(c.begin());
  if (c.size() == 1) return c.front().is_zero() ? std::optional(Root{Formula(0), {}, 1}) : std::nullopt;
  // Solves a x^2 + b x + d = 0. Division by a coefficient may cancel common factors; the shortest of the forms is
  // taken.
  const auto quadratic = [&](const Formula& a, const Formula& b, const Formula& d, double near) {
    std::optional<Formula> shortest;
    std::size_t length = 0;
    for (const Formula& divisor : {Formula(1), a, b, d}) {
      if (divisor.is_zero()) continue;
      const Formula A = a / divisor, B = b / divisor, D = d / divisor;
      const Formula root = sqrt(B * B - Formula(4) * A * D);
      Formula x = nearer((-B + root) / (Formula(2) * A), (-B - root) / (Formula(2) * A), near);
      const std::size_t own = text(x).size();
      if (shortest && own >= length) continue;
      shortest = std::move(x);
      length = own;
    }
    return *shortest;
  };
  const bool even = c.size() % 2 == 1 && c[1].is_zero() && (c.size() < 5 || c[3].is_zero());
  if (c.size() == 2) return Root{-c[0] / c[1], {}, 1};
  if (even) {
    const Formula square = c.size() == 3 ? -c[0] / c[2] : quadratic(c[4], c[2], c[0], value * value);
    if (plain(square) < 0) return std::nullopt;
    const Formula root = sqrt(square);
    return Root{value < 0 ? -root : root, square, value < 0 ? -1.0 : 1.0,
                c.size() == 3 || c[2].is_zero() ? std::nullopt : std::optional(c[4] / c[2])};
  }
  if (c.size() == 3) return Root{quadratic(c[2], c[1], c[0], value), {}, 1, c[2] / c[1]};
  return std::nullopt;
}

// The angle u near a value for which c[0] + c[1] t + c[2] t^2 = 0 with t = tan(u/2), where this gives the sine or the
// tangent of u alone: sin u = 2t/(1 + t^2), tan u = 2t/(1 - t^2).
std::optional<Formula> angle_without_half(const std::vector<Formula>& c, double value) {
  if (c.size() != 3 || c[1].is_zero() || c[2].is_zero()) return std::nullopt;
  const Formula half_turn = value < 0 ? -Formula::pi() : Formula::pi();
  const bool behind = std::cos(value) < 0;
  if ((c[0] - c[2]).is_zero()) {
    const Formula angle = asin(Formula(-2) * c[2] / c[1]);
    return behind ? half_turn - angle : angle;
  }
  if ((c[0] + c[2]).is_zero()) {
    const Formula angle = atan(Formula(2) * c[2] / c[1]);
    return behind ? half_turn + angle : angle;
  }
  return std::nullopt;
}

// The polynomial in tan(u) that vanishes with one in t = tan(u/2), where u enters by 2u alone, as in moments and
// products of inertia: a sin 2u + b cos 2u + d = 0 is a 4 (t - t^3) + b (1 - 6 t^2 + t^4) + d (1 + t^2)^2 = 0 and, with
// T = tan(u), 2 a T + b (1 - T^2) + d (1 + T^2) = 0.
std::optional<std::vector<Formula>> in_double_angle(std::vector<Formula> c) {
  if (c.size() < 3 || c.size() > 5) return std::nullopt;
  c.resize(5, Formula(0));
  if (!(c[4] - c[0]).is_zero() || !(c[3] + c[1]).is_zero()) return std::nullopt;
  const Formula a = c[1] / Formula(4), b = (Formula(2) * c[0] - c[2]) / Formula(8),
                d = (Formula(6) * c[0] + c[2]) / Formula(8);
  return std::vector{b + d, Formula(2) * a, d - b};
}

// The angle u near a value for which such a polynomial in tan(u) vanishes.
std::optional<Formula> half_of_angle(const std::vector<Formula>& c, double value) {
  const double twice = std::remainder(2 * value, 2 * std::numbers::pi);
  const auto half_turns = [](double turned) { return Formula(std::round(turned / std::numbers::pi)) * Formula::pi(); };
  if (const auto angle = angle_without_half(c, twice)) return *angle / Formula(2) + half_turns(value - twice / 2);
  const double tangent = std::tan(value);
  const std::optional<Root> root = root_of(c, tangent);
  if (!root) return std::nullopt;
  if (!root->square) return atan(root->root) + half_turns(value - std::atan(tangent));
  const Formula angle = acos((Formula(1) - *root->square) / (Formula(1) + *root->square)) / Formula(2);
  return (root->sign < 0 ? -angle : angle) + half_turns(value - twice / 2);
}

// The formula of an unknown for which an expression vanishes. `degree` orders such formulas by the effort that they
// took.
struct Found {
  Formula formula;
  std::size_t degree = 0;
  std::optional<Formula> leading{};
};
std::optional<Found> solve_for(const Formula& remainder, const UnknownLetter& unknown) {
  const std::vector<std::string> letters = remainder.letters();
  if (std::find(letters.begin(), letters.end(), unknown.name) == letters.end()) return std::nullopt;
  try {
    if (!unknown.angle) {
      const auto coefficients = polynomial_in(numerator(remainder), unknown.name);
      if (!coefficients) return std::nullopt;
      const std::optional<Root> root = root_of(*coefficients, unknown.value);
      if (!root) return std::nullopt;
      return Found{root->root, coefficients->size() - 1, root->leading};
    }
    // With t = tan(u/2) sines and cosines of u are rational functions of t.
    const std::string half = unknown.name + "_half";
    const Formula t = Formula::letter(half, poinsot::Sign::real);
    const Formula algebraic = numerator(substituted(remainder, {{unknown.name, Formula(2) * atan(t)}}));
    const auto coefficients = polynomial_in(algebraic, half);
    if (!coefficients) return std::nullopt;
    if (const auto angle = angle_without_half(*coefficients, unknown.value)) return Found{*angle, coefficients->size()};
    if (const auto doubled = in_double_angle(*coefficients))
      if (const auto angle = half_of_angle(*doubled, unknown.value)) return Found{*angle, coefficients->size()};
    const std::optional<Root> root = root_of(*coefficients, std::tan(unknown.value / 2));
    if (!root) return std::nullopt;
    if (!root->square) return Found{Formula(2) * atan(root->root), coefficients->size(), root->leading};
    const Formula angle = acos((Formula(1) - *root->square) / (Formula(1) + *root->square));
    return Found{root->sign < 0 ? -angle : angle, coefficients->size(), root->leading};
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

// A value with other numbers in the place of its own.
template <class Change>
Value<Formula> changed(Value<Formula> value, const Change& change) {
  value.number = change(value.number);
  for (std::size_t k = 0; value.is_vector() && k < 3; ++k) value.vector[k] = change(value.vector[k]);
  for (Value<Formula>& item : value.items) item = changed(item, change);
  return value;
}

}  // namespace

std::optional<std::vector<Formula>> polynomial_in(const Formula& x, const std::string& letter) {
  std::vector<Formula> coefficients;
  Formula slope = x;
  Formula factorial(1);
  for (int k = 0; k <= highest_degree; ++k) {
    if (k > 0) {
      slope = derivative(slope, letter);
      factorial *= Formula(k);
    }
    if (slope.is_zero()) return coefficients;
    coefficients.push_back(substituted(slope, {{letter, Formula(0)}}) / factorial);
  }
  return derivative(slope, letter).is_zero() ? std::optional(coefficients) : std::nullopt;
}

Formula first_order(const Formula& x, const std::vector<std::string>& small) {
  std::map<std::string, Formula> zero;
  for (const std::string& letter : small) zero[letter] = Formula(0);
  const std::vector<std::string> letters = x.letters();
  Formula sum = zero.empty() ? x : substituted(x, zero);
  for (const std::string& letter : small) {
    if (std::find(letters.begin(), letters.end(), letter) == letters.end()) continue;
    sum += Formula::letter(letter, poinsot::Sign::real) * substituted(derivative(x, letter), zero);
  }
  return sum;
}

std::vector<DecidedSign> signs_of_unknowns(const std::vector<Formula>& remainders,
                                           const std::vector<UnknownLetter>& letters) {
  std::vector<DecidedSign> all;
  for (const Formula& remainder : remainders)
    with_known_signs(remainder, [&](const Formula& argument) {
      const std::vector<std::string> names = argument.letters();
      const bool of_unknown = std::ranges::any_of(
          letters, [&](const UnknownLetter& letter) { return std::ranges::find(names, letter.name) != names.end(); });
      if (of_unknown && std::ranges::find(all, argument, &DecidedSign::of) == all.end())
        all.push_back({argument, plain(argument) < 0 ? -1 : 1});
      return 0;
    });
  return all;
}

Formula with_signs(const Formula& x, const std::vector<DecidedSign>& signs) {
  return with_known_signs(x, [&](const Formula& argument) {
    const auto known = std::ranges::find(signs, argument, &DecidedSign::of);
    return known == signs.end() ? 0 : known->sign;
  });
}

Value<Formula> with_signs(const Value<Formula>& value, const std::vector<DecidedSign>& signs) {
  return changed(value, [&](const Formula& x) { return with_signs(x, signs); });
}

Value<Formula> with_sizes(const Value<Formula>& value, const std::vector<Formula>& positive) {
  return changed(value, [&](const Formula& x) {
    return with_known_signs(x, [&](const Formula& argument) {
      for (const int sign : {1, -1})
        if (is_assumed_positive(Formula(sign) * argument, positive, true)) return sign;
      return 0;
    });
  });
}

std::map<std::string, Formula> solve_unknowns(std::vector<Formula> remainders, std::vector<UnknownLetter> unknowns,
                                              std::vector<Formula>* leading) {
  std::map<std::string, Formula> found;
  while (!unknowns.empty()) {
    std::optional<Found> best;
    std::size_t chosen = 0;
    for (const Formula& remainder : remainders)
      for (std::size_t k = 0; k < unknowns.size(); ++k) {
        std::optional<Found> candidate = solve_for(remainder, unknowns[k]);
        if (!candidate) continue;
        const double value = plain(candidate->formula);
        const double reach = near_root * std::abs(unknowns[k].value) + near_nothing * unknowns[k].natural;
        if (!(std::abs(value - unknowns[k].value) <= reach)) continue;
        const auto cost = [](const Found& item) { return std::pair(item.degree, item.formula.terms()); };
        if (best && cost(*best) <= cost(*candidate)) continue;
        best = std::move(candidate);
        chosen = k;
      }
    if (!best) throw NoFormula("the conditions for '" + unknowns.front().name + "' have no solution in formulas");
    const std::map<std::string, Formula> value{{unknowns[chosen].name, best->formula}};
    for (auto& [name, formula] : found) formula = substituted(formula, value);
    found[unknowns[chosen].name] = best->formula;
    if (leading) {
      for (Formula& one : *leading) one = substituted(one, value);
      if (best->leading) leading->push_back(*best->leading);
    }
    unknowns.erase(unknowns.begin() + static_cast<std::ptrdiff_t>(chosen));
    std::vector<Formula> left;
    for (const Formula& remainder : remainders)
      if (Formula rest = substituted(remainder, value); !rest.is_zero()) left.push_back(std::move(rest));
    remainders = std::move(left);
  }
  if (!remainders.empty()) throw NoFormula("what is stated holds for special values of the letters only");
  return found;
}

}  // namespace poinsot::problem
