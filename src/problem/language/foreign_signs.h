// Signs that people write in formulas and that the language writes otherwise.
#pragma once

#include <string>
#include <string_view>

namespace poinsot::problem {

// For the beginning of a text: what is wrong and what to do, both empty if it is no known foreign sign.
struct ForeignSign {
  std::string message;
  std::string hint;
};
ForeignSign foreign_sign_of_expression(std::string_view text);

}  // namespace poinsot::problem
