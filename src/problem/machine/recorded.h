// A scalar that remembers how it was computed from parts of a motion whose values are not known yet.
//
// What rests on constants alone is computed at once, in the scalar of the constants. All else is a tree of the
// operations that a MotionExpression (engine/dynamics/motion_expression.h) can have. plain() of it is no number, so
// that no decision is taken on a value that the motion will bring.
#pragma once

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/motion_expression.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "problem/language/exact_numbers.h"

namespace poinsot::problem {

template <class Base>
class Recorded {
 public:
  using Constant = Base;
  struct Node {
    MotionOperation operation;
    std::vector<Recorded> operands;
    int part = 0, component = 0;  // of a part of the motion
  };

  Recorded() = default;
  Recorded(Base constant) : constant_(std::move(constant)) {}
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, Base>) Recorded(Number number) : constant_(number) {}
  Recorded(MotionOperation operation, std::vector<Recorded> operands, int part = 0, int component = 0)
      : node_(std::make_shared<const Node>(Node{operation, std::move(operands), part, component})) {}

  bool is_constant() const { return !node_; }
  const Base& constant() const { return constant_; }
  const Node* node() const { return node_.get(); }
  // Whether it is this number.
  bool is(int number) const { return !node_ && vanishes(constant_ - Base(number)); }

  friend Recorded operator+(const Recorded& a) { return a; }
  friend Recorded operator-(const Recorded& a) { return a.node_ ? Recorded(-1) * a : Recorded(-a.constant_); }
  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    if (a.is(0)) return b;
    if (b.is(0)) return a;
    if (both_constant(a, b)) return Base(a.constant_ + b.constant_);
    return {MotionOperation::add, {a, b}};
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    if (b.is(0)) return a;
    if (both_constant(a, b)) return Base(a.constant_ - b.constant_);
    return {MotionOperation::subtract, {a, b}};
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    if (a.is(0) || b.is(1)) return a;
    if (b.is(0) || a.is(1)) return b;
    if (both_constant(a, b)) return Base(a.constant_ * b.constant_);
    return {MotionOperation::multiply, {a, b}};
  }
  friend Recorded operator/(const Recorded& a, const Recorded& b) {
    if (a.is(0) || b.is(1)) return a;
    if (both_constant(a, b)) return Base(a.constant_ / b.constant_);
    return {MotionOperation::divide, {a, b}};
  }
  Recorded& operator+=(const Recorded& b) { return *this = *this + b; }
  Recorded& operator-=(const Recorded& b) { return *this = *this - b; }

 private:
  static bool both_constant(const Recorded& a, const Recorded& b) { return !a.node_ && !b.node_; }

  Base constant_{};
  std::shared_ptr<const Node> node_;
};

using poinsot::plain;
template <class Base>
double plain(const Recorded<Base>& x) {
  using poinsot::plain;
  return x.is_constant() ? plain(x.constant()) : std::numeric_limits<double>::quiet_NaN();
}
template <class Base>
bool is_constant(const Recorded<Base>& x) {
  using poinsot::is_constant;
  return x.is_constant() && is_constant(x.constant());
}

template <class Base>
Recorded<Base> sqrt(const Recorded<Base>& x) {
  using std::sqrt;
  if (x.is_constant()) return Base(sqrt(x.constant()));
  return {MotionOperation::square_root, {x}};
}
template <class Base>
Recorded<Base> abs(const Recorded<Base>& x) {
  if (x.is_constant()) return Base(poinsot::detail::size_of_number(x.constant()));
  return {MotionOperation::absolute, {x}};
}
template <class Base>
Recorded<Base> sin(const Recorded<Base>& x) {
  if (x.is_constant()) return Base(sine_cosine(x.constant()).sine);
  return {MotionOperation::sine, {x}};
}
template <class Base>
Recorded<Base> cos(const Recorded<Base>& x) {
  if (x.is_constant()) return Base(sine_cosine(x.constant()).cosine);
  return {MotionOperation::cosine, {x}};
}
template <class Base>
Recorded<Base> tan(const Recorded<Base>& x) {
  return sin(x) / cos(x);
}
template <class Base>
Recorded<Base> atan2(const Recorded<Base>& y, const Recorded<Base>& x) {
  using std::atan2;
  if (y.is_constant() && x.is_constant()) return Base(atan2(y.constant(), x.constant()));
  return {MotionOperation::arc_tangent_2, {y, x}};
}
template <class Base>
Recorded<Base> atan(const Recorded<Base>& x) {
  return atan2(x, Recorded<Base>(1));
}
template <class Base>
Recorded<Base> asin(const Recorded<Base>& x) {
  return atan2(x, sqrt((Recorded<Base>(1) - x) * (Recorded<Base>(1) + x)));
}
template <class Base>
Recorded<Base> acos(const Recorded<Base>& x) {
  return atan2(sqrt((Recorded<Base>(1) - x) * (Recorded<Base>(1) + x)), x);
}
template <class Base>
Recorded<Base> norm(const Vector3<Recorded<Base>>& v) {
  if (v.x.is_constant() && v.y.is_constant() && v.z.is_constant())
    return Base(norm(Vector3<Base>{v.x.constant(), v.y.constant(), v.z.constant()}));
  return {MotionOperation::magnitude, {v.x, v.y, v.z}};
}
// The smaller and the larger of two numbers.
template <class Base>
Recorded<Base> smaller(const Recorded<Base>& a, const Recorded<Base>& b) {
  return (a + b - abs(a - b)) / Recorded<Base>(2);
}
template <class Base>
Recorded<Base> larger(const Recorded<Base>& a, const Recorded<Base>& b) {
  return (a + b + abs(a - b)) / Recorded<Base>(2);
}

template <class Base>
inline constexpr bool is_exact<Recorded<Base>> = true;

}  // namespace poinsot::problem
