// TeX for explanations: numbers with units, symbols, formulas, vectors.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "problem/explanation/explanation.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

// Text of the problem file in the typeface that Markdown uses for code.
inline std::string code(const std::string& text) { return "`" + text + "`"; }
inline std::string code(const Expression& expression) { return code(to_string(expression)); }
// A sentence that has names between quotes, with these in the typeface of names; an apostrophe within a word stays.
std::string with_emphasis(std::string sentence);

// A number in SI units, with its formula in the data of the statement if it has one.
struct Shown {
  double number = 0;
  std::optional<Formula> formula;
};
struct ShownVector {
  Vector3<double> number{};
  std::optional<Vector3<Formula>> formula;

  Shown operator[](std::size_t k) const { return {number[k], formula ? std::optional((*formula)[k]) : std::nullopt}; }
};

// A term of a linear equation: coefficient times symbol, or only a coefficient. `value` is that of the symbol, in SI
// units.
struct ShownTerm {
  Shown coefficient;
  std::string symbol{};  // TeX
  double value = 1;
  Dimension dimension{};  // that of the symbol
};

using NaturalCoefficient = std::function<double(const Dimension&)>;

class ExplanationTex {
 public:
  // open: the letters for which random values were drawn. A number is then shown only if its formula has none of
  // them.
  ExplanationTex(const Situation& situation, std::vector<std::string> open);

  // Sets the values of letters in the units shown. A formula that does not give the number with these values contains
  // a number that has a unit, in SI, and is not shown.
  void set_letters(LetterValues letters) { letters_ = std::move(letters); }
  // Of the letters without value so many are masses that may be any: numbers without them are known all the same.
  void set_any_masses(std::size_t count) { any_masses_ = count; }
  bool numbers_open() const { return open_.size() > any_masses_; }
  // Data that are to be found: until then their numbers, and those of formulas in them, are shown nowhere beside these.
  void hide_until_found(std::vector<std::string> names) { sought_ = std::move(names); }
  const LetterValues& letters() const { return letters_; }
  bool letters_open() const { return !open_.empty(); }
  // Whether the number may be shown.
  bool is_known(const Shown& value) const;
  // Whether it hangs on data that are still to be found.
  bool is_sought(const Shown& value) const;
  bool is_sought(const ShownVector& value) const {
    return is_sought(value[0]) || is_sought(value[1]) || is_sought(value[2]);
  }
  // Whether number or formula may be shown.
  bool can_show(const Shown& value) const { return is_known(value) || value.formula.has_value(); }
  bool can_show(const ShownVector& value) const;

  // The unit in which a dimension is shown. All units are of one coherent system, so that equations in numbers need
  // no factors.
  const Unit& unit(const Dimension& dimension) const;
  std::string unit_alone(const Dimension& dimension, bool as_energy = false) const;
  // The same with the space before it.
  std::string unit_tex(const Dimension& dimension, bool as_energy = false) const {
    const std::string alone = unit_alone(dimension, as_energy);
    return alone.empty() ? "" : "\\ " + alone;
  }
  // The number in that unit with six digits, without the unit.
  std::string number(double value, const Dimension& dimension) const;
  // The number with its unit; zero has none.
  std::string with_unit(double value, const Dimension& dimension, bool as_energy = false) const;
  // The number that is read back from the digits shown, in SI units.
  double rounded(double value, const Dimension& dimension) const;

  // The equation "symbol = formula = number unit" with what there is of these; its sides are in SI units. as_energy:
  // whether in J and not in N*m.
  ExplainedEquation equation(const std::string& symbol, const Shown& value, const Dimension& dimension,
                             bool as_energy = false) const;
  ExplainedEquation equation(const std::string& symbol, const ShownVector& value, const Dimension& dimension) const;
  // The same of a value that a motion keeps, for which the formula is what matters and may fill a line.
  ExplainedEquation kept(const std::string& symbol, const Shown& value, const Dimension& dimension) const;
  // The number with its unit, or else the formula; "" where neither may be shown.
  std::string value(const Shown& value, const Dimension& dimension) const;
  // The same between dollar signs within a line.
  std::string inline_value(const Shown& value, const Dimension& dimension) const;
  // Both the formula and the number.
  std::string inline_both(const Shown& value, const Dimension& dimension) const;
  std::string inline_both(const ShownVector& value, const Dimension& dimension) const;
  std::string inline_vector(const ShownVector& value, const Dimension& dimension) const;
  std::string inline_equation(const std::string& symbol, const Shown& value, const Dimension& dimension) const;
  std::string inline_equation(const std::string& symbol, const ShownVector& value, const Dimension& dimension) const;

  // The equation name: left = right, in symbols if all coefficients have short formulas, and then in numbers. There
  // is none if both sides vanish or nothing can be shown. Numbers far below `natural` are rounding, and coefficients of
  // symbols far below what natural_coefficient gives for their dimension, in SI units.
  std::vector<ExplainedEquation> balance(const std::string& name, const std::vector<ShownTerm>& left,
                                         const std::vector<ShownTerm>& right, const Dimension& dimension,
                                         double natural, const NaturalCoefficient& natural_coefficient) const;

  // The formula alone; nothing if it is too long to read.
  static std::optional<std::string> formula(const Formula& formula);
  // Adds a term to a sum in TeX: a factor and the symbol that it multiplies.
  static void add_term(std::string& sum, std::string factor, const std::string& symbol);
  // A name in upright letters, as for an index.
  static std::string upright(const std::string& name);
  // A name of the statement as a symbol with an index: omega1 is \omega_{1}.
  static std::string symbol(const std::string& name, const std::string& index = "");
  // A name as that of a vector: F1 is \mathbf{F}_{1}.
  static std::string vector_symbol(const std::string& name);
  // A symbol as plain text: A_{x} is A_x.
  static std::string plain(const std::string& tex);
  // The unit vector along an axis, as \mathbf{i}.
  std::string unit_vector(std::size_t axis) const;
  const std::string& axis(std::size_t k) const { return axes_[k]; }

 private:
  // In characters of plain text: of a formula without a number, and of an equation in symbols above that in numbers.
  static constexpr std::size_t longest_alone = 600, longest_line = 150;

  bool has_open_letters(const Formula& formula) const;
  // The formula as TeX, if it has letters and is short enough to read.
  std::optional<std::string> formula_tex(const Shown& value, const Dimension& dimension, std::size_t longest) const;
  std::size_t longest_formula() const;
  ExplainedEquation equation(const std::string& symbol, const Shown& value, const Dimension& dimension, bool as_energy,
                             std::size_t longest) const;
  bool fits_units(const Shown& value, const Dimension& dimension) const;
  std::string side_in_numbers(const std::vector<ShownTerm>& terms, const Dimension& dimension, double natural,
                              const NaturalCoefficient& natural_coefficient, double& sum, double& size) const;
  std::optional<std::string> side_in_symbols(const std::vector<ShownTerm>& terms, const Dimension& dimension) const;
  std::vector<ExplainedSymbol> symbols_in(const std::vector<ShownTerm>& left,
                                          const std::vector<ShownTerm>& right) const;
  std::string vector_tex(const Vector3<double>& value, const Dimension& dimension) const;
  std::optional<std::string> vector_formula(const ShownVector& value, const Dimension& dimension) const;

  std::vector<std::string> open_, sought_;
  std::size_t any_masses_ = 0;
  std::array<std::string, 3> axes_;
  LetterValues letters_;
  UnitHabits habits_;
  mutable std::vector<std::pair<Dimension, Unit>> units_;
};

// Whether a number is nothing but rounding beside another.
bool is_rounding(double value, double size);

// Whether a formula has this value, but for a part `tolerance` of it and for the rounding of its terms, which may
// cancel.
bool has_value(const Formula& formula, const LetterValues& letters, double value, double tolerance);

// What TeX that was put together shows: several factors or terms, which a power or a fraction needs in brackets; the
// rate of a letter; that something equals something.
bool has_parts(const std::string& tex);
bool shows_rate(const std::string& tex);
bool is_equality(const std::string& tex);
// The symbol of the value that something begins with: v_{x,0} of v_{x}, \dot{x}_{0} of \dot{x}.
std::string at_beginning(const std::string& symbol);

}  // namespace poinsot::problem
