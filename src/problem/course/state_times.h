// The search for the times at which something comes into a state along a motion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/words.h"

namespace poinsot::problem {

// What is said of a search in vain, and what can be done.
inline std::string in_vain(const std::string& state, double reached) {
  return state + " does not happen up to " + with_digits(reached, 4) + " s";
}
inline constexpr const char* look_until = "check the condition, or say until when it is sought: to: 4 s";

// The times between `from` and `until` at which pieces of the stages begin that are in a state, after others that are
// not; `from` if the piece there is in it. is: whether the piece of a stage with this number is.
template <class Stages, class Is>
std::vector<double> entries_into(const Stages& stages, double from, double until, const Is& is) {
  std::vector<double> found;
  bool before = false;
  for (const auto& stage : stages)
    for (std::size_t i = 0; i < stage.pieces.size(); ++i) {
      const auto& piece = stage.pieces[i];
      if (piece.empty() || piece.end_time() <= from || piece.start_time() >= until) continue;
      const bool now = is(stage, i);
      if (now && !before) found.push_back(std::max(from, piece.start_time()));
      before = now;
    }
  return found;
}

// Looks for times up to `to`; without it, farther and farther until there are some. find: the times up to one to which
// the motion is followed. none: is told how far it was looked in vain, and throws where that is enough.
template <class Find, class None>
std::vector<double> sought_times(double from, std::optional<double> to, double pace, const Find& find,
                                 const None& none) {
  double span = pace;
  for (double until = to ? *to : from + span;; until = from + (span *= 2)) {
    std::vector<double> found = find(until);
    if (to || !found.empty()) return found;
    none(until);
  }
}

}  // namespace poinsot::problem
