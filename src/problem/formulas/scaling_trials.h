// A problem solved by numbers at values of the letters that are chosen to show how its answers depend on them.
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

// The units that are changed. `fall` changes those of length and time such that accelerations (of gravity) keep their
// numbers.
enum class Units { length, mass, time, fall };
// The power of the scale with which the numbers of a dimension change.
double exponent_of(const Dimension& dimension, Units units);

// Solves each trial once, for all answers.
class ScalingTrials {
 public:
  // The value of every answer; nothing where it has none.
  using Answers = std::vector<std::optional<Value<double>>>;
  // Throws StatementError where the problem makes no sense at the letters.
  using Solve = std::function<Answers(const LetterValues& letters)>;
  struct Point {
    LetterValues letters;
    Answers answers;
  };

  // base: values of the letters at which all answers exist. near: other values stay within a quarter of these, for
  // answers that exist only there; otherwise they are drawn over two octaves, and angles from 0.2 to 1.2 rad. error:
  // the relative error of the numbers.
  ScalingTrials(std::vector<Letter> letters, LetterValues base, bool near, double error, Solve solve);

  const std::vector<Letter>& letters() const { return letters_; }
  const Letter& letter(const std::string& name) const;
  double error() const { return error_; }

  // The following throw NoFormula if there are not enough values of the letters at which the problem makes sense.
  const Point& base();
  // The point at which all letters are scaled by their dimensions, as if units were changed, and the scale.
  const std::pair<double, Point>& scaled(Units units);
  // Points at which a single letter has other values.
  const std::vector<Point>& moved(const std::string& letter);
  // Fourteen points or fewer at which a single letter, which is no angle, goes from a third to three times its value.
  const std::vector<Point>& along(const std::string& letter);
  // Points at which an angle alone goes beyond those values: up to half a turn, and negative. There are none if
  // trials stay near the base. A point has no answers if they take too long, or if it lies beyond a point that lacks
  // an answer.
  const std::vector<Point>& turned(const std::string& angle);
  // Three points at which all letters are random.
  const std::vector<Point>& drawn();
  // Sixteen points, where there is an answer, at which all letters are random within a seventh of the base: on the same
  // side of every branch as the base, unless it lies close to the border.
  const std::vector<Point>& around();

 private:
  // Points that are found once, or the reason why there are none.
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
  std::map<std::string, Known> moved_, turned_, along_;
  Known drawn_, around_;
};

}  // namespace poinsot::problem
