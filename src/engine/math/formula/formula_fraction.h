// What a Formula holds: a quotient of polynomials in generators, the letters and functions that are no rational
// functions of each other.
//
// Kept true of every fraction: its generators are in order and each occurs, or is needed by a root that occurs;
// numerator and denominator have no common factor, the leading coefficient of the denominator is positive; the
// denominator holds neither roots nor signs, the numerator at most their first powers. A fraction is never zero.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/math/formula/formula_polynomial.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::symbolic {

enum class Kind {
  letter,
  pi,
  tangent,           // tan(multiple * argument / 2), the argument a product of letters
  constant_tangent,  // tan(multiple * argument / 2), the argument pi or 1 rad
  inverse,           // asin, acos, atan or ln of an argument, atan2 of two
  exponential,       // e^(multiple * argument), the argument a product of letters or a number
  sign,              // 1 or -1, as the argument is positive or negative
  root               // the square root, not negative, of the argument, a polynomial
};

// A positive or negative fraction of small integers.
struct Ratio {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  friend bool operator==(const Ratio&, const Ratio&) = default;
};

struct Generator;
using GeneratorPointer = std::shared_ptr<const Generator>;
using Generators = std::vector<GeneratorPointer>;

struct Generator {
  Kind kind{};
  std::string name;  // of the letter or the inverse function
  Sign sign = Sign::real;
  Ratio multiple;
  Formula argument;
  Formula second;  // x of atan2(y, x)

  std::string key;   // tells apart and orders generators of one kind
  Generators needs;  // of a root or sign: what its argument is made of
  bool positive = false;
  bool constant = false;  // without letters
  bool doubtful = false;  // may depend on others in ways that polynomials do not show
};

GeneratorPointer letter_generator(const std::string& name, Sign sign);
GeneratorPointer pi_generator();
GeneratorPointer tangent_generator(Kind kind, const Formula& argument, Ratio multiple);
GeneratorPointer inverse_generator(const std::string& function, const Formula& argument, const Formula& second);
GeneratorPointer exponential_generator(const Formula& argument, Ratio multiple);
GeneratorPointer sign_generator(const Formula& argument);
// dependent: of a product of which other roots may hold parts, as sqrt(x y), sqrt(x z) and sqrt(y z) do.
GeneratorPointer root_generator(const Formula& radicand, bool dependent = false);
bool before(const GeneratorPointer& a, const GeneratorPointer& b);
// Throws std::invalid_argument if a letter is once positive and once real.
bool same(const GeneratorPointer& a, const GeneratorPointer& b);

using GeneratorList = std::shared_ptr<const Generators>;

// What was assumed where a root was simplified: a positive letter, or something not negative. It is brought to words
// only when asked for: many are made and few are read.
struct Assumption {
  std::string key;
  Formula not_negative;  // zero: the key is a positive letter
  friend bool operator<(const Assumption& a, const Assumption& b) { return a.key < b.key; }
};
using Assumptions = std::shared_ptr<const std::vector<Assumption>>;  // in order; null: none

struct Fraction {
  GeneratorList generators;
  Polynomial numerator;
  Polynomial denominator;
  Assumptions assumptions;
};

Assumptions united(const Assumptions& a, const Assumptions& b);
Formula assuming(const Formula& x, const Assumption& assumption);

// numerator / denominator in the form that is kept, from polynomials in which roots may occur with any power.
Formula quotient(const Generators& generators, Polynomial numerator, Polynomial denominator,
                 const Assumptions& assumptions);
// The same where the denominator is 1.
Formula polynomial_formula(const Generators& generators, Polynomial numerator, const Assumptions& assumptions = {});
Formula generator_formula(const GeneratorPointer& generator);
Formula integer_formula(const Integer& number);
Formula ratio_formula(const Ratio& ratio);

// The numerator and the denominator as formulas.
Formula numerator_of(const Formula& x);
Formula denominator_of(const Formula& x);
// The polynomial with each generator's square replaced where it is known.
Polynomial reduced(const Generators& generators, Polynomial polynomial);
// True of roots and signs.
bool is_algebraic(const Generator& generator);

// What stands for a generator: numerator / denominator, where 1 / 0 is a tangent without value.
struct Replacement {
  Formula numerator;
  Formula denominator;
};
// x with other values for those of its generators that have a replacement (null: stays).
using Replacements = std::function<std::unique_ptr<Replacement>(const GeneratorPointer&)>;
Formula replaced(const Formula& x, const Replacements& replacements);
// True of what is a function of any argument: roots, signs, inverse functions and powers of e.
bool has_arguments(const Generator& generator);
// Such a one of other arguments; the sign of zero is zero.
Formula with_arguments(const Generator& g, const Formula& argument, const Formula& second);

// 1, -1 or 0 (not seen) as the polynomial is positive, negative or of a sign that changes or is not found.
int sign_of(const Generators& generators, const Polynomial& polynomial);
int sign_of(const Formula& x);

// x in the largest part of each angle of which it is a function: sines and cosines of a if it is made of tan(a/4), but
// only as sin(a) and cos(a) are.
Formula with_coarsest_angles(const Formula& x);
// x with the tangent of an angle expanded to that of half the angle.
Formula with_half_angle(const Formula& x, const GeneratorPointer& tangent);

// tan(n x) as a quotient of polynomials in tan(x), n >= 1: coefficients of its powers.
struct MultipleTangent {
  std::vector<Integer> numerator;
  std::vector<Integer> denominator;
};
MultipleTangent multiple_tangent(std::int64_t n);

// The number of a formula without generators.
struct Rational {
  Integer numerator;
  Integer denominator;
};
Rational rational_of(const Formula& x);

// Equal to zero as far as 1000 bits can tell, at a point of no special place.
bool is_zero_by_digits(const Generators& generators, const Polynomial& polynomial);

// x as a sum of rational multiples of products of letters. Throws FormulaTooLarge where these have too many digits.
struct MultipleOfUnit {
  Formula unit;
  Ratio multiple;
};
std::vector<MultipleOfUnit> multiples_in(const Formula& x);
// A function of x, with what was assumed of x.
Formula assuming_alike(Formula function, const Formula& x);

// A text that differs for different formulas, and is not for reading.
std::string key_of(const Formula& x);

}  // namespace poinsot::symbolic
