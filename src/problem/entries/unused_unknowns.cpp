#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "problem/entries/name_checks.h"
#include "problem/keys/entry_words.h"
#include "problem/keys/reader.h"

namespace poinsot::problem {
namespace {

// Collects the words of all sections that can fix an unknown. Being asked, claimed or expected does not. sections:
// those of the file, or of one situation.
void collect_fixing_words(const Entry& sections, std::set<std::string>& words) {
  static constexpr std::array asking{"ask", "claim", "expect", "find", "title"};
  for (const auto& [key, section] : sections.members) {
    if (std::ranges::find(asking, key.text) != asking.end()) continue;
    if (key.text != "situations") {
      collect_words(section, Keys::too, words);
      continue;
    }
    for (const auto& [name, situation] : section.members) collect_fixing_words(situation, words);
  }
}

}  // namespace

bool has_corners(const Entry& root) {
  std::set<std::string> words;
  collect_fixing_words(root, words);
  return std::ranges::any_of(std::array{"abs", "norm", "max", "min", "acute_angle"},
                             [&](const char* function) { return words.contains(function); });
}

void check_unused_unknowns(const Entry& root, const Statement& statement) {
  std::set<std::string> words;
  collect_fixing_words(root, words);
  std::vector<std::string> names(words.begin(), words.end());
  std::erase_if(names, [](const std::string& word) { return word.front() >= '0' && word.front() <= '9'; });
  for (const Situation& situation : statement.situations)
    for (const Unknown& unknown : situation.find)
      if (!words.contains(unknown.name) && nearest(unknown.name, names).empty())
        fail(statement.file, unknown.mark,
             "the unknown '" + unknown.name + "' stands nowhere in the figure and the facts: nothing can fix it",
             "write it where its value belongs, or remove it");
}

}  // namespace poinsot::problem
