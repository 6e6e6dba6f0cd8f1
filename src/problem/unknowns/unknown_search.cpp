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

constexpr std::size_t most_roots = 64;

// The root of the sum of the squared misfits of the equations.
double misfit(UnknownEquations& equations, const std::vector<double>& x) {
  const auto found = equations(x);
  if (!found) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const double value : found->smooth.empty() ? found->values : found->smooth) sum += value * value;
  return std::sqrt(sum);
}

// Sets a value to zero that rounding has left small, if the equations hold as well with zero.
void round_to_zero(UnknownEquations& equations, std::vector<double>& point) {
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (point[k] == 0 || std::abs(point[k]) > 1e-9 * equations.ranges()[k].scale) continue;
    std::vector<double> zero = point;
    zero[k] = 0;
    if (misfit(equations, zero) <= misfit(equations, point)) point = std::move(zero);
  }
}

// Angles at both ends of their range may be a whole turn apart. Such points are one pose if the equations have the
// same values there, and only one is kept.
std::vector<std::vector<double>> each_pose_once(UnknownEquations& equations,
                                                const std::vector<std::vector<double>>& points) {
  constexpr double turn = 6.283185307179586, same = 1e-9;
  const auto a_turn_apart = [&](const std::vector<double>& a, const std::vector<double>& b) {
    bool turned = false;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const bool angle = equations.slots()[k].unknown.unit.dimension == dimensions::angle;
      const bool turns = angle && std::abs(b[k] - a[k] - turn) <= same;
      if (!turns && std::abs(b[k] - a[k]) > same * equations.ranges()[k].scale) return false;
      turned = turned || turns;
    }
    if (!turned) return false;
    // The equations must agree near both points too.
    std::vector<double> here = a, there = b;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const double step = 0.1 * (equations.ranges()[k].upper - equations.ranges()[k].lower);
      const double move = std::isfinite(step) ? step : 0.1 * equations.ranges()[k].scale;
      here[k] += move;
      there[k] += move;
    }
    const auto first = equations(here), second = equations(there);
    if (!first || !second || first->values.size() != second->values.size()) return false;
    for (std::size_t i = 0; i < first->values.size(); ++i)
      if (std::abs(first->values[i] - second->values[i]) > same * (first->size + second->size)) return false;
    return true;
  };
  std::vector<std::vector<double>> kept;
  for (const std::vector<double>& point : points)
    if (std::none_of(points.begin(), points.end(), [&](const auto& other) { return a_turn_apart(point, other); }))
      kept.push_back(point);
  return kept;
}

std::string values_in_words(const std::vector<UnknownSlot>& slots, const std::vector<double>& x) {
  std::string words;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Unit& unit = slots[k].unknown.unit;
    words += (words.empty() ? "" : ", ") + slots[k].unknown.name +
             (slots[k].unknown.vector ? std::string(".") + "xyz"[slots[k].component] : "") + " = " +
             with_digits(x[k] / unit.factor, 4) + (unit.text.empty() ? "" : " " + unit.text);
  }
  return words;
}

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
        if (!in_vain) in_vain = RootsFound{roots, found.open, found.warnings, found.alternative};
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
    if (const auto error = objection(root))
      add_once(reasons, "one solution of the conditions is left out: " + std::string(error->what()));
    else
      sensible.push_back(root);
  }
  if (!sensible.empty()) {
    found.roots = std::move(sensible);
    for (const std::string& reason : reasons) add_once(found.warnings, reason);
  }
  if (found.alternative && objection(*found.alternative)) found.alternative.reset();
}

RootsFound UnknownSearch::find_by_blocks(const UnknownSystem& system, const AllSettings& settings) {
  RootsFound all;
  all.roots.push_back(settings);
  UnknownEquations equations = equations_of(system, settings);
  const std::vector<UnknownSystem> blocks = blocks_of(equations);
  if (blocks.size() == 1 && blocks.front() == system) return find_block(equations);
  for (const UnknownSystem& block : blocks)
    refine(all, [&](const AllSettings& root) { return find_block(block, root); });
  return all;
}

RootsFound UnknownSearch::find_block(const UnknownSystem& system, const AllSettings& settings, bool explained) {
  UnknownEquations equations = equations_of(system, settings);
  return find_block(equations, explained);
}

RootsFound UnknownSearch::find_block(UnknownEquations& equations, bool explained) {
  RootsFound found;
  const UnknownSystem& system = equations.system();
  const std::vector<UnknownSlot>& slots = equations.slots();
  std::string small;
  for (std::size_t k : equations.without_squares()) small += (small.empty() ? "" : ", ") + slots[k].unknown.name + "^2";
  if (!small.empty()) found.warnings.push_back("neglected, as stated: " + small);

  const solve::RootProblem problem = equations.problem();
  const solve::Roots result = solve::find_roots(problem, limit_.left());
  const auto open_unknown = [&](std::size_t k) {
    OpenUnknown open{slots[k].unknown.name, std::nullopt};
    for (const std::size_t situation : system.situations())
      if (is_own(situation, open.name)) open.situation = situation;
    return open;
  };
  for (std::size_t k : result.open_unknowns) add_once(found.open, open_unknown(k));
  std::set<std::string> sought;
  for (const Unknown& unknown : unknowns_) sought.insert(unknown.name);
  bool excluded = false;
  std::vector<std::vector<double>> kept;
  for (std::vector<double> point : each_pose_once(equations, result.points)) {
    round_to_zero(equations, point);
    // Points that differ only in open unknowns are the same.
    const bool again = !result.open_unknowns.empty() && std::any_of(kept.begin(), kept.end(), [&](const auto& other) {
      for (std::size_t k = 0; k < point.size(); ++k) {
        const bool open = std::ranges::find(found.open, open_unknown(k)) != found.open.end();
        const double size = std::max({std::abs(point[k]), std::abs(other[k]), equations.ranges()[k].scale});
        if (!open && std::abs(point[k] - other[k]) > 1e-7 * size) return false;
      }
      return true;
    });
    if (again) continue;
    AllSettings root = equations.settings_at(point);
    if (satisfies_where(statement_, system.situations(), root, sought)) {
      found.roots.push_back(std::move(root));
      kept.push_back(std::move(point));
    } else {
      excluded = true;
    }
  }
  if (!result.alternative.empty()) found.alternative = equations.settings_at(result.alternative);
  if (!found.roots.empty() && !found.open.empty() && !problem.costly) {
    const Balance balance = balance_of(equations);
    if (balance.independent < balance.unknowns) found.warnings.push_back(shortage_in_words(balance.short_of));
  }
  if (found.roots.empty()) {
    if (!equations.makes_sense() && equations.refusal()) throw *equations.refusal();
    if (explained) found.warnings.push_back(nothing_found(equations, result, excluded));
  } else if (result.search == solve::RootSearch::few_evaluations) {
    found.warnings.push_back("found from a few motions; others are not excluded");
  } else if (result.search == solve::RootSearch::many_starts && found.open.empty()) {
    found.warnings.push_back(
        "the roots were found " +
        (result.starts > 0 ? "from " + counted(result.starts, "start") : std::string("by polynomials")) +
        "; others are not excluded");
  }
  return found;
}

// Reports how roots were sought in vain, and which conditions clash where they come closest to holding.
std::string UnknownSearch::nothing_found(UnknownEquations& equations, const solve::Roots& result, bool excluded) const {
  const UnknownSystem& system = equations.system();
  std::string how;
  switch (result.search) {
    case solve::RootSearch::linear:
      how = "the equations are linear";
      break;
    case solve::RootSearch::certified:
      how = "none exist there";
      break;
    case solve::RootSearch::few_evaluations:
      how = "from a few motions";
      break;
    case solve::RootSearch::many_starts:
      how = result.starts > 0 ? "searched from " + counted(result.starts, "start")
                              : "searched by polynomials, which leave parts of the ranges unresolved";
      break;
  }
  if (limit_.spent()) how += "; the time for it was over";
  if (result.search != solve::RootSearch::few_evaluations)
    if (const Balance balance = balance_of(equations); !balance.surplus.conditions.empty())
      how += "; " + surplus_in_words(balance.surplus);
  const std::string conditions = conditions_in_words(statement_, system);
  std::string text = "no values of " + joined(names_of(system.unknowns)) + " in their ranges satisfy all conditions (" +
                     how + ")" + (excluded ? " with what stands under where:" : "") +
                     (conditions.empty() ? "" : ": " + conditions);
  for (const std::size_t i : system.situations())
    if (!statement_.situations[i].gravity) {
      text += "; gravity, of which nothing is said, was left out: write gravity: -y or gravity: none";
      break;
    }
  if (result.best.empty()) return text;
  // If the situation is solved at this place, its error tells what clashes. That needs values for all of its
  // unknowns.
  const AllSettings nearest = equations.settings_at(result.best);
  for (std::size_t i : system.situations()) {
    const Situation& situation = statement_.situations[i];
    if (std::any_of(situation.find.begin(), situation.find.end(),
                    [&](const Unknown& unknown) { return !nearest[i].contains(unknown.name); }))
      continue;
    try {
      SolvedInstant instant(situation, nearest[i], When{0, situation.has_blow()}, choice_);
      if (system.has({i, Aspect::forces})) instant.solve_forces();
    } catch (const StatementError& error) {
      const Diagnostic& clash = error.diagnostics().front();
      return clash.file + ":" + std::to_string(clash.mark.line) + ":" + std::to_string(clash.mark.column) + ": " +
             text + "; where they come closest, at " + values_in_words(equations.slots(), result.best) + ", " +
             clash.message;
    }
  }
  return text;
}

}  // namespace poinsot::problem
