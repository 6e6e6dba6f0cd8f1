// Places and directions that ride with bodies, and a force at a place.
//
// Bodies are indices into the tree, or `ground`. A point is given on the axes of its body from the body's origin.
#pragma once

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

template <class Scalar>
struct Place {
  int body = ground;
  Vector3<Scalar> point{};
};

// A unit vector.
template <class Scalar>
struct Direction {
  int body = ground;
  Vector3<Scalar> vector{};
};

// A force at a point (m) together with a couple, on ground axes from the ground's origin.
template <class Scalar>
struct PlacedForce {
  Vector3<Scalar> point{};
  Vector3<Scalar> force{};
  Vector3<Scalar> couple{};
};

template <class Scalar>
PlacedForce<Scalar> reversed(const PlacedForce<Scalar>& f) {
  return {f.point, -f.force, -f.couple};
}

// The same about the ground's origin.
template <class Scalar>
SpatialForce<Scalar> wrench_of(const PlacedForce<Scalar>& f) {
  return {f.couple + cross(f.point, f.force), f.force};
}
// The same about a point, of which no large distance from the origin takes digits.
template <class Scalar>
SpatialForce<Scalar> wrench_about(const PlacedForce<Scalar>& f, const Vector3<Scalar>& point) {
  return {f.couple + cross(f.point - point, f.force), f.force};
}

// Its power, W, on body `on` and, reversed, on body `from`: f . (v_on - v_from) + c . (w_on - w_from), the velocities
// those of the bodies' points at the place of the force. After update_velocities.
template <class Scalar>
Scalar power_between(const Workspace<Scalar>& w, int on, int from, const PlacedForce<Scalar>& f) {
  const auto velocity = [&](int body) -> Vector3<Scalar> {
    const BodyMotion<Scalar>& motion = w.motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, f.point - motion.p);
  };
  return dot(f.force, velocity(on) - velocity(from)) +
         dot(f.couple, angular_velocity(w, on) - angular_velocity(w, from));
}

}  // namespace poinsot
