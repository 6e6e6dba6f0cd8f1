#include "problem/answers/read_settings.h"

#include <algorithm>
#include <set>

#include "problem/language/diagnostic.h"
#include "problem/language/words.h"

namespace poinsot::problem {

Settings read_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets) {
  Settings settings;
  for (const auto& [name, text] : sets) {
    std::vector<std::string> known;
    const Situation* owner = nullptr;
    for (const Situation& situation : statement.situations) {
      const std::vector<std::string> names = settable_names(situation);
      if (!owner && std::find(names.begin(), names.end(), name) != names.end()) owner = &situation;
      known.insert(known.end(), names.begin(), names.end());
    }
    if (!owner) {
      std::string all;
      std::set<std::string> unique(known.begin(), known.end());
      for (const std::string& word : unique) all += (all.empty() ? "" : ", ") + word;
      const std::string hint = did_you_mean(name, known);
      fail("--set " + name, {}, "the problem has no letter or datum '" + name + "'",
           !hint.empty() ? hint
           : all.empty() ? "it has none at all"
                         : "it has " + all);
    }
    settings[name] = read_setting(*owner, name, text);
  }
  return settings;
}

FormulaValues exact_settings(const Statement& statement, const std::vector<std::pair<std::string, std::string>>& sets) {
  FormulaValues exact;
  for (const auto& [name, text] : sets)
    for (const Situation& situation : statement.situations) {
      const std::vector<std::string> names = settable_names(situation);
      if (std::find(names.begin(), names.end(), name) == names.end()) continue;
      exact[name] = exact_setting(situation, name, text);
      break;
    }
  return exact;
}

}  // namespace poinsot::problem
