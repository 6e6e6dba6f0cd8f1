// Words of a text file line by line, for the mesh readers.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace poinsot::mesh_text {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

// A word for a message: printable, and cut off where it is long.
inline std::string shown(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 30)) text += (c >= 32 && c < 127) ? c : '?';
  return text + (word.size() > 30 ? "...'" : "'");
}

// The number that a word spells in full, in the C notation; not finite results are returned as they are.
inline std::optional<double> number(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  // Too small for a double is zero; too large is left to the caller's check for finite values.
  if (error == std::errc::result_out_of_range) {
    const bool small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return small ? 0.0 : HUGE_VAL;
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

inline bool equal_ignoring_case(std::string_view a, std::string_view lower) {
  if (a.size() != lower.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const char c = (a[i] >= 'A' && a[i] <= 'Z') ? static_cast<char>(a[i] - 'A' + 'a') : a[i];
    if (c != lower[i]) return false;
  }
  return true;
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t line() const { return line_; }

  // The next word on this line; empty at its end. A backslash at the end of a line joins the next line to it.
  std::string_view word_on_line() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') {
      if (joins_line(at_)) break;
      ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }
  // The next word on this line or a later one; empty at the end of the text.
  std::string_view word() {
    for (;;) {
      const std::string_view found = word_on_line();
      if (!found.empty() || at_ >= text_.size()) return found;
      skip_line();
    }
  }
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    if (at_ < text_.size()) {
      ++at_;
      ++line_;
    }
  }
  bool at_end() const { return at_ >= text_.size(); }

 private:
  // Length of a backslash with its line end at a place, or 0.
  std::size_t joins_line(std::size_t at) const {
    if (text_[at] != '\\') return 0;
    if (at + 1 < text_.size() && text_[at + 1] == '\n') return 2;
    if (at + 2 < text_.size() && text_[at + 1] == '\r' && text_[at + 2] == '\n') return 3;
    return 0;
  }
  void skip_blanks() {
    while (at_ < text_.size()) {
      if (is_blank(text_[at_])) {
        ++at_;
      } else if (const std::size_t join = joins_line(at_); join != 0) {
        at_ += join;
        ++line_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace poinsot::mesh_text
