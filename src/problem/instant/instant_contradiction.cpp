// The message if the equations of an instant contradict each other.
#include <optional>
#include <string>
#include <vector>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/machine/gimbal_lock.h"

namespace poinsot::problem {

namespace {

// The joints at which a motor is not stated that what is stated of accelerations may need.
std::string hint_at_motors(const Situation& situation) {
  std::vector<std::string> couples, forces;
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (!freedom.accel && !freedom.effort && !freedom.stiffness && !freedom.damping && !freedom.friction)
        add_once(freedom.turning ? couples : forces, "'" + joint.name + "'");
  std::string where;
  for (const auto* names : {&couples, &forces})
    if (!names->empty())
      where += (where.empty() ? "" : ", ") + std::string(names == &couples ? "couple" : "force") + ": any at joint" +
               (names->size() > 1 ? "s " : " ") + joined(*names);
  return where.empty() ? "" : "; if motors make it move so, write " + where;
}

}  // namespace

const solve::LinearSystem& SolvedInstant::equations_of(System system) const {
  return system == System::velocities ? velocity_equations_
         : system == System::blow     ? blow_equations_
                                      : motion_equations_;
}

void SolvedInstant::contradiction(System system, const solve::LinearSolution& solution) {
  const solve::LinearSystem& equations = equations_of(system);
  std::vector<std::string> names;
  std::optional<Mark> rate_mark, rest_mark, fact_mark;
  bool only_balance = system == System::motion;
  for (std::size_t equation : solution.conflict) {
    add_once(names, std::string(equations.words(equation)));
    const solve::EquationKind kind = equations.source(equation).kind;
    only_balance = only_balance && kind == solve::EquationKind::balance;
    const ConditionSource source = source_of(system, equation);
    if (source.mark == Mark{}) continue;
    (source.fact ? fact_mark : source.instant ? rest_mark : rate_mark) = source.mark;
  }
  // A fact is the easiest to correct.
  Mark mark = fact_mark ? *fact_mark : rest_mark ? *rest_mark : rate_mark.value_or(Mark{1, 1});
  std::string all;
  for (std::size_t i = 0; i < names.size() && i < 8; ++i) all += (all.empty() ? "" : "; ") + names[i];
  if (names.size() > 8) all += "; ...";
  if (only_balance) {
    if (const auto lock = gimbal_lock(machine_, machine_.q))
      throw UnansweredError(situation_.file, mark, *lock + ": there they cannot follow the motion", beside_gimbal_lock);
    if (mark.line == 1 && !situation_.joints.empty()) mark = situation_.joints.front().mark;
    throw ContradictionError(situation_.file, mark, "nothing carries what the motion needs: " + all,
                             "let a support or contact carry it, or leave a freedom for it");
  }
  if (mark.line == 1 && situation_.steady) mark = situation_.steady->mark;
  if (mark.line == 1 && !situation_.joints.empty()) mark = situation_.joints.front().mark;
  // Of velocities it may be the angles alone that do not allow what the bodies could do.
  if (const auto lock = system == System::velocities ? gimbal_lock(machine_, machine_.q) : std::nullopt)
    throw ContradictionError(situation_.file, mark,
                             (names.size() == 1 ? "this cannot hold: " : "these cannot all hold together: ") + all +
                                 "; in this pose " + *lock + ", which leaves no turning about one of three lines",
                             std::string("correct or remove it, or ") + beside_gimbal_lock);
  if (names.size() == 1)
    throw ContradictionError(situation_.file, mark,
                             "this cannot hold: " + all + "; how the bodies are held does not allow it",
                             "correct or remove it, or free what holds it");
  throw ContradictionError(
      situation_.file, mark, std::string("these cannot all hold together: ") + all,
      "correct or remove one of them" + (system == System::motion && fact_mark ? hint_at_motors(situation_) : ""));
}

}  // namespace poinsot::problem
