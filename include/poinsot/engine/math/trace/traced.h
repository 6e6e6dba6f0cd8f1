// A scalar that writes down what is computed with it: algorithms that run on it leave a straight-line program in which
// every common subexpression occurs once.
//
// A Formula (formula.h) is kept in the canonical form that people read. A Traced is a way of computing: a reference
// to an operation of the Trace that is being recorded. Recording is cheap (some hundred nanoseconds for an
// operation), so that equations with many thousand operations take milliseconds.
//
// Operations whose results are the same function of the inputs become one. Each is evaluated at random points of a
// finite field with 2^122 elements, and those with equal values are equal (except with a chance below 1e-20). So
// cos^2 + sin^2 is 1, and what cancels is 0. Numbers with few digits are taken as the fractions that they stand for:
// 0.1 is 1/10.
//
// Decisions in algorithms look at a sample: plain(x) is the value when each input has its sample number. The root of
// x^2 becomes x or -x by this sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "poinsot/engine/math/algebra/sine_cosine.h"

namespace poinsot {

class Trace;

class Traced {
 public:
  Traced() = default;  // zero
  // A constant of the trace that is being recorded.
  template <class Number>
  requires std::is_arithmetic_v<Number> Traced(Number number) : Traced(constant(static_cast<double>(number))) {}

  Traced& operator+=(const Traced& b) { return *this = *this + b; }
  Traced& operator-=(const Traced& b) { return *this = *this - b; }
  Traced& operator*=(const Traced& b) { return *this = *this * b; }
  Traced& operator/=(const Traced& b) { return *this = *this / b; }
  friend Traced operator+(const Traced& a) { return a; }
  friend Traced operator-(const Traced& a) { return a.node_ == 0 ? a : Traced(a.node_, !a.negative_); }
  friend Traced operator+(const Traced& a, const Traced& b);
  friend Traced operator-(const Traced& a, const Traced& b) { return a + -b; }
  friend Traced operator*(const Traced& a, const Traced& b);
  // A division by something that is zero everywhere throws std::domain_error.
  friend Traced operator/(const Traced& a, const Traced& b);
  friend bool operator==(const Traced&, const Traced&) = default;

  // For the sources of the room: the operation, and whether its result is taken with the other sign.
  Traced(std::uint32_t node, bool negative) : node_(node), negative_(negative) {}
  std::uint32_t node() const { return node_; }
  bool negative() const { return negative_; }

 private:
  static Traced constant(double number);

  std::uint32_t node_ = 0;
  bool negative_ = false;
};

enum class TracedOperation : std::uint8_t {
  constant,
  input,
  add,  // of a positive and any second operand
  multiply,
  divide,
  square_root,
  sine,
  cosine,
  arc_sine,
  arc_cosine,
  arc_tangent,
  arc_tangent_2,
  absolute
};

// A recording. While a TraceScope refers to it, all computing with Traced in this thread adds to it. A Traced belongs
// to the trace in which it was made and must not be used in another.
class Trace {
 public:
  Trace();
  ~Trace();
  Trace(Trace&&) noexcept;
  Trace& operator=(Trace&&) noexcept;

  // A new variable. sample: the number at which decisions look.
  Traced input(double sample);
  std::size_t input_count() const;
  // What was assumed to be positive, as it is at the sample: x where the root of x^2 was taken as x.
  const std::vector<Traced>& assumed_positive() const;

  struct Node;
  const std::vector<Node>& nodes() const;

 private:
  friend class TraceScope;
  friend struct TraceAccess;
  struct State;
  std::unique_ptr<State> state_;
};

class TraceScope {
 public:
  explicit TraceScope(Trace& trace);
  ~TraceScope();
  TraceScope(const TraceScope&) = delete;
  TraceScope& operator=(const TraceScope&) = delete;

 private:
  Trace::State* outer_;
};

Traced sqrt(const Traced& x);  // a negative constant throws std::domain_error
SineCosine<Traced> sine_cosine(const Traced& x);
SineVersine<Traced> sine_versine(const Traced& x);
Traced sin(const Traced& x);
Traced cos(const Traced& x);
Traced tan(const Traced& x);
Traced asin(const Traced& x);
Traced acos(const Traced& x);
Traced atan(const Traced& x);
Traced atan2(const Traced& y, const Traced& x);
Traced abs(const Traced& x);

double plain(const Traced& x);
bool is_constant(const Traced& x);
inline bool vanishes(const Traced& x) { return x.node() == 0; }
inline bool isfinite(const Traced&) { return true; }
template <class Predicate>
bool every_value(const Traced& x, Predicate predicate) {
  return predicate(plain(x));
}
// 1 or -1: the sign at the sample, 1 for zero.
inline Traced positive_sign(const Traced& x) { return Traced(plain(x) < 0 ? -1 : 1); }

}  // namespace poinsot
