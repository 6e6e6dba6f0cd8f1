// Exact symbolic scalars: formulas in letters, with a zero test that is certain.
//
// A Formula is a rational function, with rational numbers, of letters, pi, sines and cosines, square roots and inverse
// trigonometric functions. It is kept in a canonical form, so that two formulas are equal exactly if their difference
// is the zero formula. This is certain for rational functions of letters, sines and cosines of rational multiples of
// letters and products of letters, and square roots of such. Sines of numbers other than multiples of pi/12, nested
// roots, inverse functions and roots of factors of unknown sign are compared by some 300 digits at a point.
//
// Method: an angle a enters by the letter t = tan(a/2), so that sin a = 2t/(1 + t^2), cos a = (1 - t^2)/(1 + t^2), and
// a formula without roots is a quotient of two polynomials without common factor. Roots are taken of each irreducible
// factor by itself; such roots are independent. Denominators contain no roots.
//
// Values are immutable and shared: copies are cheap, and several threads may read the same formula.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/engine/math/algebra/scalar.h"
#include "poinsot/engine/math/algebra/sine_cosine.h"
#include "poinsot/engine/work/work.h"

namespace poinsot {

namespace symbolic {
struct Fraction;
}

// What is known of a letter. The square root of m^2 is m for a positive m, and sqrt(m^2) for a real one.
enum class Sign { positive, real };

// Thrown when a formula would have more terms than FormulaLimits allows, or when the work allowed is done.
class FormulaTooLarge : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Limits for all formulas that this thread makes. The work is looked at between operations.
struct FormulaLimits {
  std::size_t terms = 20000;   // of a numerator or denominator
  Work work = unlimited_work;  // of all kinds, while the limits hold
};

// As long as this object exists, other limits apply to this thread.
class FormulaLimitScope {
 public:
  explicit FormulaLimitScope(const FormulaLimits& limits);
  ~FormulaLimitScope();
  FormulaLimitScope(const FormulaLimitScope&) = delete;
  FormulaLimitScope& operator=(const FormulaLimitScope&) = delete;

 private:
  std::size_t outer_terms_;
  WorkLimit outer_work_;
};

class Formula {
 public:
  Formula() = default;  // zero
  template <std::integral Integer>
  Formula(Integer number) : Formula(of_integer(static_cast<std::int64_t>(number))) {}
  // The fraction with a denominator up to 10000 of which this is the nearest double (1.0/12 is 1/12), or else the
  // exact value of the double. Throws std::domain_error if it is not finite.
  explicit Formula(double number);

  // The exact value of "7", "-3/8", "0.15" or "1.5e-3". Throws std::invalid_argument for any other text.
  static Formula number(std::string_view digits);
  // A letter has one sign: a formula with the same name in both signs throws std::invalid_argument.
  static Formula letter(const std::string& name, Sign sign);
  static Formula pi();

  bool is_zero() const;
  bool is_number() const;                    // no letters
  bool is_rational() const;                  // a quotient of integers
  std::size_t terms() const;                 // of the numerator and the denominator together
  std::vector<std::string> letters() const;  // in alphabetical order
  // What was assumed when roots were simplified, such as "m > 0" or "g - r*w^2 >= 0", in alphabetical order.
  std::vector<std::string> assumptions() const;
  // Those among them that something under a root is not negative.
  std::vector<std::string> root_assumptions() const;

  Formula& operator+=(const Formula& b);
  Formula& operator-=(const Formula& b);
  Formula& operator*=(const Formula& b);
  // This and the divisions below throw std::domain_error if b is zero.
  Formula& operator/=(const Formula& b);

  friend Formula operator+(const Formula& a) { return a; }
  friend Formula operator-(const Formula& a);
  friend Formula operator+(const Formula& a, const Formula& b);
  friend Formula operator-(const Formula& a, const Formula& b);
  friend Formula operator*(const Formula& a, const Formula& b);
  friend Formula operator/(const Formula& a, const Formula& b);
  friend bool operator==(const Formula& a, const Formula& b);

  // For the sources of this room only.
  using Shared = std::shared_ptr<const symbolic::Fraction>;
  explicit Formula(Shared fraction) : fraction_(std::move(fraction)) {}
  const Shared& fraction() const { return fraction_; }

 private:
  static Formula of_integer(std::int64_t number);

  Shared fraction_;  // null: zero
};

// x^power; a negative power of zero throws std::domain_error.
Formula pow(const Formula& x, int power);
// The root that is not negative. If it is not seen that x is not negative, this is assumed, and assumptions() tells
// it. A negative number throws std::domain_error.
Formula sqrt(const Formula& x);
Formula abs(const Formula& x);
// Sine and cosine of x. Those of sums are expanded, so that sin(a + b) is a polynomial in sines and cosines of a and
// b.
SineCosine<Formula> sine_cosine(const Formula& x);
SineVersine<Formula> sine_versine(const Formula& x);
Formula sin(const Formula& x);
Formula cos(const Formula& x);
Formula tan(const Formula& x);
Formula asin(const Formula& x);
Formula acos(const Formula& x);
Formula atan(const Formula& x);
Formula atan2(const Formula& y, const Formula& x);

// The numerator: a polynomial in letters, roots and tangents of half angles that is zero where x is.
Formula numerator(const Formula& x);
// The derivative by a letter.
Formula derivative(const Formula& x, const std::string& letter);
// The formula with other formulas in place of letters, all at once. Throws std::domain_error if a denominator becomes
// zero.
Formula substituted(const Formula& x, const std::map<std::string, Formula>& values);

using LetterValues = std::map<std::string, double>;
// The number at given values of the letters, correct to the last places even if terms cancel. Throws
// std::invalid_argument if a letter has no value; NaN where the formula has none.
double value_at(const Formula& x, const LetterValues& values);
long double long_value_at(const Formula& x, const LetterValues& values);
// The value as decimal digits, the last of which is correct within one unit.
std::string digits_at(const Formula& x, const LetterValues& values, int digits);

// The number at which decisions look (poinsot/engine/math/algebra/plain.h). For a formula with letters it is the
// value at a point that depends only on the letters' names and is not special: what is not zero everywhere is not
// zero there. It is zero exactly if is_zero().
double plain(const Formula& x);

// As long as this object exists, plain() in this thread takes these values of the letters, if the number is not zero
// with them. Letters without a value have the one of their name.
class PlainPointScope {
 public:
  explicit PlainPointScope(LetterValues values);
  ~PlainPointScope();
  PlainPointScope(const PlainPointScope&) = delete;
  PlainPointScope& operator=(const PlainPointScope&) = delete;

 private:
  LetterValues outer_;
};

inline bool is_constant(const Formula& x) { return x.is_number(); }
inline bool vanishes(const Formula& x) { return x.is_zero(); }
inline bool isfinite(const Formula&) { return true; }
template <class Predicate>
bool every_value(const Formula& x, Predicate predicate) {
  return predicate(plain(x));
}
// 1 or -1: the sign at that point; 1 for zero.
inline Formula positive_sign(const Formula& x) { return Formula(plain(x) < 0 ? -1 : 1); }

// The functions of poinsot/engine/math/algebra/angle_functions.h.
Formula sinc_of_square(const Formula& x);
Formula cosine_of_square(const Formula& x);
Formula cosine_rest_of_square(const Formula& x);
Formula sine_rest_of_square(const Formula& x);

}  // namespace poinsot
