#include "problem/explanation/explanation_tex.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <regex>
#include <utility>

#include "poinsot/engine/math/formula/formula_text.h"
#include "problem/language/words.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t longest_beside_number = 64;  // in characters of plain text, for a formula beside its number
// Numbers of an instant are good to some 1e-12 of their natural size. With a tenth of this, rounding of long chains
// would be shown as a force of 3e-16 N; what is a billionth of the natural size is real and is shown.
constexpr double rounding = 1e-10;
constexpr int shown_digits = 6;
constexpr double degree = std::numbers::pi / 180;

// A number as TeX: "0.25", "3\\cdot 10^{-7}".
std::string tex_number(double value) {
  std::string digits = value == 0 ? "0" : with_digits(value, shown_digits);
  const std::size_t exponent = digits.find('e');
  if (exponent == std::string::npos) return digits;
  return digits.substr(0, exponent) + "\\cdot 10^{" + std::to_string(std::stoi(digits.substr(exponent + 1))) + "}";
}

// Whether there is a sum outside all brackets.
bool is_sum(const std::string& tex) {
  int depth = 0;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const char c = tex[i];
    if (c == '{' || c == '(') ++depth;
    if (c == '}' || c == ')') --depth;
    if (depth == 0 && i > 0 && (c == '+' || c == '-') && tex[i - 1] == ' ') return true;
  }
  return false;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '_' ? std::string("\\_") : std::string(1, c);
  return result;
}

// TeX of an index: "A" in italics, "wire_A" upright; items separated by commas are set one by one.
std::string index_tex(const std::string& index) {
  std::string tex;
  for (std::size_t begin = 0; begin <= index.size();) {
    const std::size_t end = std::min(index.find(',', begin), index.size());
    const std::string item = index.substr(begin, end - begin);
    tex += (tex.empty() ? "" : ",") + (item.size() > 1 ? "\\mathrm{" + escaped(item) + "}" : item);
    begin = end + 1;
  }
  return tex;
}

// Velocities that nothing in the file names are told in words, "angular velocity of disk at pivot along x": as symbols
// with the axis and the body as their index.
std::string with_symbols_of_velocities(const std::string& tex) {
  static const std::regex velocity("\\\\text\\{(angular )?velocity of ([^{}]*?)( at [^{}]*?)? along ([^{} ]+)\\}");
  std::string result;
  std::sregex_iterator it(tex.begin(), tex.end(), velocity), end;
  std::size_t at = 0;
  for (; it != end; ++it) {
    result += tex.substr(at, static_cast<std::size_t>(it->position()) - at);
    std::string body = (*it)[2];
    std::erase(body, '\\');
    result += ((*it)[1].matched ? "\\omega_{" : "v_{") + index_tex((*it)[4].str() + "," + body) + "}";
    at = static_cast<std::size_t>(it->position() + it->length());
  }
  return result + tex.substr(at);
}

// A formula as TeX. A name such as phidot is written as a rate, with a dot; phidot0 has an index beside.
std::string formula_as_tex(const Formula& formula) {
  static const std::regex rate("\\\\mathit\\{([A-Za-z]+[0-9]*)dot(?:_?([0-9]))?\\}");
  const std::string tex = with_symbols_of_velocities(text(formula, Notation::tex));
  std::string result;
  std::sregex_iterator it(tex.begin(), tex.end(), rate), end;
  std::size_t at = 0;
  for (; it != end; ++it) {
    result += tex.substr(at, static_cast<std::size_t>(it->position()) - at);
    result += "\\dot{" + text(Formula::letter((*it)[1], poinsot::Sign::real), Notation::tex) + "}";
    if ((*it)[2].matched) result += "_{" + (*it)[2].str() + "}";
    at = static_cast<std::size_t>(it->position() + it->length());
  }
  return result + tex.substr(at);
}

// As TeX, if it is short enough to read. A formula with a magnitude in it does not say which of two cases holds, which
// its number does: beside that it is left out.
std::optional<std::string> readable(const Formula& formula, std::size_t longest, bool beside_number) {
  try {
    if (text(formula).size() > longest) return std::nullopt;
    std::string tex = formula_as_tex(formula);
    if (beside_number && tex.find("\\left|") != std::string::npos) return std::nullopt;
    return tex;
  } catch (const FormulaTooLarge&) {
    return std::nullopt;
  }
}

double size_of(const Vector3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

bool has_value(const Formula& formula, const LetterValues& letters, double value, double tolerance) {
  const double found = formula.is_zero() ? 0 : value_at(formula, letters);
  const double apart = std::abs(found - value);
  if (apart <= tolerance * std::max(std::abs(found), std::abs(value))) return true;
  // Where terms cancel, by as much as the formula changes when each letter changes in its last digits: some ten times
  // the part to which the numbers of an instant are good.
  constexpr double last_digits = 1e-11;
  double allowed = 0;
  LetterValues moved = letters;
  for (auto& [name, letter] : moved) {
    const double own = letter;
    letter *= 1 + last_digits;
    allowed += std::abs(value_at(formula, moved) - found);
    letter = own;
  }
  return apart <= allowed;
}

bool is_rounding(double value, double size) { return !(std::abs(value) > rounding * size); }

ExplanationTex::ExplanationTex(const Situation& situation, std::vector<std::string> open)
    : open_(std::move(open)), axes_(situation.axes) {
  if (situation.habits.customary()) habits_.note(parse_unit("ft"));
}

namespace {

bool has_any_of(const Formula& formula, const std::vector<std::string>& names) {
  return !names.empty() && std::ranges::any_of(formula.letters(), [&](const std::string& letter) {
    return std::ranges::find(names, letter) != names.end();
  });
}

}  // namespace

bool ExplanationTex::has_open_letters(const Formula& formula) const { return has_any_of(formula, open_); }

bool ExplanationTex::is_sought(const Shown& value) const {
  return value.formula && has_any_of(*value.formula, sought_);
}

bool ExplanationTex::is_known(const Shown& value) const {
  return open_.empty() || (value.formula && !has_open_letters(*value.formula));
}

bool ExplanationTex::can_show(const ShownVector& value) const {
  return can_show(value[0]) && can_show(value[1]) && can_show(value[2]);
}

const Unit& ExplanationTex::unit(const Dimension& dimension) const {
  for (const auto& [known, unit] : units_)
    if (known == dimension) return unit;
  return units_.emplace_back(dimension, habits_.unit_for(dimension)).second;
}

std::string ExplanationTex::unit_alone(const Dimension& dimension, bool as_energy) const {
  std::string tex;
  const std::string text = as_energy ? habits_.unit_for(dimension, true).text : unit(dimension).text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '*') {
      tex += "\\,";
    } else if (text[i] == '^') {
      tex += "^{";
      for (++i; i < text.size() && text[i] != '*' && text[i] != '/'; ++i) tex += text[i];
      tex += "}";
      --i;
    } else {
      tex += text[i];
    }
  }
  return tex.empty() ? "" : "\\mathrm{" + tex + "}";
}

std::string ExplanationTex::number(double value, const Dimension& dimension) const {
  return tex_number(value / unit(dimension).factor);
}

double ExplanationTex::rounded(double value, const Dimension& dimension) const {
  const double factor = unit(dimension).factor;
  const std::string text = with_digits(value / factor, shown_digits);
  double shown = 0;
  std::from_chars(text.data(), text.data() + text.size(), shown);
  return shown * factor;
}

std::string ExplanationTex::with_unit(double value, const Dimension& dimension, bool as_energy) const {
  if (dimension == dimensions::angle && value != 0) return tex_number(value / degree) + "^{\\circ}";
  const std::string digits = number(value, dimension);
  return digits == "0" ? digits : digits + unit_tex(dimension, as_energy);
}

bool ExplanationTex::fits_units(const Shown& value, const Dimension& dimension) const {
  if (letters_.empty() || value.formula->is_zero()) return true;
  try {
    const double shown = value.number / unit(dimension).factor;
    // A number with a unit that stands in a formula shows in its first digits: units differ by factors of ten and more.
    constexpr double same_units = 1e-7;
    return has_value(*value.formula, letters_, shown, same_units);
  } catch (const std::exception&) {
    return false;
  }
}

std::size_t ExplanationTex::longest_formula() const { return letters_open() ? longest_alone : longest_beside_number; }

std::optional<std::string> ExplanationTex::formula_tex(const Shown& value, const Dimension& dimension,
                                                       std::size_t longest) const {
  const std::optional<Formula>& formula = value.formula;
  if (!formula || formula->letters().empty() || !fits_units(value, dimension)) return std::nullopt;
  return readable(*formula, longest, is_known(value));
}

std::optional<std::string> ExplanationTex::formula(const Formula& formula) {
  return readable(formula, longest_alone, false);
}

ExplainedEquation ExplanationTex::equation(const std::string& symbol, const Shown& value, const Dimension& dimension,
                                           bool as_energy) const {
  return equation(symbol, value, dimension, as_energy, longest_formula());
}
ExplainedEquation ExplanationTex::kept(const std::string& symbol, const Shown& value,
                                       const Dimension& dimension) const {
  return equation(symbol, value, dimension, dimension == dimensions::energy,
                  letters_open() ? longest_alone : longest_line);
}
ExplainedEquation ExplanationTex::equation(const std::string& symbol, const Shown& value, const Dimension& dimension,
                                           bool as_energy, std::size_t longest) const {
  ExplainedEquation equation{"", symbol, {}, std::abs(value.number)};
  if (const auto tex = formula_tex(value, dimension, longest)) {
    equation.tex += " = " + *tex;
    equation.sides.push_back(value.number);
    if (is_sought(value)) return equation;
  }
  if (is_known(value)) {
    equation.tex += " = " + with_unit(value.number, dimension, as_energy);
    equation.sides.push_back(rounded(value.number, dimension));
  }
  return equation;
}

std::string ExplanationTex::vector_tex(const Vector3<double>& value, const Dimension& dimension) const {
  std::string sum;
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_rounding(value[k], size_of(value))) continue;
    add_term(sum, number(value[k], dimension), unit_vector(k));
    ++count;
  }
  if (count == 0) return "\\mathbf{0}";
  return (count > 1 ? "(" + sum + ")" : sum) + unit_tex(dimension);
}

std::optional<std::string> ExplanationTex::vector_formula(const ShownVector& value, const Dimension& dimension) const {
  if (!value.formula) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k)
    if (!fits_units(value[k], dimension)) return std::nullopt;
  std::string sum;
  bool has_letters = false;
  std::size_t length = 0;
  const std::size_t longest = letters_open() ? 3 * longest_alone : longest_line;
  for (std::size_t k = 0; k < 3; ++k) {
    const Formula& component = (*value.formula)[k];
    if (component.is_zero()) continue;
    has_letters = has_letters || !component.letters().empty();
    const auto tex = readable(component, longest - std::min(length, longest), is_known(value[k]));
    if (!tex) return std::nullopt;
    length += text(component).size();
    add_term(sum, *tex, unit_vector(k));
  }
  if (!has_letters) return std::nullopt;
  return sum;
}

ExplainedEquation ExplanationTex::equation(const std::string& symbol, const ShownVector& value,
                                           const Dimension& dimension) const {
  ExplainedEquation equation{"", symbol, {}, size_of(value.number)};
  if (const auto tex = vector_formula(value, dimension)) {
    equation.tex += " = " + *tex;
    if (is_sought(value)) return equation;
  }
  if (is_known(value[0]) && is_known(value[1]) && is_known(value[2]))
    equation.tex += " = " + vector_tex(value.number, dimension);
  return equation;
}

std::string ExplanationTex::value(const Shown& value, const Dimension& dimension) const {
  const auto tex = formula_tex(value, dimension, longest_formula());
  if (is_known(value) && !(tex && is_sought(value))) return with_unit(value.number, dimension);
  return tex.value_or("");
}

std::string ExplanationTex::inline_value(const Shown& value, const Dimension& dimension) const {
  const std::string tex = this->value(value, dimension);
  return tex.empty() ? "" : "$" + tex + "$";
}

std::string ExplanationTex::inline_both(const Shown& value, const Dimension& dimension) const {
  const auto tex = formula_tex(value, dimension, longest_formula());
  const std::string known = is_known(value) && !(tex && is_sought(value)) ? with_unit(value.number, dimension) : "";
  return "$" + tex.value_or("") + (tex && !known.empty() ? " = " : "") + known + "$";
}

std::string ExplanationTex::inline_both(const ShownVector& value, const Dimension& dimension) const {
  const std::string tex = equation("", value, dimension).tex, sign = " = ";
  return tex.empty() ? "" : "$" + tex.substr(sign.size()) + "$";
}

std::string ExplanationTex::inline_vector(const ShownVector& value, const Dimension& dimension) const {
  const auto tex = vector_formula(value, dimension);
  if (is_known(value[0]) && is_known(value[1]) && is_known(value[2]) && !(tex && is_sought(value)))
    return "$" + vector_tex(value.number, dimension) + "$";
  return tex ? "$" + *tex + "$" : "";
}

std::string ExplanationTex::inline_equation(const std::string& symbol, const Shown& value,
                                            const Dimension& dimension) const {
  return "$" + equation(symbol, value, dimension).tex + "$";
}
std::string ExplanationTex::inline_equation(const std::string& symbol, const ShownVector& value,
                                            const Dimension& dimension) const {
  return "$" + equation(symbol, value, dimension).tex + "$";
}

std::string ExplanationTex::side_in_numbers(const std::vector<ShownTerm>& terms, const Dimension& dimension,
                                            double natural, const NaturalCoefficient& natural_coefficient, double& sum,
                                            double& size) const {
  std::string side;
  for (const ShownTerm& term : terms) {
    const Dimension of_coefficient = dimension / term.dimension;
    // A coefficient is left out if it is rounding, and its contribution too: that of a symbol that is zero tells
    // nothing.
    if (is_rounding(term.coefficient.number * (term.symbol.empty() ? 1 : term.value), natural) &&
        (term.symbol.empty() || is_rounding(term.coefficient.number, natural_coefficient(of_coefficient))))
      continue;
    add_term(side, number(term.coefficient.number, of_coefficient), term.symbol);
    const double amount = rounded(term.coefficient.number, of_coefficient) * term.value;
    sum += amount;
    size = std::max(size, std::abs(amount));
  }
  return side.empty() ? "0" : side;
}

std::optional<std::string> ExplanationTex::side_in_symbols(const std::vector<ShownTerm>& terms,
                                                           const Dimension& dimension) const {
  std::string side;
  for (const ShownTerm& term : terms) {
    if (!term.coefficient.formula) return std::nullopt;
    if (term.coefficient.formula->is_zero()) continue;
    if (!fits_units(term.coefficient, dimension / term.dimension)) return std::nullopt;
    const auto tex =
        readable(*term.coefficient.formula, letters_open() ? longest_alone : longest_line, is_known(term.coefficient));
    if (!tex) return std::nullopt;
    // A number that no letter stands for is written as in the file: 0.002 and not 1/500.
    const bool letters = !term.coefficient.formula->letters().empty();
    const Dimension of_coefficient = dimension / term.dimension;
    add_term(side,
             letters || of_coefficient == dimensions::none ? *tex : number(term.coefficient.number, of_coefficient),
             term.symbol);
  }
  return side.empty() ? "0" : side;
}

std::vector<ExplainedSymbol> ExplanationTex::symbols_in(const std::vector<ShownTerm>& left,
                                                        const std::vector<ShownTerm>& right) const {
  std::vector<ExplainedSymbol> symbols;
  for (const auto* side : {&left, &right})
    for (const ShownTerm& term : *side)
      if (!term.symbol.empty()) symbols.push_back({term.symbol, term.value / unit(term.dimension).factor});
  return symbols;
}

void ExplanationTex::add_term(std::string& sum, std::string factor, const std::string& symbol) {
  bool negative = false;
  if (!symbol.empty() && is_sum(factor)) {
    factor = "\\left(" + factor + "\\right)";
  } else if (factor.starts_with('-') && !is_sum(factor)) {
    negative = true;
    factor.erase(0, 1);
  }
  if (factor == "1" && !symbol.empty()) factor.clear();
  if (!sum.empty())
    sum += negative ? " - " : " + ";
  else if (negative)
    sum += "-";
  sum += factor;
  if (!symbol.empty()) sum += (factor.empty() ? "" : "\\,") + symbol;
}

std::string ExplanationTex::upright(const std::string& name) { return "\\mathrm{" + escaped(name) + "}"; }

std::string ExplanationTex::symbol(const std::string& name, const std::string& index) {
  std::string tex = formula_as_tex(Formula::letter(name, poinsot::Sign::real));
  if (index.empty()) return tex;
  // A name that has an index keeps it in front of the new one.
  if (tex.ends_with('}') && tex.find("_{") != std::string::npos)
    return tex.substr(0, tex.size() - 1) + "," + index_tex(index) + "}";
  return tex + "_{" + index_tex(index) + "}";
}

std::string ExplanationTex::vector_symbol(const std::string& name) {
  const std::string tex = symbol(name);
  const std::size_t index = std::min(tex.find("_{"), tex.size());
  return (tex.starts_with('\\') ? "\\boldsymbol{" : "\\mathbf{") + tex.substr(0, index) + "}" + tex.substr(index);
}

std::string ExplanationTex::unit_vector(std::size_t axis) const {
  static constexpr std::array<const char*, 3> small{"i", "j", "k"}, large{"I", "J", "K"};
  if (axes_[0] == "x" && axes_[1] == "y" && axes_[2] == "z") return std::string("\\mathbf{") + small[axis] + "}";
  if (axes_[0] == "X" && axes_[1] == "Y" && axes_[2] == "Z") return std::string("\\mathbf{") + large[axis] + "}";
  return "\\mathbf{e}_{" + escaped(axes_[axis]) + "}";
}

}  // namespace poinsot::problem
