// Finds extremes, zeros and periods of a number along a motion.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problem/course/followed_motion.h"
#include "problem/course/number_along_motion.h"
#include "problem/language/diagnostic.h"

namespace poinsot::problem {

// The number is assumed to be smooth within steps of the integration. Throws UnansweredError, at the mark, if the
// motion gives no answer: nothing repeats, or there is no extreme or zero as far as an endless motion is followed.
class MotionFeatures {
 public:
  // The motion must outlive the features. `words` are those of the number in the file, for messages at the mark.
  MotionFeatures(FollowedMotion& motion, NumberWithRate number, std::string words, std::string file, Mark mark)
      : motion_(motion), number_(motion, std::move(number), std::move(words), std::move(file), mark) {}

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
  // An extreme that is seen in the samples.
  struct Rough {
    double before = 0, middle = 0, after = 0;  // times
    double estimate = 0;                       // of the value, from a parabola
    double doubt = 0;                          // the possible error of the estimate
    bool smooth = true;                        // otherwise there may be a corner
  };
  std::vector<Rough> rough_extremes(const NumberSamples& sampled, bool largest) const;
  std::vector<ExtremeFound> extremes(const NumberSamples& sampled, bool largest) const;
  std::optional<ExtremeFound> met_twice(const NumberSamples& sampled, bool largest, double range) const;
  ExtremeFound extreme(bool largest) const;
  std::optional<double> fall_before(double until) const;
  ExtremeFound outermost(const NumberSamples& sampled, bool largest) const;
  bool has_settled(const NumberSamples& sampled, bool largest, const ExtremeFound& best) const;
  bool is_approached(const NumberSamples& sampled, bool largest, double extreme) const;
  bool is_sudden(const NumberSamples& sampled, std::size_t from) const;
  bool goes_away(const NumberSamples& sampled, bool upwards) const;
  ExtremeFound note(const ExtremeFound& found) const {
    latest_ = std::max(latest_, found.time);
    return found;
  }
  ExtremeFound polished(const Rough& rough, bool largest) const;
  double repeated(double range) const {
    const double natural = number_.natural_size();
    return motion_.repeats_to(natural > 0 ? range / natural : range);
  }
  std::optional<ExtremeFound> nearest_to_zero(const NumberSamples& sampled, std::size_t at) const;

  FollowedMotion& motion_;
  NumberAlongMotion number_;
  mutable double latest_ = 0;
};

}  // namespace poinsot::problem
