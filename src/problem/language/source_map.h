// Translates byte offsets in the text of a file to lines and columns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/language/tree.h"

namespace poinsot::problem {

class SourceMap {
 public:
  // The text must outlive the map.
  explicit SourceMap(std::string_view text);

  std::string_view text() const { return text_; }
  Mark mark(std::size_t offset) const;
  // The character at an offset, '\0' at the end.
  char at(std::size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }

  // Whether the bracket or brace at the offset has a closing one. Brackets in quotes and comments are counted as
  // well.
  bool bracket_closes(std::size_t offset) const;

  // Whether the quoted text that begins at the offset has its closing quote.
  bool quotes_close(std::size_t offset) const;

  // The places of the pieces of a scalar's value, whose token begins at the offset `token`. Value and text are
  // compared letter by letter, where a folded line break counts as a blank. After an escape in double quotes the
  // places are those of the last piece before it.
  std::vector<Entry::Run> runs(std::string_view value, std::size_t token) const;

  // What an author often means where the reader of the tree stumbles over the line at the offset: a tab in the
  // indentation, '=' in place of ':', no ':' at all (of the line before too, which the reader takes on as one text), a
  // line that is indented too far. Nothing if the lines look right.
  struct Slip {
    std::size_t offset;
    std::string message, hint;
  };
  std::optional<Slip> slip_of_line(std::size_t offset) const;

 private:
  // A line without its indentation and its comment.
  struct Line {
    std::size_t begin = 0;   // the offset of the first character that is no blank
    std::size_t indent = 0;  // the blanks and tabs before it
    std::string_view words;  // empty for an empty line
  };
  Line line(std::size_t number) const;  // counted from 0

  std::string_view text_;
  // The number of characters before the byte at `offset`.
  int characters_before(std::size_t offset) const;

  std::vector<std::size_t> line_starts_;
  // the number of characters before every 64th byte, so that a place in a long line is found quickly
  std::vector<int> counts_;
};

}  // namespace poinsot::problem
