#include "poinsot/solve/roots.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "solve/chebyshev_roots.h"
#include "solve/few_evaluations.h"
#include "solve/linear_roots.h"
#include "solve/root_function.h"
#include "solve/root_polish.h"
#include "solve/scattered_starts.h"

namespace poinsot::solve {
namespace {

using Eigen::VectorXd;

constexpr std::size_t most_random_starts = 60;

class RootFinder {
 public:
  RootFinder(const RootProblem& problem, double seconds) : function_(problem, seconds) {}

  Roots find() {
    Roots roots;
    if (function_.problem().costly && function_.unknowns() > 0) {
      from_few_evaluations(roots);
    } else if (auto linear = linear_roots(function_)) {
      roots = std::move(*linear);
    } else if (function_.unknowns() <= 2) {
      by_polynomials(roots);
    } else {
      roots.search = RootSearch::many_starts;
      from_random_starts(roots);
    }
    if (roots.search != RootSearch::linear) {
      roots.points = found_.points(function_);
      if (roots.points.empty()) roots.best_misfit = smallest_misfit();
    }
    if (roots.points.empty() && function_.best().size()) roots.best = function_.unscaled(function_.best());
    roots.evaluations = function_.evaluations();
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
    const bool valued = function_.best().size() > 0;
    roots.search = roots.unresolved.empty() && valued ? RootSearch::certified : RootSearch::many_starts;
    if (roots.search == RootSearch::certified || roots.open) return;
    std::vector<VectorXd> starts = starts_on_grid(function_);
    starts.insert(starts.begin(), chebyshev.places.begin(), chebyshev.places.end());
    for (const VectorXd& start : starts) {
      if (function_.out_of_time() || roots.open) break;
      from_start(start, roots);
    }
  }

  // Curves of solutions may be several, and other unknowns be open along another.
  void look_for_other_families(Roots& roots) {
    constexpr std::size_t starts = 10;
    for (const VectorXd& start : starts_at_random(function_.problem(), starts)) {
      if (function_.out_of_time() || roots.open_unknowns.size() == function_.problem().ranges.size()) return;
      const auto root = polish(function_, start);
      if (!root || !root->zero || !function_.inside(root->u)) continue;
      const auto family = family_through(function_, *root);
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
    for (const VectorXd& start : starts_from_few_evaluations(function_)) {
      if (function_.out_of_time() || roots.open) break;
      from_start(start, roots);
    }
  }

  // When a few starts have all led to one place, inside the ranges or not, it is taken for the only one.
  void from_random_starts(Roots& roots) {
    constexpr int enough = 4;
    constexpr std::size_t most_used = 24;
    std::vector<VectorXd> starts = starts_at_random(function_.problem(), most_random_starts);
    starts.insert(starts.begin(), middle_of_ranges(function_.problem()));
    std::optional<VectorXd> only;
    int led_there = 0;
    for (const VectorXd& start : starts) {
      if (function_.out_of_time() || led_there >= enough || roots.starts >= most_used || roots.open) break;
      const auto root = from_start(start, roots);
      if (!root) continue;
      if (!only) only = root->u;
      const bool same = (root->u - *only).norm() <= root->radius + 1e-6 * (1e-3 + only->norm());
      led_there = same && led_there >= 0 ? led_there + 1 : -1;  // two places: never enough
    }
  }

  std::optional<PolishedRoot> from_start(const VectorXd& start, Roots& roots) {
    ++roots.starts;
    auto root = polish(function_, start);
    if (!root || !root->zero) return std::nullopt;
    if (found_.add(function_, *root))
      if (const auto family = family_through(function_, *root)) {
        roots.open = true;
        roots.open_unknowns = family->open_unknowns;
        roots.alternative = function_.unscaled(family->other);
      }
    return root;
  }

  // Where nothing was found: how close the equations come.
  double smallest_misfit() {
    if (function_.best().size() && !function_.out_of_time()) polish(function_, VectorXd(function_.best()));
    return function_.best_misfit();
  }

  RootFunction function_;
  RootList found_;
};

}  // namespace

Roots find_roots(const RootProblem& problem, double seconds) { return RootFinder(problem, seconds).find(); }

}  // namespace poinsot::solve
