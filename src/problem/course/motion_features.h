// Extremes, zeros and periods of a number along a motion.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/language/diagnostic.h"

namespace poinsot::problem {

class Course;

struct ExtremeFound {
  double value = 0;
  double time = 0;
  double settled = 0;  // of an endless motion that does not repeat: when it was seen that nothing exceeds it later, s
};

// A number along a motion, and its rate where the motion itself knows that.
struct NumberWithRate {
  std::function<double(double time)> number, rate;
  double natural_size = 0;  // of such a number in this problem; 0 if it has none
};

// The number is taken as smooth between the steps of the integration. Throws StatementError, at the mark, where the
// motion does not answer: nothing repeats, there is no extreme or zero as far as an endless motion is followed.
class MotionFeatures {
 public:
  MotionFeatures(Course& motion, NumberWithRate number, std::string words, std::string file, Mark mark)
      : motion_(motion),
        number_(std::move(number.number)),
        rate_(std::move(number.rate)),
        natural_size_(number.natural_size),
        words_(std::move(words)),
        file_(std::move(file)),
        mark_(mark) {}

  // Over the whole motion if it has an end; of an endless one over as many cycles as it takes to see that it repeats,
  // or until it has come to rest or gone away.
  ExtremeFound largest() const;
  ExtremeFound smallest() const;
  double period() const;
  // sense 1: only where it rises through zero, or is positive at the start; -1: falls, or is negative. Without `to`,
  // the first only.
  std::vector<double> zeros(double from, std::optional<double> to, int sense) const;
  std::vector<double> times_of_extreme(bool largest, double from, std::optional<double> to) const;
  // The latest time on which what has been found depends, s.
  double latest() const { return latest_; }

 private:
  struct Sampled {
    std::vector<double> time, value;
    std::size_t from(double part) const;  // the first sample after this part of the time
  };
  // An extreme among samples.
  struct Rough {
    double before = 0, middle = 0, after = 0;  // times
    double estimate = 0;                       // of the value, by a parabola
    double doubt = 0;                          // how far that may be off
    bool smooth = true;                        // else there may be a corner
  };
  Sampled samples(double from, double to) const;
  std::vector<Rough> rough_extremes(const Sampled& sampled, bool largest) const;
  std::vector<ExtremeFound> extremes(const Sampled& sampled, bool largest) const;
  std::optional<ExtremeFound> met_twice(const Sampled& sampled, bool largest, double range) const;
  ExtremeFound extreme(bool largest) const;
  ExtremeFound outermost(const Sampled& sampled, bool largest) const;
  bool has_settled(const Sampled& sampled, bool largest, const ExtremeFound& best) const;
  bool goes_away(const Sampled& sampled, bool upwards) const;
  ExtremeFound note(const ExtremeFound& found) const {
    latest_ = std::max(latest_, found.time);
    return found;
  }
  std::optional<ExtremeFound> level_between(double before, double after) const;
  ExtremeFound outermost_between(double before, double after, bool largest) const;
  ExtremeFound polished(const Rough& rough, bool largest) const;
  std::optional<ExtremeFound> nearest_to_zero(const Sampled& sampled, std::size_t at) const;
  double zero_between(double a, double b, double level) const;

  Course& motion_;
  std::function<double(double time)> number_, rate_;
  double natural_size_;
  std::string words_, file_;
  Mark mark_;
  mutable Sampled sampled_;  // from the start
  mutable double latest_ = 0;
};

}  // namespace poinsot::problem
