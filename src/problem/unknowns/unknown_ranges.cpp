#include "problem/unknowns/unknown_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/language/diagnostic.h"
#include "problem/language/expression_walk.h"
#include "problem/quantities/asks_model.h"
#include "problem/unknowns/sample.h"

namespace poinsot::problem {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_bare(const Expression& expression, const std::string& name) {
  if (const Unary* unary = expression.as<Unary>()) return is_bare(unary->operand, name);
  const Name* word = expression.as<Name>();
  return word && word->primes == 0 && word->name == name;
}
bool is_bare(const std::optional<Expression>& expression, const std::string& name) {
  return expression && is_bare(*expression, name);
}
// Whether the name is an item of a list of coordinates, or of a list of places.
bool stands_in(const Expression& place, const std::string& name) {
  const List* list = place.as<List>();
  return list && std::any_of(list->items.begin(), list->items.end(),
                             [&](const Expression& item) { return is_bare(item, name) || stands_in(item, name); });
}
bool stands_in(const std::optional<Expression>& place, const std::string& name) {
  return place && stands_in(*place, name);
}

template <class Visit>
bool any_shape_argument(const Situation& situation, Visit&& visit) {
  for (const Body& body : situation.bodies)
    for (const auto* parts : {&body.parts, &body.added})
      for (const poinsot::problem::Part& part : *parts)
        for (const NamedExpression& argument : part.shape.arguments)
          if (visit(argument.value)) return true;
  return false;
}

// Whether `holds` is true of an expression that plays this part in a law of force.
template <class Holds>
bool any_part_of_laws(const Situation& situation, LawPart wanted, const Holds& holds) {
  bool any = false;
  for_each_stated_law(situation, [&](const auto& law) {
    law.for_each_part([&](LawPart part, const std::optional<Expression>& expression) {
      any = any || (part == wanted && holds(expression));
    });
  });
  return any;
}

// Whether the name is an extent: a radius, a side, or the length of a relaxed spring.
bool is_extent(const Situation& situation, const std::string& name) {
  return any_shape_argument(situation, [&](const Expression& argument) { return is_bare(argument, name); }) ||
         any_part_of_laws(situation, LawPart::extent, [&](const auto& part) { return is_bare(part, name); });
}

// Whether the name is a coordinate of a place or a displacement, which may have either sign.
bool is_coordinate(const Situation& situation, const std::string& name) {
  const auto any_of = [](const auto& list, const auto& holds) { return std::any_of(list.begin(), list.end(), holds); };
  return any_of(situation.points, [&](const NamedExpression& point) { return stands_in(point.value, name); }) ||
         any_shape_argument(situation, [&](const Expression& argument) { return stands_in(argument, name); }) ||
         any_of(situation.bodies, [&](const Body& body) { return stands_in(body.center, name); }) ||
         any_of(situation.joints,
                [&](const Joint& joint) {
                  return stands_in(joint.place, name) || stands_in(joint.at, name) ||
                         any_of(joint.freedoms, [&](const Freedom& freedom) {
                           return is_bare(freedom.position, name) || is_bare(freedom.free_position, name);
                         });
                }) ||
         any_part_of_laws(situation, LawPart::place, [&](const auto& part) { return stands_in(part, name); }) ||
         any_of(situation.impulses, [&](const Impulse& impulse) { return stands_in(impulse.at, name); }) ||
         any_of(situation.instants, [&](const Instant& instant) {
           return any_of(instant.facts, [&](const Fact& fact) {
             return level_of(situation, fact.quantity) == Level::position && is_bare(fact.value, name);
           });
         });
}

// Whether the name is the mass, weight or density of something.
bool is_amount(const Situation& situation, const std::string& name) {
  const auto states = [&](const Amount& amount) {
    return is_bare(amount.mass, name) || is_bare(amount.weight, name) || is_bare(amount.density, name) ||
           is_bare(amount.specific_weight, name);
  };
  return std::ranges::any_of(situation.bodies, [&](const Body& body) {
    const auto any_of = [&](const std::vector<poinsot::problem::Part>& parts) {
      return std::ranges::any_of(parts, states, &poinsot::problem::Part::amount);
    };
    return states(body.amount) || any_of(body.parts) || any_of(body.added);
  });
}

// Whether the name is a stiffness or a damping constant. These are not negative.
bool is_resistance(const Situation& situation, const std::string& name) {
  for (const Joint& joint : situation.joints)
    for (const Freedom& freedom : joint.freedoms)
      if (is_bare(freedom.stiffness, name) || is_bare(freedom.damping, name)) return true;
  return any_part_of_laws(situation, LawPart::resistance, [&](const auto& part) { return is_bare(part, name); });
}

// Whether the name belongs to an amount that may be chosen. These can only push.
bool is_chosen_push(const Statement& statement, const Situation& situation, const std::string& name) {
  return std::any_of(situation.choose.begin(), situation.choose.end(), [&](const Choice& choice) {
    return std::any_of(choice.of.begin(), choice.of.end(),
                       [&](const std::string& amount) { return unknowns_of_amount(statement, amount).contains(name); });
  });
}

// Whether the expression asks for a quantity of the model, and not for data and unknowns only.
bool asks_quantity(const Situation& situation, const Expression& expression) {
  Situation bare = situation;
  bare.find.clear();
  bare.choose.clear();
  return asks_model(bare, expression);
}

// The quantity at the start, or just after a blow. Contradictions in the statement are found later, for each root.
Value<double> quantity_at(const Situation& situation, const Settings& settings, const Expression& condition) {
  OpenChoice choice;
  choice.trial = true;
  SolvedInstant instant(situation, settings, When{0, situation.has_blow()}, choice);
  return instant.raw(condition, std::nullopt, nullptr);
}

}  // namespace

bool is_amount_of_matter(const Situation& situation, const Unknown& unknown) {
  return unknown.unit.dimension == dimensions::mass || is_amount(situation, unknown.name);
}

bool is_never_negative(const Statement& statement, const Situation& situation, const Unknown& unknown) {
  if (unknown.vector) return false;
  // No body has a negative mass, whatever sign its unknown may have elsewhere.
  if (is_amount(situation, unknown.name)) return true;
  if (unknown.either_sign) return false;
  const Dimension& d = unknown.unit.dimension;
  if (d == dimensions::time) return true;
  if (d == dimensions::length) return is_extent(situation, unknown.name) || !is_coordinate(situation, unknown.name);
  return is_amount_of_matter(situation, unknown) || is_resistance(situation, unknown.name) ||
         is_chosen_push(statement, situation, unknown.name);
}

void narrow_ranges(const Situation& situation, const Settings& settings, std::vector<solve::RootRange>& ranges,
                   const SlotOf& slot_of) {
  for (const Expression& condition : situation.where) {
    const Comparison* comparison = condition.as<Comparison>();
    if (!comparison)
      fail(situation.file, condition.mark(), "a condition under where: is a comparison", "write 0 deg < b < 90 deg");
    if (std::find(comparison->relations.begin(), comparison->relations.end(), Relation::equal) !=
        comparison->relations.end())
      fail(situation.file, beginning(condition),
           "'" + to_string(condition) +
               "' fixes something: under where: stand bounds, by which solutions are told apart",
           "state it as a fact: facts: {\"" + to_string(comparison->operands.front()) +
               "\": " + to_string(comparison->operands.back()) + "}");
    for (std::size_t i = 0; i + 1 < comparison->operands.size(); ++i) {
      const Expression &left = comparison->operands[i], &right = comparison->operands[i + 1];
      const bool less = comparison->relations[i] == Relation::less || comparison->relations[i] == Relation::less_equal;
      const bool greater =
          comparison->relations[i] == Relation::greater || comparison->relations[i] == Relation::greater_equal;
      const auto value_of = [&](const Expression& e) -> std::optional<double> {
        DataScope<double> data(situation, settings);
        try {
          const Value<double> value = data.value(e);
          return value.is_number() ? std::optional(value.number) : std::nullopt;
        } catch (const StatementError&) {
          return std::nullopt;  // the bound depends on an unknown
        }
      };
      for (const auto& [name, bound, above] : {std::tuple{&left, &right, greater}, std::tuple{&right, &left, less}}) {
        const Name* word = name->template as<Name>();
        const auto slot = word && word->primes == 0 ? slot_of(word->name) : std::nullopt;
        const auto value = slot ? value_of(*bound) : std::nullopt;
        if (!value || !(less || greater)) continue;
        solve::RootRange& range = ranges[*slot];
        const bool open = comparison->relations[i] == Relation::less || comparison->relations[i] == Relation::greater;
        if (above && *value >= range.lower) {
          range.lower = *value;
          range.lower_open = open;
        } else if (!above && *value <= range.upper) {
          range.upper = *value;
          range.upper_open = open;
        }
      }
    }
  }
}

bool satisfies_where(const Statement& statement, const std::vector<std::size_t>& situations,
                     const AllSettings& settings, const std::set<std::string>& sought) {
  for (std::size_t i : situations)
    for (const Expression& condition : statement.situations[i].where) {
      // A condition on unknowns that are found later is judged when they are.
      std::set<std::string> names;
      collect_names(condition, names);
      const bool later = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return sought.contains(name) && !settings[i].contains(name);
      });
      if (later) continue;
      const Situation& situation = statement.situations[i];
      Value<double> value;
      if (asks_quantity(situation, condition)) {
        // A condition on a quantity is judged once all unknowns of the situation have values.
        if (std::any_of(situation.find.begin(), situation.find.end(),
                        [&](const Unknown& unknown) { return !settings[i].contains(unknown.name); }))
          continue;
        value = quantity_at(situation, settings[i], condition);
      } else {
        value = DataScope<double>(situation, settings[i]).value(condition);
      }
      if (value.is_boolean() && !value.truth) return false;
    }
  return true;
}

namespace {

// Infinite ranges, narrowed as stated.
std::vector<solve::RootRange> stated_ranges(const Statement& statement, const UnknownSystem& system,
                                            const AllSettings& settings) {
  const std::vector<UnknownSlot> slots = system.slots(statement);
  std::vector<solve::RootRange> ranges(slots.size(), {-infinite, infinite, 1});
  for (std::size_t i : system.situations())
    narrow_ranges(statement.situations[i], settings[i], ranges,
                  [&](const std::string& name) -> std::optional<std::size_t> {
                    for (std::size_t k = 0; k < slots.size(); ++k)
                      if (slots[k].unknown.name == name && !slots[k].unknown.vector) return k;
                    return std::nullopt;
                  });
  return ranges;
}

}  // namespace

std::vector<std::size_t> lengths_of_doubtful_sign(const Statement& statement, const UnknownSystem& system,
                                                  const AllSettings& settings) {
  const std::vector<UnknownSlot> slots = system.slots(statement);
  const std::vector<std::size_t> situations = system.situations();
  const Situation& situation = statement.situations[situations.empty() ? 0 : situations.front()];
  const std::vector<solve::RootRange> ranges = stated_ranges(statement, system, settings);
  std::vector<std::size_t> doubtful;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Unknown& unknown = slots[k].unknown;
    const bool open = !std::isfinite(ranges[k].lower) && !(ranges[k].upper <= 0);
    if (open && unknown.unit.dimension == dimensions::length && is_never_negative(statement, situation, unknown) &&
        !is_extent(situation, unknown.name))
      doubtful.push_back(k);
  }
  return doubtful;
}

std::vector<solve::RootRange> ranges_of(const Statement& statement, const UnknownSystem& system,
                                        const AllSettings& settings, const std::vector<double>& natural) {
  const std::vector<UnknownSlot> slots = system.slots(statement);
  const std::vector<std::size_t> situations = system.situations();
  const Situation& situation = statement.situations[situations.empty() ? 0 : situations.front()];
  std::vector<solve::RootRange> ranges = stated_ranges(statement, system, settings);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    // The stated unit of an unknown is its natural size, unless the sizes in the problem are of a very different
    // order: four decades, as people choose units within a thousand of what they measure.
    constexpr double far = 1e4;
    ranges[k].scale = slots[k].unknown.unit.factor;
    const double ratio = natural[k] / ranges[k].scale;
    if (std::isfinite(ratio) && ratio > 0 && (ratio > far || ratio < 1 / far)) ranges[k].scale = natural[k];
  }
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Unknown& unknown = slots[k].unknown;
    solve::RootRange& range = ranges[k];
    const bool open = !std::isfinite(range.lower) && !(range.upper <= 0);
    if (open && is_never_negative(statement, situation, unknown)) range.lower = 0;
    if (unknown.unit.dimension == dimensions::angle) {
      constexpr double half_turn = 3.141592653589793;
      range.scale = 1;
      if (!std::isfinite(range.lower))
        range.lower = range.upper > -half_turn ? -half_turn : range.upper - 2 * half_turn;
      if (!std::isfinite(range.upper)) range.upper = range.lower < half_turn ? half_turn : range.lower + 2 * half_turn;
    }
    // A narrow range is its own natural size.
    if (const double half = (range.upper - range.lower) / 2; half > 0) range.scale = std::min(range.scale, half);
  }
  return ranges;
}

}  // namespace poinsot::problem
