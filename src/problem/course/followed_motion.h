// What a search for extremes, zeros and periods needs to know of a motion, beside the number that it looks at.
#pragma once

#include <optional>
#include <vector>

namespace poinsot::problem {

class FollowedMotion {
 public:
  virtual ~FollowedMotion() = default;

  // Times between which the motion is smooth and changes little, from `from` to `to`, both included.
  virtual std::vector<double> nodes(double from, double to) = 0;
  // The times within these, and they themselves, between which nothing sudden happens.
  virtual std::vector<double> breaks(double from, double to) { return {from, to}; }
  // The end of the motion, if it has one, s.
  virtual std::optional<double> end() = 0;
  // How far it has been followed, s.
  virtual double reached() const = 0;
  // A time in which the motion changes noticeably, s.
  virtual double pace_time() const = 0;
  // A time in which it changes noticeably at the rates that it has had so far, s: longer than the pace time where what
  // sets the pace moves nothing.
  virtual double turning_time(double until) = 0;
  // Whether an endless motion is not followed beyond a time: for the number of its steps, or also for its length.
  virtual bool followed_by_many_steps(double until) const = 0;
  virtual bool followed_enough(double until) const = 0;
  // Whether it loses energy in its last stage and nothing drives it; whether springs can bring it back.
  virtual bool dissipates() const = 0;
  // Whether dry friction or blows may bring it to rest, which takes a finite time.
  virtual bool may_come_to_rest() const { return false; }
  virtual bool has_springs() const = 0;
  // Whether nothing moves any more at a time to which it has been followed, nor ever will: friction holds it all.
  virtual bool rests_at(double /*time*/) const { return false; }
  // Whether at a time to which it has been followed what a center pulls has as good as come there, where it ends.
  virtual bool ends_in_center(double /*time*/) { return false; }
  // The part of its range to which a number returns where the motion repeats: its error along some periods. range: in
  // the natural size of such numbers.
  virtual double repeats_to(double /*range*/) const { return 1e-7; }
};

}  // namespace poinsot::problem
