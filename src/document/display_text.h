// Text that comes from a problem file, made fit for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot::document {

// The text on one line and without power over the terminal: line ends and tabs become blanks; other control characters,
// marks that change the direction of writing, and bytes that are no UTF-8 become U+FFFD.
std::string printable(std::string_view text);

// The columns that a printable text takes on a terminal: two for a wide East Asian character or a pictograph, none for
// a combining mark.
std::size_t display_width(std::string_view text);

// The text with blanks behind it up to the width; unchanged if it is wider.
std::string padded_right(std::string text, std::size_t width);

// The text with blanks before it up to the width; unchanged if it is wider.
std::string padded_left(const std::string& text, std::size_t width);

}  // namespace poinsot::document
