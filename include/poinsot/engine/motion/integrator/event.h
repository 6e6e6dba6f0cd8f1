// Instants at which a function of the motion is zero.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace poinsot {

enum class Crossing { any, rising, falling };

// A number in whose zeros the value of an event may have a corner, as in those of x where the value is abs(x), or in
// whose extremes it may turn sharply, as the distance to a point does where its square is least.
struct EventCorner {
  std::function<double(double t, std::span<const double> q, std::span<const double> v)> value;
  bool turns = false;  // in its extremes, else in its zeros
};

struct Event {
  std::string name;
  std::function<double(double t, std::span<const double> q, std::span<const double> v)> value;
  Crossing crossing = Crossing::any;
  bool terminal = false;  // the integration ends there
  // Natural size of the value: extremes within tolerance times size of zero count as touching it.
  double size = 1.0;
  bool touching = false;               // instants where the value touches zero without a change of sign are wanted too
  std::vector<EventCorner> corners{};  // between them the value is as smooth as the motion
};

struct EventHit {
  std::size_t event = 0;  // its place among the events asked
  double time = 0.0;      // s
  int direction = 0;      // +1 rising through zero in the sense of time's run, -1 falling, 0 touching
  std::vector<double> q;
  std::vector<double> v;
};

}  // namespace poinsot
