#include "poinsot/engine/solve/roots/roots.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solve/roots/chebyshev_roots.h"
#include "engine/solve/roots/few_evaluations.h"
#include "engine/solve/roots/linear_roots.h"
#include "engine/solve/roots/partly_linear.h"
#include "engine/solve/roots/root_function.h"
#include "engine/solve/roots/root_polish.h"
#include "engine/solve/roots/scattered_starts.h"
#include "poinsot/engine/work/work.h"

namespace poinsot::solve {
namespace {

using Eigen::VectorXd;

// Two places are one if they differ by less than this part of themselves, or of a thousandth of a natural size:
// polished ones agree to 1e-9, and roots that differ in their seventh digit only would be told as one in an answer.
constexpr double one_place = 1e-6, next_to_nothing = 1e-3;

class RootFinder {
 public:
  RootFinder(const RootProblem& problem, Work most) : function_(problem, most) {}

  Roots find() {
    Roots roots;
    if (function_.problem().costly && function_.unknowns() > 0) {
      from_few_evaluations(roots);
    } else if (auto linear = linear_roots(function_)) {
      roots = std::move(*linear);
    } else if (function_.unknowns() <= 2) {
      by_polynomials(roots);
    } else if (!by_elimination(roots)) {
      roots.search = RootSearch::many_starts;
      from_random_starts(roots);
    }
    if (roots.search != RootSearch::linear) {
      roots.points = found_.points(function_);
      if (roots.points.empty()) roots.best_misfit = smallest_misfit();
    }
    if (roots.points.empty() && function_.best().size()) roots.best = function_.unscaled(function_.best());
    roots.evaluations = function_.evaluations() + rough_evaluations_;
    return roots;
  }

 private:
  void by_polynomials(Roots& roots) {
    ChebyshevRoots chebyshev = chebyshev_roots(function_);
    found_ = std::move(chebyshev.roots);
    roots.reach = chebyshev.reach;
    roots.unresolved = std::move(chebyshev.unresolved);
    roots.open = !chebyshev.open_unknowns.empty();
    roots.open_unknowns = std::move(chebyshev.open_unknowns);
    if (chebyshev.alternative.size()) roots.alternative = function_.unscaled(chebyshev.alternative);
    if (roots.open) look_for_other_families(roots);
    roots.search = roots.unresolved.empty() && function_.valued() ? RootSearch::certified : RootSearch::many_starts;
    if (roots.search == RootSearch::certified || roots.open) return;
    std::vector<VectorXd> starts = starts_on_grid(function_);
    starts.insert(starts.begin(), chebyshev.places.begin(), chebyshev.places.end());
    for (const VectorXd& start : starts) {
      if (function_.limit().spent() || roots.open) break;
      from_start(start, roots);
    }
  }

  // For more unknowns, all but one or two of which enter linearly. Returns whether this settles the search; if
  // nothing was found, a search from many starts must confirm it.
  bool by_elimination(Roots& roots) {
    const auto found = partly_linear_roots(function_, function_.limit().left() / 4);
    if (!found) return false;
    bool complete = found->complete && function_.valued();
    for (const VectorXd& place : found->places) {
      const auto root = polish(function_, place);
      if (!root || !root->zero) continue;
      // A root that belongs to a family is left to the search from many starts, which judges what is open.
      if (family_through(function_, *root))
        complete = false;
      else
        found_.add(function_, *root);
    }
    if (!complete) return false;
    if (found_.roots().empty()) {
      from_random_starts(roots);
      roots.search = RootSearch::many_starts;
      if (roots.open || !found_.roots().empty()) return true;
      roots.starts = 0;
    }
    roots.reach = found->reach;
    roots.search = RootSearch::certified;
    return true;
  }

  // Whether a root agrees with a known one in all unknowns but the open ones.
  bool lies_along_a_known_one(const PolishedRoot& root, const std::vector<std::size_t>& open) const {
    const auto differs = [&](const PolishedRoot& other, Eigen::Index k) {
      return std::find(open.begin(), open.end(), static_cast<std::size_t>(k)) == open.end() &&
             std::abs(other.u[k] - root.u[k]) > root.radius + one_place * (next_to_nothing + std::abs(root.u[k]));
    };
    return std::any_of(found_.roots().begin(), found_.roots().end(), [&](const PolishedRoot& other) {
      for (Eigen::Index k = 0; k < root.u.size(); ++k)
        if (differs(other, k)) return false;
      return true;
    });
  }

  // There may be several curves of solutions, along which different unknowns are open.
  void look_for_other_families(Roots& roots) {
    constexpr std::size_t starts = 10;
    for (const VectorXd& start : starts_at_random(function_.problem(), starts)) {
      if (function_.limit().spent() || roots.open_unknowns.size() == function_.problem().ranges.size()) return;
      const auto root = polish(function_, start);
      if (!root || !root->zero || !function_.inside(root->u)) continue;
      const auto family = family_through(function_, *root);
      std::vector<std::size_t> open = roots.open_unknowns;
      if (family) open.insert(open.end(), family->open_unknowns.begin(), family->open_unknowns.end());
      if (!lies_along_a_known_one(*root, open)) found_.add(function_, *root);
      if (!family) continue;
      const std::size_t before = roots.open_unknowns.size();
      for (const std::size_t k : family->open_unknowns)
        if (std::find(roots.open_unknowns.begin(), roots.open_unknowns.end(), k) == roots.open_unknowns.end())
          roots.open_unknowns.push_back(k);
      std::sort(roots.open_unknowns.begin(), roots.open_unknowns.end());
      if (roots.open_unknowns.size() > before) roots.alternative = function_.unscaled(family->other);
    }
  }

  void from_few_evaluations(Roots& roots) {
    roots.search = RootSearch::few_evaluations;
    for (const PolishedRoot& place : rough_roots()) {
      if (function_.limit().spent() || roots.open) return;
      from_rough(place, roots);
    }
    if (!found_.roots().empty()) return;
    for (const VectorXd& start : starts_from_few_evaluations(function_)) {
      if (function_.limit().spent() || roots.open) break;
      from_start(start, roots);
    }
  }

  // Starts alternate between the most promising of many places and any of them. When several starts have all led to
  // one place in the ranges, it is taken for the only one. While nothing is found, more starts are tried.
  void from_random_starts(Roots& roots) {
    constexpr int enough = 12;
    constexpr std::size_t most_used = 24, most_in_vain = 120;
    constexpr double most_work_in_vain = 0.6;
    std::optional<VectorXd> only;
    int led_there = 0;
    for (const VectorXd& start : promising_starts()) {
      const bool found = !found_.roots().empty();
      if (function_.limit().spent() || led_there >= enough || roots.open) break;
      if (roots.starts >= (found ? most_used : most_in_vain)) break;
      if (!found && roots.starts >= most_used && function_.limit().part_spent() > most_work_in_vain) break;
      const auto root = from_start(start, roots);
      if (!root || !function_.inside(root->u)) continue;
      if (!only) only = root->u;
      const bool same = (root->u - *only).norm() <= root->radius + one_place * (next_to_nothing + only->norm());
      // starts have led to two places: the search uses all of its starts
      led_there = same && led_there >= 0 ? led_there + 1 : -1;
    }
    if (roots.open) look_for_other_families(roots);
  }

  // The middle of the ranges and random places, in an order that alternates between those of the smallest misfit and
  // the others.
  std::vector<VectorXd> promising_starts() {
    constexpr std::size_t places = 160;
    constexpr double most_work = 0.2;
    const std::vector<VectorXd> list = starts_at_random(function_.problem(), places);
    std::vector<std::pair<double, std::size_t>> by_misfit;
    for (std::size_t i = 0; i < list.size() && function_.limit().part_spent() < most_work; ++i)
      if (const auto sample = function_.smooth_at(list[i]))
        by_misfit.emplace_back(sample->values.norm() / std::max(sample->size, 1e-300), i);
    std::sort(by_misfit.begin(), by_misfit.end());
    std::vector<VectorXd> starts{middle_of_ranges(function_.problem())};
    std::vector<bool> taken(list.size(), false);
    const auto take = [&](std::size_t i) {
      if (!taken[i]) starts.push_back(list[i]);
      taken[i] = true;
    };
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i < by_misfit.size()) take(by_misfit[i].second);
      take(i);
    }
    return starts;
  }

  // The roots of the rough equations, without repetition.
  std::vector<PolishedRoot> rough_roots() {
    // The rough equations are off by 1e-7: their zeros are polished to ten times that, are zeros if they come within a
    // thousand times, as where two nearly meet, and are one if they differ by a hundred times.
    constexpr double near_zero = 1e-4, enough = 1e-6, same = 1e-5;
    std::vector<PolishedRoot> found;
    if (!function_.problem().rough) return found;
    RootProblem problem = function_.problem();
    problem.equations = std::exchange(problem.rough, nullptr);
    problem.slopes = nullptr;
    problem.smooth = nullptr;
    // A start that leads to where motions take long must not use up what the others need, nor the rough look what it
    // takes to polish the roots that it finds.
    constexpr Work of_all = 2, of_rest = 4;
    RootFunction rough(problem, function_.limit().left() / of_all);
    for (const VectorXd& start : starts_from_few_evaluations(rough)) {
      if (rough.limit().spent()) break;
      RootFunction from_here(problem, rough.limit().left() / of_rest);
      auto root = polish(from_here, start, enough);
      rough_evaluations_ += from_here.evaluations();
      if (!root || root->part > near_zero) continue;
      const bool known = std::any_of(found.begin(), found.end(), [&](const PolishedRoot& other) {
        return (other.u - root->u).norm() <= same * (1 + root->u.norm());
      });
      if (!known) found.push_back(std::move(*root));
    }
    rough_evaluations_ += rough.evaluations();
    return found;
  }

  // With one unknown the slopes of the rough equations suffice. With several, exact slopes at the root tell what is
  // open.
  void from_rough(const PolishedRoot& rough, Roots& roots) {
    auto root = polish_with(function_, rough.u, rough.slopes);
    if (root && root->zero && function_.unknowns() > 1) {
      RootSample here;
      here.values = root->values;
      if (auto slopes = function_.slopes(root->u, here)) root->slopes = std::move(*slopes);
    }
    if (!root || !root->zero) root = polish(function_, rough.u);
    ++roots.starts;
    keep(root, roots);
  }

  std::optional<PolishedRoot> from_start(const VectorXd& start, Roots& roots) {
    ++roots.starts;
    return keep(polish(function_, start), roots);
  }

  std::optional<PolishedRoot> keep(std::optional<PolishedRoot> root, Roots& roots) {
    if (!root || !root->zero) return std::nullopt;
    if (found_.add(function_, *root))
      if (const auto family = family_through(function_, *root)) {
        roots.open = true;
        roots.open_unknowns = family->open_unknowns;
        roots.alternative = function_.unscaled(family->other);
      }
    return root;
  }

  // Where nothing was found: the smallest misfit, which tells how close the equations come.
  double smallest_misfit() {
    if (function_.best().size() && !function_.limit().spent()) polish(function_, VectorXd(function_.best()));
    return function_.best_misfit();
  }

  RootFunction function_;
  std::size_t rough_evaluations_ = 0;
  RootList found_;
};

// The same problem with larger natural sizes for those unbounded unknowns that the equations notice only far away.
// Returns nothing if there are no such unknowns.
std::optional<RootProblem> widened(const RootProblem& problem) {
  // A change is noticed of which six digits are more than rounding.
  constexpr double noticed = 1e-6;
  RootProblem wider = problem;
  RootFunction function(problem, unlimited_work);
  const VectorXd u = middle_of_ranges(problem);
  const auto here = function.at(u);
  if (!here) return std::nullopt;
  bool any = false;
  for (Eigen::Index k = 0; k < function.unknowns(); ++k) {
    RootRange& range = wider.ranges[static_cast<std::size_t>(k)];
    if (std::isfinite(range.lower) && std::isfinite(range.upper)) continue;
    for (const double step : {1.0, 1e3, 1e6, 1e9, 1e12, 1e15}) {
      VectorXd moved = u;
      moved[k] += std::isinf(range.upper) ? step : -step;
      const auto there = function.at(moved);
      if (!there || there->values.size() != here->values.size()) break;
      if ((there->values - here->values).norm() <= noticed * std::max(here->size, there->size)) continue;
      any = any || step > 1;
      range.scale *= step;
      break;
    }
  }
  if (!any) return std::nullopt;
  return wider;
}

}  // namespace

Roots find_roots(const RootProblem& problem, Work most) {
  const WorkLimit limit(most);
  Roots roots = RootFinder(problem, most).find();
  if (!roots.points.empty() || problem.costly || limit.spent()) return roots;
  // The unknowns may have an effect only at values that are far larger than their natural sizes.
  if (const auto wider = widened(problem))
    if (Roots far = RootFinder(*wider, limit.left()).find(); !far.points.empty()) return far;
  return roots;
}

}  // namespace poinsot::solve
