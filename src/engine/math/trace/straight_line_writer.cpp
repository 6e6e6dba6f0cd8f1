#include "engine/math/trace/straight_line_writer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <stdexcept>

namespace poinsot {
namespace {

using Op = TracedOperation;

constexpr std::size_t longest_inline = 90;  // characters of what has no name of its own

std::string wrapped(const Piece& piece, bool brackets, TextForm form) {
  if (!brackets) return piece.text;
  return form == TextForm::tex ? "\\left(" + piece.text + "\\right)" : "(" + piece.text + ")";
}

std::string shortest(double number) {
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

bool is_code(TextForm form) { return form == TextForm::c || form == TextForm::cpp || form == TextForm::python; }

// A name for SymPy and Python: theta' becomes theta_dot.
std::string python_name(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (c == '\'')
      result += "_dot";
    else
      result += std::isalnum(static_cast<unsigned char>(c)) || c == '_' ? c : '_';
  }
  return is_code_name(result) ? result : result + "_";
}

std::string tex_number(const std::string& digits) {
  const std::size_t e = digits.find('e');
  if (e == std::string::npos) return digits;
  return digits.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(digits.substr(e + 1))) + "}";
}

std::string range(std::size_t first, std::size_t count) {
  return count == 1 ? "[" + std::to_string(first) + "]"
                    : "[" + std::to_string(first) + "] to [" + std::to_string(first + count - 1) + "]";
}
}  // namespace

// Greek letters stand for themselves; digits at the end and what follows a _ become an index.
std::string tex_name(std::string name) {
  static const std::set<std::string, std::less<>> greek{
      "alpha", "beta",  "gamma",  "delta", "epsilon", "zeta",  "eta",     "theta", "iota", "kappa", "lambda", "mu",
      "nu",    "xi",    "pi",     "rho",   "sigma",   "tau",   "upsilon", "phi",   "chi",  "psi",   "omega",  "Gamma",
      "Delta", "Theta", "Lambda", "Xi",    "Pi",      "Sigma", "Upsilon", "Phi",   "Psi",  "Omega"};
  std::size_t primes = 0;
  while (!name.empty() && name.back() == '\'') {
    name.pop_back();
    ++primes;
  }
  std::string index;
  if (const std::size_t bar = name.find('_'); bar != std::string::npos && bar > 0) {
    index = name.substr(bar + 1);
    name.resize(bar);
    for (std::size_t i = 0; i < index.size(); ++i)
      if (index[i] == '_') index.replace(i++, 1, "\\_");
  } else {
    std::size_t digits = name.size();
    while (digits > 1 && std::isdigit(static_cast<unsigned char>(name[digits - 1]))) --digits;
    index = name.substr(digits);
    name.resize(digits);
  }
  std::string base = greek.contains(name) ? "\\" + name : name.size() == 1 ? name : "\\mathrm{" + name + "}";
  if (primes == 1) base = "\\dot{" + base + "}";
  if (primes == 2) base = "\\ddot{" + base + "}";
  return index.empty() ? base : base + "_{" + index + "}";
}

ProgramWriter::ProgramWriter(const StraightLine& program, const ProgramText& text, TextForm form)
    : program_(program),
      text_(text),
      form_(form),
      uses_(program.steps().size(), 0),
      pieces_(program.steps().size()),
      longest_inline_(longest_inline) {
  check();
  for (const TextInput& input : text.inputs) taken_.insert(shown_name(input));
  for (const TextBlock& block : text.blocks) taken_.insert(block.name);
  while (std::any_of(taken_.begin(), taken_.end(), [&](const std::string& name) {
    return name.size() > prefix_.size() && name.starts_with(prefix_) &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix_.size()), name.end(),
                       [](unsigned char c) { return std::isdigit(c); });
  }))
    prefix_ += "z";
  count_uses();
}

void ProgramWriter::keep_in_one_line() {
  longest_inline_ = static_cast<std::size_t>(-1);
  std::fill(uses_.begin(), uses_.end(), 1);
}

void ProgramWriter::check() const {
  std::size_t outputs = 0;
  for (const TextBlock& block : text_.blocks) outputs += block.rows * block.columns;
  if (text_.inputs.size() != program_.input_count() || outputs != program_.outputs().size())
    throw std::invalid_argument("write_program: " + std::to_string(text_.inputs.size()) + " names for " +
                                std::to_string(program_.input_count()) + " inputs, blocks of " +
                                std::to_string(outputs) + " numbers for " + std::to_string(program_.outputs().size()) +
                                " outputs");
  if (!is_code_name(text_.function))
    throw std::invalid_argument("'" + text_.function + "' cannot be the name of a function");
}

bool ProgramWriter::writes_powers() const { return !is_code(form_); }

void ProgramWriter::count_uses() {
  const auto& steps = program_.steps();
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (!is_operation(steps[i].operation)) continue;
    ++uses_[steps[i].first.step];
    const bool square = steps[i].operation == Op::multiply && steps[i].first == steps[i].second;
    if (steps[i].second.step != 0 && !(square && writes_powers())) ++uses_[steps[i].second.step];
  }
  for (const StraightLine::Operand& output : shown_outputs()) ++uses_[output.step];
}

// Outputs that the text shows: of symmetric blocks one triangle, but in code all.
std::vector<StraightLine::Operand> ProgramWriter::shown_outputs() const {
  if (form_ != TextForm::plain && form_ != TextForm::tex) return program_.outputs();
  std::vector<StraightLine::Operand> shown;
  std::size_t at = 0;
  for (const TextBlock& block : text_.blocks)
    for (std::size_t i = 0; i < block.rows; ++i)
      for (std::size_t j = 0; j < block.columns; ++j, ++at)
        if (!block.symmetric || j <= i) shown.push_back(program_.outputs()[at]);
  return shown;
}

std::string ProgramWriter::shown_name(const TextInput& input) const {
  switch (form_) {
    case TextForm::plain:
      return input.name;
    case TextForm::tex:
      return tex_name(input.name);
    case TextForm::sympy:
      return python_name(input.name);
    default:
      return input.array + "[" + std::to_string(input.index) + "]";
  }
}

Piece ProgramWriter::constant(const StraightLine::Step& step) const {
  const bool whole = step.denominator == 1;
  if (whole) {
    const std::string digits = std::to_string(step.numerator);
    return {is_code(form_) ? digits + ".0" : digits, Binding::atom};
  }
  std::string decimals = shortest(step.value);
  if (is_code(form_) || step.denominator == 0) {
    if (decimals.find_first_of(".e") == std::string::npos) decimals += ".0";
    return {form_ == TextForm::tex ? tex_number(decimals) : decimals, Binding::atom};
  }
  const std::string n = std::to_string(step.numerator), d = std::to_string(step.denominator);
  if (form_ == TextForm::sympy) return {"Rational(" + n + ", " + d + ")", Binding::atom};
  // A number with few decimals as such.
  if (decimals.size() <= 7 && decimals.find('e') == std::string::npos) return {decimals, Binding::atom};
  if (form_ == TextForm::tex) return {"\\frac{" + n + "}{" + d + "}", Binding::atom};
  return {n + "/" + d, Binding::quotient};
}

Piece ProgramWriter::of(const StraightLine::Operand& x) const {
  const Piece& piece = pieces_[x.step];
  if (!x.negative) return piece;
  return {"-" + wrapped(piece, piece.binding == Binding::sum, form_), Binding::sum};
}

std::string ProgramWriter::function_name(Op op) const {
  const bool tex = form_ == TextForm::tex;
  const std::string before = tex ? "\\" : form_ == TextForm::cpp ? "std::" : "";
  switch (op) {
    case Op::square_root:
      return before + "sqrt";
    case Op::sine:
      return before + "sin";
    case Op::cosine:
      return before + "cos";
    case Op::arc_sine:
      return before + (tex ? "arcsin" : "asin");
    case Op::arc_cosine:
      return before + (tex ? "arccos" : "acos");
    case Op::arc_tangent:
      return before + (tex ? "arctan" : "atan");
    case Op::arc_tangent_2:
      return tex ? "\\operatorname{atan2}" : before + "atan2";
    default:
      return form_ == TextForm::c || form_ == TextForm::cpp || form_ == TextForm::python ? before + "fabs"
             : form_ == TextForm::sympy                                                  ? "Abs"
                                                                                         : "abs";
  }
}

Piece ProgramWriter::operation(const StraightLine::Step& step) const {
  const Piece a = of(step.first), b = of(step.second);
  const bool tex = form_ == TextForm::tex;
  switch (step.operation) {
    case Op::add: {
      if (!step.second.negative) return {a.text + " + " + b.text, Binding::sum};
      const Piece& taken = pieces_[step.second.step];
      return {a.text + " - " + wrapped(taken, taken.binding == Binding::sum, form_), Binding::sum};
    }
    case Op::multiply: {
      if (writes_powers() && step.first == step.second) {
        const std::string base = wrapped(a, a.binding != Binding::atom, form_);
        return {form_ == TextForm::sympy ? base + "**2" : base + "^" + (tex ? "{2}" : "2"), Binding::power};
      }
      const std::string left = wrapped(a, a.binding == Binding::sum, form_);
      const bool brackets = b.binding == Binding::sum || (b.binding == Binding::quotient && !tex);
      return {left + (tex ? " \\, " : "*") + wrapped(b, brackets, form_), Binding::product};
    }
    case Op::divide:
      if (tex) return {"\\frac{" + a.text + "}{" + b.text + "}", Binding::quotient};
      return {wrapped(a, a.binding == Binding::sum, form_) + "/" +
                  wrapped(b, b.binding != Binding::atom && b.binding != Binding::power, form_),
              Binding::quotient};
    case Op::square_root:
      if (tex) return {"\\sqrt{" + a.text + "}", Binding::atom};
      [[fallthrough]];
    default: {
      if (step.operation == Op::absolute && tex) return {"\\left|" + a.text + "\\right|", Binding::atom};
      std::string arguments = a.text;
      if (step.operation == Op::arc_tangent_2) arguments += ", " + b.text;
      return {function_name(step.operation) + wrapped({arguments, Binding::atom}, true, form_), Binding::atom};
    }
  }
}

std::vector<std::pair<std::string, std::string>> ProgramWriter::named() {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto& steps = program_.steps();
  pieces_[0] = {is_code(form_) ? "0.0" : "0", Binding::atom};
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const StraightLine::Step& step = steps[i];
    if (step.operation == Op::constant) {
      pieces_[i] = constant(step);
    } else if (step.operation == Op::input) {
      pieces_[i] = {shown_name(text_.inputs[step.input]), Binding::atom};
    } else if (uses_[i] > 0) {
      Piece piece = operation(step);
      if (uses_[i] > 1 || piece.text.size() > longest_inline_) {
        const std::string name = prefix_ + std::to_string(rows.size() + 1);
        const std::string shown = form_ == TextForm::tex ? tex_name(name) : name;
        rows.emplace_back(shown, std::move(piece.text));
        piece = {shown, Binding::atom};
      }
      pieces_[i] = std::move(piece);
    }
  }
  return rows;
}

std::string ProgramWriter::shape(const TextBlock& block) {
  if (block.rows == 1 && block.columns == 1) return "a number";
  if (block.columns == 1) return std::to_string(block.rows) + " numbers";
  return std::to_string(block.rows) + " x " + std::to_string(block.columns) + ", row after row";
}

std::vector<std::string> ProgramWriter::legend() const {
  std::vector<std::string> lines;
  for (const TextInput& input : text_.inputs)
    lines.push_back(input.array + "[" + std::to_string(input.index) + "]  " + input.name +
                    (input.meaning.empty() ? "" : ", " + input.meaning));
  std::size_t at = 0;
  for (const TextBlock& block : text_.blocks) {
    const std::size_t count = block.rows * block.columns;
    if (count > 0)
      lines.push_back("out" + range(at, count) + "  " + block.name + ", " + shape(block) + ": " + block.meaning);
    at += count;
  }
  return lines;
}

bool ProgramWriter::uses_functions() const {
  return std::any_of(program_.steps().begin(), program_.steps().end(),
                     [](const auto& step) { return step.operation >= Op::square_root; });
}

}  // namespace poinsot
