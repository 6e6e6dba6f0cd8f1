#include "statement/unused_unknowns.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "statement/entry_words.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

void collect_all_words(const Entry& entry, std::set<std::string>& words) {
  collect_words(entry.text, words);
  for (const Entry& item : entry.items) collect_all_words(item, words);
  for (const auto& [key, value] : entry.members) {
    collect_words(key.text, words);
    collect_all_words(value, words);
  }
}

// What is asked, claimed or expected of an unknown does not fix it. sections: of the file, or of one of its situations.
void collect_fixing_words(const Entry& sections, std::set<std::string>& words) {
  static constexpr std::array asking{"ask", "claim", "expect", "find", "title"};
  for (const auto& [key, section] : sections.members) {
    if (std::ranges::find(asking, key.text) != asking.end()) continue;
    if (key.text != "situations") {
      collect_all_words(section, words);
      continue;
    }
    for (const auto& [name, situation] : section.members) collect_fixing_words(situation, words);
  }
}

}  // namespace

void check_unused_unknowns(const Entry& root, const Problem& problem) {
  if (problem.find.empty()) return;
  std::set<std::string> words;
  collect_fixing_words(root, words);
  for (const Unknown& unknown : problem.find)
    if (!words.contains(unknown.name))
      fail(problem.file, unknown.mark,
           "the unknown '" + unknown.name + "' stands nowhere in the figure and the facts: nothing can fix it",
           "write it where its value belongs, or remove it");
}

}  // namespace poinsot::statement
