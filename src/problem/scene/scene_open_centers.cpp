#include "problem/scene/scene_open_centers.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace poinsot::problem {
namespace {

std::optional<Expression> coordinate(const Expression& place, std::size_t i, const Situation& situation) {
  if (const List* list = place.as<List>(); list != nullptr && list->items.size() == 3) return list->items[i];
  if (place.as<Name>() != nullptr)
    return Expression{
        std::make_shared<const Node>(Node{Member{place, situation.axes[i]}, place.mark(), place->height + 1})};
  return std::nullopt;
}

bool is_open(const Body& body) {
  const List* list = body.center ? body.center->as<List>() : nullptr;
  return list != nullptr && list->items.size() == 3 && std::any_of(list->items.begin(), list->items.end(), is_any);
}

// Where a joint holds the body or is held by it.
std::optional<Expression> held_place(const Body& body, const Situation& situation) {
  for (const Joint& joint : situation.joints)
    if (joint.to == body.name || joint.from == body.name)
      if (std::optional<Expression> place = joint.at ? joint.at : std::optional(joint.place);
          coordinate(*place, 0, situation))
        return place;
  return std::nullopt;
}

}  // namespace

std::optional<Statement> with_open_centers_at_joints(const Statement& statement) {
  std::optional<Statement> placed;
  for (std::size_t s = 0; s < statement.situations.size(); ++s)
    for (std::size_t k = 0; k < statement.situations[s].bodies.size(); ++k) {
      const Situation& situation = statement.situations[s];
      const std::optional<Expression> place =
          is_open(situation.bodies[k]) ? held_place(situation.bodies[k], situation) : std::nullopt;
      if (!place) continue;
      List center = *situation.bodies[k].center->as<List>();
      for (std::size_t i = 0; i < 3; ++i)
        if (is_any(center.items[i])) center.items[i] = *coordinate(*place, i, situation);
      if (!placed) placed = statement;
      Expression& replaced = *placed->situations[s].bodies[k].center;
      replaced = {std::make_shared<const Node>(Node{std::move(center), replaced->mark, replaced->height + 1})};
    }
  return placed;
}

}  // namespace poinsot::problem
