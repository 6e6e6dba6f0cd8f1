// Byte offsets of a file's text as lines and columns.
#pragma once

#include <cstddef>
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

  // Has the bracket or brace at the offset its closing one? Those in quotes and comments count as well.
  bool bracket_closes(std::size_t offset) const;

  // Does the text in quotes that begins at the offset have its closing quote?
  bool quotes_close(std::size_t offset) const;

  // Where the pieces of a scalar's value stand, given the offset at which its token begins in the text. The value and
  // the text are matched letter by letter, folded line breaks allowed for; behind an escape in double quotes the places
  // are those of the last piece.
  std::vector<Entry::Run> runs(std::string_view value, std::size_t token) const;

 private:
  std::string_view text_;
  // Characters before byte `offset`.
  int characters_before(std::size_t offset) const;

  std::vector<std::size_t> line_starts_;
  std::vector<int> counts_;  // characters before every 64th byte, so that a place is found quickly in long lines too
};

}  // namespace poinsot::problem
