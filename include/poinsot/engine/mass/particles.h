// Every uniform shape as weighted particles: particles::NAME(placement...) -> ParticleSet, with the names and arguments
// of poinsot/engine/mass/shapes.h but none of its formulas; then particles_of_mass or particles_of_density. Bodies
// given only by their inertia become six particles.
#pragma once

#include "poinsot/engine/mass/particle_lines.h"
#include "poinsot/engine/mass/particle_plates.h"
#include "poinsot/engine/mass/particle_shells.h"
#include "poinsot/engine/mass/particle_solids.h"

namespace poinsot {

// Six particles of a sixth of the mass each, in pairs at equal distances from the mass center on the principal axes.
// They have the body's mass, mass center and inertia. No particles for a massless body. Throws std::invalid_argument
// for moments that no distribution of mass has; moments on the edge of the possible (thin plates, rods) may be beyond
// it by 1e-9 of the largest moment.
std::vector<Particle<double>> equivalent_particles(const MassProperties<double>& body);
std::vector<Particle<long double>> equivalent_particles(const MassProperties<long double>& body);

}  // namespace poinsot
