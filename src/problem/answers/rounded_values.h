// What of a number is rounding, told by the numbers themselves: solved anew with every operation rounded upwards, and
// again downwards, what is only left over from rounding is another number, and what is real stays.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problem/unknowns/sample.h"

namespace poinsot::problem {

class RoundedValues {
 public:
  // The arguments must outlive it.
  RoundedValues(const Statement& statement, const AllSettings& settings) : statement_(statement), settings_(settings) {}

  // The values of an ask for each way of rounding; none where it has no value so. Not for asks that follow a motion.
  const std::vector<Value<double>>& of(const Ask& ask);

  // How far rounding moves any number of the ask's value.
  double spread(const Ask& ask, const Value<double>& value);

 private:
  const Statement& statement_;
  const AllSettings& settings_;
  std::map<std::string, std::vector<Value<double>>> known_;  // by ask
};

// Numbers that are rounding become zero. From 1e-14 of `size` on none is taken for it; below, one is if it is less than
// the last digit of its vector or of `asked_size`, or another number in one of the rounded values. Where there are none
// of these: if it is less than 1e-14 of its vector or of asked_size.
void drop_noise(Value<double>& value, double size, double asked_size, const std::vector<Value<double>>& rounded);

}  // namespace poinsot::problem
