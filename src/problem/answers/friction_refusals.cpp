#include "problem/answers/friction_refusals.h"

#include <algorithm>
#include <set>

#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/machine/data.h"
#include "problem/quantities/quantity_functions.h"

namespace poinsot::problem {
namespace {

void refuse_situation(const Situation& situation) {
  const auto rough =
      std::ranges::find_if(situation.contacts, [](const Contact& contact) { return contact.friction.has_value(); });
  if (rough == situation.contacts.end()) return;
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    fail(situation.file, rough->friction->mark, message, hint);
  };
  if (situation.has_blow())
    refuse("a blow with friction is not solved: how far contact '" + rough->name + "' slips meanwhile is not sought",
           "leave out the friction, or state no_slip: true where nothing slips");
  if (situation.steady)
    refuse("steady motions with friction are not sought: whether contact '" + rough->name +
               "' sticks or slides in one is not tried",
           "state no_slip: true where it rolls, or leave out the friction");
  if (std::ranges::any_of(situation.instants, [&](const Instant& instant) {
        return is_later(situation, instant) && (instant.rest || !instant.facts.empty());
      }))
    refuse("where contact '" + rough->name + "' has friction, nothing is found from what is stated of later instants",
           "state the start only, and ask of later instants");
  if (!situation.choose.empty())
    refuse("what is to be chosen is not sought where contacts have friction",
           "give it a value, or list it under find:");
  if (!situation.gravity)
    refuse("nothing is said of gravity, which decides how contact '" + rough->name + "' is pressed",
           "write gravity: -y or gravity: none");
}

const Mark& first_mark(const Statement& statement) {
  for (const Situation& situation : statement.situations)
    for (const Contact& contact : situation.contacts)
      if (contact.friction) return contact.friction->mark;
  static const Mark none{1, 1};
  return none;
}

}  // namespace

bool is_limit_of_sticking(const Ask& ask) {
  if (!ask.extremum || ask.extremum->conditions.empty()) return false;
  return std::ranges::all_of(ask.extremum->conditions, [](const Expression& condition) {
    const Call* call = condition.as<Call>();
    return call && call->function == "sticking";
  });
}

void refuse_beside_friction(const Statement& statement) {
  for (const Situation& situation : statement.situations) refuse_situation(situation);
  if (!statement.claims.empty())
    fail(statement.file, statement.claims.front().mark,
         "claims are not decided where contacts have friction: they would have to hold in every state of the contacts",
         "ask for the quantity, or leave out the friction");
  if (statement.record)
    fail(statement.file, first_mark(statement), "motions with friction are not recorded",
         "ask for tables over the time");
  for (const Ask& ask : statement.asks) {
    const std::vector<std::string> data = settable_names(statement.situations.front());
    if (ask.table && std::ranges::find(data, ask.table->over) != data.end())
      fail(statement.file, ask.mark,
           "tables over data are not made where contacts have friction: their states may differ from row to row",
           "ask for single values, with --set for others");
    if (ask.extremum && !is_limit_of_sticking(ask))
      fail(statement.file, ask.mark,
           "extrema are not sought where contacts have friction, but for the limit up to which they stick",
           "write {smallest: mu, while: sticking(floor)}");
    std::set<std::string> functions;
    for (const Expression& expression : ask.of) collect_functions(expression, functions, true);
    for (const std::string& name : functions) {
      const QuantityFunction* function = find_quantity(name);
      if (!function) continue;
      if (function->kind == QuantityKind::stability)
        fail(statement.file, ask.mark,
             name + "() is not told where contacts have friction: what is disturbed may stick or slide",
             "leave out the friction, or state no_slip: true where nothing slips");
    }
  }
}

}  // namespace poinsot::problem
