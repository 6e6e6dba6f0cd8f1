#include "problem/language/source_map.h"

#include <algorithm>

#include "problem/language/utf8.h"

namespace poinsot::problem {
namespace {

constexpr std::size_t stride = 64;

bool is_white(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

SourceMap::SourceMap(std::string_view text) : text_(text), line_starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
  counts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); i += stride) {
    counts_.push_back(counts_.back() + character_count(text.substr(i, stride)));
  }
}

int SourceMap::characters_before(std::size_t offset) const {
  const std::size_t block = offset / stride;
  return counts_[block] + character_count(text_.substr(block * stride, offset - block * stride));
}

Mark SourceMap::mark(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) - 1;
  return {static_cast<int>(line - line_starts_.begin()) + 1, characters_before(offset) - characters_before(*line) + 1};
}

bool SourceMap::bracket_closes(std::size_t offset) const {
  std::size_t depth = 0;
  for (std::size_t i = offset; i < text_.size(); ++i) {
    if (text_[i] == '[' || text_[i] == '{') ++depth;
    if ((text_[i] == ']' || text_[i] == '}') && --depth == 0) return true;
  }
  return false;
}

bool SourceMap::quotes_close(std::size_t offset) const {
  const char quote = at(offset);
  for (std::size_t i = offset + 1; i < text_.size(); ++i) {
    if (quote == '"' && text_[i] == '\\') {
      ++i;
    } else if (text_[i] == quote) {
      if (quote == '"' || at(i + 1) != '\'') return true;
      ++i;
    }
  }
  return false;
}

std::vector<Entry::Run> SourceMap::runs(std::string_view value, std::size_t token) const {
  std::vector<Entry::Run> runs;
  const char opening = at(token);
  std::size_t source = token;
  if (opening == '"' || opening == '\'') {
    ++source;
  } else if (opening == '|' || opening == '>') {
    while (source < text_.size() && text_[source] != '\n') ++source;
    while (is_white(at(source))) ++source;
  }
  bool in_step = false;
  for (std::size_t i = 0; i < value.size() && source < text_.size();) {
    if (text_[source] == value[i]) {
      if (!in_step) runs.push_back({i, mark(source)});
      in_step = value[i] != '\n';
      ++i;
      // Within single quotes a doubled quote stands for one.
      source += opening == '\'' && text_[source] == '\'' ? 2 : 1;
    } else if (is_white(text_[source])) {
      while (is_white(at(source))) ++source;
      if (is_white(value[i])) ++i;
      in_step = false;
    } else {
      break;
    }
  }
  return runs;
}

}  // namespace poinsot::problem
