// An independent check of a solution: the bodies as particles on their paths through space.
//
// The check shares nothing with the solver but the figure and the numbers to be checked. The positions of particles
// follow from the links as drawn (each turns about its axis or slides along it). Velocities and accelerations are
// differences of positions at nine instants, in long doubles. Momenta and energies are sums over the particles, and
// forces and moments must equal sum m a and sum r x m a.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "poinsot/engine/mass/particle_set.h"
#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/joint.h"

namespace poinsot::solve {

// A link of the tree on ground axes in the drawn pose, where all coordinates are zero.
struct CheckLink {
  JointType type = JointType::weld;
  int parent = -1;                 // -1 for the ground
  Vector3<double> anchor{};        // a point of its axis or its center, m
  Vector3<double> axis{};          // of any length
  double pitch = 0;                // of a screw, m/rad
  int position = 0, velocity = 0;  // indices of its first coordinates
};

// The solver's results for one body.
struct CheckBody {
  int link = 0;
  std::vector<Particle<double>> particles;         // in the drawn pose, on ground axes
  Vector3<double> momentum{}, angular_momentum{};  // the latter about the ground's origin
  double kinetic_energy = 0;
  bool forces_known = false;
  SpatialForce<double> wrench{};           // all forces on the body, about the ground's origin
  double force_size = 0, moment_size = 0;  // sums of the magnitudes of the single forces and moments
  // Of a body on its way round a far center: about its mass center, where what turns it does not drown in the moments
  // of that way.
  struct Within {
    Vector3<double> angular_momentum{}, moment{};
    // Of the terms that make them up, such as a force at a far pivot: their rounding is no misfit.
    double angular_momentum_size = 0, moment_size = 0;
  };
  std::optional<Within> within{};
};

// Relative misfits. Those of forces are relative to the largest force on any body. They are zero where nothing moves
// and nothing acts.
struct CheckResult {
  double momentum = 0;
  double energy = 0;
  double newton_euler = 0;  // only for bodies with forces_known
};

// q, v, a: the coordinates of the tree, their rates and accelerations, in the order of State. reach: the length of the
// mechanism where it is longer than its bodies tell, m.
CheckResult check_with_particles(const std::vector<CheckLink>& links, const std::vector<CheckBody>& bodies,
                                 const std::vector<double>& q, const std::vector<double>& v,
                                 const std::vector<double>& a, double reach = 0);

}  // namespace poinsot::solve
