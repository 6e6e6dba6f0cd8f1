// Worked solutions as Markdown with mathematics in TeX.
#pragma once

#include <cstddef>
#include <string>

#include "document/document.h"

namespace poinsot::document {

// One solution: title, sections with displayed equations between `$$`, answers, checks. Ends in a newline. The
// document must have been made with explanations. Throws as require_values().
std::string to_markdown(const Document& document, std::size_t solution);

// All solutions, one after the other.
std::string to_markdown(const Document& document);

}  // namespace poinsot::document
