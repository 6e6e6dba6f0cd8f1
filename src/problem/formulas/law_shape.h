// The forms in which a number may depend on letters: (a + b f(angle)) times a product of powers of letters and of
// sines and cosines of angles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// A factor whose power stands in the product: a letter, or a function of an angle.
enum class Factor { letter, half_sine, half_cosine, cosine, sine };
// The function f of the angle in the sum.
enum class Term { none, angle, sine, cosine, cosine_squared };

double number_of(Factor factor, double letter);
double number_of(Term term, double angle);
Formula formula_of(Factor factor, const Formula& letter);
Formula formula_of(Term term, const Formula& angle);

// The power base^(halves/2).
Formula power_of(const Formula& base, int halves);

struct LawShape {
  struct Part {
    std::string letter;
    Factor factor = Factor::letter;
    int halves = 0;  // the exponent, times two
  };
  std::vector<Part> product;
  Term term = Term::none;
  std::string angle;  // the angle of the term

  double product_at(const LetterValues& letters) const;
};

// The values of a number at several angles.
struct AngleSamples {
  std::vector<double> angles, numbers;
};

// The powers of functions of the angle whose product the numbers follow, to a relative tolerance; nothing if they
// follow none.
std::optional<std::vector<LawShape::Part>> product_of(const std::string& letter, const AngleSamples& samples,
                                                      double tolerance);
// The function f, if the numbers follow a + b f(angle).
std::optional<Term> term_of(const AngleSamples& samples, double tolerance);

// A fraction of small denominator, or one times a power of standard gravity, that is within the relative tolerance of a
// number; nothing if there is none.
std::optional<Formula> simple_coefficient(double number, double tolerance);

// The same, or the root of such a fraction, or one of these times pi or over it: sqrt(2/3), 2*pi. Of what has few
// digits nothing but fractions is taken, which could be so by chance.
std::optional<Formula> known_coefficient(double number, double tolerance);

// The number rounded to so many digits, which are counted from the first digit of `largest`.
Formula rounded(double number, double largest, int digits);

}  // namespace poinsot::problem
