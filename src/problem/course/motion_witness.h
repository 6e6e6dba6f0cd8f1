// Second roads to what is told of a motion. They are given numbers at times, and know nothing of how these were found.
//
// A motion is what its forces make of it: between two instants t1 and t2 with nothing sudden between them
//   q(t2) - q(t1) = integral of q',   v(t2) - v(t1) = integral of a,
// with q' and a those of single instants, by Gauss's rule. An extreme, a time and a period hold at times that have
// nothing to do with those at which they were sought.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/course/motion_features.h"

namespace poinsot::problem {

// Of an instant: coordinates and velocities with their rates. Velocities whose rates nothing determines, as they move
// no mass, are not known.
struct WitnessedState {
  std::vector<double> q, v, q_rate, v_rate;
  std::vector<bool> rate_known;
};
// Natural sizes of the coordinates and, up to a common pace, of the velocities; the pace at the start, 1/s.
struct NaturalSizes {
  std::vector<double> of_q, of_v;
  double pace = 0;
};

// Parts of one that are spread evenly over it, however many are taken.
double spread_evenly(std::size_t k);
// The numbers below `count` in an order of which each beginning is spread over them all.
std::vector<std::size_t> spread_order(std::size_t count);

// By how much the changes between two times differ from what the rates make of them, as a part of these changes; what
// changes little is measured by a small part of its size. Nothing where the motion gives no state.
std::optional<double> window_misfit(const std::function<std::optional<WitnessedState>(double)>& state_at, double from,
                                    double to, const NaturalSizes& sizes);

// What a second road finds against a motion or what is told of it, as a relative misfit, and its words.
struct MotionDoubt {
  double value = 0;
  std::string words;
};

// A stretch of a motion in which nothing sudden happens: which cords and contacts act in it, and its last step.
struct HeldStretch {
  std::vector<bool> acting;
  double last_step = 0, end = 0;  // s
};

// What gives way between two stretches that follow each other pulls or presses until it does. doubt_at: of an instant,
// nothing where the motion gives no state. The worst doubt just before each end; nothing where nothing gives way.
std::optional<MotionDoubt> doubt_before_giving_way(const std::vector<HeldStretch>& stretches,
                                                   const std::function<std::optional<MotionDoubt>(double)>& doubt_at);

// How far a scan contradicts what is told, as a part of the range of what is asked, and when it does most.
struct ScanMisfit {
  double value = 0;
  double time = 0;  // s
};

// A number along a motion, looked at where no search has looked; nothing where the motion does not give it.
class MotionScan {
 public:
  // The number is looked at `count` times from `from` to `to`.
  MotionScan(const std::function<double(double)>& number, double from, double to, std::size_t count);

  // natural: the size of such a number, beside which rounding is nothing.
  ScanMisfit of_extreme(const ExtremeFound& told, bool largest, double natural = 0) const;
  // sense as for MotionFeatures::zeros. Between `from` and `to` the times told are all.
  ScanMisfit of_zeros(const std::vector<double>& told, int sense) const;
  // The number is zero at all times: its size is told as the misfit.
  ScanMisfit of_zero() const;
  // The number after a period is what it was, and it is not so after a part of it.
  ScanMisfit of_period(double told) const;

 private:
  std::optional<double> at(double time) const;

  const std::function<double(double)>& number_;
  double from_, to_;
  std::vector<double> time_, value_;
  double low_ = 0, high_ = 0;
  double size_ = 0;
};

}  // namespace poinsot::problem
