// Finds extremes, zeros and periods of a number along a motion.
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
  // For an endless motion that does not repeat: the time at which it was clear that no later value exceeds this one,
  // s.
  double settled = 0;
};

// A number along a motion, with its rate if the motion knows it.
struct NumberWithRate {
  std::function<double(double time)> number, rate;
  double natural_size = 0;  // the natural size of such a number; 0 if it has none
};

// The number is assumed to be smooth within steps of the integration. Throws UnansweredError, at the mark, if the
// motion gives no answer: nothing repeats, or there is no extreme or zero as far as an endless motion is followed.
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

  // The extreme over the whole motion if it has an end; otherwise over as many cycles as are needed to see that it
  // repeats, or until it has come to rest or gone away.
  ExtremeFound largest() const;
  ExtremeFound smallest() const;
  double period() const;
  // sense 1: only zeros where the number rises, or the start if it is positive there; -1: where it falls, or
  // negative. Without `to`, only the first one.
  std::vector<double> zeros(double from, std::optional<double> to, int sense) const;
  std::vector<double> times_of_extreme(bool largest, double from, std::optional<double> to) const;
  // The latest time on which the results depend, s.
  double latest() const { return latest_; }

 private:
  struct Sampled {
    std::vector<double> time, value;
    std::size_t from(double part) const;  // the index of the first sample after this part of the time
  };
  // An extreme that is seen in the samples.
  struct Rough {
    double before = 0, middle = 0, after = 0;  // times
    double estimate = 0;                       // of the value, from a parabola
    double doubt = 0;                          // the possible error of the estimate
    bool smooth = true;                        // otherwise there may be a corner
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
  mutable Sampled sampled_;  // those from the start of the motion
  mutable double latest_ = 0;
};

}  // namespace poinsot::problem
