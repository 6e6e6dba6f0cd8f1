// Renders the answer document as text: for a reader, for another program, as a worked solution.
//
// The functions depend on their arguments only. Those that take a document throw std::domain_error as
// require_values() does.
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
  // Of the terminal: what does not fit beside the words of its question stands below them. 0: as wide as it takes.
  std::size_t columns = 0;
};

// The title; for each solution its unknowns, the answer to each question, and the checks; what to do about open
// letters; warnings. The text ends in a newline. No control sequence of a problem file reaches the terminal.
std::string to_terminal(const Document& document, const TerminalStyle& style = {});

// The document on one line without line end, in the form of answer_schema(). Questions are in the order of the file.
// Numbers have the digits with which they read back as the same double, bytes that are not UTF-8 become U+FFFD, and a
// misfit that is not finite is null.
std::string to_json(const Document& document);

// What comparing a problem file with its own expected answers found: a line for each discrepancy (Problem::check).
struct CheckedFile {
  std::string file;
  std::vector<std::string> shortfalls;
};

// The files with what they fall short of, and how many passed and failed: one line without line end.
std::string checks_to_json(const std::vector<CheckedFile>& files);

// The JSON Schema (draft 2020-12) of what to_json() writes of a document, ending in a newline.
std::string answer_schema();

// A picture that stands in a worked solution, by the address of its file.
struct MarkdownPicture {
  std::string section;  // it ends the first section of this heading; the answers, if there is no such section
  std::string title, address;
};

// One solution as Markdown with mathematics in TeX: title, sections with displayed equations between `$$`, answers,
// checks. The text ends in a newline. A document of Problem::explain() has sections, one of Problem::solve() has
// none. Throws std::out_of_range if there is no such solution.
std::string to_markdown(const Document& document, std::size_t solution,
                        const std::vector<MarkdownPicture>& pictures = {});
// All solutions, one after the other, each with its pictures, and the warnings.
std::string to_markdown(const Document& document, const std::vector<std::vector<MarkdownPicture>>& pictures = {});

// The text on one line and without control over the terminal: line ends and tabs become blanks; other control
// characters, marks that change the direction of writing, and bytes that are not UTF-8 become U+FFFD. Messages
// contain text of problem files and need this: StatementError::what() has one message on each of its lines.
std::string printable(std::string_view text);

// The hint "did you mean 'x'?" with the candidate nearest to the word, or "" if none is near enough.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace poinsot
