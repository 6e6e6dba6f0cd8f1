// A vector that follows from the motion of a mechanism, as a load that depends on it needs: steps of arithmetic on
// constants and on parts of the motion, such as a component of the velocity of a point.
//
// It is evaluated over any scalar, so that whoever varies a state gets the slopes of the load with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/algebra/scalar.h"

namespace poinsot {

enum class MotionPartKind : std::uint8_t {
  position,          // of a place, from the ground's origin
  velocity,          // of a place, as seen from a body
  angular_velocity,  // of a body, as seen from another
  direction,         // that rides with a body
  coordinate,        // a position coordinate of the tree: its first component
  rate               // a velocity coordinate of the tree: its first component
};

// A part of the motion, on ground axes.
template <class Scalar>
struct MotionPart {
  MotionPartKind kind = MotionPartKind::position;
  Place<Scalar> at;  // of a direction: the vector that rides
  int seen_from = ground;
  int coordinate = 0;
};

enum class MotionOperation : std::uint8_t {
  constant,  // first: which
  part,      // first: which part of the motion, second: which component
  add,
  subtract,
  multiply,
  divide,
  square_root,
  sine,
  cosine,
  arc_tangent_2,  // of first over second
  absolute,
  magnitude  // of a vector with the components first, second, third
};
// Operands are the numbers of earlier steps.
struct MotionStep {
  MotionOperation operation = MotionOperation::constant;
  int first = 0, second = 0, third = 0;
};

namespace detail {

// The size of a vector. Where it vanishes it has no slope; the products in which it stands, such as |v| v, have the
// slope that is left when it is taken for zero.
template <class Number>
Number root_of_squares(const Number& sum) {
  using std::sqrt;
  return sqrt(sum);
}
template <int N, class Base>
Dual<N, Base> root_of_squares(const Dual<N, Base>& sum) {
  return vanishes(sum.value) ? Dual<N, Base>(0) : sqrt(sum);
}

template <class Number>
Number size_of_number(const Number& x) {
  using std::abs;
  if constexpr (requires { abs(x); })
    return abs(x);
  else
    return positive_sign(x) * x;
}
template <int N, class Base>
Dual<N, Base> size_of_number(const Dual<N, Base>& x) {
  const Base size = size_of_number(x.value);
  return vanishes(size) ? Dual<N, Base>(0) : x.chained(size, x.value / size);
}

// What the steps compute. part(which, component) and constant(which) give what stands in them.
template <class Number, class Part, class Constant>
std::array<Number, 3> run_motion_steps(const std::vector<MotionStep>& steps, const std::array<int, 3>& results,
                                       const Part& part, const Constant& constant) {
  std::vector<Number> value;
  value.reserve(steps.size());
  const auto at = [&](int i) -> const Number& { return value[static_cast<std::size_t>(i)]; };
  for (const MotionStep& step : steps) {
    switch (step.operation) {
      case MotionOperation::constant:
        value.push_back(constant(step.first));
        break;
      case MotionOperation::part:
        value.push_back(part(step.first, step.second));
        break;
      case MotionOperation::add:
        value.push_back(at(step.first) + at(step.second));
        break;
      case MotionOperation::subtract:
        value.push_back(at(step.first) - at(step.second));
        break;
      case MotionOperation::multiply:
        value.push_back(at(step.first) * at(step.second));
        break;
      case MotionOperation::divide:
        value.push_back(at(step.first) / at(step.second));
        break;
      case MotionOperation::square_root: {
        using std::sqrt;
        value.push_back(sqrt(at(step.first)));
        break;
      }
      case MotionOperation::sine:
        value.push_back(sine_cosine(at(step.first)).sine);
        break;
      case MotionOperation::cosine:
        value.push_back(sine_cosine(at(step.first)).cosine);
        break;
      case MotionOperation::arc_tangent_2: {
        using std::atan2;
        value.push_back(atan2(at(step.first), at(step.second)));
        break;
      }
      case MotionOperation::absolute:
        value.push_back(size_of_number(at(step.first)));
        break;
      case MotionOperation::magnitude:
        value.push_back(root_of_squares(Number(at(step.first) * at(step.first) + at(step.second) * at(step.second) +
                                               at(step.third) * at(step.third))));
        break;
    }
  }
  return {at(results[0]), at(results[1]), at(results[2])};
}

}  // namespace detail

template <class Scalar>
struct MotionExpression {
  std::vector<MotionPart<Scalar>> parts;
  std::vector<Scalar> constants;
  std::vector<MotionStep> steps;
  std::array<int, 3> results{};  // the steps that give the components
  int axes = ground;             // the body or frame on whose axes they are, and on which the parts enter

  // After update_velocities.
  Vector3<Scalar> value(const Model<Scalar>& tree, const Workspace<Scalar>& w) const {
    std::vector<Vector3<Scalar>> now;
    now.reserve(parts.size());
    for (const MotionPart<Scalar>& part : parts) now.push_back(value_of(part, tree, w));
    const auto found = detail::run_motion_steps<Scalar>(
        steps, results,
        [&](int i, int k) -> const Scalar& { return now[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]; },
        [&](int i) -> const Scalar& { return constants[static_cast<std::size_t>(i)]; });
    return {found[0], found[1], found[2]};
  }

  template <class Target, class Convert>
  MotionExpression<Target> converted(const Convert& to) const {
    MotionExpression<Target> target{{}, {}, steps, results, axes};
    for (const MotionPart<Scalar>& part : parts)
      target.parts.push_back({part.kind, to(part.at), part.seen_from, part.coordinate});
    for (const Scalar& x : constants) target.constants.push_back(to(x));
    return target;
  }

 private:
  Vector3<Scalar> value_of(const MotionPart<Scalar>& part, const Model<Scalar>& tree,
                           const Workspace<Scalar>& w) const {
    const auto coordinate = static_cast<std::size_t>(part.coordinate);
    if (part.kind == MotionPartKind::coordinate) return {w.q[coordinate], Scalar(0), Scalar(0)};
    if (part.kind == MotionPartKind::rate) return {w.v[coordinate], Scalar(0), Scalar(0)};
    return direction_on_body(tree, w, axes, on_ground(part, tree, w));
  }
  static Vector3<Scalar> on_ground(const MotionPart<Scalar>& part, const Model<Scalar>& tree,
                                   const Workspace<Scalar>& w) {
    const BodyMotion<Scalar>& from = w.motion[static_cast<std::size_t>(part.seen_from + 1)];
    if (part.kind == MotionPartKind::angular_velocity) return angular_velocity(w, part.at.body) - from.w;
    if (part.kind == MotionPartKind::direction) return direction_on_ground(tree, w, part.at.body, part.at.point);
    Vector3<Scalar> P = point_position(tree, w, part.at.body, part.at.point);
    if (part.kind == MotionPartKind::position) return P;
    return point_velocity(tree, w, part.at.body, part.at.point) - from.v - cross(from.w, P - from.p);
  }
};

}  // namespace poinsot
