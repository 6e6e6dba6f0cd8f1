#include "engine/math/formula/formula_polynomial.h"

#include <flint/fmpz_mpoly_factor.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {
namespace {

thread_local std::size_t most_terms = FormulaLimits().terms;
thread_local WorkLimit formula_work(unlimited_work);

// FLINT keeps pools of memory for each thread, which a thread that ends has to give back.
struct PoolKeeper {
  ~PoolKeeper() { flint_cleanup(); }
};

}  // namespace

FormulaLimitScope::FormulaLimitScope(const FormulaLimits& inner)
    : outer_terms_(std::exchange(most_terms, inner.terms)),
      outer_work_(std::exchange(formula_work, WorkLimit(inner.work))) {}
FormulaLimitScope::~FormulaLimitScope() {
  most_terms = outer_terms_;
  formula_work = outer_work_;
}

namespace symbolic {

void check_limits(std::size_t terms) {
  if (terms > most_terms) {
    throw FormulaTooLarge("a formula would have more than " + std::to_string(most_terms) +
                          " terms; give some of the letters values");
  }
  if (formula_work.spent())
    throw FormulaTooLarge("the time allowed for formulas has passed; give some of the letters values");
}

void count_formula_work(double operations) {
  constexpr double of_any = 300;  // what any operation takes beside its terms: memory is taken and given back
  count_work(static_cast<Work>(of_any + operations));
}

std::string Integer::text() const {
  const std::unique_ptr<char, void (*)(void*)> digits(fmpz_get_str(nullptr, 10, number_), flint_free);
  return digits.get();
}

// Rings are made when first needed and never given back: values may outlive any owner.
const fmpz_mpoly_ctx_struct* ring_of(std::size_t variables) {
  constexpr std::size_t most = 256;
  static std::array<std::atomic<const fmpz_mpoly_ctx_struct*>, most> rings{};
  static std::mutex making;
  static thread_local const PoolKeeper keeper;

  const std::size_t n = std::max<std::size_t>(variables, 1);
  if (n >= most) throw FormulaTooLarge("a formula would have more than 255 letters, sines and roots");
  if (const auto* ring = rings[n].load(std::memory_order_acquire)) return ring;
  const std::lock_guard lock(making);
  if (const auto* ring = rings[n].load(std::memory_order_acquire)) return ring;
  auto ring = std::make_unique<fmpz_mpoly_ctx_struct>();
  fmpz_mpoly_ctx_init(ring.get(), static_cast<slong>(n), ORD_LEX);
  rings[n].store(ring.get(), std::memory_order_release);
  return ring.release();
}

Polynomial Polynomial::variable(std::size_t variables, std::size_t index) {
  Polynomial x(variables);
  fmpz_mpoly_gen(x.get(), static_cast<slong>(index), x.ring());
  return x;
}

int Polynomial::degree(std::size_t variable) const {
  return static_cast<int>(fmpz_mpoly_degree_si(terms_, static_cast<slong>(variable), ring_));
}

std::vector<bool> Polynomial::used() const {
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(ring_));
  std::vector<int> marks(n);
  fmpz_mpoly_used_vars(marks.data(), terms_, ring_);
  return {marks.begin(), marks.end()};
}

Integer Polynomial::coefficient(std::size_t term) const {
  Integer c;
  fmpz_mpoly_get_term_coeff_fmpz(c.get(), terms_, static_cast<slong>(term), ring_);
  return c;
}

std::vector<int> Polynomial::exponents(std::size_t term) const {
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(ring_));
  std::vector<slong> powers(n);
  fmpz_mpoly_get_term_exp_si(powers.data(), terms_, static_cast<slong>(term), ring_);
  return {powers.begin(), powers.end()};
}

void Polynomial::push(const Integer& coefficient, const std::vector<int>& exponents) {
  const std::vector<ulong> powers(exponents.begin(), exponents.end());
  fmpz_mpoly_push_term_fmpz_ui(terms_, coefficient.get(), powers.data(), ring_);
}

void Polynomial::tidy() {
  fmpz_mpoly_sort_terms(terms_, ring_);
  fmpz_mpoly_combine_like_terms(terms_, ring_);
}

std::vector<Polynomial> Polynomial::coefficients_by(std::size_t variable) const {
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(ring_));
  std::vector<Polynomial> parts(static_cast<std::size_t>(std::max(degree(variable), 0)) + 1, Polynomial(n));
  for (std::size_t i = 0; i < length(); ++i) {
    std::vector<int> powers = exponents(i);
    const auto k = static_cast<std::size_t>(std::exchange(powers[variable], 0));
    parts[k].push(coefficient(i), powers);
  }
  for (Polynomial& part : parts) part.tidy();
  return parts;
}

Polynomial Polynomial::moved(const std::vector<int>& place, std::size_t variables) const {
  const auto n = static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(ring_));
  const std::size_t known = std::min(n, place.size());
  Polynomial result(variables);
  fmpz_mpoly_fit_length(result.terms_, fmpz_mpoly_length(terms_, ring_), result.ring_);
  std::vector<ulong> powers(n), moved_powers(std::max<std::size_t>(variables, 1));
  for (slong term = 0; term < fmpz_mpoly_length(terms_, ring_); ++term) {
    fmpz_mpoly_get_term_exp_ui(powers.data(), terms_, term, ring_);
    std::fill(moved_powers.begin(), moved_powers.end(), 0);
    for (std::size_t i = 0; i < known; ++i)
      if (place[i] >= 0) moved_powers[static_cast<std::size_t>(place[i])] = powers[i];
    fmpz_mpoly_push_term_fmpz_ui(result.terms_, terms_->coeffs + term, moved_powers.data(), result.ring_);
  }
  // Variables that stay in their order leave the terms in theirs.
  int last = -1;
  for (std::size_t i = 0; i < known; ++i) {
    if (place[i] < 0) continue;
    if (place[i] <= last) {
      result.tidy();
      break;
    }
    last = place[i];
  }
  return result;
}

Integer Polynomial::content() const {
  Integer divisor(0);
  for (std::size_t i = 0; i < length(); ++i) {
    const Integer c = coefficient(i);
    fmpz_gcd(divisor.get(), divisor.get(), c.get());
    if (fmpz_is_one(divisor.get())) break;
  }
  if (is_zero()) return Integer(1);
  if (leading_sign() < 0) fmpz_neg(divisor.get(), divisor.get());
  return divisor;
}

int Polynomial::leading_sign() const { return is_zero() ? 0 : fmpz_sgn(coefficient(0).get()); }

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial c(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring_)));
  fmpz_mpoly_add(c.terms_, a.terms_, b.terms_, a.ring_);
  return c;
}
Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial c(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring_)));
  fmpz_mpoly_sub(c.terms_, a.terms_, b.terms_, a.ring_);
  return c;
}
Polynomial operator-(const Polynomial& a) {
  Polynomial c(a);
  fmpz_mpoly_neg(c.terms_, a.terms_, a.ring_);
  return c;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  check_limits(0);
  Polynomial c(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring_)));
  // What two large factors make is estimated first, lest the product itself take too long.
  if (a.length() > 1 && b.length() > 1) check_limits(a.length() * b.length() / 200);
  count_formula_work(20 * static_cast<double>(a.length()) * static_cast<double>(b.length()));
  fmpz_mpoly_mul(c.terms_, a.terms_, b.terms_, a.ring_);
  check_limits(c.length());
  return c;
}
bool operator==(const Polynomial& a, const Polynomial& b) {
  return a.ring_ == b.ring_ && fmpz_mpoly_equal(a.terms_, b.terms_, a.ring_) != 0;
}

Polynomial scaled(const Polynomial& a, const Integer& factor) {
  Polynomial c(a);
  fmpz_mpoly_scalar_mul_fmpz(c.get(), a.get(), factor.get(), a.ring());
  return c;
}
Polynomial divided_exactly(const Polynomial& a, const Integer& divisor) {
  Polynomial c(a);
  fmpz_mpoly_scalar_divexact_fmpz(c.get(), a.get(), divisor.get(), a.ring());
  return c;
}
Polynomial divided_exactly(const Polynomial& a, const Polynomial& divisor) {
  if (divisor.is_one()) return a;
  Polynomial c(a);
  if (fmpz_mpoly_divides(c.get(), a.get(), divisor.get(), a.ring()) == 0) {
    throw std::logic_error("a polynomial was to be divided by one that is no factor of it");
  }
  return c;
}

Polynomial power(const Polynomial& a, int exponent) {
  Polynomial result(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring())), Integer(1));
  for (int k = 0; k < exponent; ++k) result = result * a;
  return result;
}

Factors factored(const Polynomial& a) {
  check_limits(a.length());
  count_formula_work(2000 * static_cast<double>(a.length()));
  const auto clear = [&a](fmpz_mpoly_factor_struct* f) {
    fmpz_mpoly_factor_clear(f, a.ring());
    delete f;
  };
  const std::unique_ptr<fmpz_mpoly_factor_struct, decltype(clear)> f(new fmpz_mpoly_factor_struct, clear);
  fmpz_mpoly_factor_init(f.get(), a.ring());
  if (fmpz_mpoly_factor(f.get(), a.get(), a.ring()) == 0) {
    throw FormulaTooLarge("the factors of a formula could not be found; give some of the letters values");
  }
  Factors result;
  fmpz_set(result.constant.get(), f->constant);
  for (slong i = 0; i < f->num; ++i) {
    Polynomial base(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(a.ring())));
    fmpz_mpoly_set(base.get(), f->poly + i, a.ring());
    const int exponent = static_cast<int>(fmpz_get_si(f->exp + i));
    if (base.leading_sign() < 0) {
      base = -base;
      if (exponent % 2 != 0) fmpz_neg(result.constant.get(), result.constant.get());
    }
    result.powers.emplace_back(std::move(base), exponent);
  }
  return result;
}

}  // namespace symbolic
}  // namespace poinsot
