// Reads infix formulas, on any scalar: the way back from text to formulas and to numbers.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
// How GoogleTest shows formulas.
inline void PrintTo(const Formula& x, std::ostream* out) { *out << text(x); }
}  // namespace poinsot

namespace poinsot::testing {

// Scalar: double or Formula. name: the value of a letter or of pi; number: that of digits.
template <class Scalar>
class FormulaReader {
 public:
  using OfText = std::function<Scalar(const std::string&)>;
  FormulaReader(std::string text, OfText name, OfText number)
      : text_(std::move(text)), name_(std::move(name)), number_(std::move(number)) {}

  Scalar read() {
    Scalar value = sum();
    skip();
    if (at_ != text_.size()) fail();
    return value;
  }

 private:
  [[noreturn]] void fail() const { throw std::invalid_argument("at " + std::to_string(at_) + " of " + text_); }
  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(const std::string& sign) {
    skip();
    if (text_.compare(at_, sign.size(), sign) != 0) return false;
    at_ += sign.size();
    return true;
  }
  Scalar sum() {
    Scalar value = take("-") ? Scalar(-product()) : product();
    while (true) {
      if (take("+")) {
        value = value + product();
      } else if (take("-")) {
        value = value - product();
      } else {
        return value;
      }
    }
  }
  Scalar product() {
    Scalar value = signed_power();
    while (true) {
      skip();
      if (text_.compare(at_, 2, "**") != 0 && take("*")) {
        value = value * signed_power();
      } else if (take("/")) {
        value = value / signed_power();
      } else {
        return value;
      }
    }
  }
  Scalar signed_power() { return take("-") ? Scalar(-power()) : power(); }
  Scalar power() {
    const Scalar base = atom();
    if (!take("^") && !take("**")) return base;
    skip();
    int exponent = 0;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_]))) {
      exponent = 10 * exponent + (text_[at_++] - '0');
    }
    Scalar value(1);
    for (int k = 0; k < exponent; ++k) value = value * base;
    return value;
  }
  Scalar atom() {
    using std::abs;
    using std::acos;
    using std::asin;
    using std::atan;
    using std::atan2;
    using std::cos;
    using std::sin;
    using std::sqrt;
    using std::tan;
    if (take("(")) {
      Scalar value = sum();
      if (!take(")")) fail();
      return value;
    }
    skip();
    std::string word;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' || text_[at_] == '.')) {
      word += text_[at_++];
    }
    if (word.empty()) fail();
    if (std::isdigit(static_cast<unsigned char>(word[0])) || word[0] == '.') return number_(word);
    if (!take("(")) return name_(word);
    const Scalar x = sum();
    Scalar second(0);
    if (take(",")) second = sum();
    if (!take(")")) fail();
    if (word == "sqrt") return sqrt(x);
    if (word == "abs") return abs(x);
    if (word == "sin") return sin(x);
    if (word == "cos") return cos(x);
    if (word == "tan") return tan(x);
    if (word == "asin") return asin(x);
    if (word == "acos") return acos(x);
    if (word == "atan") return atan(x);
    if (word == "atan2") return atan2(x, second);
    fail();
  }

  std::string text_;
  OfText name_;
  OfText number_;
  std::size_t at_ = 0;
};

// Letters named in `real` may have either sign, all others are positive.
inline Formula read_expression(const std::string& text, const std::vector<std::string>& real = {}) {
  return FormulaReader<Formula>(
             text,
             [&real](const std::string& name) {
               if (name == "pi") return Formula::pi();
               const bool any_sign = std::find(real.begin(), real.end(), name) != real.end();
               return Formula::letter(name, any_sign ? Sign::real : Sign::positive);
             },
             [](const std::string& digits) { return Formula::number(digits); })
      .read();
}
inline double read_value(const std::string& text, const LetterValues& values) {
  return FormulaReader<double>(
             text,
             [&values](const std::string& name) { return name == "pi" ? 3.14159265358979323846 : values.at(name); },
             [](const std::string& digits) { return std::stod(digits); })
      .read();
}

// As the operators of a formula are counted: each sign of operation and each function.
inline int count_operators(const std::string& text) {
  int count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "**") == 0)
      ++i, ++count;
    else if (std::string("+-*/^").find(text[i]) != std::string::npos)
      ++count;
    else if (text[i] == '(' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])))
      ++count;
  }
  return count;
}

}  // namespace poinsot::testing
