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

void check_coordinates_of(const Situation& situation, const std::set<std::string>& used) {
  std::set<std::string> known;
  for (const NamedExpression& datum : situation.given) known.insert(datum.name);
  for (const Letter& letter : situation.letters) known.insert(letter.name);
  for (const Unknown& unknown : situation.find) known.insert(unknown.name);
  std::vector<std::string> unused;
  std::copy_if(known.begin(), known.end(), std::back_inserter(unused),
               [&](const std::string& name) { return !used.contains(name); });
  if (unused.empty()) return;
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms) {
      const Name* name = freedom.position ? freedom.position->as<Name>() : nullptr;
      if (!name || known.contains(name->name)) continue;
      const std::string near = nearest(name->name, unused);
      if (near.empty()) continue;
      fail(situation.file, freedom.position->mark(),
           "'" + name->name + "' is no datum, and '" + near + "', which is one, is used nowhere",
           "did you mean '" + near + "'? If '" + name->name + "' is to name a coordinate, remove '" + near + "'");
    }
}

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

void check_misspelt_coordinates(const Entry& root, const Statement& statement) {
  std::set<std::string> used;
  collect_words(root, Keys::left_out, used);
  for (const Situation& situation : statement.situations) check_coordinates_of(situation, used);
}

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
