// Exact symbolic scalars: formulas in letters, with a zero test that is certain.
//
// An Expression is a rational function, with rational numbers, of letters, pi, sines and cosines, square roots and
// inverse trigonometric functions. It is kept in one form whatever the way it was reached, so that two expressions are
// equal exactly if their difference is the zero expression. Certain is that for rational functions of letters, sines
// and cosines of rational multiples of letters and products of letters, and square roots of such; sines of numbers
// other than multiples of pi/12, nested roots, inverse functions and roots of factors of unknown sign are compared by
// some 300 digits at a point.
//
// How: an angle a enters through the letter t = tan(a/2), so that sin a = 2t/(1 + t^2), cos a = (1 - t^2)/(1 + t^2) and
// all that has no roots is a quotient of two polynomials without common factor. A root is taken of each irreducible
// factor by itself; such roots are independent. Denominators hold no roots.
//
// Values are immutable and shared: copies are cheap, and different threads may read the same expression.
#pragma once

#include <chrono>
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

namespace poinsot {

namespace symbolic {
struct Fraction;
}

// What is known of a letter. The square root of m^2 is m for a positive m, and sqrt(m^2) for a real one.
enum class Sign { positive, real };

// Thrown when an expression would have more terms than ExpressionLimits allows, or when its deadline has passed.
class FormulaTooLarge : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Bounds on every expression that this thread makes. The deadline is looked at between operations, and an operation on
// `terms` terms takes at most some seconds.
struct FormulaLimits {
  std::size_t terms = 20000;  // of a numerator or denominator
  std::optional<std::chrono::steady_clock::time_point> deadline{};
};

// While it lives, other limits hold for this thread.
class FormulaLimitScope {
 public:
  explicit FormulaLimitScope(const FormulaLimits& limits);
  ~FormulaLimitScope();
  FormulaLimitScope(const FormulaLimitScope&) = delete;
  FormulaLimitScope& operator=(const FormulaLimitScope&) = delete;

 private:
  FormulaLimits outer_;
};

class Formula {
 public:
  Formula() = default;  // zero
  template <std::integral Integer>
  Formula(Integer number) : Formula(of_integer(static_cast<std::int64_t>(number))) {}
  // The fraction with a denominator up to 10000 whose nearest double this is (1.0/12 is 1/12), else the double as it
  // stands, a binary fraction. Throws std::domain_error if it is not finite.
  explicit Formula(double number);

  // "7", "-3/8", "0.15", "1.5e-3", exactly. Throws std::invalid_argument for anything else.
  static Formula number(std::string_view digits);
  // One letter has one sign: the same name with both signs in one expression throws std::invalid_argument.
  static Formula letter(const std::string& name, Sign sign);
  static Formula pi();

  bool is_zero() const;
  bool is_number() const;                    // no letters
  bool is_rational() const;                  // a quotient of integers
  std::size_t terms() const;                 // of the numerator and the denominator together
  std::vector<std::string> letters() const;  // in alphabetical order
  // What was assumed where roots were simplified, such as "m > 0" or "g - r*w^2 >= 0", in alphabetical order.
  std::vector<std::string> assumptions() const;

  Formula& operator+=(const Formula& b);
  Formula& operator-=(const Formula& b);
  Formula& operator*=(const Formula& b);
  // Throws std::domain_error if b is zero, also the divisions below.
  Formula& operator/=(const Formula& b);

  friend Formula operator+(const Formula& a) { return a; }
  friend Formula operator-(const Formula& a);
  friend Formula operator+(const Formula& a, const Formula& b);
  friend Formula operator-(const Formula& a, const Formula& b);
  friend Formula operator*(const Formula& a, const Formula& b);
  friend Formula operator/(const Formula& a, const Formula& b);
  friend bool operator==(const Formula& a, const Formula& b);

  // For the sources of the room.
  using Shared = std::shared_ptr<const symbolic::Fraction>;
  explicit Formula(Shared fraction) : fraction_(std::move(fraction)) {}
  const Shared& fraction() const { return fraction_; }

 private:
  static Formula of_integer(std::int64_t number);

  Shared fraction_;  // null: zero
};

// x^power; a negative power of zero throws std::domain_error.
Formula pow(const Formula& x, int power);
// The root that is not negative. That x is not negative is assumed, and told by assumptions(), where it is not seen; a
// negative number throws std::domain_error.
Formula sqrt(const Formula& x);
Formula abs(const Formula& x);
// x of sin(x): sums are expanded, sin(a + b) and sin(a - b) being polynomials in sines and cosines of a and b.
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
// With expressions in place of letters, all at once. Throws std::domain_error where a denominator becomes zero.
Formula substituted(const Formula& x, const std::map<std::string, Formula>& values);

using LetterValues = std::map<std::string, double>;
// The number at given values of the letters, right to the last places even where terms cancel. Throws
// std::invalid_argument if a letter has no value; not a number where the expression has none.
double value_at(const Formula& x, const LetterValues& values);
long double long_value_at(const Formula& x, const LetterValues& values);
// As decimal digits, the last of them within one unit.
std::string digits_at(const Formula& x, const LetterValues& values, int digits);

// What decisions look at (poinsot/math/plain.h): the value of a number; of a formula the value at a point that depends
// on the names of the letters alone and lies at no special place, where what is not zero everywhere is not zero. Zero
// exactly if is_zero().
double plain(const Formula& x);

// While it lives, plain() looks at these values of the letters in this thread, wherever it finds a number that is not
// zero there; letters without a value have that of their name.
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
// 1 or -1: the sign at that point, 1 for zero.
inline Formula positive_sign(const Formula& x) { return Formula(plain(x) < 0 ? -1 : 1); }

// The functions of poinsot/math/angle_functions.h.
Formula sinc_of_square(const Formula& x);
Formula cosine_of_square(const Formula& x);
Formula cosine_rest_of_square(const Formula& x);
Formula sine_rest_of_square(const Formula& x);

}  // namespace poinsot
