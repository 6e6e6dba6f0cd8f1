// UTF-8 text: characters and where they are.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace poinsot::problem {

// The character at `offset` and its length in bytes. There is none if the bytes are not UTF-8 (truncated, overlong, a
// surrogate, beyond U+10FFFF) or the offset is at the end.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
};
std::optional<Character> character_at(std::string_view text, std::size_t offset);

// The offset of the first byte that is not UTF-8, or is a control character other than tab, line feed and carriage
// return.
std::optional<std::size_t> first_binary_byte(std::string_view text);

// Of the digits of numbers, in any locale.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The number of characters in a valid text.
int character_count(std::string_view text);

// The character at `offset` as its own string, for messages.
std::string character_text(std::string_view text, std::size_t offset);

}  // namespace poinsot::problem
