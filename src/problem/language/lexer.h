// The words of an expression: literals with their units, names with their primes, signs.
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
  std::string text;       // of a literal: as written with one blank before the unit; of a name: without primes
  std::size_t begin = 0;  // bytes in the scalar's text
  std::size_t end = 0;
  int primes = 0;
  double value = 0;  // of a literal, in its unit
  Unit unit;
  bool has_unit = false;

  bool is_sign(std::string_view sign) const { return kind == Kind::sign && text == sign; }
  bool is_preposition(std::string_view word) const { return kind == Kind::preposition && text == word; }
};

// The text of one expression and where it stands in the file.
class ExpressionSource {
 public:
  // Entry (a scalar) and file must outlive the source.
  ExpressionSource(const Entry& entry, const std::string& file) : entry_(entry), file_(file) {}

  std::string_view text() const { return entry_.text; }
  Mark place(std::size_t offset) const { return entry_.place(offset); }
  [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = "") const {
    throw StatementError(file_, place(offset), std::move(message), std::move(hint));
  }

 private:
  const Entry& entry_;
  const std::string& file_;
};

// The last token is of kind end. Throws StatementError: a unit glued to its number, unknown units, numbers beyond the
// range of double, signs that the language does not have.
std::vector<Token> tokens_of(const ExpressionSource& source);

}  // namespace poinsot::problem
