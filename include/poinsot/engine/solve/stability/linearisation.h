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

// A motion that moves no mass and breaks no constraint: the turning of a particle, of a rod about its own line, of a
// massless arm about the line to what it carries.
struct UnseenMotion {
  int coordinate = 0;         // the velocity coordinate by which it is known, which then need not deviate
  std::vector<double> along;  // the velocities of all coordinates in it, one of this coordinate
};
// Those among some coordinates of a mechanism at q, independent of each other.
std::vector<UnseenMotion> unseen_motions(const Mechanism<double>& mechanism, const std::vector<double>& q,
                                         const std::vector<int>& coordinates);

// The system near a steady motion. Deviations of coordinates are measured like velocities: for ball and free joints
// on the body's own axes.
struct SteadyMotion {
  const Mechanism<double>* mechanism = nullptr;  // contacts move over its bodies: none is carried
  std::vector<double> q, v;
  std::vector<bool> held;  // for each velocity coordinate, whether its motion is given, so that it does not deviate
  std::vector<std::optional<double>> given;  // the accelerations that do not follow from forces
  std::vector<UnseenMotion> unseen;          // whose coordinates have given accelerations
  // For bodies on ball or free joints that spin: the twist of the spin on the body's axes, about its axis of
  // symmetry.
  std::vector<std::pair<int, SpatialMotion<double>>> spins;
  // Displacements after which the motion is the same (a turn about the vertical or of a body about its axis of
  // symmetry, a shift in the absence of gravity): deviations of the coordinates, followed by those of the velocities.
  std::vector<std::vector<double>> symmetries;
  Vector3<double> turning{};    // of the frame in which everything rests but for spins, rad/s on ground axes
  double length = 1, time = 1;  // natural sizes
};

struct Mode {
  double growth_rate = 0;  // 1/s, of exp(growth_rate t); a negative one decays
  double frequency = 0;    // rad/s; zero if there is no oscillation
  double doubt = 0;        // 1/s: a bound for the error of both, from the accuracy of the equations
  // Which bodies of the tree take part; empty for displacements that only go round in a turning frame.
  std::vector<bool> moves;
  // How the coordinates move in it, measured like velocities and to any scale: displacements Re(shape exp(rate t)) with
  // the rate growth_rate + i frequency. find_shapes() finds it. It stays empty where another mode has the same rates,
  // so that any combination of both is a mode, too.
  std::vector<std::complex<double>> shape{};
};

enum class Stability { stable, unstable, undecided };

struct Linearisation {
  bool steady = true;  // whether the motion is steady at all
  int unsteady = -1;   // if it is not, the velocity coordinate that changes most
  // One of each conjugate pair, in order of falling growth rate, without those of the symmetries.
  std::vector<Mode> modes;
  double length = 1;   // m: the natural length of the motion
  double pace = 0;     // 1/s: that of the fastest motion, or the one set by weights and lengths
  int deviations = 0;  // how many numbers a deviation has that constraints allow, those of the symmetries among them
  bool has_shapes = false;
};

// Throws std::runtime_error if accelerations are not determined near the motion, as where springs act on an unseen
// motion.
Linearisation linearise(const SteadyMotion& motion);

// The stability of the modes in which a body takes part (for `everything`, of all modes). It is undecided if no mode
// grows beyond doubt, but some vanish apart from those of the symmetries, so that terms of higher order decide, or
// are too close to growing for the accuracy of their rates. A rate smaller than its doubt counts as zero.
constexpr int everything = -2;
Stability stability(const Linearisation& linearisation, int body = everything);
double growth_rate(const Linearisation& linearisation, int body = everything);
std::vector<double> frequencies(const Linearisation& linearisation, int body = everything);

// A mode as it is told: rates smaller than their doubt are zero, and a pair of rates whose frequency is zero is two
// modes.
struct ToldMode {
  double growth_rate = 0, frequency = 0;  // as above
  double damping_ratio = 0;               // -growth_rate over the size of growth_rate + i frequency
  std::size_t mode = 0;                   // its place among the modes
};
// The modes in which a body takes part, by rising frequency and of equal ones by rising growth. Those that vanish are
// left out.
std::vector<ToldMode> told_modes(const Linearisation& linearisation, int body = everything);
int vanishing_modes(const Linearisation& linearisation, int body = everything);

void find_shapes(const SteadyMotion& motion, Linearisation& linearisation);

}  // namespace poinsot::solve
