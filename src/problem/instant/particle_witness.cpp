#include "problem/instant/particle_witness.h"

namespace poinsot::problem {

bool confirmed_by_particles(const SolvedInstant& instant) {
  const SolvedInstant::Residuals residuals = instant.check();
  const solve::CheckResult& particles = residuals.particles;
  return particles.momentum <= check_tolerance && particles.energy <= check_tolerance &&
         (!instant.forces_solved() || particles.newton_euler <= check_tolerance) &&
         residuals.impulse <= check_tolerance && residuals.constraints.value_or(0) <= check_tolerance &&
         instant.misfit_of_told().misfit <= check_tolerance;
}

}  // namespace poinsot::problem
