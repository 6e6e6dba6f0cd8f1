// Tells which numbers of a value are rounding. The statement is solved again with every operation and every number of
// the file rounded upwards and once more downwards: a number that is nothing but rounding changes, and a real one
// stays.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

class RoundedValues {
 public:
  // The arguments must outlive the object.
  RoundedValues(const Statement& statement, const AllSettings& settings) : statement_(statement), settings_(settings) {}

  // The values of an ask for each direction of rounding, left out where it has none. This is not for asks that follow
  // a motion.
  const std::vector<Value<double>>& of(const Ask& ask);

  // The largest change that rounding makes in any number of the ask's value.
  double spread(const Ask& ask, const Value<double>& value);

 private:
  const Statement& statement_;
  const AllSettings& settings_;
  std::map<std::string, std::vector<Value<double>>> known_;  // by ask
};

// What may be noise, as a part of the natural size of a quantity: rounding at an instant, and what following a motion
// leaves besides, which is told to some thirteen digits.
inline constexpr double noise_of_instant = 1e-14, noise_of_motion = 1e-13;

// Sets numbers to zero that are rounding. Numbers of at least `noise` of `size` are not. A smaller one is rounding if
// it is less than the last digit of its vector, or if one of the rounded values has a different number; what is small
// beside the system alone is none: the drag of a mote on a planet. Without rounded values it is rounding if it is less
// than `noise` of its vector or of `asked_size`.
void drop_noise(Value<double>& value, double size, double asked_size, const std::vector<Value<double>>& rounded,
                double noise);

}  // namespace poinsot::problem
