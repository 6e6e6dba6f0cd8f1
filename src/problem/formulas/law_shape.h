// How a number may depend on letters: (a + b f(angle)) times a product of powers of letters, and of sines and cosines
// of angles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// A function of a letter that has a power; the others are of angles.
enum class Factor { letter, half_sine, half_cosine, cosine, sine };
// The function of an angle in the sum.
enum class Term { none, angle, sine, cosine, cosine_squared };

double number_of(Factor factor, double letter);
double number_of(Term term, double angle);
Formula formula_of(Factor factor, const Formula& letter);
Formula formula_of(Term term, const Formula& angle);

// base^(halves/2)
Formula power_of(const Formula& base, int halves);

struct LawShape {
  struct Part {
    std::string letter;
    Factor factor = Factor::letter;
    int halves = 0;  // the exponent
  };
  std::vector<Part> product;
  Term term = Term::none;
  std::string angle;  // of the term

  double product_at(const LetterValues& letters) const;
};

// A number at values of an angle.
struct AngleSamples {
  std::vector<double> angles, numbers;
};

// The powers of functions of the angle that the numbers follow, to a relative tolerance; none if they do not.
std::optional<std::vector<LawShape::Part>> product_of(const std::string& letter, const AngleSamples& samples,
                                                      double tolerance);
// The f of a + b f(angle).
std::optional<Term> term_of(const AngleSamples& samples, double tolerance);

// `digits` digits of a number, counted from the first of the largest.
Formula rounded(double number, double largest, int digits);

}  // namespace poinsot::problem
