#include "problem/instant/open_words.h"

#include <algorithm>
#include <iterator>

#include "problem/language/words.h"
#include "problem/machine/gimbal_lock.h"

namespace poinsot::problem {

std::string with_article(const std::string& name) { return name.starts_with("the ") ? name : "the " + name; }

namespace {

// The names of the unknowns that change in one open direction. Those that are asked for stand first, so that they are
// among those that are told.
std::vector<std::string> moved_names(const solve::LinearSystem& equations, const solve::LinearSolution& solution,
                                     std::size_t direction, std::size_t first, std::size_t last,
                                     const std::set<std::size_t>& asked = {}) {
  std::vector<std::size_t> moved;
  if (direction < solution.share.size())
    std::ranges::copy_if(solution.share[direction], std::back_inserter(moved),
                         [&](std::size_t k) { return k >= first && k < last; });
  std::stable_partition(moved.begin(), moved.end(), [&](std::size_t k) { return asked.contains(k); });
  std::vector<std::string> names;
  for (const std::size_t k : moved) names.emplace_back(equations.name(k));
  if (names.size() > 6) {
    names.resize(5);
    names.emplace_back("more");
  }
  return names;
}

// The unknowns of the equations of motion that are forces of what these names stand for.
std::set<std::size_t> forces_of(const Machine& machine, const std::set<std::string>& names) {
  std::set<std::size_t> actions, unknowns;
  for (const std::string& name : names) {
    const std::vector<std::size_t> own = machine.actions_of(name);
    actions.insert(own.begin(), own.end());
  }
  const solve::ForceUnknowns count = solve::force_unknowns(machine.mechanism);
  for (std::size_t k = 0; k < count.components; ++k)
    if (actions.contains(static_cast<std::size_t>(machine.mechanism.components[k].action)))
      unknowns.insert(count.accelerations + k);
  return unknowns;
}

std::string remedy_of(const SolvedInstant& instant) {
  if (const auto lock = gimbal_lock(instant.machine(), instant.machine().q)) return *lock + ": " + beside_gimbal_lock;
  return "state it, or the couple or force that causes it";
}

}  // namespace

std::string open_velocities(std::vector<std::string> names, std::size_t missing) {
  const std::size_t count = names.size();
  if (count > 6) {
    names.resize(5);
    names.emplace_back("more");
  }
  const std::string enough = missing >= count ? ""
                                              : " (" + (missing == 1 ? std::string("one") : std::to_string(missing)) +
                                                    " of them would do, or another fact)";
  return "nothing fixes " + listed(names) + enough + ": state " + (count == 1 || missing == 1 ? "it" : "them") +
         " under joints: or instants:";
}

std::string open_force(const SolvedInstant& instant, std::size_t direction, const std::set<std::string>& asked) {
  if (instant.after_blow() && !instant.forces_solved()) {
    const std::vector<std::string> names =
        moved_names(instant.blow_equations(), instant.blow(), direction, 0, instant.blow_equations().unknowns());
    return "the blow does not fix " + listed(names, "and") +
           (names.size() > 1 ? " one by one" : ": state it under instants: {after: ...}");
  }
  // This is a motion after a blow that does not determine how it starts.
  if (!instant.forces_solved()) return "the blow does not fix all velocities after it";
  const auto& equations = instant.motion_equations();
  const std::size_t accelerations = solve::force_unknowns(instant.machine().mechanism).accelerations;
  std::vector<std::string> motions = moved_names(equations, instant.motion(), direction, 0, accelerations);
  for (std::string& name : motions)
    if (name != "more") name = with_article(name);
  if (!motions.empty()) return "nothing fixes " + listed(motions) + ": " + remedy_of(instant);
  return listed(moved_names(equations, instant.motion(), direction, accelerations, equations.unknowns(),
                            forces_of(instant.machine(), asked))) +
         " share the same load: the statement does not fix them one by one" + std::string(remedy_of_shares);
}

}  // namespace poinsot::problem
