// Positions and velocities of a model's coordinates, and how positions change with velocities.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/model/model.h"

namespace poinsot {

// Coordinates in the order of the bodies; joint.h says what each joint's are.
template <class Scalar>
struct State {
  std::vector<Scalar> q;  // position_size() numbers
  std::vector<Scalar> v;  // velocity_size() numbers
};

// The state at rest in which every body frame coincides with its joint frame.
template <class Scalar>
State<Scalar> neutral_state(const Model<Scalar>& model) {
  State<Scalar> state{std::vector<Scalar>(model.position_size(), Scalar(0)),
                      std::vector<Scalar>(model.velocity_size(), Scalar(0))};
  for (const Body<Scalar>& body : model.bodies()) {
    if (body.joint == JointType::ball || body.joint == JointType::free) state.q[body.q] = Scalar(1);
  }
  return state;
}

namespace detail {

inline void require_size(const char* function, const char* what, std::size_t size, int expected) {
  if (size != static_cast<std::size_t>(expected)) {
    throw std::invalid_argument(std::string(function) + ": " + what + " has " + std::to_string(size) +
                                " entries, the model needs " + std::to_string(expected));
  }
}

}  // namespace detail

// q after the velocities v (per second) have held for the time dt (s) on the joints: angles and displacements grow
// linearly, a ball turns about a fixed axis, a free body follows the screw motion of its constant twist. Quaternions
// are normalised. Errors: std::invalid_argument if a size is wrong.
template <class Scalar>
void integrate_position(const Model<Scalar>& model, std::span<Scalar> q, std::span<const Scalar> v, const Scalar& dt) {
  detail::require_size("integrate_position", "q", q.size(), model.position_size());
  detail::require_size("integrate_position", "v", v.size(), model.velocity_size());
  for (const Body<Scalar>& body : model.bodies()) {
    switch (body.joint) {
      case JointType::weld:
        break;
      case JointType::revolute:
      case JointType::prismatic:
      case JointType::screw:
        q[body.q] = q[body.q] + v[body.v] * dt;
        break;
      case JointType::ball:
      case JointType::free: {
        Scalar* c = &q[body.q];
        const Quaternion<Scalar> attitude{c[0], c[1], c[2], c[3]};
        const Vector3<Scalar> turn = dt * Vector3<Scalar>{v[body.v], v[body.v + 1], v[body.v + 2]};
        if (body.joint == JointType::free) {
          // The path of the origin: the mean rotation on the way, applied to the displacement.
          const Vector3<Scalar> d = dt * Vector3<Scalar>{v[body.v + 3], v[body.v + 4], v[body.v + 5]};
          const Scalar x = norm_squared(turn);
          const Vector3<Scalar> td = cross(turn, d);
          const Vector3<Scalar> path = d + cosine_rest_of_square(x) * td + sine_rest_of_square(x) * cross(turn, td);
          const Vector3<Scalar> moved = rotation_matrix(attitude) * path;
          c[4] = c[4] + moved.x;
          c[5] = c[5] + moved.y;
          c[6] = c[6] + moved.z;
        }
        const Quaternion<Scalar> turned = normalized(attitude * quaternion_exponential(turn));
        c[0] = turned.w;
        c[1] = turned.x;
        c[2] = turned.y;
        c[3] = turned.z;
        break;
      }
    }
  }
}

// dq/dt from v, for integrators that treat the quaternions as four numbers.
template <class Scalar>
void position_rate(const Model<Scalar>& model, std::span<const Scalar> q, std::span<const Scalar> v,
                   std::span<Scalar> rate) {
  detail::require_size("position_rate", "q", q.size(), model.position_size());
  detail::require_size("position_rate", "v", v.size(), model.velocity_size());
  detail::require_size("position_rate", "rate", rate.size(), model.position_size());
  for (const Body<Scalar>& body : model.bodies()) {
    if (body.joint == JointType::ball || body.joint == JointType::free) {
      const Quaternion<Scalar> attitude{q[body.q], q[body.q + 1], q[body.q + 2], q[body.q + 3]};
      const Quaternion<Scalar> turning =
          quaternion_rate(attitude, Vector3<Scalar>{v[body.v], v[body.v + 1], v[body.v + 2]});
      rate[body.q] = turning.w;
      rate[body.q + 1] = turning.x;
      rate[body.q + 2] = turning.y;
      rate[body.q + 3] = turning.z;
      if (body.joint == JointType::free) {
        const Vector3<Scalar> moving =
            rotation_matrix(attitude) * Vector3<Scalar>{v[body.v + 3], v[body.v + 4], v[body.v + 5]};
        rate[body.q + 4] = moving.x;
        rate[body.q + 5] = moving.y;
        rate[body.q + 6] = moving.z;
      }
    } else if (body.joint != JointType::weld) {
      rate[body.q] = v[body.v];
    }
  }
}

}  // namespace poinsot
