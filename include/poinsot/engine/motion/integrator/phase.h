// A phase that grows evenly with time, counted in cycles and read without loss of digits after any number of them.
//
// Rate and offset carry twice the digits of a double, and the product with the time is formed with its rounding error,
// so that the fraction of the cycle is right to the last place of a double, however many cycles have passed. That is
// what keeps closed forms exact at late times: the error of a phase does not grow with it beyond that of the rate.
#pragma once

#include <cmath>
#include <cstdint>

namespace poinsot {

class Phase {
 public:
  struct Reading {
    double count;     // whole cycles, to the nearest
    double fraction;  // the rest, between -1/2 and 1/2
    double total() const { return count + fraction; }
  };

  Phase() = default;
  // rate: cycles per second; offset: cycles at t = 0.
  Phase(long double rate, long double offset)
      : rate_high_(static_cast<double>(rate)),
        rate_low_(static_cast<double>(rate - static_cast<long double>(rate_high_))),
        offset_high_(static_cast<double>(offset)),
        offset_low_(static_cast<double>(offset - static_cast<long double>(offset_high_))) {}

  // t in s.
  Reading at(double t) const {
    const Sum sum = sum_at(t);
    Reading reading{std::nearbyint(sum.high), 0};
    reading.fraction = (sum.high - reading.count) + sum.low;
    if (std::fabs(reading.fraction) > 0.75) {
      // Beyond 2^52 cycles the second number holds whole cycles too.
      const double more = std::nearbyint(reading.fraction);
      reading.count += more;
      reading.fraction -= more;
    }
    return reading;
  }
  // The phase in cycles, as one number.
  double total(double t) const {
    const Sum sum = sum_at(t);
    return sum.high + sum.low;
  }
  double rate() const { return rate_high_; }

 private:
  struct Sum {
    double high, low;
  };
  Sum sum_at(double t) const {
    const double product = rate_high_ * t;
    const double product_rest = std::fma(rate_high_, t, -product) + rate_low_ * t;
    const double high = product + offset_high_;
    const double part = high - product;
    const double rest = (product - (high - part)) + (offset_high_ - part);
    return {high, product_rest + rest + offset_low_};
  }

  double rate_high_ = 0, rate_low_ = 0;
  double offset_high_ = 0, offset_low_ = 0;
};

// The argument u = rate t + u_0 of elliptic functions, split into periods 2 K: u = 2 K count + argument, the argument
// in the middle cell, -K to K. Without periods, K infinite, u itself.
class CellPhase {
 public:
  struct Place {
    double count, argument;
    // sn, cn and their like have their signs changed.
    bool odd() const {
      // Beyond 2^53 every double is even.
      return std::fabs(count) < 0x1p53 && static_cast<std::int64_t>(count) % 2 != 0;
    }
  };

  CellPhase() = default;
  CellPhase(long double rate, long double initial_argument, long double quarter_period)
      : endless_(std::isinf(quarter_period)) {
    const long double cell = endless_ ? 1 : 2 * quarter_period;
    size_ = static_cast<double>(cell);
    phase_ = Phase(rate / cell, initial_argument / cell);
  }

  Place at(double t) const {
    if (endless_) return {0, phase_.total(t)};
    const Phase::Reading reading = phase_.at(t);
    return {reading.count, size_ * reading.fraction};
  }

 private:
  bool endless_ = false;
  double size_ = 1;
  Phase phase_;
};

}  // namespace poinsot
