#include "problem/plane/planar_statement.h"

#include <algorithm>
#include <utility>

#include "problem/keys/joint_kinds.h"
#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/plane/planar_words.h"

namespace poinsot::problem {
namespace {

using Pointing = PlanarWords::Pointing;

void refuse_joints(const Situation& situation) {
  const std::string normal = situation.axes[situation.plane->normal()];
  for (const Joint& joint : situation.joints)
    if (joint.kind->any_turning || joint.kind->advances || joint.kind->name == "universal" ||
        joint.kind->name == "cylindrical")
      fail(
          situation.file, joint.mark,
          "joint '" + joint.name + "' moves across the plane, as a " + joint.kind->name + " joint does",
          "in a plane a pin is revolute: " + normal + ", a guide prismatic: " + situation.axes[situation.plane->first]);
}

// A couple that is a number is one about the normal.
template <class Pushed>
void give_axes(const PlanarWords& words, std::vector<Pushed>& pushes) {
  for (Pushed& push : pushes)
    if (push.couple && !push.direction && !push.couple->template as<List>() &&
        words.pointing(*push.couple) == Pointing::none)
      push.direction = words.normal(push.couple->mark());
}

void restrict_fact(const PlanarWords& words, Fact& fact) {
  const bool number = !fact.value.as<List>() && words.pointing(fact.value) == Pointing::none;
  fact.quantity = words.with_numbers(fact.quantity);
  const Pointing pointing = words.pointing(fact.quantity);
  if (pointing == Pointing::normal && number) fact.quantity = words.as_number(fact.quantity);
  if (pointing == Pointing::in_plane) fact.value = words.as_vector(fact.value, built(Name{"any"}, fact.value.mark()));
}

// A list by itself is one of several things.
bool is_vector(const PlanarWords& words, const Expression& asked) {
  return !asked.as<List>() && words.pointing(asked) == Pointing::in_plane;
}

void restrict_ask(const PlanarWords& words, Ask& ask) {
  std::vector<Expression> asked;
  for (const Expression& stated : ask.of) {
    const Expression one = words.as_number(stated);
    if (!is_vector(words, one)) {
      asked.push_back(one);
    } else if (ask.is_list) {
      asked.push_back(built(List{words.components(one)}, one.mark()));
    } else {
      asked = words.components(one);
    }
  }
  if (asked.size() > ask.of.size()) ask.is_list = true;
  ask.of = std::move(asked);
  if (ask.extremum)
    for (Expression& condition : ask.extremum->conditions) condition = words.with_numbers(condition);
  if (ask.when) ask.when->condition = words.with_numbers(ask.when->condition);
  if (ask.table)
    for (NamedExpression& column : ask.table->columns) {
      column.value = words.as_number(column.value);
      if (is_vector(words, column.value))
        column.value = built(List{words.components(column.value)}, column.value.mark());
    }
}

void restrict_situation(Situation& situation) {
  refuse_joints(situation);
  const PlanarWords words(situation);
  give_axes(words, situation.loads);
  give_axes(words, situation.impulses);
  give_axes(words, situation.excitations);
  for (Instant& instant : situation.instants) {
    for (Fact& fact : instant.facts) restrict_fact(words, fact);
    if (instant.found_when) instant.found_when = words.with_numbers(*instant.found_when);
  }
  for (Stage& stage : situation.stages)
    if (stage.until) stage.until = words.with_numbers(*stage.until);
  for (auto* list : {&situation.where, &situation.assume})
    for (Expression& condition : *list) condition = words.with_numbers(condition);
  for (NamedExpression& item : situation.define) item.value = words.with_numbers(item.value);
  // Whoever looks at the plane sees its first axis run to the right.
  if (situation.view.empty()) {
    const std::string towards = situation.plane->sign() > 0 ? "1" : "-1";
    for (std::size_t k = 0; k < 3; ++k)
      situation.view += (k > 0 ? "," : "") + (k == situation.plane->normal() ? towards : "0");
  }
}

}  // namespace

void restrict_to_plane(Statement& statement) {
  const Situation& first = statement.situations.front();
  if (!first.plane) return;
  const PlanarWords words(first);
  for (Ask& ask : statement.asks) restrict_ask(words, ask);
  for (Claim& claim : statement.claims)
    for (auto* list : {&claim.of, &claim.assume})
      for (Expression& one : *list) one = words.with_numbers(one);
  if (statement.record)
    for (NamedExpression& column : statement.record->columns) column.value = words.as_number(column.value);
  for (Situation& situation : statement.situations) restrict_situation(situation);
}

}  // namespace poinsot::problem
