#include "document/display_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace poinsot::document {
namespace {

struct CodePointRange {
  std::uint32_t first;
  std::uint32_t last;
};

template <std::size_t n>
bool contains(const std::array<CodePointRange, n>& ranges, std::uint32_t code_point) {
  return std::ranges::any_of(
      ranges, [=](const CodePointRange& range) { return range.first <= code_point && code_point <= range.last; });
}

// Control characters (C0 and C1), what is invisible, by which two names that look alike differ (soft hyphen, zero
// width, invisible operators, tags), and the marks, embeddings, overrides and isolates of bidirectional text.
constexpr std::array<CodePointRange, 11> unprintable{{{0x0, 0x1F},
                                                      {0x7F, 0x9F},
                                                      {0xAD, 0xAD},
                                                      {0x61C, 0x61C},
                                                      {0x180E, 0x180E},
                                                      {0x200B, 0x200F},
                                                      {0x2028, 0x202E},
                                                      {0x2060, 0x206F},
                                                      {0xFEFF, 0xFEFF},
                                                      {0xFFF9, 0xFFFB},
                                                      {0xE0000, 0xE007F}}};

// Combining marks and variation selectors.
constexpr std::array<CodePointRange, 5> zero_width{
    {{0x300, 0x36F}, {0x1AB0, 0x1AFF}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}}};

// East Asian Wide and Fullwidth, and pictographs.
constexpr std::array<CodePointRange, 12> double_width{{{0x1100, 0x115F},
                                                       {0x2E80, 0x303E},
                                                       {0x3041, 0xA4CF},
                                                       {0xAC00, 0xD7A3},
                                                       {0xF900, 0xFAFF},
                                                       {0xFE30, 0xFE6F},
                                                       {0xFF00, 0xFF60},
                                                       {0xFFE0, 0xFFE6},
                                                       {0x1F300, 0x1F64F},
                                                       {0x1F680, 0x1F6FF},
                                                       {0x1F900, 0x1F9FF},
                                                       {0x20000, 0x3FFFD}}};

struct CodePoint {
  std::uint32_t value;
  std::size_t bytes;
};

// The first code point of a text that is not empty; nothing if its bytes are not UTF-8 (RFC 3629).
std::optional<CodePoint> leading_code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  if (head < 0x80) return CodePoint{head, 1};
  const std::size_t length = head >= 0xF0 ? 4 : head >= 0xE0 ? 3 : 2;
  if (head < 0xC2 || head > 0xF4 || text.size() < length) return std::nullopt;
  std::uint32_t value = head & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return std::nullopt;
    value = value << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < smallest[length] || value > 0x10FFFF || surrogate) return std::nullopt;
  return CodePoint{value, length};
}

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const std::optional<CodePoint> code_point = leading_code_point(text);
    if (code_point && contains(double_width, code_point->value)) {
      width += 2;
    } else if (!code_point || !contains(zero_width, code_point->value)) {
      width += 1;
    }
    text.remove_prefix(code_point ? code_point->bytes : 1);
  }
  return width;
}

std::string padded_right(std::string text, std::size_t width) {
  text.append(width - std::min(width, display_width(text)), ' ');
  return text;
}

std::string padded_left(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, display_width(text)), ' ') + text;
}

}  // namespace poinsot::document

namespace poinsot {

std::string printable(std::string_view text) {
  constexpr const char* replacement_character = "\xEF\xBF\xBD";
  std::string result;
  while (!text.empty()) {
    const std::optional<document::CodePoint> code_point = document::leading_code_point(text);
    const std::size_t bytes = code_point ? code_point->bytes : 1;
    if (text[0] == '\n' || text[0] == '\t' || text[0] == '\r') {
      result += ' ';
    } else if (!code_point || document::contains(document::unprintable, code_point->value)) {
      result += replacement_character;
    } else {
      result += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return result;
}

}  // namespace poinsot
