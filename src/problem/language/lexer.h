// The tokens of an expression: literals with their units, names with their primes, signs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "problem/language/tree.h"
#include "problem/language/units.h"

namespace poinsot::problem {

struct Token {
  enum class Kind { literal, name, preposition, sign, end };

  Kind kind = Kind::end;
  std::string text;       // as written, of a literal with one blank before the unit, of a name without its primes
  std::size_t begin = 0;  // in bytes, within the text of the scalar
  std::size_t end = 0;
  int primes = 0;
  double value = 0;  // of a literal, in its own unit
  Unit unit;
  bool has_unit = false;

  bool is_sign(std::string_view sign) const { return kind == Kind::sign && text == sign; }
  bool is_preposition(std::string_view word) const { return kind == Kind::preposition && text == word; }
};

// The text of one expression and where it stands in the file.
class ExpressionSource {
 public:
  // The entry (a scalar) and the name of the file must outlive the source.
  ExpressionSource(const Entry& entry, const std::string& file) : entry_(entry), file_(file) {}

  std::string_view text() const { return entry_.text; }
  Mark place(std::size_t offset) const { return entry_.place(offset); }
  // A token as the file writes it.
  std::string written(const Token& token) const {
    return std::string(text().substr(token.begin, token.end - token.begin));
  }
  std::string quoted(const Token& token) const { return "'" + written(token) + "'"; }
  [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = "") const {
    throw StatementError(file_, place(offset), std::move(message), std::move(hint));
  }

 private:
  const Entry& entry_;
  const std::string& file_;
};

// The tokens, the last of which is of kind `end`. Throws StatementError for a unit that touches its number, an
// unknown unit, a number beyond the range of double, or a sign that the language does not have.
std::vector<Token> tokens_of(const ExpressionSource& source);

}  // namespace poinsot::problem
