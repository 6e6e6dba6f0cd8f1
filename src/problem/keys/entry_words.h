// The words that occur in the texts of a file and could be names.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "problem/language/tree.h"

namespace poinsot::problem {

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

enum class Keys { left_out, too };

inline void collect_words(const Entry& entry, Keys keys, std::set<std::string>& words) {
  collect_words(entry.text, words);
  for (const Entry& item : entry.items) collect_words(item, keys, words);
  for (const auto& [key, value] : entry.members) {
    if (keys == Keys::too) collect_words(key.text, words);
    collect_words(value, keys, words);
  }
}

}  // namespace poinsot::problem
