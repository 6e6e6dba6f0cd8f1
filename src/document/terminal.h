// The answer document as text for a reader.
#pragma once

#include <string>

#include "document/document.h"

namespace poinsot::document {

struct TerminalStyle {
  bool color = false;  // with ANSI escape sequences
  int digits = 6;      // significant digits of a number, at least 1
};

// Title; for each solution its unknowns, each question by name with what was found, and the checks; what to do about
// open letters; warnings. Ends in a newline. Nothing of a problem file reaches the terminal as a control sequence.
// Throws as require_values().
std::string to_terminal(const Document& document, const TerminalStyle& style = {});

}  // namespace poinsot::document
