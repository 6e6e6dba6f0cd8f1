// How exactly the pull of a center on bodies is known, in words.
//
// A particle or a sphere is pulled exactly. Of any other part terms beyond the second order are left out. With J the
// sum of m d^2 about its center C, s the farthest that its matter reaches from C and e = s/r, the terms of order n of
// the force are at most (n + 1) mu J s^(n-2)/r^(n+2), since the gradient of a solid harmonic P_n d^n/r^(n+1) is at most
// (n + 1) d^n/r^(n+2); those of the couple are at most sqrt(n (n + 1)) mu J s^(n-2)/r^(n+1).
#pragma once

#include <string>
#include <vector>

#include "problem/machine/machine.h"

namespace poinsot::problem {

// One sentence for the bodies that are pulled exactly, and one for each other. Nothing where no center pulls. q: the
// positions at which the size of what is left out is told.
std::vector<std::string> words_of_attraction(const Situation& situation, const Machine& machine,
                                             const std::vector<double>& q);
// Without sizes, where data are letters.
std::vector<std::string> words_of_attraction(const Situation& situation);

}  // namespace poinsot::problem
