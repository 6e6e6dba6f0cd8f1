// Common divisors of polynomials. Most are seen at once, by images modulo a prime or by a division; what is left is
// found by FLINT, whose algorithms are made for far larger polynomials than those of most formulas.
#include <flint/fmpz_vec.h>
#include <flint/nmod_poly.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/math/formula/formula_polynomial.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::symbolic {
namespace {

constexpr ulong image_prime = 2305843009213693951;  // 2^61 - 1

// A polynomial with numbers modulo a prime for all variables but one.
class Image {
 public:
  Image() { nmod_poly_init(polynomial_, image_prime); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() { nmod_poly_clear(polynomial_); }
  nmod_poly_struct* get() { return polynomial_; }
  int degree() const { return static_cast<int>(nmod_poly_degree(polynomial_)); }

 private:
  nmod_poly_t polynomial_;
};

// The terms of a polynomial, laid out to be evaluated.
struct Terms {
  explicit Terms(const Polynomial& a)
      : variables(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring()))),
        powers(a.length() * variables),
        degrees(variables, 0) {
    for (std::size_t i = 0; i < a.length(); ++i) {
      ulong* here = powers.data() + i * variables;
      fmpz_mpoly_get_term_exp_ui(here, a.get(), static_cast<slong>(i), a.ring());
      for (std::size_t v = 0; v < variables; ++v) degrees[v] = std::max(degrees[v], here[v]);
      coefficients.push_back(fmpz_fdiv_ui(a.get()->coeffs + i, image_prime));
    }
  }
  void image(std::size_t kept, const std::vector<ulong>& numbers, const nmod_t& modulus, Image& result) const {
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      const ulong* here = powers.data() + i * variables;
      ulong value = coefficients[i];
      for (std::size_t v = 0; v < variables; ++v) {
        if (v == kept || here[v] == 0) continue;
        value = nmod_mul(value, here[v] == 1 ? numbers[v] : nmod_pow_ui(numbers[v], here[v], modulus), modulus);
      }
      const auto power = static_cast<slong>(here[kept]);
      nmod_poly_set_coeff_ui(result.get(), power,
                             nmod_add(nmod_poly_get_coeff_ui(result.get(), power), value, modulus));
    }
  }

  std::size_t variables;
  std::vector<ulong> powers, degrees, coefficients;
};

// Whether a common divisor of a and b can be more than a number, and whether it can be as much as b. Where the leading
// coefficient of one of them in a variable does not vanish in the image, the degree of the common divisor is no more
// than that of the images' (W. S. Brown, J. ACM 18, 478, 1971).
struct DivisorBound {
  bool number_only = true, all_of_b = true;
};
DivisorBound divisor_bound(const Polynomial& a, const Polynomial& b) {
  nmod_t modulus;
  nmod_init(&modulus, image_prime);
  const Terms a_terms(a), b_terms(b);
  std::vector<ulong> numbers(a_terms.variables);
  ulong state = 0x9e3779b97f4a7c15;
  for (ulong& number : numbers) {  // Knuth's linear congruences
    state = state * 6364136223846793005 + 1442695040888963407;
    number = 2 + (state >> 4) % (image_prime - 2);
  }
  DivisorBound bound;
  for (std::size_t v = 0; v < a_terms.variables; ++v) {
    if (b_terms.degrees[v] == 0) continue;
    if (a_terms.degrees[v] == 0) {
      bound.all_of_b = false;
      continue;
    }
    Image above, below, common;
    a_terms.image(v, numbers, modulus, above);
    b_terms.image(v, numbers, modulus, below);
    const auto whole = [&](const Image& image, const Terms& terms) {
      return image.degree() == static_cast<int>(terms.degrees[v]);
    };
    if (!whole(above, a_terms) && !whole(below, b_terms)) return {false, true};
    nmod_poly_gcd(common.get(), above.get(), below.get());
    if (common.degree() > 0) bound.number_only = false;
    if (common.degree() < static_cast<int>(b_terms.degrees[v])) bound.all_of_b = false;
    if (!bound.number_only && !bound.all_of_b) break;
  }
  return bound;
}

Integer content_of(const Polynomial& a) {
  Integer content;
  _fmpz_vec_content(content.get(), a.get()->coeffs, fmpz_mpoly_length(a.get(), a.ring()));
  return content;
}

// Where it is easily seen: of numbers, of what has no factor in common, and where one divides the other.
std::optional<Polynomial> plain_divisor(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return std::nullopt;
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring()));
  if (a.is_one() || b.is_one()) return Polynomial(n, Integer(1));
  if (a.length() < b.length()) return plain_divisor(b, a);
  const bool numbers = a.is_constant() || b.is_constant();
  if (!numbers && b.length() == 1) return std::nullopt;  // FLINT is quick there
  const DivisorBound bound = numbers ? DivisorBound{true, false} : divisor_bound(a, b);
  if (!bound.number_only && !bound.all_of_b) return std::nullopt;
  const Integer b_content = content_of(b);
  Integer content = content_of(a);
  fmpz_gcd(content.get(), content.get(), b_content.get());
  if (bound.number_only) return Polynomial(n, content);
  Polynomial primitive = divided_exactly(b, b_content);
  if (primitive.leading_sign() < 0) primitive = -primitive;
  Polynomial quotient(n);
  if (fmpz_mpoly_divides(quotient.get(), a.get(), primitive.get(), a.ring()) == 0) return std::nullopt;
  return scaled(primitive, content);
}

// The coefficients of a as a polynomial in the variables that b does not have.
std::vector<Polynomial> coefficients_over(const Polynomial& a, const std::vector<bool>& in_b) {
  std::map<std::vector<int>, Polynomial> coefficients;
  for (std::size_t i = 0; i < a.length(); ++i) {
    std::vector<int> inside = a.exponents(i), outside(inside.size(), 0);
    for (std::size_t v = 0; v < inside.size(); ++v)
      if (!in_b[v]) std::swap(inside[v], outside[v]);
    coefficients.try_emplace(std::move(outside), inside.size()).first->second.push(a.coefficient(i), inside);
  }
  std::vector<Polynomial> list;
  for (auto& [outside, coefficient] : coefficients) {
    coefficient.tidy();
    list.push_back(std::move(coefficient));
  }
  return list;
}

// A common divisor has only the variables that both have: it divides the coefficients of both in the others.
std::optional<Polynomial> divisor_of_coefficients(const Polynomial& a, const Polynomial& b) {
  const std::vector<bool> in_a = a.used(), in_b = b.used();
  if (in_a == in_b) return std::nullopt;
  std::vector<Polynomial> list = coefficients_over(a, in_b);
  for (Polynomial& coefficient : coefficients_over(b, in_a)) list.push_back(std::move(coefficient));
  std::stable_sort(list.begin(), list.end(),
                   [](const Polynomial& x, const Polynomial& y) { return x.length() < y.length(); });
  Polynomial common = list.front();
  for (std::size_t i = 1; i < list.size() && !common.is_constant(); ++i) common = common_divisor(common, list[i]);
  if (!common.is_constant()) return common;
  Integer content = content_of(a);
  const Integer b_content = content_of(b);
  fmpz_gcd(content.get(), content.get(), b_content.get());
  return Polynomial(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring())), content);
}

}  // namespace

Polynomial common_divisor(const Polynomial& a, const Polynomial& b) {
  check_limits(std::max(a.length(), b.length()));
  count_formula_work(200 * static_cast<double>(a.length() + b.length()));
  if (auto plain = plain_divisor(a, b)) return std::move(*plain);
  if (a.length() > 1 && b.length() > 1)
    if (auto divisor = divisor_of_coefficients(a, b)) return std::move(*divisor);
  Polynomial c(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring())));
  if (fmpz_mpoly_gcd(c.get(), a.get(), b.get(), a.ring()) == 0) {
    throw FormulaTooLarge("the common factors of a formula could not be found; give some of the letters values");
  }
  return c;
}

}  // namespace poinsot::symbolic
