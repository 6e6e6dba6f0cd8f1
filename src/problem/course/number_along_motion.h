// A number along a motion: its samples, and its extremes and zeros where samples have told where to look.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/course/followed_motion.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

struct ExtremeFound {
  double value = 0;
  double time = 0;
  // For an endless motion that does not repeat: the time at which it was clear that no later value exceeds this one,
  // s.
  double settled = 0;
  // Whether the motion comes ever closer to this value and never there.
  bool approached = false;
  // Of a motion that ends in the center that pulls it: when, s.
  double fallen = 0;
};

// What is to be said of how an extreme of an endless motion was told, after its name; "" if nothing.
std::string in_words(const ExtremeFound& found);

// What tells where a number has a corner: a number that is smooth along the motion has a zero there, or an extreme.
struct CornerInTime {
  std::function<double(double time)> number;
  bool turns = false;  // in its extremes, else in its zeros
};

// A number along a motion, with its rate if the motion knows it.
struct NumberWithRate {
  std::function<double(double time)> number, rate;
  double natural_size = 0;              // the natural size of such a number; 0 if it has none
  std::vector<CornerInTime> corners{};  // those in whose extremes it has some before those in whose zeros
};

struct NumberSamples {
  std::vector<double> time, value;
  std::size_t from(double part) const;  // the index of the first sample after this part of the time
};

class NumberAlongMotion {
 public:
  static constexpr std::size_t most_samples = 2'000'000;

  // The motion must outlive the number. `words` are those of the number in the file, for messages at the mark.
  NumberAlongMotion(FollowedMotion& motion, NumberWithRate number, std::string words, std::string file, Mark mark)
      : motion_(motion),
        number_(std::move(number.number)),
        rate_(std::move(number.rate)),
        natural_size_(number.natural_size),
        corners_(std::move(number.corners)),
        words_(std::move(words)),
        file_(std::move(file)),
        mark_(mark) {}

  double operator()(double time) const { return number_(time); }
  double natural_size() const { return natural_size_; }

  // Several in each step of the integration, where there may be corners, and where it turns just beside something
  // sudden. Throws UnansweredError if there are more than most_samples.
  NumberSamples samples(double from, double to) const;
  std::size_t count_of_samples(double from, double to) const;

  // The extreme between two times at which the slope vanishes; nothing if the slope does not change its sign there.
  std::optional<ExtremeFound> level_between(double before, double after) const;
  // The only extreme between two times, with a corner or without.
  ExtremeFound outermost_between(double before, double after, bool largest) const;
  // The time between two others at which the number is at a level on whose two sides it lies at these times.
  double zero_between(double a, double b, double level) const;

  // Throws UnansweredError: the words of the number, and then what is wrong with it.
  [[noreturn]] void unanswered(const std::string& what, const std::string& hint = "") const;
  // Throws NotHappeningError: nothing of the kind was found up to a time. ends: whether the motion ends there.
  [[noreturn]] void never(double until, bool ends) const;

 private:
  void add_corners(std::vector<double>& times) const;
  const std::vector<double>& turn_beside(double sudden, double away) const;
  void add_turns(NumberSamples& sampled) const;

  FollowedMotion& motion_;
  std::function<double(double time)> number_, rate_;
  double natural_size_;
  std::vector<CornerInTime> corners_;
  std::string words_, file_;
  Mark mark_;
  mutable NumberSamples sampled_;                                           // those from the start of the motion
  mutable std::map<std::pair<double, double>, std::vector<double>> turns_;  // as turn_beside() finds them
};

}  // namespace poinsot::problem
