// The value of a formula by long doubles with a bound on their rounding.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/formula/formula_fraction.h"
#include "poinsot/engine/math/algebra/rounded.h"

namespace poinsot::symbolic {

// A formula made ready to be evaluated at many values of its letters: each generator once, each term with the factors
// that it has.
class ReadyFormula {
 public:
  explicit ReadyFormula(const Formula& x);

  // Without bound where this road does not tell the value, or whether there is one.
  Rounded at(const LetterValues& values) const;

 private:
  struct Factor {
    std::uint32_t node = 0, power = 0;
  };
  struct Term {
    long double coefficient = 0;
    std::uint32_t factors = 0;  // of so many
  };
  struct Sum {
    std::vector<Term> terms;
    std::vector<Factor> factors;  // of all terms, one after the other
    std::size_t variables = 0;
  };
  struct Quotient {
    Sum above, below;
  };
  struct Node {
    const Generator* generator = nullptr;
    Quotient argument{}, second{};
  };
  Quotient quotient(const Formula& x);
  Sum sum(const Polynomial& polynomial, const std::vector<std::uint32_t>& nodes);
  std::uint32_t node(const GeneratorPointer& generator);
  // The number of a node, and the part of it by which it and its product with another are off.
  struct Value {
    Rounded number;
    long double part = 0;
  };
  static Rounded product(const Term& term, const Factor* factors, const std::vector<Value>& nodes);
  static Rounded value(const Sum& sum, const std::vector<Value>& nodes);
  static Rounded value(const Quotient& quotient, const std::vector<Value>& nodes);
  static Rounded value(const Node& node, const std::vector<Value>& nodes, const LetterValues& values);

  Formula of_;  // keeps the generators
  std::map<const Generator*, std::uint32_t> known_;
  std::vector<Node> nodes_;  // after those that they need
  bool fits_ = true;         // whether all coefficients are small integers; known once the rest is made
  Quotient whole_;
};

// Formulas that were made ready last are kept for each thread.
Rounded value_by_rounding(const Formula& x, const LetterValues& values);

// The double nearest to the value. Nothing where rounding leaves open which one it is: balls of more digits tell that.
std::optional<double> nearest_by_rounding(const Formula& x, const LetterValues& values);

}  // namespace poinsot::symbolic
