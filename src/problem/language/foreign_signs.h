// Signs that people use in expressions and that this language writes differently.
#pragma once

#include <string>
#include <string_view>

namespace poinsot::problem {

// For a text that begins with such a sign: what is wrong, and what to write. Both are empty if it does not.
struct ForeignSign {
  std::string message;
  std::string hint;
  bool is_letter = false;  // whether it may stand in a name
};
ForeignSign foreign_sign_of_expression(std::string_view text);

}  // namespace poinsot::problem
