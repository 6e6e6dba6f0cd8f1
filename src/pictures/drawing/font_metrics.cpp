#include "pictures/drawing/font_metrics.h"

#include <array>
#include <cstddef>

namespace poinsot::pictures {
namespace {

#include "pictures/drawing/font_widths.inc"

constexpr char32_t first_ascii = 0x20, first_greek = 0x391;
constexpr double widest = 1000;  // as the letters of east Asia

double width_of(char32_t letter, std::size_t face) {
  if (letter == 0xa0) letter = first_ascii;  // a blank at which no line ends
  if (letter >= first_ascii && letter < first_ascii + ascii_widths[face].size())
    return ascii_widths[face][letter - first_ascii];
  if (letter >= first_greek && letter < first_greek + greek_widths[face].size())
    return greek_widths[face][letter - first_greek];
  for (std::size_t i = 0; i < extra_letters.size(); ++i)
    if (extra_letters[i] == letter) return extra_widths[face][i];
  return widest;
}

}  // namespace

double text_width(std::string_view text, Face face, double size) {
  double sum = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    char32_t letter = length == 1 ? first : first & (0xffU >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
      letter = (letter << 6) | (static_cast<unsigned char>(text[i + k]) & 0x3fU);
    sum += width_of(letter, static_cast<std::size_t>(face));
    i += length;
  }
  return sum * size / 1000;
}

}  // namespace poinsot::pictures
