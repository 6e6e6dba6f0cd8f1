// All roots of a system of equations in a range.
//
// One or two unknowns: the equations are replaced by Chebyshev polynomials, piece by piece, to about 1e-12 of their
// size; with two unknowns to 1e-7, and better on smaller pieces where that leaves anything open (J. P. Boyd, Solving
// Transcendental Equations, SIAM 2014, chapters 2 and 15; L. N. Trefethen, Approximation Theory and Approximation
// Practice, SIAM 2013). The polynomials are divided until their coefficients exclude a root or show that there is
// exactly one (R. Krawczyk, Computing 4, 187, 1969), which is polished on the equations themselves. A search that
// resolves everything this way is certified: complete as far as the polynomials stand for the equations, which is
// tested at random points of each piece.
// More unknowns: those that enter linearly are eliminated; if one or two are left, the search is as for these.
// Otherwise Levenberg and Marquardt's method from many starts.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/work/work.h"

namespace poinsot::solve {

struct RootRange {
  double lower = 0, upper = 0;                  // infinite if there is no end
  double scale = 1;                             // the natural size of the unknown
  bool lower_open = false, upper_open = false;  // whether the end is excluded, with what lies within rounding of it
};

// The left sides of equations that must vanish, and the size of the largest of their terms.
struct RootEquations {
  std::vector<double> values = {};
  double size = 0;
  // Optional: a smoother function that vanishes wherever the equations hold, and the size of its terms. Roots are
  // sought with it and must then satisfy both.
  std::vector<double> smooth = {};
  double smooth_size = 0;
  // Optional: the size of the terms of each value, where they are of different kinds. Then each must vanish beside its
  // own.
  std::vector<double> sizes = {};
};

struct RootProblem {
  std::vector<RootRange> ranges;  // one for each unknown
  // At least as many equations as unknowns; nothing where they have no value. Only roots of smooth functions can be
  // certified: weights of equations should not jump or have corners.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> equations;
  // If set, used where slopes are needed, in place of central differences: the equations, and in (*slopes)[i][k] the
  // derivative of value i by unknown k (of smooth value i, if there are such). Where it gives nothing, differences are
  // taken.
  std::function<std::optional<RootEquations>(const std::vector<double>&, std::vector<std::vector<double>>* slopes)>
      slopes;
  // Optional: the smooth equations alone, with `values` left empty, if they take less time than all; otherwise all.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> smooth = {};
  // Whether equations may have corners, as those of abs, max and norm: they can be linear on either side of one, so
  // that a few probes do not tell that they are linear.
  bool corners = false;
  // A misfit below this part of the size of the terms counts as zero. Terms that cancel leave some 1e-14 of rounding in
  // a machine of a few bodies and some 1e-11 where a loop is closed on the way; what is stated to eight digits, as many
  // data are, misses by 1e-9 and more, and is no root.
  double zero = 1e-9;
  bool costly = false;  // whether an evaluation takes long, as when a motion is followed; then there are few
  // Optional, for such problems: a faster evaluation with an error of about 1e-7, by which roots are located first.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> rough = {};
};

enum class RootSearch {
  linear,           // the equations are linear: their solution is the only one
  certified,        // there are no other roots in the ranges, as far as Roots::reach
  many_starts,      // found from many starts: there may be others
  few_evaluations,  // of equations that are costly to evaluate: there may be others
};

// What a dense scan, by the equations themselves and not by polynomials, says of the roots of one or two unknowns.
struct RootScan {
  std::size_t places = 0;  // at which the equations were evaluated
  // How far a root that the scan came to lies from the nearest one known, the largest, as a part of its size.
  double farthest = 0;
  std::vector<std::vector<double>> missed;  // roots that were not known
};

// A part of the ranges in which roots could neither be found nor excluded.
struct UnresolvedPart {
  std::vector<double> lower, upper;  // of each unknown
  std::string reason;
};

struct Roots {
  std::vector<std::vector<double>> points;  // ascending by their first unknown
  RootSearch search = RootSearch::linear;
  bool open = false;  // whether the equations leave unknowns open, at least at one root
  std::vector<std::size_t> open_unknowns;
  std::vector<double> alternative;         // another solution, if unknowns are open
  double best_misfit = 0;                  // the smallest misfit met, if there is no root
  std::vector<double> best;                // the place where it was met; empty if the equations had no value anywhere
  std::size_t starts = 0;                  // of a search from many starts
  std::size_t evaluations = 0;             // of the equations
  double reach = 0;                        // infinite ranges were searched as far as this many natural sizes
  std::vector<UnresolvedPart> unresolved;  // why a search for one or two unknowns is not certified
};

// A second road to the roots, which shares no polynomial, no linearity and no slope with find_roots, only the
// equations. It does about so much work, but looks at a few dozen places at least. Nothing where the unknowns are more
// than two, open, or found by following motions.
std::optional<RootScan> scan_roots(const RootProblem& problem, const Roots& known, Work most);

// By which part of itself, where that is more than a millionth, rounding lets each unknown of a root be off: 0 for one
// of which six digits are known, 1 for one of which none is. Up to a hundred evaluations for an unknown where
// there is a suspicion, else a few. Of what is zero it says nothing.
std::vector<double> blur_of_root(const RootProblem& problem, const std::vector<double>& point, Work most);

// Roots that are closer than rounding can tell are one. The search ends when `most` work is done: that
// of the equations, as far as they count it, and a little for each evaluation.
Roots find_roots(const RootProblem& problem, Work most = 8'000'000'000);

}  // namespace poinsot::solve
