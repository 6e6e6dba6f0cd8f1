#include "problem/unknowns/unknown_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/results/compare_values.h"
#include "problem/unknowns/unknown_blocks.h"
#include "problem/unknowns/unknown_ranges.h"

namespace poinsot::problem {
namespace {

// Each root is solved as a problem of its own, and nobody reads more of them.
constexpr std::size_t most_roots = 64;

}  // namespace

// Unknowns differ by no more than a part of the largest of their kind.
bool same_root(const AllSettings& a, const AllSettings& b, const std::vector<Unknown>& unknowns) {
  constexpr double same_to = 1e-9;  // the part to which roots are found
  const auto each = [&](const auto& visit) {
    for (const Unknown& unknown : unknowns)
      for (std::size_t i = 0; i < a.size(); ++i) {
        const auto left = a[i].find(unknown.name), right = b[i].find(unknown.name);
        if (left != a[i].end() && right != b[i].end()) visit(unknown.unit.dimension, left->second, right->second);
      }
  };
  std::vector<std::pair<Dimension, double>> sizes;
  const auto size_for = [&](const Dimension& dimension) -> double& {
    const auto known = std::ranges::find(sizes, dimension, &std::pair<Dimension, double>::first);
    return known != sizes.end() ? known->second : sizes.emplace_back(dimension, 0).second;
  };
  each([&](const Dimension& dimension, const Value<double>& left, const Value<double>& right) {
    double& size = size_for(dimension);
    size = std::max({size, size_of(left), size_of(right)});
  });
  bool alike = true;
  each([&](const Dimension& dimension, const Value<double>& left, const Value<double>& right) {
    alike = alike && same(left, right, same_to * size_for(dimension));
  });
  return alike;
}

void merge(RootsFound& all, const RootsFound& more) {
  for (const OpenUnknown& unknown : more.open) add_once(all.open, unknown);
  for (const std::string& text : more.warnings) add_once(all.warnings, text);
  if (more.alternative) all.alternative = more.alternative;
  if (more.off_by_scan) all.off_by_scan = std::max(all.off_by_scan.value_or(0), *more.off_by_scan);
}

UnknownSearch::UnknownSearch(const Statement& statement, const Settings& settings, Work most)
    : statement_(statement), most_(most), limit_(most) {
  for (const auto& [name, value] : settings) known_.insert(name);
  for (const Situation& situation : statement.situations)
    for (const Unknown& unknown : situation.find)
      if (!known_.contains(unknown.name) &&
          std::none_of(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.name == unknown.name; }))
        unknowns_.push_back(unknown);
}

UnknownEquations UnknownSearch::equations_of(const UnknownSystem& system, const AllSettings& settings) const {
  return UnknownEquations(statement_, system, settings, choice_, unknowns_);
}

// In a blow each cord and contact acts or gives way, and the equations are others for each of these cases. So unknowns
// are sought in each of them, and those values are solutions with which what was supposed comes about.
RootsFound UnknownSearch::find(const Settings& settings, const OpenChoice& choice) {
  choice_ = choice;
  limit_ = WorkLimit(most_);
  // Cords and contacts that may each act or give way: every one more doubles the cases, of which each is searched.
  constexpr std::size_t most_in_a_blow = 5;
  std::size_t giving = 0;
  for (const Situation& situation : statement_.situations)
    if (situation.has_blow()) giving = std::max(giving, situation.cords.size() + situation.contacts.size());
  if (unknowns_.empty() || giving == 0) return find_as_they_give_way(settings);
  RootsFound all;
  std::optional<RootsFound> in_vain;
  std::optional<StatementError> refusal;
  for (std::size_t way = 0; way < (std::size_t{1} << std::min(giving, most_in_a_blow)); ++way) {
    choice_.giving_way = way;
    try {
      RootsFound found = find_as_they_give_way(settings);
      const std::vector<AllSettings> roots = std::exchange(found.roots, {});
      for (const AllSettings& root : roots)
        if (gives_way_so(root) && std::none_of(all.roots.begin(), all.roots.end(), [&](const AllSettings& known) {
              return same_root(known, root, unknowns_);
            }))
          found.roots.push_back(root);
      if (found.roots.empty()) {
        // If nothing else is found, what is told is that of all acting.
        if (!in_vain) {
          in_vain = found;
          in_vain->roots = roots;
        }
        continue;
      }
      all.roots.insert(all.roots.end(), found.roots.begin(), found.roots.end());
      merge(all, found);
    } catch (const StatementError& error) {
      if (!refusal) refusal = error;
    }
  }
  choice_.giving_way = 0;
  if (!all.roots.empty()) {
    if (giving > most_in_a_blow)
      all.warnings.push_back("more than " + std::to_string(most_in_a_blow) +
                             " cords and contacts take part in the blow: not all cases of which give way were tried");
    return all;
  }
  if (in_vain) return *in_vain;
  throw StatementError(*refusal);
}

RootsFound UnknownSearch::find_confirmed(const Settings& settings) {
  confirming_ = true;
  try {
    RootsFound found = find(settings);
    confirming_ = false;
    return found;
  } catch (...) {
    confirming_ = false;
    throw;
  }
}

bool UnknownSearch::gives_way_so(const AllSettings& root) const {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Situation& situation = statement_.situations[i];
    if (!situation.has_blow()) continue;
    try {
      const SolvedInstant instant(situation, root[i], When{0, true}, choice_);
      std::size_t giving = 0, count = 0;
      const Mechanism<double>& mechanism = instant.machine().mechanism;
      for (const Component<double>& component : mechanism.components) {
        if (!component.one_sided) continue;
        if (!instant.blow_acting()[static_cast<std::size_t>(component.action)]) giving |= std::size_t{1} << count;
        ++count;
      }
      if (giving != choice_.giving_way % (std::size_t{1} << count)) return false;
    } catch (const StatementError&) {
      return false;
    }
  }
  return true;
}

RootsFound UnknownSearch::find_as_they_give_way(const Settings& settings) {
  RootsFound found;
  found.roots.push_back(AllSettings(statement_.situations.size(), settings));
  const auto search = [&](const UnknownSystem& system) {
    if (system.unknowns.empty()) return;
    refine(found, [&](const AllSettings& root) { return find_with_choices(system, root); });
    if (found.roots.size() <= most_roots) return;
    found.warnings.push_back("only the first " + std::to_string(most_roots) + " of " +
                             std::to_string(found.roots.size()) + " solutions are given");
    found.roots.resize(most_roots);
  };
  for (const UnknownSystem& system : systems()) search(system);
  leave_out_nonsense(found);
  return found;
}

std::vector<UnknownSystem> UnknownSearch::systems() const {
  std::vector<UnknownSystem> all(1);
  UnknownSystem& common = all.front();
  for (const Unknown& unknown : unknowns_)
    if (is_common(unknown.name)) common.unknowns.push_back(unknown);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i)
    if (statement_.situations[i].own_unknowns.empty())
      for (const ConditionGroup& group : groups_of(statement_, i)) common.groups.push_back(group);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    UnknownSystem own{{}, groups_of(statement_, i)};
    for (const Unknown& unknown : statement_.situations[i].find)
      if (is_own(i, unknown.name) && !known_.contains(unknown.name)) own.unknowns.push_back(unknown);
    all.push_back(std::move(own));
  }
  return all;
}

bool UnknownSearch::still_holds(const AllSettings& root, const OpenChoice& choice) {
  choice_ = choice;
  for (const UnknownSystem& system : systems())
    if (!system.unknowns.empty() && !equations_of(system, root).hold_as_set()) return false;
  return true;
}

// Why a statement with these values has no solution; nothing if it has one.
std::optional<StatementError> UnknownSearch::objection(const AllSettings& root) const {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Situation& situation = statement_.situations[i];
    try {
      SolvedInstant instant(situation, root[i], When{0, situation.has_blow()}, choice_);
      const std::vector<ConditionGroup> groups = groups_of(statement_, i);
      const bool forces = std::any_of(groups.begin(), groups.end(),
                                      [](const ConditionGroup& group) { return group.aspect == Aspect::forces; });
      if (!forces || situation.has_blow() || (situation.contacts.empty() && situation.cords.empty())) continue;
      instant.solve_forces();
      if (const std::vector<std::string> reasons = instant.unphysical(); !reasons.empty())
        return StatementError(situation.file, {}, reasons.front());
    } catch (const StatementError& error) {
      return error;
    }
  }
  return std::nullopt;
}

// Drops roots that are impossible machines. If none is left they are all kept: the reason is reported when the
// statement is solved.
void UnknownSearch::leave_out_nonsense(RootsFound& found) const {
  std::vector<AllSettings> sensible;
  std::vector<std::string> reasons;
  for (const AllSettings& root : found.roots) {
    if (found.roots.size() == 1) break;  // a single one is kept, whatever it is
    if (const auto error = objection(root))
      add_once(reasons, "one solution of the conditions is left out: " + std::string(error->what()));
    else
      sensible.push_back(root);
  }
  if (!sensible.empty()) {
    found.roots = std::move(sensible);
    // In a blow, what is no solution in one case of cords and contacts that give way is sought in the others.
    const bool by_cases = std::ranges::any_of(statement_.situations, [](const Situation& situation) {
      return situation.has_blow() && !(situation.cords.empty() && situation.contacts.empty());
    });
    if (!by_cases)
      for (const std::string& reason : reasons) add_once(found.warnings, reason);
  }
  if (found.alternative && objection(*found.alternative)) found.alternative.reset();
}

namespace {

// Which of several solutions for some of the unknowns allows no others, in words.
std::string beside_others(const UnknownSystem& system, const AllSettings& root) {
  std::vector<std::string> values;
  for (const Unknown& unknown : system.unknowns) {
    const auto settings = std::ranges::find_if(root, [&](const Settings& one) { return one.contains(unknown.name); });
    if (settings == root.end()) continue;
    const auto value = settings->find(unknown.name);
    if (!value->second.is_number()) continue;
    values.push_back(unknown.name + " = " + with_digits(value->second.number / unknown.unit.factor, 4) +
                     (unknown.unit.text.empty() ? "" : " " + unknown.unit.text));
  }
  return values.empty() ? "" : "; that is so with " + listed(values) + ", one of several values found before";
}

}  // namespace

RootsFound UnknownSearch::find_by_blocks(const UnknownSystem& system, const AllSettings& settings) {
  RootsFound all;
  all.roots.push_back(settings);
  UnknownEquations equations = equations_of(system, settings);
  const std::vector<UnknownSystem> blocks = blocks_of(equations);
  if (blocks.size() == 1 && blocks.front() == system) return find_block(equations);
  for (const UnknownSystem& block : blocks) {
    const bool several = all.roots.size() > 1;
    refine(all, [&](const AllSettings& root) {
      RootsFound found = find_block(block, root);
      if (several && found.roots.empty())
        for (std::string& warning : found.warnings) warning += beside_others(system, root);
      return found;
    });
  }
  return all;
}

}  // namespace poinsot::problem
