// The memory that the algorithms of this room work in. Made once for a model; the algorithms allocate nothing. One
// workspace serves one thread. What an algorithm leaves in it is read by the functions of that algorithm's header.
#pragma once

#include <vector>

#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/model.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {

// Pose and motion of a body's working frame, on ground axes (kinematics.h).
template <class Scalar>
struct BodyMotion {
  Matrix3<Scalar> R{};      // working axes to ground axes
  Vector3<Scalar> p{};      // ground origin to body origin, m
  Vector3<Scalar> w{};      // angular velocity, rad/s
  Vector3<Scalar> v{};      // velocity of the body's origin, m/s
  Vector3<Scalar> alpha{};  // angular acceleration, rad/s^2
  Vector3<Scalar> a{};      // acceleration of the body's origin, m/s^2
};

// What the recursive Newton-Euler algorithm keeps of a body, on its working axes (inverse_dynamics.h).
template <class Scalar>
struct NewtonEulerBody {
  Matrix3<Scalar> R{};            // its axes to its parent's
  Vector3<Scalar> p{};            // its origin on its parent's axes, m
  Vector3<Scalar> w{};            // angular velocity, rad/s
  Vector3<Scalar> alpha{};        // angular acceleration, rad/s^2
  Vector3<Scalar> a{};            // acceleration of its origin less gravity, m/s^2
  Matrix3<Scalar> A{};            // [alpha]x + [w]x [w]x: relative acceleration of its points
  SpatialForce<Scalar> wrench{};  // through its joint, about its origin
};

// What the articulated-body algorithm keeps of a body, on the axes of its tree's first body about its own origin
// (articulated_body.h).
template <class Scalar>
struct ArticulatedBody {
  Matrix3<Scalar> R{};
  Vector3<Scalar> r{};  // from its parent's origin to its own, m
  Vector3<Scalar> w{};
  Vector3<Scalar> alpha{};  // accelerations while the free coordinates have none, less gravity
  Vector3<Scalar> a{};
  Matrix3<Scalar> A{};
  ArticulatedInertia<Scalar> inertia{};
  SpatialForce<Scalar> bias{};                 // articulated force at those accelerations
  SymmetricMatrix3<Scalar> inverse_inertia{};  // of the angular block (ball)
  SpatialMotion<Scalar> change{};              // of the accelerations by the free coordinates
};

// One velocity coordinate in the articulated-body algorithm.
template <class Scalar>
struct ArticulatedCoordinate {
  SpatialForce<Scalar> U{};  // inertia times its motion
  Scalar inverse_inertia{};  // 1 / (motion . U)
  Scalar residual{};         // force not balanced by the bias; for a given coordinate minus the bias
};

// Composite inertia of the bodies outboard, on the axes of the tree's first body about the body's own origin
// (mass_matrix.h).
template <class Scalar>
struct CompositeBody {
  Matrix3<Scalar> R{};
  Vector3<Scalar> r{};          // from its parent's origin to its own, m
  Vector3<Scalar> from_root{};  // from the origin of its tree's first body, m
  SpatialInertia<Scalar> inertia{};
};

// Slot 0 of each array over bodies belongs to the ground, slot i + 1 to body i.
template <class Scalar>
struct Workspace {
  explicit Workspace(const Model<Scalar>& model)
      : sines(model.position_size()),
        cosines(model.position_size()),
        q(model.position_size()),
        v(model.velocity_size()),
        motion(model.body_count() + 1),
        newton_euler(model.body_count() + 1),
        articulated(model.body_count() + 1),
        coordinate(model.velocity_size()),
        composite(model.body_count() + 1) {
    motion[0].R = Matrix3<Scalar>::identity();
    newton_euler[0].R = Matrix3<Scalar>::identity();
    articulated[0].R = Matrix3<Scalar>::identity();
    composite[0].R = Matrix3<Scalar>::identity();
    for (std::vector<Scalar>& component : coordinate_motion) component.resize(model.velocity_size());
  }

  std::vector<Scalar> sines;  // of each revolute or screw joint's angle, by position coordinate
  std::vector<Scalar> cosines;
  std::vector<Scalar> q, v;  // the state that the motions belong to (kinematics.h); v only where there are velocities
  std::vector<BodyMotion<Scalar>> motion;
  std::vector<NewtonEulerBody<Scalar>> newton_euler;
  std::vector<ArticulatedBody<Scalar>> articulated;
  std::vector<ArticulatedCoordinate<Scalar>> coordinate;
  std::vector<CompositeBody<Scalar>> composite;
  std::vector<Scalar> coordinate_motion[6];  // each velocity coordinate's spatial motion about the root's origin
};

}  // namespace poinsot
