// The tokens of an expression, read from first to last.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "problem/language/lexer.h"

namespace poinsot::problem {

class TokenReader {
 public:
  // The last token is of kind end and is never stepped over.
  explicit TokenReader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  const Token& now() const { return tokens_[at_]; }
  const Token& before() const { return tokens_[at_ == 0 ? 0 : at_ - 1]; }
  // The one after the present token, which is not the last.
  const Token& next() const { return tokens_[at_ + 1]; }
  bool at_beginning() const { return at_ == 0; }

  void step(std::size_t count = 1) { at_ += count; }
  // Steps over the present token if it is this sign.
  bool accept(std::string_view sign) {
    if (!now().is_sign(sign)) return false;
    step();
    return true;
  }

 private:
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace poinsot::problem
