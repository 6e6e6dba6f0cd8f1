// The equations of motion linearised about a steady motion, and the growth rates and frequencies of their solutions.
//
// A steady motion (relative equilibrium) is one in which everything rests in a frame that turns uniformly, but for
// bodies that spin about axes of symmetry. Deviations from it, measured in that frame, satisfy linear equations with
// constant coefficients: x' = A x, x the deviations of the coordinates and of the velocities.
#pragma once

#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"

namespace poinsot::solve {

// The system near a steady motion. Deviations of coordinates are measured like velocities: for ball and free joints
// on the body's own axes.
struct SteadyMotion {
  const Mechanism<double>* mechanism = nullptr;  // contacts move over its bodies: none is carried
  std::vector<double> q, v;
  std::vector<bool> held;  // for each velocity coordinate, whether its motion is given, so that it does not deviate
  std::vector<std::optional<double>> given;  // the accelerations that do not follow from forces
  // For bodies on ball or free joints that spin: the twist of the spin on the body's axes, about its axis of
  // symmetry.
  std::vector<std::pair<int, SpatialMotion<double>>> spins;
  // Displacements after which the motion is the same (a turn about the vertical or of a body about its axis of
  // symmetry, a shift in the absence of gravity): deviations of the coordinates, followed by those of the velocities.
  std::vector<std::vector<double>> symmetries;
  double length = 1, time = 1;  // natural sizes
};

struct Mode {
  double growth_rate = 0;  // 1/s, of exp(growth_rate t); a negative one decays
  double frequency = 0;    // rad/s; zero if there is no oscillation
  double doubt = 0;        // 1/s: a bound for the error of both, from the accuracy of the equations
  // Which bodies of the tree take part; empty for displacements that only go round in a turning frame.
  std::vector<bool> moves;
};

enum class Stability { stable, unstable, undecided };

struct Linearisation {
  bool steady = true;  // whether the motion is steady at all
  // One of each conjugate pair, in order of falling growth rate, without those of the symmetries.
  std::vector<Mode> modes;
  double pace = 0;  // 1/s: that of the fastest motion, or the one set by weights and lengths
};

// Throws std::runtime_error if accelerations are not determined near the motion.
Linearisation linearise(const SteadyMotion& motion);

// The stability of the modes in which a body takes part (for `everything`, of all modes). It is undecided if no mode
// grows beyond doubt, but some vanish apart from those of the symmetries, so that terms of higher order decide, or
// are too close to growing for the accuracy of their rates. A rate smaller than its doubt counts as zero.
constexpr int everything = -2;
Stability stability(const Linearisation& linearisation, int body = everything);
double growth_rate(const Linearisation& linearisation, int body = everything);
std::vector<double> frequencies(const Linearisation& linearisation, int body = everything);

}  // namespace poinsot::solve
