// What is said where an expression cannot be read on or names what is not there: what is wrong and how it is written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problem/language/lexer.h"
#include "problem/language/token_reader.h"

namespace poinsot::problem {

// Brackets or the parentheses of a call that should end at the present token.
struct OpenBracket {
  const Token& opening;
  std::string_view closing;     // the sign that is missing
  const std::string& function;  // whose arguments stand here, "" in other brackets
  bool list_item = false;       // where a comma may have cut the expression short
};
[[noreturn]] void fail_unclosed(const ExpressionSource& source, const TokenReader& tokens, const OpenBracket& bracket);

// Reports that no expression can begin with the present token.
[[noreturn]] void fail_missing(const ExpressionSource& source, const TokenReader& tokens);

// Reports a token that does not continue the expression read before it.
// function: whose arguments it is among, "" in other brackets.
[[noreturn]] void fail_left_over(const ExpressionSource& source, const TokenReader& tokens, bool in_call,
                                 const std::string& function = "");

// What to do about a name that is not defined: the known name that is near to it, or what to know of units; "" if there
// is nothing to say.
std::string undefined_name_hint(const std::string& name, const std::vector<std::string>& known);

}  // namespace poinsot::problem
