// The answer document as text: for a reader, for another program, as a worked solution.
//
// These are functions of their arguments alone. Those that take a document throw std::domain_error as require_values()
// does.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/document.h"

namespace poinsot {

struct TerminalStyle {
  bool color = false;  // with ANSI escape sequences
  int digits = 6;      // significant digits of a number, at least 1
};

// Title; for each solution its unknowns, each question by name with what was found, and the checks; what to do about
// open letters; warnings. Ends in a newline. Nothing of a problem file reaches the terminal as a control sequence.
std::string to_terminal(const Document& document, const TerminalStyle& style = {});

// The document on one line, without the line's end, in the form of answer_schema(). Questions stand in the order of the
// file; numbers have the digits that make them read back as the same double; bytes that are no UTF-8 become U+FFFD; a
// residual that could not be formed (not finite) is null.
std::string to_json(const Document& document);

// The JSON Schema (draft 2020-12) of what to_json() writes, ending in a newline.
std::string answer_schema();

// One solution as Markdown with mathematics in TeX: title, sections with displayed equations between `$$`, answers,
// checks. Ends in a newline. A document of Problem::solve() has no sections, one of Problem::explain() has them. Throws
// std::out_of_range if there is no such solution.
std::string to_markdown(const Document& document, std::size_t solution);
// All solutions, one after the other, and the warnings.
std::string to_markdown(const Document& document);

// The text on one line and without power over a terminal: line ends and tabs become blanks; other control characters,
// marks that change the direction of writing, and bytes that are no UTF-8 become U+FFFD. For messages, which hold text
// of problem files: StatementError::what() has one for each of its lines.
std::string printable(std::string_view text);

// The hint "did you mean 'x'?" with the candidate that is near enough to the word to be meant, or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace poinsot
