// What acts on one velocity coordinate of a joint: a motor, with a spring and a damper at the same freedom,
//
//   effort = M - k (q - q_0) - c v,      V = k (q - q_0)^2 / 2,      unstored power = (M - c v) v.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/dynamics/place.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/model/state.h"

namespace poinsot {

template <class Scalar>
struct Drive {
  int action = 0;
  int coordinate = 0;  // velocity coordinate in the tree
  int position = 0;    // position coordinate in the tree
  bool turning = true;
  Place<Scalar> at;
  Direction<Scalar> along;
  // The axes of the other turnings of its joint, at most two: its couple does no work on them, as in gimbals.
  std::vector<Direction<Scalar>> others{};
  bool held = false;  // its motion is given: the effort is unknown
  Scalar effort{};    // M, known couple or force of `from` on `on`
  Scalar stiffness{}, free_position{}, damping{};

  // The part of its effort that is known: what is stated, its spring and its damping.
  Scalar known_effort(const State<Scalar>& state) const {
    return effort - stiffness * (position_in(state) - free_position) - damping * rate_in(state);
  }
  Scalar stored_energy(const State<Scalar>& state) const {
    const Scalar moved = position_in(state) - free_position;
    return Scalar(0.5) * stiffness * (moved * moved);
  }
  Scalar unstored_power(const State<Scalar>& state) const {
    return (effort - damping * rate_in(state)) * rate_in(state);
  }
  bool feeds() const { return !vanishes(effort); }
  bool drains() const { return !vanishes(damping); }
  bool stores() const { return !vanishes(stiffness); }

  template <class Target, class Convert>
  Drive<Target> converted(const Convert& to) const {
    Drive<Target> drive{action, coordinate, position, turning, to(at), to(along)};
    for (const Direction<Scalar>& other : others) drive.others.push_back(to(other));
    drive.held = held;
    drive.effort = to(effort);
    drive.stiffness = to(stiffness);
    drive.free_position = to(free_position);
    drive.damping = to(damping);
    return drive;
  }

 private:
  const Scalar& position_in(const State<Scalar>& state) const { return state.q[static_cast<std::size_t>(position)]; }
  const Scalar& rate_in(const State<Scalar>& state) const { return state.v[static_cast<std::size_t>(coordinate)]; }
};

}  // namespace poinsot
