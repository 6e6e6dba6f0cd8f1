// Seeks the unknowns of one system together, and says why where it finds none.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "poinsot/engine/work/work.h"
#include "problem/language/diagnostic.h"
#include "problem/language/words.h"
#include "problem/unknowns/unknown_blocks.h"
#include "problem/unknowns/unknown_ranges.h"
#include "problem/unknowns/unknown_search.h"
#include "problem/witness/particle_witness.h"

namespace poinsot::problem {
namespace {

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
    constexpr double by_rounding = 1e-9;  // of its natural size: the part to which roots are found
    if (point[k] == 0 || std::abs(point[k]) > by_rounding * equations.ranges()[k].scale) continue;
    std::vector<double> zero = point;
    zero[k] = 0;
    if (misfit(equations, zero) <= misfit(equations, point)) point = std::move(zero);
  }
}

// Angles at both ends of their range may be a whole turn apart. Such points are one pose if the equations have the
// same values there, and only one is kept.
std::vector<std::vector<double>> each_pose_once(UnknownEquations& equations,
                                                const std::vector<std::vector<double>>& points) {
  // Of a radian or of the natural size: the part to which roots are found.
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

std::string value_in_words(const UnknownSlot& slot, double x) {
  const Unit& unit = slot.unknown.unit;
  return slot.unknown.name + (slot.unknown.vector ? std::string(".") + "xyz"[slot.component] : "") + " = " +
         with_digits(x / unit.factor, 4) + (unit.text.empty() ? "" : " " + unit.text);
}

std::string values_in_words(const std::vector<UnknownSlot>& slots, const std::vector<double>& x) {
  std::string words;
  for (std::size_t k = 0; k < x.size(); ++k) words += (words.empty() ? "" : ", ") + value_in_words(slots[k], x[k]);
  return words;
}

// Roots, and how far they are from those to which a scan comes.
struct Searched {
  solve::Roots roots;
  std::optional<double> off_by_scan;
};

// What a scan finds beside the roots that were certified is a root too, and then nothing is certain.
// Which searches a scan confirms: none, those that found more than linear equations, or all.
enum class Confirmed { none, curved, all };

Searched searched_roots(const solve::RootProblem& problem, Work most, Confirmed confirmed) {
  const WorkLimit limit(most);
  const Work begin = work_done();
  Searched searched{solve::find_roots(problem, most), std::nullopt};
  solve::Roots& roots = searched.roots;
  if (confirmed == Confirmed::none) return searched;
  if (confirmed == Confirmed::curved && roots.search == solve::RootSearch::linear) return searched;
  const auto scan = solve::scan_roots(problem, roots, std::min(work_done() - begin, limit.left()));
  if (!scan) return searched;
  searched.off_by_scan = scan->farthest;
  if (scan->missed.empty()) return searched;
  roots.points.insert(roots.points.end(), scan->missed.begin(), scan->missed.end());
  std::sort(roots.points.begin(), roots.points.end());
  roots.search = solve::RootSearch::many_starts;
  roots.starts = scan->places;
  return searched;
}

// Which values of a root rounding leaves few digits; "" where all are known well.
std::string blur_in_words(const std::vector<UnknownSlot>& slots, const std::vector<double>& point,
                          const std::vector<double>& blur) {
  std::string words;
  for (std::size_t k = 0; k < point.size(); ++k) {
    constexpr double shown = 1e-6;  // of its value: six digits
    if (!(blur[k] > shown)) continue;
    const std::string off = blur[k] < 1 ? with_digits(blur[k], 1) + " of itself" : "its own size";
    words += (words.empty() ? "" : ", ") + value_in_words(slots[k], point[k]) + " may be off by up to " + off;
  }
  return words.empty() ? words : words + ": it is so small beside the other terms that rounding leaves it fewer digits";
}

// Whether one of the points is the same but for signs.
bool has_twin(const std::vector<double>& point, const std::vector<std::vector<double>>& points) {
  // Of the value: double roots are found to the root of rounding, 1e-8, and so far less closely than others.
  constexpr double same = 1e-6;
  return std::ranges::any_of(points, [&](const std::vector<double>& other) {
    for (std::size_t k = 0; k < point.size(); ++k)
      if (std::abs(std::abs(point[k]) - std::abs(other[k])) > same * std::abs(point[k])) return false;
    return true;
  });
}

// Whether something of a body is given as `any`: a value that is taken for it is none that was sought.
bool has_open_mass(const Body& body) {
  const auto any = [](const std::optional<Expression>& value) { return value && is_any(*value); };
  if (any(body.amount.mass) || any(body.amount.weight)) return true;
  if (const List* list = body.center ? body.center->as<List>() : nullptr;
      list && std::ranges::any_of(list->items, is_any))
    return true;
  if (!body.inertia) return false;
  const StatedInertia& inertia = *body.inertia;
  return inertia.rest_any || std::ranges::any_of(inertia.moments, any) || std::ranges::any_of(inertia.products, any) ||
         any(inertia.axial) || any(inertia.transverse);
}

}  // namespace

RootsFound UnknownSearch::find_block(const UnknownSystem& system, const AllSettings& settings, bool explained,
                                     std::optional<double> zero) {
  UnknownEquations equations = equations_of(system, settings);
  return find_block(equations, explained, zero);
}

RootsFound UnknownSearch::find_block(UnknownEquations& equations, bool explained, std::optional<double> zero) {
  RootsFound found;
  const UnknownSystem& system = equations.system();
  const std::vector<UnknownSlot>& slots = equations.slots();
  std::string small;
  for (std::size_t k : equations.without_squares()) small += (small.empty() ? "" : ", ") + slots[k].unknown.name + "^2";
  if (!small.empty()) found.warnings.push_back("neglected, as stated: " + small);

  solve::RootProblem problem = equations.problem();
  if (zero) problem.zero = *zero;
  const Work begin = work_done();
  // Of choices most fail, and their amounts nearly always enter linearly.
  const Confirmed confirmed = !confirming_ ? Confirmed::none : explained ? Confirmed::all : Confirmed::curved;
  Searched searched = searched_roots(problem, limit_.left(), confirmed);
  const Work taken = work_done() - begin;
  std::set<std::string> sought;
  for (const Unknown& unknown : unknowns_) sought.insert(unknown.name);
  const auto open_unknown = [&](std::size_t k) {
    OpenUnknown open{slots[k].unknown.name, std::nullopt};
    for (const std::size_t situation : system.situations())
      if (is_own(situation, open.name)) open.situation = situation;
    return open;
  };
  bool excluded = false;
  const auto keep = [&](const solve::Roots& roots) {
    for (std::size_t k : roots.open_unknowns) add_once(found.open, open_unknown(k));
    std::vector<std::vector<double>> kept;
    for (std::vector<double> point : each_pose_once(equations, roots.points)) {
      round_to_zero(equations, point);
      // Points that differ only in open unknowns are the same.
      const bool again = !roots.open_unknowns.empty() && std::any_of(kept.begin(), kept.end(), [&](const auto& other) {
        for (std::size_t k = 0; k < point.size(); ++k) {
          const bool open = std::ranges::find(found.open, open_unknown(k)) != found.open.end();
          const double size = std::max({std::abs(point[k]), std::abs(other[k]), equations.ranges()[k].scale});
          // Of its size: a hundred times what others are found to, since roots on a curve are polished across it alone.
          constexpr double same_but_open = 1e-7;
          if (!open && std::abs(point[k] - other[k]) > same_but_open * size) return false;
        }
        return true;
      });
      if (again) continue;
      AllSettings root = equations.settings_at(point);
      if (satisfies_where(statement_, system.situations(), root, sought)) {
        if (confirming_ && explained && !problem.costly && !roots.open)
          if (const std::string words = blur_in_words(slots, point, solve::blur_of_root(problem, point, limit_.left()));
              !words.empty())
            add_once(found.warnings, words);
        found.roots.push_back(std::move(root));
        kept.push_back(std::move(point));
      } else {
        excluded = true;
      }
    }
  };
  keep(searched.roots);
  // Of a length in an expression for a place it is not known whether it may be negative. It is taken as it is usually
  // meant, but no solution is passed over in silence.
  const std::vector<std::size_t> doubtful = explained && found.open.empty()
                                                ? lengths_of_doubtful_sign(statement_, system, equations.settings())
                                                : std::vector<std::size_t>{};
  if (!doubtful.empty() && !limit_.spent() && (found.roots.empty() || !problem.costly)) {
    solve::RootProblem either = problem;
    for (const std::size_t k : doubtful) either.ranges[k].lower = -std::numeric_limits<double>::infinity();
    Searched wider =
        searched_roots(either, found.roots.empty() ? limit_.left() : std::min(limit_.left(), taken), confirmed);
    if (found.roots.empty()) {
      if (!wider.roots.points.empty()) searched = std::move(wider);
      keep(searched.roots);
    } else {
      for (const std::vector<double>& point : wider.roots.points)
        if (!wider.roots.open && !has_twin(point, searched.roots.points) &&
            std::ranges::any_of(doubtful, [&](std::size_t k) { return point[k] < 0; }) &&
            satisfies_where(statement_, system.situations(), equations.settings_at(point), sought))
          found.warnings.push_back("all conditions hold with " + values_in_words(slots, point) +
                                   " as well, but a length is taken as not negative: where it may be, give it a range "
                                   "under where:");
    }
  }
  const solve::Roots& result = searched.roots;
  if (searched.off_by_scan) found.off_by_scan = searched.off_by_scan;
  if (!result.alternative.empty()) found.alternative = equations.settings_at(result.alternative);
  if (!found.roots.empty() && !found.open.empty() && !problem.costly) {
    const Balance balance = balance_of(equations);
    if (balance.independent < balance.unknowns) found.warnings.push_back(shortage_in_words(balance.short_of));
  }
  if (found.roots.empty()) {
    if (!equations.makes_sense() && equations.refusal()) {
      if (equations.refused_alike()) throw StatementError(*equations.refusal());
      // Numbers in it are those of a trial.
      Diagnostic refusal = equations.refusal()->diagnostics().front();
      refusal.message = "the problem makes no sense at any values of " + joined(names_of(system.unknowns)) +
                        " that were tried; at the first of them: " + refusal.message;
      throw StatementError(refusal);
    }
    if (explained) {
      const std::optional<std::vector<double>> beyond =
          problem.costly ? std::nullopt : root_below_zero(equations, problem, std::min(limit_.left(), taken));
      found.warnings.push_back(nothing_found(equations, result, excluded, beyond));
    }
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

// That there are no roots is right only if the equations are. Trial values do not meet them, but what they leave over
// is known, and the particles must need just that.
bool UnknownSearch::confirmed_where_nothing_was_found(const UnknownEquations& equations,
                                                      const solve::Roots& result) const {
  const UnknownSystem& system = equations.system();
  // Linear equations are solved at once and nowhere looked at: any values do for these.
  std::vector<double> values = result.best;
  if (values.empty()) values.assign(equations.slots().size(), 0.1);
  const AllSettings nearest = equations.settings_at(values);
  OpenChoice choice = choice_;
  choice.trial = choice.particles = true;
  for (const std::size_t i : system.situations()) {
    const Situation& situation = statement_.situations[i];
    if (std::ranges::any_of(situation.find, [&](const Unknown& one) { return !nearest[i].contains(one.name); }) ||
        !situation.neglect.empty())
      continue;
    try {
      SolvedInstant instant(situation, nearest[i], When{0, situation.has_blow()}, choice);
      if (system.has({i, Aspect::forces})) instant.solve_forces();
      const SolvedInstant::Residuals residuals = instant.check();
      if (!(residuals.impulse <= check_tolerance) ||
          (instant.forces_solved() && !(residuals.particles.newton_euler <= check_tolerance)))
        return false;
    } catch (const StatementError&) {
      // There the situation makes no sense, and nothing is told.
    } catch (const std::invalid_argument&) {
      // There a body is one that no particles make up.
    }
  }
  return true;
}

// A place at which all conditions hold if what is taken as not negative may be negative, if there is one.
std::optional<std::vector<double>> UnknownSearch::root_below_zero(UnknownEquations& equations,
                                                                  const solve::RootProblem& problem, Work most) const {
  solve::RootProblem either = problem;
  bool wider = false;
  for (solve::RootRange& range : either.ranges)
    if (range.lower == 0) {
      range.lower = -std::numeric_limits<double>::infinity();
      wider = true;
    }
  if (!wider) return std::nullopt;
  std::set<std::string> sought;
  for (const Unknown& unknown : unknowns_) sought.insert(unknown.name);
  const solve::Roots roots = solve::find_roots(either, most);
  if (roots.open) return std::nullopt;
  for (const std::vector<double>& point : roots.points)
    if (std::ranges::any_of(point, [](double value) { return value < 0; }) &&
        satisfies_where(statement_, equations.system().situations(), equations.settings_at(point), sought))
      return point;
  return std::nullopt;
}

// Reports how roots were sought in vain, and which conditions clash where they come closest to holding, or what kept
// the unknowns from the place `beyond` their ranges at which all hold.
std::string UnknownSearch::nothing_found(UnknownEquations& equations, const solve::Roots& result, bool excluded,
                                         const std::optional<std::vector<double>>& beyond) const {
  const UnknownSystem& system = equations.system();
  std::string how;
  bool proved = false;
  switch (result.search) {
    case solve::RootSearch::linear:
      how = "the equations are linear";
      proved = true;
      break;
    case solve::RootSearch::certified:
      how = "none exist there";
      proved = true;
      break;
    case solve::RootSearch::few_evaluations:
      how = "sought with a few motions, which exclude none";
      break;
    case solve::RootSearch::many_starts:
      how = result.starts > 0 ? "searched from " + counted(result.starts, "start") + ", which excludes none"
                              : "searched by polynomials, which leave parts of the ranges unresolved";
      break;
  }
  if (!confirmed_where_nothing_was_found(equations, result)) {
    how = (proved ? "" : how + "; ") +
          "the bodies as particles do not confirm the equations in which they were sought, so that none is excluded";
    proved = false;
  }
  if (result.search != solve::RootSearch::few_evaluations)
    if (const Balance balance = balance_of(equations); !balance.surplus.conditions.empty())
      how += "; " + surplus_in_words(balance.surplus);
  const auto open = [&](std::size_t i) { return std::ranges::any_of(statement_.situations[i].bodies, has_open_mass); };
  if (std::ranges::any_of(system.situations(), open)) {
    how +=
        "; for values that are given as `any` some were taken, and no others sought: what the conditions are to fix "
        "stands under find:";
    proved = false;
  }
  const std::string conditions = conditions_in_words(statement_, system);
  const std::string names = joined(names_of(system.unknowns));
  std::string text = "no values of " + names + " in their ranges " +
                     (proved ? "satisfy all conditions (" : "were found that satisfy all conditions (") + how + ")";
  // What ended for the work that it took says nothing of what there is.
  if (limit_.spent() && !proved)
    text = "the search for values of " + names + " that satisfy all conditions ended before it was done (" + how +
           "): whether there are any is not known, and narrower ranges under where: would help";
  text += (excluded ? " with what stands under where:" : "") + (conditions.empty() ? "" : ": " + conditions);
  for (const std::size_t i : system.situations())
    if (!statement_.situations[i].gravity) {
      text += "; gravity, of which nothing is said, was left out: write gravity: -y or gravity: none";
      break;
    }
  if (beyond) {
    std::vector<std::string> negative;
    bool matter = true;
    for (std::size_t k = 0; k < beyond->size(); ++k) {
      if (!((*beyond)[k] < 0)) continue;
      const Unknown& unknown = equations.slots()[k].unknown;
      add_once(negative, unknown.name);
      for (const std::size_t i : system.situations())
        matter = matter && is_amount_of_matter(statement_.situations[i], unknown);
    }
    return text + "; they hold with " + values_in_words(equations.slots(), *beyond) + ", but " + listed(negative) +
           (negative.size() > 1 ? " are" : " is") + " taken as not negative (" +
           (matter ? "no body has a negative mass: what is cut out of one stands under added: with hole: true)"
                   : "turn round what pushes, or write {signed: UNIT} under find:)");
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
