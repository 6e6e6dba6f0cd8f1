#include "statement/unknown_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "statement/reader.h"
#include "statement/unknown_blocks.h"
#include "statement/unknown_ranges.h"

namespace poinsot::statement {
namespace {

constexpr double most_seconds = 8;  // of all searches of a statement together
constexpr std::size_t most_roots = 64;

std::string counted(std::size_t count, const std::string& what) {
  return (count == 0 ? "no" : count == 1 ? "one" : std::to_string(count)) + " " + what + (count == 1 ? "" : "s");
}

std::string values_in_words(const std::vector<UnknownSlot>& slots, const std::vector<double>& x) {
  std::string words;
  for (std::size_t k = 0; k < x.size(); ++k) {
    char text[60];
    const Unit& unit = slots[k].unknown.unit;
    std::snprintf(text, sizeof text, " = %.4g", x[k] / unit.factor);
    words += (words.empty() ? "" : ", ") + slots[k].unknown.name +
             (slots[k].unknown.vector ? std::string(".") + "xyz"[slots[k].component] : "") + text +
             (unit.text.empty() ? "" : " " + unit.text);
  }
  return words;
}

}  // namespace

void merge(RootsFound& all, const RootsFound& more) {
  for (const std::string& name : more.open) add_once(all.open, name);
  for (const std::string& text : more.warnings) add_once(all.warnings, text);
  if (more.alternative) all.alternative = more.alternative;
}

UnknownSearch::UnknownSearch(const Statement& statement, const Settings& settings) : statement_(statement) {
  for (const auto& [name, value] : settings) known_.insert(name);
  for (const Situation& situation : statement.situations)
    for (const Unknown& unknown : situation.problem.find)
      if (!known_.contains(unknown.name) &&
          std::none_of(unknowns_.begin(), unknowns_.end(), [&](const Unknown& u) { return u.name == unknown.name; }))
        unknowns_.push_back(unknown);
}

double UnknownSearch::seconds_left() const {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  return std::max(0.0, most_seconds - spent);
}

UnknownEquations UnknownSearch::equations_of(const UnknownSystem& system, const AllSettings& settings) const {
  return UnknownEquations(statement_, system, settings, choice_, unknowns_);
}

RootsFound UnknownSearch::find(const Settings& settings, const OpenChoice& choice) {
  choice_ = choice;
  begun_ = std::chrono::steady_clock::now();
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
  UnknownSystem common;
  for (const Unknown& unknown : unknowns_)
    if (is_common(unknown.name)) common.unknowns.push_back(unknown);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i)
    if (statement_.situations[i].own_unknowns.empty())
      for (const ConditionGroup& group : groups_of(statement_, i)) common.groups.push_back(group);
  search(common);
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    UnknownSystem own{{}, groups_of(statement_, i)};
    for (const Unknown& unknown : statement_.situations[i].problem.find)
      if (is_own(i, unknown.name) && !known_.contains(unknown.name)) own.unknowns.push_back(unknown);
    search(own);
  }
  leave_out_nonsense(found);
  return found;
}

// Why a statement with these values has no solution.
std::optional<StatementError> UnknownSearch::objection(const AllSettings& root) const {
  for (std::size_t i = 0; i < statement_.situations.size(); ++i) {
    const Problem& problem = statement_.situations[i].problem;
    try {
      SolvedInstant(problem, root[i], When{0, problem.has_blow()}, choice_);
    } catch (const StatementError& error) {
      return error;
    }
  }
  return std::nullopt;
}

// A root or another solution may be nothing that can be built. Where no root makes sense, the reason is told when it is
// solved.
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
  for (const UnknownSystem& block : blocks_of(equations))
    refine(all, [&](const AllSettings& root) { return find_block(block, root); });
  return all;
}

RootsFound UnknownSearch::find_block(const UnknownSystem& system, const AllSettings& settings) {
  RootsFound found;
  UnknownEquations equations = equations_of(system, settings);
  const std::vector<UnknownSlot>& slots = equations.slots();
  std::string small;
  for (std::size_t k : equations.without_squares()) small += (small.empty() ? "" : ", ") + slots[k].unknown.name + "^2";
  if (!small.empty()) found.warnings.push_back("neglected, as stated: " + small);

  const solve::RootProblem problem = equations.problem();
  const solve::Roots result = solve::find_roots(problem, seconds_left());
  for (std::size_t k : result.open_unknowns) add_once(found.open, slots[k].unknown.name);
  std::set<std::string> sought;
  for (const Unknown& unknown : unknowns_) sought.insert(unknown.name);
  bool excluded = false;
  std::vector<std::vector<double>> kept;
  for (std::vector<double> point : result.points) {
    // What is left of zero by rounding is zero.
    for (std::size_t k = 0; k < point.size(); ++k)
      if (std::abs(point[k]) <= 1e-13 * equations.ranges()[k].scale) point[k] = 0;
    // Points that differ in what is open only are one.
    const bool again = !result.open_unknowns.empty() && std::any_of(kept.begin(), kept.end(), [&](const auto& other) {
      for (std::size_t k = 0; k < point.size(); ++k) {
        const bool open = std::find(found.open.begin(), found.open.end(), slots[k].unknown.name) != found.open.end();
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
    const std::string conditions = conditions_in_words(statement_, system);
    if (balance.independent < balance.unknowns)
      found.warnings.push_back(listed(system.unknowns) + ": " + counted(balance.unknowns, "unknown") + ", but " +
                               counted(balance.independent, "independent condition") + " on " +
                               (balance.unknowns == 1 ? "it" : "them") + (conditions.empty() ? "" : ": " + conditions));
  }
  if (found.roots.empty()) {
    if (!equations.makes_sense() && equations.refusal()) throw *equations.refusal();
    found.warnings.push_back(nothing_found(equations, result, excluded));
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

// What was tried in vain, and what clashes where the conditions come closest to being satisfied.
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
  if (seconds_left() <= 0) how += "; the time for it was over";
  if (result.search != solve::RootSearch::few_evaluations)
    if (const Balance balance = balance_of(equations); balance.conditions > balance.unknowns)
      how += "; " + counted(balance.conditions, "condition") + " on " + counted(balance.unknowns, "unknown");
  const std::string conditions = conditions_in_words(statement_, system);
  std::string text = "no values of " + listed(system.unknowns) + " in their ranges satisfy all conditions (" + how +
                     ")" + (excluded ? " with what stands under where:" : "") +
                     (conditions.empty() ? "" : ": " + conditions);
  if (result.best.empty()) return text;
  // Solved as it stands there, the statement says itself what clashes; not while other unknowns have no value yet.
  const AllSettings nearest = equations.settings_at(result.best);
  for (std::size_t i : system.situations()) {
    const Problem& problem = statement_.situations[i].problem;
    if (std::any_of(problem.find.begin(), problem.find.end(),
                    [&](const Unknown& unknown) { return !nearest[i].contains(unknown.name); }))
      continue;
    try {
      SolvedInstant instant(problem, nearest[i], When{0, problem.has_blow()}, choice_);
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

}  // namespace poinsot::statement
