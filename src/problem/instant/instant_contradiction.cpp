// The message if the equations of an instant contradict each other.
#include <algorithm>
#include <string_view>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/gimbal_lock.h"

namespace poinsot::problem {

void SolvedInstant::contradiction(const solve::LinearSystem& equations, const solve::LinearSolution& solution,
                                  bool forces) {
  std::vector<std::string> names;
  Mark mark{1, 1};
  std::optional<Mark> fact_mark;
  for (std::size_t equation : solution.conflict) {
    const std::string_view words = equations.words(equation);
    if (std::find(names.begin(), names.end(), words) == names.end()) names.emplace_back(words);
  }
  for (const auto* list : {&machine_.rates, &machine_.accelerations})
    for (const StatedRate& rate : *list)
      if (std::find(names.begin(), names.end(), rate.words) != names.end()) mark = rate.mark;
  for (const Instant* instant : facts_)
    for (const std::string& name : names) {
      if (name.starts_with("'" + instant->name + "'")) mark = instant->mark;
      for (const Fact& fact : instant->facts)
        if (name == "'" + instant->name + "': " + to_string(fact.quantity)) fact_mark = fact.mark;
    }
  if (fact_mark) mark = *fact_mark;
  std::string all;
  for (std::size_t i = 0; i < names.size() && i < 8; ++i) all += (all.empty() ? "" : "; ") + names[i];
  if (names.size() > 8) all += "; ...";
  const bool only_balance = forces && std::all_of(names.begin(), names.end(), [](const std::string& name) {
                              return name.starts_with("forces on ") || name.starts_with("moments on ");
                            });
  if (only_balance) {
    if (const auto lock = gimbal_lock(machine_, machine_.q))
      throw UnansweredError(situation_.file, mark, *lock + ": there they cannot follow the motion", beside_gimbal_lock);
    if (mark.line == 1 && !situation_.joints.empty()) mark = situation_.joints.front().mark;
    fail(situation_.file, mark, "nothing carries what the motion needs: " + all,
         "let a support or contact carry it, or leave a freedom for it");
  }
  if (mark.line == 1 && situation_.steady) mark = situation_.steady->mark;
  if (mark.line == 1 && !situation_.joints.empty()) mark = situation_.joints.front().mark;
  if (names.size() == 1)
    fail(situation_.file, mark, "this cannot hold: " + all + "; how the bodies are held does not allow it",
         "correct or remove it, or free what holds it");
  fail(situation_.file, mark, std::string("these cannot all hold together: ") + all, "correct or remove one of them");
}

}  // namespace poinsot::problem
