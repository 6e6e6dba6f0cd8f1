// Joints of the tree and the modes of their velocity coordinates.
#pragma once

#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

// How a body may move relative to its parent. F is the frame in which the joint is fixed to the parent, B the body's
// frame; they coincide in the neutral position.
//
// | type      | position coordinates                          | velocity coordinates                              |
// |-----------|-----------------------------------------------|---------------------------------------------------|
// | weld      | none                                          | none                                              |
// | revolute  | angle, rad                                    | its rate                                          |
// | prismatic | displacement, m                               | its rate                                          |
// | screw     | angle, rad (advance: pitch times angle)       | its rate                                          |
// | ball      | unit quaternion w x y z of R_FB               | angular velocity of B in F, on axes of B          |
// | free      | the same, then origin of B on axes of F, m    | the same, then velocity of the origin of B in F,  |
// |           |                                               | on axes of B                                      |
enum class JointType { weld, revolute, prismatic, screw, ball, free };

constexpr int position_size(JointType type) {
  switch (type) {
    case JointType::weld:
      return 0;
    case JointType::ball:
      return 4;
    case JointType::free:
      return 7;
    default:
      return 1;
  }
}
constexpr int velocity_size(JointType type) {
  switch (type) {
    case JointType::weld:
      return 0;
    case JointType::ball:
      return 3;
    case JointType::free:
      return 6;
    default:
      return 1;
  }
}

// What is known of a velocity coordinate: its force (free), its acceleration (prescribed), or that it stays at rest
// (locked: prescribed with acceleration zero). The other one of force and acceleration is found.
enum class CoordinateMode { free, prescribed, locked };

// A joint as stated; axis on the axes of the joint frame, of any length but zero.
template <class Scalar>
struct Joint {
  JointType type = JointType::weld;
  Vector3<Scalar> axis{Scalar(0), Scalar(0), Scalar(1)};
  Scalar pitch{};  // screw: advance along the axis per turn angle, m/rad

  static Joint weld() { return {}; }
  static Joint revolute(const Vector3<Scalar>& axis) { return {JointType::revolute, axis, Scalar(0)}; }
  static Joint prismatic(const Vector3<Scalar>& axis) { return {JointType::prismatic, axis, Scalar(0)}; }
  static Joint screw(const Vector3<Scalar>& axis, const Scalar& pitch) { return {JointType::screw, axis, pitch}; }
  static Joint ball() { return {JointType::ball}; }
  static Joint free() { return {JointType::free}; }
};

}  // namespace poinsot
