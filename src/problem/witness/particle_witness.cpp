#include "problem/witness/particle_witness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "poinsot/engine/solve/stability/spectrum_check.h"

namespace poinsot::problem {

namespace {

double largest_of(const SolvedInstant::Residuals& residuals, const SolvedInstant& instant) {
  const solve::CheckResult& particles = residuals.particles;
  double largest = 0;
  for (const double misfit :
       {particles.momentum, particles.energy, instant.forces_solved() ? particles.newton_euler : 0, residuals.impulse,
        residuals.constraints.value_or(0), residuals.friction.value_or(0), residuals.laws.value_or(0),
        instant.misfit_of_told().misfit})
    largest = std::isnan(misfit) ? std::numeric_limits<double>::infinity() : std::max(largest, misfit);
  return largest;
}

}  // namespace

double misfit_by_particles(const SolvedInstant& instant) { return largest_of(instant.check(), instant); }

bool confirmed_by_particles(const SolvedInstant& instant) { return misfit_by_particles(instant) <= check_tolerance; }

bool confirmed_by_all_roads(const SolvedInstant& instant) {
  const SolvedInstant::Residuals residuals = instant.check();
  return largest_of(residuals, instant) <= check_tolerance &&
         residuals.stability.value_or(0) <= solve::spectrum_tolerance;
}

}  // namespace poinsot::problem
