// Letters without value: the values at which a statement is tried in their place, and what a user is told of them.
#pragma once

#include <string>
#include <vector>

#include "problem/language/diagnostic.h"
#include "problem/machine/data.h"

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

}  // namespace poinsot::problem
