#include "problem/claims/claim_stability.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "poinsot/engine/math/formula/formula_sign.h"

namespace poinsot::problem {
namespace {

using Matrix = FormulaMatrix;

constexpr std::size_t most_freedoms = 5;  // a determinant of formulas has up to the factorial of these terms
constexpr std::size_t highest_power = 6;  // of the rate of growth in the characteristic polynomial

// Whether the formula is seen to be positive.
bool is_positive(const Formula& x) {
  const SeenSign seen = seen_sign(x);
  return seen.sign > 0 && seen.strict;
}

// Whether a check holds for every leading principal minor.
template <class Check>
bool leading_minors(const Matrix& A, const Check& check) {
  for (std::size_t n = 1; n <= A.size(); ++n) {
    Matrix minor;
    for (std::size_t i = 0; i < n; ++i) minor.emplace_back(A[i].begin(), A[i].begin() + static_cast<std::ptrdiff_t>(n));
    if (!check(determinant(minor))) return false;
  }
  return true;
}

// The criteria of stability. Each asks that some formulas are positive, and calls a check for each of them.
enum class Criterion { negative_squares, hurwitz, energy };

// Whether all roots are negative and different: the coefficients have one sign, and the discriminant shows that all
// roots are real.
template <class Check>
bool negative_roots(const std::vector<Formula>& c, const Check& check) {
  if (!std::all_of(c.begin(), c.end(), check)) return false;
  switch (c.size()) {
    case 1:
    case 2:
      return true;
    case 3:
      return check(c[1] * c[1] - Formula(4) * c[0] * c[2]);
    case 4: {
      const Formula &d = c[0], &e = c[1], &b = c[2], &a = c[3];
      return check(Formula(18) * a * b * e * d - Formula(4) * b * b * b * d + b * b * e * e -
                   Formula(4) * a * e * e * e - Formula(27) * a * a * d * d);
    }
    default:
      return false;
  }
}

// Hurwitz's criterion: whether all roots have negative real parts.
template <class Check>
bool roots_on_the_left(const std::vector<Formula>& c, const Check& check) {
  if (!std::all_of(c.begin(), c.end(), check) || c.size() > highest_power + 1) return false;
  const std::size_t n = c.size() - 1;
  Matrix H = zeros(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const auto power =
          static_cast<std::ptrdiff_t>(n) - 2 * static_cast<std::ptrdiff_t>(k + 1) + static_cast<std::ptrdiff_t>(i + 1);
      if (power >= 0 && power <= static_cast<std::ptrdiff_t>(n)) H[i][k] = c[static_cast<std::size_t>(power)];
    }
  return leading_minors(H, check);
}

// The characteristic polynomial in ascending powers, divided by l as often as l = 0 is a root identically;
// `vanishing` counts these roots.
struct Polynomial {
  std::vector<Formula> c;
  std::size_t vanishing = 0;

  std::vector<Formula> even() const {
    std::vector<Formula> powers;
    for (std::size_t k = 0; k < c.size(); k += 2) powers.push_back(c[k]);
    return powers;
  }
  bool is_even() const {
    for (std::size_t k = 1; k < c.size(); k += 2)
      if (!c[k].is_zero()) return false;
    return true;
  }
};

Polynomial polynomial_of(const LinearisedFormulas& near) {
  Polynomial polynomial{characteristic_polynomial(near), 0};
  std::vector<Formula>& c = polynomial.c;
  while (polynomial.vanishing < c.size() && c[polynomial.vanishing].is_zero()) ++polynomial.vanishing;
  c.erase(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(polynomial.vanishing));
  if (!c.empty() && plain(c.back()) < 0)
    for (Formula& coefficient : c) coefficient = -coefficient;
  return polynomial;
}

template <class Check>
bool holds(Criterion criterion, const LinearisedFormulas& near, const Polynomial& polynomial, const Check& check) {
  switch (criterion) {
    case Criterion::negative_squares:
      return polynomial.is_even() && negative_roots(polynomial.even(), check);
    case Criterion::hurwitz:
      return !polynomial.is_even() && roots_on_the_left(polynomial.c, check);
    case Criterion::energy:
      break;
  }
  // If K is symmetric and definite and C is skew, the energy x'.M x' + x.K x is conserved and bounds x and x'
  // (Thomson and Tait).
  if (!polynomial.is_even() || near.follows_spin || polynomial.vanishing > 0) return false;
  Matrix symmetric = near.C, skew = near.K;
  for (std::size_t i = 0; i < near.K.size(); ++i)
    for (std::size_t k = 0; k < near.K.size(); ++k) {
      symmetric[i][k] = near.C[i][k] + near.C[k][i];
      skew[i][k] = near.K[i][k] - near.K[k][i];
    }
  return vanishes(symmetric) && vanishes(skew) && leading_minors(near.K, check);
}

std::optional<Criterion> stable_by(const LinearisedFormulas& near, std::size_t symmetries) {
  const Polynomial polynomial = polynomial_of(near);
  // The roots that vanish identically must be those of the symmetries and no others.
  if (polynomial.vanishing != symmetries || polynomial.c.empty()) return std::nullopt;
  for (const Criterion criterion : {Criterion::negative_squares, Criterion::hurwitz, Criterion::energy})
    if (holds(criterion, near, polynomial, is_positive)) return criterion;
  return std::nullopt;
}

const char* words_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::negative_squares:
      return "all squares of the rates are negative and differ if the coefficients and the discriminant are positive";
    case Criterion::hurwitz:
      return "all real parts are negative if the coefficients and Hurwitz's determinants are positive";
    case Criterion::energy:
      break;
  }
  return "the energy of a disturbance, which stays what it is, bounds it if the leading minors of its matrix are "
         "positive";
}

StabilityShown shown_of(const LinearisedFormulas& near, std::optional<Criterion> criterion) {
  Polynomial polynomial = polynomial_of(near);
  if (polynomial.c.empty()) return {};
  const Formula first = polynomial.c.back();
  for (Formula& coefficient : polynomial.c) coefficient /= first;
  const Criterion looked = criterion.value_or(polynomial.is_even() ? Criterion::negative_squares : Criterion::hurwitz);
  StabilityShown shown{polynomial.c, polynomial.vanishing, words_of(looked), {}};
  holds(looked, near, polynomial, [&](const Formula& x) {
    if (!x.is_number() && std::find(shown.positive.begin(), shown.positive.end(), x) == shown.positive.end())
      shown.positive.push_back(x);
    return true;
  });
  return shown;
}

}  // namespace

bool proves_stability(const SteadyFormulas& motion, const WorkedAssumptions& assumptions,
                      std::optional<StabilityShown>* shown) {
  const Mechanism<Formula>& mechanism = motion.machine.mechanism;
  if (!mechanism.constraints.empty() || !assumptions.complete()) return false;
  const std::vector<std::size_t> free = free_coordinates(motion);
  if (free.size() > most_freedoms) return false;
  const LinearisedFormulas near = linearised(motion, free);
  if (!std::all_of(near.unrest.begin(), near.unrest.end(), [&](const Formula& unrest) {
        return assumptions.proves({unrest, Formula(0), Relation::equal});
      }))
    return false;
  std::optional<Criterion> criterion;
  const bool proved = std::all_of(assumptions.cases().begin(), assumptions.cases().end(), [&](const WorkedCase& one) {
    // If an assumption allows equality, what should be positive may vanish.
    if (!one.unsolved().empty() || one.is_weak()) return false;
    LinearisedFormulas applied = near;
    for (Matrix* matrix : {&applied.M, &applied.C, &applied.K})
      for (auto& row : *matrix)
        for (Formula& entry : row) entry = one.apply(entry);
    criterion = stable_by(applied, motion.symmetries);
    return criterion.has_value();
  });
  if (shown) *shown = shown_of(near, proved ? criterion : std::nullopt);
  return proved;
}

}  // namespace poinsot::problem
