// The width of text on a terminal. Text of a problem file is made fit for one by printable(), of poinsot/rendering.h.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "poinsot/rendering.h"  // printable

namespace poinsot::document {

// The columns that a printable text takes on a terminal: two for a wide East Asian character or a pictograph, none for
// a combining mark.
std::size_t display_width(std::string_view text);

// The text with blanks behind it up to the width; unchanged if it is wider.
std::string padded_right(std::string text, std::size_t width);

// The text with blanks before it up to the width; unchanged if it is wider.
std::string padded_left(const std::string& text, std::size_t width);

}  // namespace poinsot::document
