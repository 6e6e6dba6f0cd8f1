// TeX of what an explanation shows: numbers with units, symbols, formulas, vectors.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "problem/explanation/explanation.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// Text as it stands in a problem file, in the typeface of Markdown's code.
inline std::string code(const std::string& text) { return "`" + text + "`"; }
inline std::string code(const Expression& expression) { return code(to_string(expression)); }

// A number in SI, and where it is had its formula in the data of the statement.
struct Shown {
  double number = 0;
  std::optional<Formula> formula;
};
struct ShownVector {
  Vector3<double> number{};
  std::optional<Vector3<Formula>> formula;

  Shown operator[](std::size_t k) const { return {number[k], formula ? std::optional((*formula)[k]) : std::nullopt}; }
};

// One term of a linear side: coefficient times symbol, or the coefficient alone. The symbol's value in SI.
struct ShownTerm {
  Shown coefficient;
  std::string symbol{};  // TeX
  double value = 1;
  Dimension dimension{};  // of the symbol
};

class ExplanationTex {
 public:
  // letters_open: numbers were drawn at random for letters, so that a number is shown only where its formula has no
  // letter without value. open: these letters.
  ExplanationTex(const Situation& situation, std::vector<std::string> open);

  // Values of the letters in the units shown. A formula that does not have the number's value with them holds a number
  // with a unit, in SI, and is not shown.
  void set_letters(LetterValues letters) { letters_ = std::move(letters); }
  bool letters_open() const { return !open_.empty(); }
  // Whether a number may be shown as such.
  bool is_known(const Shown& value) const;
  // Whether anything can be shown of it.
  bool can_show(const Shown& value) const { return is_known(value) || value.formula.has_value(); }
  bool can_show(const ShownVector& value) const;

  // The unit in which this dimension is shown: one of a coherent system, so that equations in numbers need no factors.
  const Unit& unit(const Dimension& dimension) const;
  std::string unit_tex(const Dimension& dimension, bool as_energy = false) const;
  // In that unit, six digits, without the unit.
  std::string number(double value, const Dimension& dimension) const;
  // With the unit, but for zero.
  std::string with_unit(double value, const Dimension& dimension, bool as_energy = false) const;
  // As it is read back from these digits, SI.
  double rounded(double value, const Dimension& dimension) const;

  // "formula = number unit", whichever there is; the sides are the equation's.
  // as_energy: in J and not in N*m.
  ExplainedEquation equation(const std::string& symbol, const Shown& value, const Dimension& dimension,
                             bool as_energy = false) const;
  ExplainedEquation equation(const std::string& symbol, const ShownVector& value, const Dimension& dimension) const;
  // In one line of text, between dollar signs: the number with unit, else the formula.
  std::string inline_value(const Shown& value, const Dimension& dimension) const;
  // Formula and number.
  std::string inline_both(const Shown& value, const Dimension& dimension) const;
  std::string inline_vector(const ShownVector& value, const Dimension& dimension) const;
  std::string inline_equation(const std::string& symbol, const Shown& value, const Dimension& dimension) const;
  std::string inline_equation(const std::string& symbol, const ShownVector& value, const Dimension& dimension) const;

  // name: left = right. In symbols where all coefficients have short formulas, then in numbers. Nothing where both
  // sides vanish or nothing can be shown. natural: what is far below it is rounding, SI.
  std::vector<ExplainedEquation> balance(const std::string& name, const std::vector<ShownTerm>& left,
                                         const std::vector<ShownTerm>& right, const Dimension& dimension,
                                         double natural) const;

  // A formula by itself; nothing where it is too long to be read.
  static std::optional<std::string> formula(const Formula& formula);
  // A name upright, as an index.
  static std::string upright(const std::string& name);
  // A name of the statement as a symbol: omega1 is \omega_{1}; with an index.
  static std::string symbol(const std::string& name, const std::string& index = "");
  // The unit vector of an axis: \mathbf{i}.
  std::string unit_vector(std::size_t axis) const;
  const std::string& axis(std::size_t k) const { return axes_[k]; }

 private:
  bool has_open_letters(const Formula& formula) const;
  // The formula as TeX if it has letters and is short enough to be read.
  std::optional<std::string> formula_tex(const Shown& value, const Dimension& dimension) const;
  bool fits_units(const Shown& value, const Dimension& dimension) const;
  std::string side_in_numbers(const std::vector<ShownTerm>& terms, const Dimension& dimension, double natural,
                              double& sum, double& size) const;
  std::optional<std::string> side_in_symbols(const std::vector<ShownTerm>& terms, const Dimension& dimension) const;
  std::vector<ExplainedSymbol> symbols_in(const std::vector<ShownTerm>& left,
                                          const std::vector<ShownTerm>& right) const;
  std::string vector_tex(const Vector3<double>& value, const Dimension& dimension) const;
  std::optional<std::string> vector_formula(const ShownVector& value, const Dimension& dimension) const;

  std::vector<std::string> open_;
  std::array<std::string, 3> axes_;
  LetterValues letters_;
  UnitHabits habits_;
  mutable std::vector<std::pair<Dimension, Unit>> units_;
};

// "a, b and c".
std::string in_words(const std::vector<std::string>& items);

// Whether a number is no more than rounding beside another.
bool is_rounding(double value, double size);

}  // namespace poinsot::problem
