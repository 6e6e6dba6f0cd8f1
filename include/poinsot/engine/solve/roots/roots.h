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

namespace poinsot::solve {

struct RootRange {
  double lower = 0, upper = 0;                  // infinite where open
  double scale = 1;                             // a natural size of the unknown
  bool lower_open = false, upper_open = false;  // the end itself is excluded, and what lies within rounding of it
};

// Left sides of equations that must vanish, and the size of the largest terms in them.
struct RootEquations {
  std::vector<double> values = {};
  double size = 0;
  // Optional: a smoother function that vanishes wherever the equations hold, and the size of its terms. Roots are then
  // sought with it; they must satisfy both.
  std::vector<double> smooth = {};
  double smooth_size = 0;
};

struct RootProblem {
  std::vector<RootRange> ranges;  // one for each unknown
  // At least as many equations as unknowns; nothing where they have no value. What can be certified are the roots of
  // smooth functions: weights of equations should not jump or have corners.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> equations;
  // If set, used where slopes are needed, in place of central differences: the equations, and in (*slopes)[i][k] the
  // derivative of value i by unknown k (of smooth value i, if there are such). Where it gives nothing, differences are
  // taken.
  std::function<std::optional<RootEquations>(const std::vector<double>&, std::vector<std::vector<double>>* slopes)>
      slopes;
  // Optional: the smooth equations alone, `values` left empty, where these are found sooner than all; else all.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> smooth = {};
  bool costly = false;  // an evaluation takes long (a motion is followed): few are made
  // Optional, for these: the equations sooner, to about 1e-7 of their size. Roots are looked for with them.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> rough = {};
  // Seconds since some time, by which a search ends; the steady clock when left out.
  std::function<double()> clock = {};
};

enum class RootSearch {
  linear,           // the equations are linear: their solution is the only one
  certified,        // there are no other roots in the ranges, as far as Roots::reach
  many_starts,      // found from many starts: there may be others
  few_evaluations,  // of equations that are costly to evaluate: there may be others
};

// A part of the ranges where roots could neither be found nor excluded.
struct UnresolvedPart {
  std::vector<double> lower, upper;  // of each unknown
  std::string reason;
};

struct Roots {
  std::vector<std::vector<double>> points;  // ascending by their first unknown
  RootSearch search = RootSearch::linear;
  bool open = false;  // the equations leave the unknowns open, at least at a root
  std::vector<std::size_t> open_unknowns;
  std::vector<double> alternative;         // where unknowns are open: another solution
  double best_misfit = 0;                  // where there is no root: the smallest misfit met
  std::vector<double> best;                // and the place of it; empty if the equations had no value anywhere
  std::size_t starts = 0;                  // of a search from many starts
  std::size_t evaluations = 0;             // of the equations
  double reach = 0;                        // infinite ranges of a certified search end at so many natural sizes
  std::vector<UnresolvedPart> unresolved;  // why a search for one or two unknowns is not certified; a few parts
};

// Equations are taken as equal to zero below a misfit of 1e-9 of the sizes of their terms. Roots closer together than
// rounding can tell are one. Ends within `seconds`.
Roots find_roots(const RootProblem& problem, double seconds = 8);

}  // namespace poinsot::solve
