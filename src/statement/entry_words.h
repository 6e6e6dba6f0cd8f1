// The words of a file's texts: what may be names.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "poinsot/statement/tree.h"

namespace poinsot::statement {

inline void collect_words(std::string_view text, std::set<std::string>& words) {
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.insert(word);
    word.clear();
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      word += c;
    else
      end_word();
  }
  end_word();
}

// Of values, not of keys.
inline void collect_words(const Entry& entry, std::set<std::string>& words) {
  collect_words(entry.text, words);
  for (const Entry& item : entry.items) collect_words(item, words);
  for (const auto& [key, value] : entry.members) collect_words(value, words);
}

}  // namespace poinsot::statement
