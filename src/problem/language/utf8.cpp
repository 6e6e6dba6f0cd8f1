#include "problem/language/utf8.h"

#include <array>

namespace poinsot::problem {

std::optional<Character> character_at(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[offset + i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return Character{lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || offset + bytes > text.size()) return std::nullopt;
  constexpr std::array<unsigned, 5> lead_bits{0, 0, 0x1f, 0x0f, 0x07};
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
  char32_t code = lead & lead_bits[bytes];
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return std::nullopt;
    code = (code << 6) | (byte(i) & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < smallest[bytes] || surrogate || code > 0x10ffff) return std::nullopt;
  return Character{code, bytes};
}

std::optional<std::size_t> first_binary_byte(std::string_view text) {
  for (std::size_t offset = 0; offset < text.size();) {
    const std::optional<Character> character = character_at(text, offset);
    if (!character) return offset;
    const char32_t code = character->code;
    const bool white = code == '\t' || code == '\n' || code == '\r';
    if ((code < 0x20 && !white) || (code >= 0x7f && code < 0xa0)) return offset;
    offset += character->bytes;
  }
  return std::nullopt;
}

int character_count(std::string_view text) {
  int count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return count;
}

std::string character_text(std::string_view text, std::size_t offset) {
  const std::optional<Character> character = character_at(text, offset);
  return std::string(text.substr(offset, character ? character->bytes : 1));
}

}  // namespace poinsot::problem
