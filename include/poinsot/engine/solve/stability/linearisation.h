// The motion near a steady one: its equations linearised, their growth rates and frequencies.
//
// A steady motion (relative equilibrium) is one in which everything rests in a frame that turns uniformly, but for
// bodies that spin about axes of symmetry. Deviations from it, measured in that frame, satisfy linear equations with
// constant coefficients: x' = A x, x the deviations of the coordinates and of the velocities.
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/model/model.h"

namespace poinsot::solve {

// What moves, near the steady motion. Deviations of coordinates are measured like velocities: on the body's own axes
// for ball and free joints.
struct SteadyMotion {
  const Model<double>* tree = nullptr;
  std::vector<double> q, v;
  std::vector<bool> held;  // of each velocity coordinate: its motion is given and does not deviate
  // Bodies on ball or free joints that spin: the twist of the spin on the body's axes, about its axis of symmetry.
  std::vector<std::pair<int, SpatialMotion<double>>> spins;
  // Directions in which the whole may be displaced and still moves in the same way (a turn about the vertical, of a
  // body about its axis of symmetry, a shift in the absence of gravity): deviations of coordinates, then of velocities.
  std::vector<std::vector<double>> symmetries;
  // Accelerations of the coordinates in any state near it; nothing where they are not determined.
  std::function<std::optional<std::vector<double>>(const std::vector<double>& q, const std::vector<double>& v)>
      accelerations;
  // Rows of the constraints on velocities (J), those that bind positions too first, and how many these are.
  std::function<std::vector<std::vector<double>>(const std::vector<double>& q)> constraints;
  std::size_t position_constraints = 0;
  double length = 1, time = 1;  // natural sizes
};

struct Mode {
  double growth_rate = 0;   // 1/s, of exp(growth_rate t); negative: it dies out
  double frequency = 0;     // rad/s; zero: no oscillation
  double doubt = 0;         // 1/s: by how much the two may be off, as accurately as the equations are known
  std::vector<bool> moves;  // which bodies of the tree take part; empty: what only goes round in a frame that turns
};

enum class Stability { stable, unstable, undecided };

struct Linearisation {
  bool steady = true;       // whether the motion is a steady one at all
  std::vector<Mode> modes;  // one of each conjugate pair, by falling growth rate; those of the symmetries left out
  double pace = 0;          // 1/s: of the fastest motion, or of what weights and lengths bring
};

// Throws std::runtime_error if accelerations are not determined near the motion.
Linearisation linearise(const SteadyMotion& motion);

// Of the modes in which a body of the tree takes part (all: `everything`). Undecided: no mode is seen to grow, but some
// vanish apart from those of the symmetries, so that terms of higher order decide, or are too near to growing for the
// accuracy of their rates. What is below its doubt counts as zero.
constexpr int everything = -2;
Stability stability(const Linearisation& linearisation, int body = everything);
double growth_rate(const Linearisation& linearisation, int body = everything);
std::vector<double> frequencies(const Linearisation& linearisation, int body = everything);

}  // namespace poinsot::solve
