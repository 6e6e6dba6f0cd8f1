// All roots of a system of equations in a range.
#pragma once

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
  std::vector<double> values;
  double size = 0;
};

struct RootProblem {
  std::vector<RootRange> ranges;  // one for each unknown
  // At least as many equations as unknowns; nothing where they have no value.
  std::function<std::optional<RootEquations>(const std::vector<double>&)> equations;
};

enum class RootSearch {
  linear,       // the equations are linear: their solution is the only one
  many_starts,  // found from many starts: there may be others
};

struct Roots {
  std::vector<std::vector<double>> points;  // ascending by their first unknown
  RootSearch search = RootSearch::linear;
  bool open = false;  // the equations leave the unknowns open, at least at a root
  std::vector<std::size_t> open_unknowns;
  std::vector<double> alternative;  // of linear equations that leave unknowns open: another solution
  double best_misfit = 0;           // where there is no root: the smallest misfit met
  std::size_t starts = 0;
};

// Equations are taken as equal to zero below a misfit of 1e-9 of the sizes of their terms. Ends within `seconds`.
Roots find_roots(const RootProblem& problem, double seconds = 8);

}  // namespace poinsot::solve
