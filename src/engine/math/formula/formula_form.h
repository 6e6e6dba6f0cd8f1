// A formula as it will be written: a tree of sums, products, quotients, powers and calls.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/math/formula/formula_fraction.h"

namespace poinsot::symbolic {

struct Form {
  enum class Kind {
    number,    // digits, without sign
    name,      // a letter or pi
    negative,  // minus its part
    sum,       // of its parts, of which those to be subtracted are negative
    product,   // of at least two parts
    quotient,  // of its two parts
    power,     // its part to the exponent, 2 or more
    call       // of a function
  };
  Kind kind = Kind::number;
  std::string text;  // digits, the name, or that of the function
  std::vector<Form> parts{};
  int exponent = 1;
};

// Whether brackets are needed where it is a factor or a term to be subtracted.
inline bool is_compound(const Form& form) { return form.kind == Form::Kind::sum || form.kind == Form::Kind::negative; }

// x where the form is the size of x, written as the root of a square, sqrt(x^2); else null.
const Form* sized_part(const Form& form);

Form number_form(const Integer& digits);  // not negative
// The number nearest to the digits of a form, whatever the locale; infinite if it is too large.
double number_of_digits(const std::string& digits);
Form call_form(const std::string& function, Form argument);
Form power_form(Form base, int exponent);
Form negative_form(Form positive);
Form sum_form(std::vector<Form> terms);  // of at least one
// The same, starting with a term to be added if there is one; and a sum with its signs turned.
Form ordered_sum(std::vector<Form> terms);
Form negated_sum(const Form& sum);
// coefficient / divisor * product of powers; negative exponents go below the line, in the order given. A factor beside
// its sign, sqrt(x^2)/x, is its size.
struct FormPower {
  Form base;
  int exponent;
};
Form product_form(const Integer& coefficient, const Integer& divisor, std::vector<FormPower> powers);

// The order of factors in which people write a product: numbers, then letters as in m g L, functions, sums, roots.
bool stands_before(const FormPower& a, const FormPower& b);

// The same, minus that if `negative`, in the order in which people write it; coefficient and divisor of either sign.
Form assembled_product(bool negative, Integer coefficient, Integer divisor, std::vector<FormPower> powers);

// Signs of operation and functions, as they are counted to tell which of two forms is shorter.
int operators(const Form& form);
// Fewer operators, or as many and a shorter text.
bool is_shorter(const Form& a, const Form& b);

// Infix text, as poinsot/engine/math/formula/formula_text.h says.
std::string text_of(const Form& form);
std::string tex_of(const Form& form);

// The shortest of the forms that are tried.
Form form_of(const Formula& x);
// The same of an angle's sine or cosine: multiple * argument.
Form angle_form(const Generator& tangent, std::int64_t times);

// A sum, scaled: value = numerator / denominator * form.
struct ScaledForm {
  Integer numerator;
  Integer denominator;
  Form form;
};
// The polynomial, divided by the (1 + t^2)^half_degree of each tangent t in it, in sines and cosines.
ScaledForm trigonometric_form(const Generators& generators, const Polynomial& polynomial);
// (degree + 1)/2 of tangents, 0 of others.
std::vector<int> half_degrees(const Generators& generators, const Polynomial& polynomial);
bool is_angle(const Generator& generator);

// t^sine (1 + t)^plus (1 - t)^minus (1 + t^2)^one for the tangent t of half an angle.
struct HalfTangents {
  int sine = 0, plus = 0, minus = 0, one = 0;
};
// The same, divided by 2^twos, as powers of functions of the angle: those with the shortest form.
struct AnglePowers {
  std::vector<FormPower> powers;
  int twos = 0;
};
AnglePowers angle_powers(const Generator& tangent, const HalfTangents& half);

// A polynomial as a sum, its variables written as the forms given; not zero.
ScaledForm polynomial_form(const Polynomial& polynomial, const std::vector<Form>& variables);
// The operators of that sum if no factors are pulled out.
int flat_operators(const Polynomial& polynomial, const std::vector<Form>& variables);

// Sines and cosines as further variables of a polynomial: those of angle k are 2k and 2k + 1 after the generators.
struct Angles {
  std::vector<std::size_t> tangents;  // the generators
  std::vector<int> halves;            // for each of them
  std::size_t generators = 0;
  std::size_t sine(std::size_t k) const { return generators + 2 * k; }
  std::size_t cosine(std::size_t k) const { return generators + 2 * k + 1; }
  std::size_t variables() const { return generators + 2 * tangents.size(); }
};

// polynomial / 2^twos, with the forms of its variables.
struct TrigonometricSum {
  Polynomial polynomial;
  std::vector<Form> variables;
  int twos = 0;
};
// p / 2^twos as sums of sines and cosines of sums of multiples of the angles; cosines of double angles as they are, or
// by squares of sines, or by squares of cosines.
std::vector<TrigonometricSum> harmonic_sums(const Generators& generators, const Polynomial& p, const Angles& angles,
                                            int twos, const std::vector<Form>& variables);

}  // namespace poinsot::symbolic
