// Collects why a statement could not be solved at the points at which a claim is tried.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/entries/drawn_letters.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// The values of the letters at a point as words: "m = 2 kg, L = 0.5 m".
std::string words_of_point(const std::vector<Letter>& letters, const Point& point);

// Counts faults by their kind, and keeps of each kind the first with its point.
class ClaimFaults {
 public:
  void note(const StatementError& error, const Point& point);
  bool empty() const { return met_.empty(); }

  // The most frequent fault (the first of several), with the values of the letters in its message.
  StatementError most_frequent(const std::vector<Letter>& letters) const;
  // The same as words: "a moment of inertia is negative, as at m = 2 kg".
  std::string words(const std::vector<Letter>& letters) const;

 private:
  struct Met {
    StatementError error;
    std::string kind;
    Point point;
    int times = 1;
  };
  const Met& chief() const;

  std::vector<Met> met_;
};

}  // namespace poinsot::problem
