// What a center that pulls exerts on a body as it is stated, by the particles of the body on their way from the figure:
// a second road to the law of force (engine/dynamics/attraction_law.h) and to how it was read.
//
// What is a particle or a sphere is pulled at the center of its particles. Of any other part each particle is pulled by
// itself, and the pull is taken as a series in how far the particles are from their center, up to the second power: the
// particles of a shape agree with it in its second moments and not in those beyond, as they would have to for more.
#pragma once

#include <optional>

#include "engine/solve/instant/particle_paths.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

struct StatedAttraction {
  using Real = solve::ParticlePaths::Real;
  using Vector = solve::ParticlePaths::Vector;

  Vector at = Vector::zero();  // the mass center
  Vector force = Vector::zero(), couple = Vector::zero();
  Real energy = 0;       // zero infinitely far from the center
  Real couple_size = 0;  // of the couple that the body would feel if it were a rod, and of what rounding makes of it
};

// body: its place among those of the file. Nothing where no center pulls, or the body has no particles.
std::optional<StatedAttraction> stated_attraction(const solve::ParticlePaths& paths, const Machine& machine,
                                                  DataScope<double>& data, std::size_t body);

// The same of all bodies of the file, or of that with this index in the tree: the energy, or its rate, with its size.
struct StatedPotential {
  StatedAttraction::Real value = 0, size = 0;
};
StatedPotential stated_potential(const solve::ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
                                 int body, bool rate);

}  // namespace poinsot::problem
