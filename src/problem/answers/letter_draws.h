// Letters without value: the values at which a statement is tried in their place, and what a user is told of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/work/work.h"
#include "problem/formulas/letter_scan.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"
#include "problem/results/solution.h"
#include "problem/unknowns/unknown_search.h"

namespace poinsot::problem {

// The letters of all situations, each once, that the settings give no value.
std::vector<Letter> open_letters(const Statement& statement, const Settings& settings);

class LetterDraws {
 public:
  // The first draw is one at which what is assumed of letters alone holds, if there is any.
  LetterDraws(const Statement& statement, const Settings& settings);

  const std::vector<Letter>& letters() const { return letters_; }
  bool none() const { return letters_.empty(); }

  // Values for each letter at the draw that is current, or at others by their number after it; farther from the size of
  // a unit with a larger spread.
  std::vector<Value<double>> values(int after = 0, int spread = 0) const;
  // The settings with those of the current draw.
  Settings settings() const;
  // Draws anew; false if that was done as often as may be.
  bool next();

  // An error at a draw, as a user can read it: numbers in what is told of drawn letters are no data of the author's. An
  // error that is alike at every draw has none of them.
  StatementError told(const StatementError& error, bool alike) const;
  // Adds the values of the letters to warnings that hold at these values only.
  void tell(std::vector<std::string>& warnings) const;

 private:
  const Settings& settings_;
  std::vector<Letter> letters_;
  int draw_ = 0;
};

// The roots of the unknowns at other values of the letters than those at which solutions were found, up to a hundred
// times larger and smaller. A formula continues a root as far as there is one; another root may be there besides, which
// has no part in any formula found so far.
class RootsElsewhere {
 public:
  // found_at: the letters of the solutions, with all else that has a value. most: the work that the search may take.
  RootsElsewhere(const Statement& statement, const Settings& settings, const std::vector<Letter>& letters,
                 const std::vector<Unknown>& unknowns, const Settings& found_at, Work most);

  // The next root that none of the solutions has there; nothing once all letters were looked at. Solutions whose
  // unknowns have no formulas count for one root each.
  std::optional<AllSettings> next(const std::vector<Solution>& solutions);
  // Whether the unknowns of a solution have the formulas that they have in another one.
  static bool repeats(const Solution& solution, const std::vector<Solution>& others);
  // Whether a solution found at such a root may stand beside the first ones: its unknowns have formulas, and at the
  // letters of the first ones, of which it is none, these have no value or what is told of them excludes it.
  bool stands_beside(const Solution& solution) const;
  // Adds to each solution that is said to be there at letters that were looked at, and is not, what its letters must
  // be.
  void tell_where_there_is_none(std::vector<Solution>& solutions) const;
  // What is said of a root that is told by no formula.
  std::string words_of(const AllSettings& root) const;

 private:
  bool holds_at(const Solution& solution, const Settings& there) const;
  bool is_told_by(const Solution& solution, const AllSettings& root) const;
  Settings point(std::size_t index) const;

  const Statement& statement_;
  const Settings& settings_;
  const std::vector<Letter>& letters_;
  const std::vector<Unknown>& unknowns_;
  const Settings found_at_;
  const LetterScan scan_;
  const WorkLimit limit_;
  std::size_t looked_at_ = 0;
  std::vector<AllSettings> roots_;  // of the letters that are looked at, as far as they are not told yet
  struct Place {
    Settings letters;
    std::vector<AllSettings> roots;
  };
  std::vector<Place> searched_;  // places of which all roots are known
};

}  // namespace poinsot::problem
