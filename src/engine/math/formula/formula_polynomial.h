// Polynomials with integer coefficients in numbered variables, as values: FLINT's fmpz and fmpz_mpoly.
#pragma once

#include <flint/fmpz.h>
#include <flint/fmpz_mpoly.h>

#include <string>
#include <utility>
#include <vector>

namespace poinsot::symbolic {

class Integer {
 public:
  Integer() { fmpz_init(number_); }
  explicit Integer(slong number) { fmpz_init_set_si(number_, number); }
  Integer(const Integer& other) { fmpz_init_set(number_, other.number_); }
  Integer(Integer&& other) noexcept {
    fmpz_init(number_);
    fmpz_swap(number_, other.number_);
  }
  Integer& operator=(Integer other) noexcept {
    fmpz_swap(number_, other.number_);
    return *this;
  }
  ~Integer() { fmpz_clear(number_); }

  fmpz* get() { return number_; }
  const fmpz* get() const { return number_; }
  std::string text() const;

 private:
  fmpz_t number_;
};

// The ring of polynomials in so many variables (at least one), in lexicographic order. It lives to the end.
const fmpz_mpoly_ctx_struct* ring_of(std::size_t variables);

class Polynomial {
 public:
  explicit Polynomial(std::size_t variables) : ring_(ring_of(variables)) { fmpz_mpoly_init(terms_, ring_); }
  Polynomial(std::size_t variables, const Integer& constant) : Polynomial(variables) {
    fmpz_mpoly_set_fmpz(terms_, constant.get(), ring_);
  }
  static Polynomial variable(std::size_t variables, std::size_t index);
  Polynomial(const Polynomial& other) : ring_(other.ring_) {
    fmpz_mpoly_init(terms_, ring_);
    fmpz_mpoly_set(terms_, other.terms_, ring_);
  }
  Polynomial(Polynomial&& other) noexcept : ring_(other.ring_) {
    fmpz_mpoly_init(terms_, ring_);
    fmpz_mpoly_swap(terms_, other.terms_, ring_);
  }
  Polynomial& operator=(Polynomial other) noexcept {
    std::swap(ring_, other.ring_);
    std::swap(*terms_, *other.terms_);
    return *this;
  }
  ~Polynomial() { fmpz_mpoly_clear(terms_, ring_); }

  fmpz_mpoly_struct* get() { return terms_; }
  const fmpz_mpoly_struct* get() const { return terms_; }
  const fmpz_mpoly_ctx_struct* ring() const { return ring_; }

  bool is_zero() const { return fmpz_mpoly_is_zero(terms_, ring_) != 0; }
  bool is_one() const { return fmpz_mpoly_is_one(terms_, ring_) != 0; }
  bool is_constant() const { return fmpz_mpoly_is_fmpz(terms_, ring_) != 0; }
  std::size_t length() const { return static_cast<std::size_t>(fmpz_mpoly_length(terms_, ring_)); }
  int degree(std::size_t variable) const;
  std::vector<bool> used() const;  // one for each variable of the ring

  Integer coefficient(std::size_t term) const;
  std::vector<int> exponents(std::size_t term) const;  // one for each variable of the ring
  void push(const Integer& coefficient, const std::vector<int>& exponents);
  void tidy();  // after the last push: brings the terms in order

  // By powers of a variable: entry k is the coefficient of its k-th power, without the variable.
  std::vector<Polynomial> coefficients_by(std::size_t variable) const;
  // With variable i of this ring as variable place[i] of a ring of so many variables; place -1: does not occur.
  Polynomial moved(const std::vector<int>& place, std::size_t variables) const;
  // The greatest common divisor of the coefficients, with the sign of the leading one; 1 of zero.
  Integer content() const;
  int leading_sign() const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a);
  // Throws FormulaTooLarge if the product has too many terms, also power.
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial& a, const Polynomial& b);

 private:
  const fmpz_mpoly_ctx_struct* ring_;
  fmpz_mpoly_t terms_;
};

Polynomial scaled(const Polynomial& a, const Integer& factor);
Polynomial divided_exactly(const Polynomial& a, const Integer& divisor);
Polynomial divided_exactly(const Polynomial& a, const Polynomial& divisor);
Polynomial power(const Polynomial& a, int exponent);
// The greatest common divisor, its leading coefficient positive.
Polynomial common_divisor(const Polynomial& a, const Polynomial& b);

// constant * product of base^exponent: irreducible bases with positive leading coefficients, none of them constant.
struct Factors {
  Integer constant;
  std::vector<std::pair<Polynomial, int>> powers;
};
Factors factored(const Polynomial& a);

// Throws FormulaTooLarge if so many terms are too many or the deadline has passed.
void check_limits(std::size_t terms);
// For an operation that takes so many multiplications of terms.
void count_formula_work(double operations);

}  // namespace poinsot::symbolic
