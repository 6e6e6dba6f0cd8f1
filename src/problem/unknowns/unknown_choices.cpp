// Finds unknowns of which some are chosen (`choose:`). Those that belong to what is not chosen are zero.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/unknowns/choice_clash.h"
#include "problem/unknowns/choice_witness.h"
#include "problem/unknowns/unknown_blocks.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {
namespace {

// The part of the size of the terms that rounding leaves of conditions which hold without any amounts: some thousand
// roundings. With more, small amounts that make up for a small fault would be passed over.
constexpr double holds_by_itself = 1e-12;
// The part by which totals differ that are not alike: roots are found to this.
constexpr double same_total = 1e-9;

std::string place_of(const Statement& statement, const Mark& mark) {
  return statement.file + ":" + std::to_string(mark.line) + ":" + std::to_string(mark.column) + ": ";
}

// The values that a root gives to the slots; nothing where one is a vector or has none.
std::optional<std::vector<double>> values_of_slots(const std::vector<UnknownSlot>& slots, const AllSettings& root) {
  std::vector<double> values;
  for (const UnknownSlot& slot : slots) {
    if (slot.unknown.vector) return std::nullopt;
    for (const Settings& one : root)
      if (const auto value = one.find(slot.unknown.name); value != one.end()) {
        values.push_back(value->second.number);
        break;
      }
  }
  if (values.size() != slots.size()) return std::nullopt;
  return values;
}

// What a second road finds against the roots of a choice.
std::optional<std::string> doubt_of(const Statement& statement, UnknownEquations& equations, const Choice& choice,
                                    const std::vector<AllSettings>& roots) {
  // What must hold besides may exclude what fulfils the equations.
  for (const Situation& situation : statement.situations)
    if (!situation.where.empty() || !situation.contacts.empty() || !situation.cords.empty()) return std::nullopt;
  const std::vector<UnknownSlot>& slots = equations.slots();
  std::vector<std::vector<std::size_t>> amounts;
  for (const std::string& name : choice.of) {
    const std::set<std::string> unknowns = unknowns_of_amount(statement, name);
    std::vector<std::size_t>& own = amounts.emplace_back();
    for (std::size_t k = 0; k < slots.size(); ++k)
      if (unknowns.contains(slots[k].unknown.name)) own.push_back(k);
  }
  ChoicesFound found;
  if (!choice.least_total) found.exactly = static_cast<int>(choice.exactly);
  for (const AllSettings& root : roots) {
    const auto values = values_of_slots(slots, root);
    if (!values) return std::nullopt;
    found.solutions.push_back(*values);
  }
  return choice_doubt(equations, amounts, found);
}

}  // namespace

RootsFound UnknownSearch::find_with_choices(const UnknownSystem& system, const AllSettings& settings) {
  std::vector<const Choice*> choices;
  for (std::size_t i : system.situations())
    for (const Choice& choice : statement_.situations[i].choose)
      if (std::none_of(choices.begin(), choices.end(), [&](const Choice* other) { return other->name == choice.name; }))
        choices.push_back(&choice);
  if (choices.empty()) return find_by_blocks(system, settings);
  if (choices.size() > 1) fail(statement_.file, choices[1]->mark, "only one choice can be made in a problem");
  const Choice& choice = *choices.front();
  // What does not depend on the choice is found first.
  std::set<std::string> chosen_unknowns;
  for (const std::string& name : choice.of) chosen_unknowns.merge(unknowns_of_amount(statement_, name));
  UnknownSystem rest = system;
  RootsFound all;
  all.roots.push_back(settings);
  UnknownEquations equations = equations_of(system, settings);
  for (const UnknownSystem& block : blocks_of(equations)) {
    if (std::any_of(block.unknowns.begin(), block.unknowns.end(),
                    [&](const Unknown& u) { return chosen_unknowns.contains(u.name); }))
      break;
    refine(all, [&](const AllSettings& root) { return find_block(block, root); });
    std::erase_if(rest.unknowns, [&](const Unknown& unknown) { return block.seeks(unknown.name); });
    std::erase_if(rest.groups, [&](const ConditionGroup& group) { return block.has(group); });
  }
  refine(all, [&](const AllSettings& root) { return find_chosen(rest, root, choice); });
  return all;
}

// Tries every choice. Each that has a solution contributes it.
RootsFound UnknownSearch::find_chosen(const UnknownSystem& system, const AllSettings& settings, const Choice& choice) {
  // If the conditions hold without any of the amounts but for rounding, none is needed.
  if (RootsFound none = find_subset(system, settings, choice, 0, holds_by_itself);
      !none.roots.empty() && none.open.empty())
    return none;
  // What the amounts have to make up for may be tiny beside the terms. So choices that leave any of it are none; only
  // if all leave some, as rounding may, those that leave least are taken.
  RootsFound all;
  for (const double zero : {1e-13, 1e-11, 1e-9}) {
    all = find_subsets(system, settings, choice, zero);
    if (!all.roots.empty() || limit_.spent()) break;
  }
  if (all.roots.empty() || limit_.spent()) return all;
  UnknownEquations equations = equations_of(system, settings);
  if (const std::optional<std::string> doubt = doubt_of(statement_, equations, choice, all.roots)) {
    all.roots.clear();
    all.warnings.push_back(place_of(statement_, choice.mark) + "what was found of '" + choice.name +
                           "' is not confirmed: " + *doubt);
  } else if (choice.least_total) {
    open_a_tie(equations, choice, all);
  }
  return all;
}

// Where several choices have the least total, so have their mixtures, if the conditions are linear: then what differs
// between them is open, and one of them and a mixture of all stand for the rest.
void UnknownSearch::open_a_tie(UnknownEquations& equations, const Choice& choice, RootsFound& all) const {
  if (all.roots.size() < 2) return;
  const std::vector<UnknownSlot>& slots = equations.slots();
  std::vector<double> mixture(slots.size(), 0.0);
  std::set<std::size_t> differing;
  const auto first = values_of_slots(slots, all.roots.front());
  // Unequal shares, so that what hangs on them is not the same by chance.
  double share = 1, shares = 0;
  for (const AllSettings& root : all.roots) {
    const auto values = values_of_slots(slots, root);
    if (!values || !first) return;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      mixture[k] += share * (*values)[k];
      if (std::abs((*values)[k] - (*first)[k]) > same_total * std::max(std::abs((*values)[k]), std::abs((*first)[k])))
        differing.insert(k);
    }
    shares += share;
    share *= 1.37;
  }
  for (double& value : mixture) value /= shares;
  const auto left = equations(mixture);
  constexpr double holds = 1e-11;  // of the terms: a mixture leaves of linear conditions what its parts do, rounding
  if (!left || differing.empty() ||
      std::ranges::any_of(left->values, [&](double value) { return std::abs(value) > holds * left->size; }))
    return;
  AllSettings mixed = equations.settings_at(mixture);
  std::vector<Value<double>> chosen;
  for (const std::string& name : choice.of) {
    const std::set<std::string> unknowns = unknowns_of_amount(statement_, name);
    for (std::size_t k = 0; k < slots.size(); ++k)
      if (unknowns.contains(slots[k].unknown.name) && mixture[k] > 0) {
        chosen.push_back(Value<double>::of_text(name));
        break;
      }
  }
  for (Settings& one : mixed) one[choice.name] = Value<double>::of_list(chosen);
  std::vector<std::string> names;
  for (const std::size_t k : differing) {
    OpenUnknown open{slots[k].unknown.name, std::nullopt};
    for (const std::size_t situation : equations.system().situations())
      if (is_own(situation, open.name)) open.situation = situation;
    add_once(names, open.name);
    add_once(all.open, open);
  }
  const Unit& unit = slots[*differing.begin()].unknown.unit;
  all.warnings.push_back(place_of(statement_, choice.mark) + "the least total under '" + choice.name + "' is " +
                         with_digits(total_of(choice, all.roots.front()) / unit.factor, 6) +
                         (unit.text.empty() ? "" : " " + unit.text) + ", and " + listed(names) +
                         " can make it up in more than one way: their shares are open");
  all.roots.resize(1);
  all.alternative = std::move(mixed);
}

RootsFound UnknownSearch::find_subsets(const UnknownSystem& system, const AllSettings& settings, const Choice& choice,
                                       double zero) {
  RootsFound all;
  // If conditions are linear, the least total needs no more amounts than there are independent conditions (a vertex
  // of a linear programme).
  std::size_t most = 0;
  if (choice.least_total) {
    UnknownEquations equations = equations_of(system, settings);
    most = balance_of(equations).independent;
  }
  double least = std::numeric_limits<double>::infinity();
  std::size_t tried = 0, left = 0;
  for (std::size_t subset = 0; subset < (std::size_t{1} << choice.of.size()); ++subset) {
    const auto count = static_cast<std::size_t>(std::popcount(subset));
    if (choice.least_total ? count > most : count != static_cast<std::size_t>(choice.exactly)) continue;
    if (limit_.spent()) {
      ++left;
      continue;
    }
    ++tried;
    RootsFound found = find_subset(system, settings, choice, subset, zero);
    if (choice.least_total && !found.open.empty()) continue;  // then a choice of fewer amounts has a solution too
    for (AllSettings& more : found.roots) {
      if (choice.least_total) {
        const double total = total_of(choice, more);
        if (total > least * (1 + same_total)) continue;
        if (total < least * (1 - same_total)) all.roots.clear();
        least = std::min(least, total);
      }
      const bool known = std::any_of(all.roots.begin(), all.roots.end(),
                                     [&](const AllSettings& other) { return same_root(more, other, system.unknowns); });
      if (!known) all.roots.push_back(std::move(more));
    }
    if (found.roots.empty()) continue;
    for (const OpenUnknown& unknown : found.open) add_once(all.open, unknown);
    if (found.alternative) all.alternative = found.alternative;
    if (found.off_by_scan) all.off_by_scan = std::max(all.off_by_scan.value_or(0), *found.off_by_scan);
  }
  const std::string place = place_of(statement_, choice.mark);
  if (left > 0)
    all.warnings.push_back(place + "the time was over when " + std::to_string(tried) + " of " +
                           std::to_string(tried + left) + " choices under '" + choice.name + "' had been tried");
  if (all.roots.empty() && left == 0) all.warnings.push_back(place + nothing_chosen(system, settings, choice));
  return all;
}

std::string UnknownSearch::nothing_chosen(const UnknownSystem& system, const AllSettings& settings,
                                          const Choice& choice) const {
  std::string text = (choice.least_total ? "no amounts of what stands under '" + choice.name + "' satisfy"
                                         : "no choice of " + std::to_string(choice.exactly) + " of them under '" +
                                               choice.name + "' satisfies") +
                     " all conditions with values in their ranges (durations, masses and pushes are not negative)";
  std::vector<std::set<std::string>> unknowns_of;
  for (const std::string& name : choice.of) unknowns_of.push_back(unknowns_of_amount(statement_, name));
  UnknownEquations equations = equations_of(system, settings);
  const ChoiceClash clash = choice_clash(equations, unknowns_of);
  // Enough amounts were allowed, so that a range or a condition under where: must be the reason.
  const bool enough = clash.conditions.empty() &&
                      (choice.least_total || clash.would_do.size() <= static_cast<std::size_t>(choice.exactly));
  if (!clash.told || enough) return text + ": " + conditions_in_words(statement_, system);
  std::string words;
  for (const std::string& condition : clash.conditions) words += (words.empty() ? "" : "; ") + condition;
  for (const std::size_t i : clash.would_do) words += (words.empty() ? "" : ", ") + choice.of[i];
  if (clash.conditions.empty()) return text + ": " + std::to_string(clash.would_do.size()) + " would do: " + words;
  return text + ": even all of them together cannot satisfy " + words +
         (clash.by_sign ? "; negative values could" : "");
}

// Finds the unknowns with the amounts set to zero that are not in the subset.
RootsFound UnknownSearch::find_subset(const UnknownSystem& system, const AllSettings& settings, const Choice& choice,
                                      std::size_t subset, double zero) {
  AllSettings chosen = settings;
  UnknownSystem others = system;
  std::vector<Value<double>> names;
  const auto give = [&](const std::string& name, const Value<double>& value) {
    for (Settings& one : chosen) one[name] = value;
  };
  for (std::size_t k = 0; k < choice.of.size(); ++k) {
    if (subset >> k & 1) {
      names.push_back(Value<double>::of_text(choice.of[k]));
      continue;
    }
    for (const std::string& name : unknowns_of_amount(statement_, choice.of[k])) {
      const auto unknown = std::find_if(others.unknowns.begin(), others.unknowns.end(),
                                        [&](const Unknown& u) { return u.name == name; });
      if (unknown == others.unknowns.end()) continue;
      give(name, Value<double>::of_number(0, unknown->unit.dimension));
      others.unknowns.erase(unknown);
    }
  }
  give(choice.name, Value<double>::of_list(std::move(names)));
  if (!others.unknowns.empty()) return find_block(others, chosen, false, zero);
  RootsFound nothing_to_find;
  UnknownEquations equations = equations_of(others, chosen);
  const auto values = equations({});
  if (!values) return nothing_to_find;
  double misfit = 0;
  for (double value : values->values) misfit = std::max(misfit, std::abs(value));
  if (misfit <= zero * std::max(values->size, 1e-300)) nothing_to_find.roots.push_back(std::move(chosen));
  return nothing_to_find;
}

double UnknownSearch::total_of(const Choice& choice, const AllSettings& settings) const {
  double total = 0;
  std::optional<Dimension> dimension;
  for (const std::string& name : choice.of)
    for (const std::string& unknown : unknowns_of_amount(statement_, name)) {
      const auto sought =
          std::find_if(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.name == unknown; });
      if (sought == unknowns_.end()) continue;
      if (sought->vector)
        fail(statement_.file, choice.mark, "the amount '" + unknown + "' is a vector: it has no place in a sum");
      if (dimension && !same_kind(*dimension, sought->unit.dimension))
        fail(statement_.file, choice.mark, "the amounts under '" + choice.name + "' are of different kinds: no sum");
      dimension = sought->unit.dimension;
      for (const Settings& one : settings)
        if (const auto found = one.find(unknown); found != one.end()) {
          total += found->second.number;
          break;
        }
    }
  return total;
}

}  // namespace poinsot::problem
