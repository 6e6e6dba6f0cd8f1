// A problem with open letters, solved by numbers at letters chosen to tell how its answers depend on them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/entries/statement.h"
#include "problem/language/exact_numbers.h"
#include "problem/language/value.h"

namespace poinsot::problem {

// Which units are changed; `fall`: those of length and time, so that accelerations (of gravity) keep their numbers.
enum class Units { length, mass, time, fall };
// The power of the scale by which numbers of a dimension change then.
double exponent_of(const Dimension& dimension, Units units);

// Each trial is made once, for all answers.
class ScalingTrials {
 public:
  // Every answer; none where it has no value there.
  using Answers = std::vector<std::optional<Value<double>>>;
  // Throws StatementError where the letters make no sense.
  using Solve = std::function<Answers(const LetterValues& letters)>;
  struct Point {
    LetterValues letters;
    Answers answers;
  };

  // base: letters at which everything has a value. near: other values stay within a quarter of these, for answers that
  // exist only there; else they are drawn over two octaves, angles from 0.2 to 1.2 rad. error: of the numbers,
  // relative.
  ScalingTrials(std::vector<Letter> letters, LetterValues base, bool near, double error, Solve solve);

  const std::vector<Letter>& letters() const { return letters_; }
  const Letter& letter(const std::string& name) const;
  double error() const { return error_; }

  // These throw NoFormula if there are not enough values of the letters at which the problem makes sense.
  const Point& base();
  // In other units: all letters scaled as their dimensions ask, with the scale.
  const std::pair<double, Point>& scaled(Units units);
  // One letter alone at other values.
  const std::vector<Point>& moved(const std::string& letter);
  // An angle alone beyond those values: up to a half turn, and negative. Empty where others stay near the base. A point
  // has no answers where they take too long, or beyond one that lacks an answer.
  const std::vector<Point>& turned(const std::string& angle);
  // All letters drawn at random, three times.
  const std::vector<Point>& drawn();

 private:
  // Points found once, or why there are none.
  class Known {
   public:
    const std::vector<Point>& get(const std::function<std::vector<Point>()>& find);

   private:
    std::optional<std::vector<Point>> points_;
    std::optional<std::string> refused_;
  };

  std::optional<Point> tried(const LetterValues& letters) const;
  std::vector<double> values_to_try(const Letter& letter) const;

  std::vector<Letter> letters_;
  LetterValues base_letters_;
  bool near_;
  double error_;
  Solve solve_;
  std::optional<Point> base_;
  std::map<Units, std::pair<double, Point>> scaled_;
  std::map<std::string, Known> moved_, turned_;
  Known drawn_;
};

}  // namespace poinsot::problem
