#include "problem/instant/open_words.h"

#include <algorithm>

#include "problem/language/words.h"
#include "problem/machine/gimbal_lock.h"

namespace poinsot::problem {

std::string with_article(const std::string& name) { return name.starts_with("the ") ? name : "the " + name; }

namespace {

// The names of the unknowns that change in one open direction.
std::vector<std::string> moved_names(const solve::LinearSystem& equations, const solve::LinearSolution& solution,
                                     std::size_t direction, std::size_t first, std::size_t last,
                                     const std::set<std::string>& asked = {}) {
  std::vector<std::string> names;
  if (direction >= solution.share.size()) return names;
  for (std::size_t k : solution.share[direction])
    if (k >= first && k < last) names.emplace_back(equations.name(k));
  // What is asked of stands first, so that it is among those that are told.
  std::ranges::stable_partition(names, [&](const std::string& name) {
    return std::ranges::any_of(asked,
                               [&](const std::string& one) { return name.find("(" + one + ")") != std::string::npos; });
  });
  if (names.size() > 6) {
    names.resize(5);
    names.emplace_back("more");
  }
  return names;
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
  return listed(moved_names(equations, instant.motion(), direction, accelerations, equations.unknowns(), asked)) +
         " share the same load: the statement does not fix them one by one" + std::string(remedy_of_shares);
}

}  // namespace poinsot::problem
