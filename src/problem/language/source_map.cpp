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

SourceMap::Line SourceMap::line(std::size_t number) const {
  Line line;
  line.begin = line_starts_[number];
  std::size_t end = number + 1 < line_starts_.size() ? line_starts_[number + 1] - 1 : text_.size();
  while (line.begin < end && (text_[line.begin] == ' ' || text_[line.begin] == '\t')) ++line.begin;
  line.indent = line.begin - line_starts_[number];
  // A comment begins with a '#' behind a blank.
  for (std::size_t i = line.begin; i < end; ++i)
    if (text_[i] == '#' && (i == line.begin || is_white(text_[i - 1]))) end = i;
  while (end > line.begin && is_white(text_[end - 1])) --end;
  line.words = text_.substr(line.begin, end - line.begin);
  return line;
}

std::optional<SourceMap::Slip> SourceMap::slip_of_line(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto number = static_cast<std::size_t>(std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) -
                                               line_starts_.begin() - 1);
  const Line here = line(number);
  std::optional<Line> before;
  for (std::size_t k = number; k-- > 0 && !before;)
    if (const Line other = line(k); !other.words.empty()) before = other;
  for (const std::optional<Line>& looked_at : {before, std::optional<Line>(here)}) {
    if (!looked_at) continue;
    const std::string_view indentation = text_.substr(looked_at->begin - looked_at->indent, looked_at->indent);
    if (const std::size_t tab = indentation.find('\t'); tab != std::string_view::npos)
      return Slip{looked_at->begin - looked_at->indent + tab, "a tab stands in the indentation of this line",
                  "indent with blanks; most editors can replace tabs by them"};
  }
  const auto has_colon = [](std::string_view words) {
    return words.ends_with(':') || words.find(": ") != std::string_view::npos;
  };
  for (const std::optional<Line>& looked_at : {before, std::optional<Line>(here)}) {
    if (!looked_at || looked_at->words.empty()) continue;
    const std::string_view words = looked_at->words;
    if (const std::size_t key_end = words.find_first_of(" :=,'\"{}[]");
        key_end != std::string_view::npos && key_end > 0 && words[key_end] == ' ') {
      const std::size_t opening = words.find_first_not_of(' ', key_end);
      if (words[opening] == '{' || words[opening] == '[') {
        const std::string key(words.substr(0, key_end)), bracket(1, words[opening]);
        return Slip{looked_at->begin + key_end, "a ':' and a blank are missing behind '" + key + "'",
                    "write '" + key + ": " + bracket + "...'"};
      }
    }
    if (has_colon(words) || words.find_first_of("[]{}'\"|>") != std::string_view::npos || words.starts_with("-"))
      continue;
    std::size_t name = 0;
    while (name < words.size() && !is_white(words[name]) && words[name] != '=' && words[name] != ':') ++name;
    std::size_t value = name;
    while (value < words.size() && (is_white(words[value]) || words[value] == '=' || words[value] == ':')) ++value;
    if (name == 0 || value == name || value == words.size()) continue;
    const std::string key(words.substr(0, name)), rest(words.substr(value));
    const bool equals = words.substr(name, value - name).find('=') != std::string_view::npos;
    const std::string repair = "write '" + key + ": " + rest + "'";
    if (equals) return Slip{looked_at->begin + name, "'=' stands where a ':' is expected", repair};
    return Slip{looked_at->begin + name, "a ':' and a blank are missing behind '" + key + "'", repair};
  }
  if (here.words.starts_with("```"))
    return Slip{here.begin, "a line of Markdown stands here", "leave out the lines that begin with ```"};
  const bool heads_others = before && here.indent > before->indent && has_colon(here.words);
  if (heads_others && std::ranges::all_of(before->words, [](char c) {
        return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      }))
    return Slip{before->begin + before->words.size(), "a ':' is missing behind '" + std::string(before->words) + "'",
                "write '" + std::string(before->words) + ":'"};
  if (before && here.indent > before->indent && has_colon(here.words) && has_colon(before->words) &&
      !before->words.ends_with(':') && !before->words.starts_with("-"))
    return Slip{here.begin, "this line is indented farther than the one before it, which has a value already",
                "begin both in the same column"};
  return std::nullopt;
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
