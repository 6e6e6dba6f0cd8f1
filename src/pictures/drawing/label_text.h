// Symbols and words set as labels: letters italic, digits and words upright, vectors bold, indices small and lower.
#pragma once

#include <string>
#include <string_view>

#include "pictures/drawing/drawing.h"

namespace poinsot::pictures {

constexpr double label_size = 14;
constexpr double longest_label = 260;  // a longer one is cut and ends in three dots

// A symbol in the TeX that worked solutions use: letters, \mathbf, \bar, \dot, indices, Greek letters. What else it
// holds is set as it stands.
Label tex_label(std::string_view tex, double size = label_size);
// Names as plain text: letters italic, Greek ones by their names, digits and what follows `_` as index, rates such as
// phidot with a dot.
Label name_label(std::string_view name, double size = label_size);
// A formula as answer documents write it, m*r^2*omega/4: letters as names, powers raised, products without a sign.
Label formula_label(std::string_view formula, double size = label_size);
// Words and numbers, upright.
Label words_label(std::string_view words, double size = label_size);
// The second behind the first, with a gap.
Label joined(Label first, const Label& second, double gap);

// A name with its Greek letter, for plain words: "ω1" for omega1.
std::string with_greek_letters(std::string_view name);

// Text of one line that any file may hold: UTF-8 without control characters.
std::string clean(std::string_view text);

}  // namespace poinsot::pictures
