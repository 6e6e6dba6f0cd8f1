// The independent check: the bodies as particles on their way through space.
//
// Nothing is shared with the solver but the figure and the numbers to be checked. Positions of particles follow from
// the links as drawn (each turns about or slides along its axis), velocities and accelerations are differences of
// positions in long double over nine instants, momenta and energies are sums over particles, and forces and moments
// must equal sum m a and sum r x m a.
#pragma once

#include <string>
#include <vector>

#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/joint.h"

namespace poinsot::solve {

// A link of the tree on ground axes in the drawn pose, where all coordinates are zero.
struct CheckLink {
  JointType type = JointType::weld;
  int parent = -1;                 // -1: the ground
  Vector3<double> anchor{};        // a point of its axis, or its center, m
  Vector3<double> axis{};          // of any length
  double pitch = 0;                // screw: m/rad
  int position = 0, velocity = 0;  // first coordinates
};

// What is claimed of one body.
struct CheckBody {
  int link = 0;
  std::vector<Particle<double>> particles;         // in the drawn pose, on ground axes
  Vector3<double> momentum{}, angular_momentum{};  // the latter about the ground's origin
  double kinetic_energy = 0;
  bool forces_known = false;
  SpatialForce<double> wrench{};           // all forces on it, about the ground's origin
  double force_size = 0, moment_size = 0;  // sums of the magnitudes of the single forces and moments in it
};

// Relative residuals, those of forces by the largest sizes met at any body; zero where nothing moves and nothing acts.
struct CheckResult {
  double momentum = 0;
  double energy = 0;
  double newton_euler = 0;  // only over bodies with forces_known
};

// q, v, a: coordinates of the tree with their rates and accelerations, as State has them.
CheckResult check_with_particles(const std::vector<CheckLink>& links, const std::vector<CheckBody>& bodies,
                                 const std::vector<double>& q, const std::vector<double>& v,
                                 const std::vector<double>& a);

}  // namespace poinsot::solve
