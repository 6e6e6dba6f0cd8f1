#include "problem/witness/riding_witness.h"

#include <vector>

#include "engine/solve/instant/particle_paths.h"

namespace poinsot::problem {

double riding_misfit(const Situation& situation, const Machine& machine, const State<double>& state,
                     const Vector3<double>& taken) {
  using Vector = solve::ParticlePaths::Vector;
  if (!situation.steady || !(norm(taken) > 0)) return 0;
  const int frame = machine.index.at(situation.steady->frame);
  // What follows from forces carries no such frame.
  std::vector<double> given(state.v.size(), 0.0);
  for (const StatedRate& rate : machine.accelerations) given[static_cast<std::size_t>(rate.velocity)] = rate.value;
  std::vector<solve::ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine.masses) bodies.push_back({link, &mass.particles});
  const solve::ParticlePaths paths(machine.links, bodies, state.q, state.v, given);
  const Vector goes =
      frame == ground ? Vector::zero() : paths.acceleration(frame, paths.place(frame, Vector::zero()), ground);
  const Vector told{taken.x, taken.y, taken.z};
  const solve::ParticlePaths::Real size = norm(told) + norm(goes) + paths.pace() * paths.pace() * paths.length();
  return static_cast<double>(norm(Vector(told - goes)) / size);
}

}  // namespace poinsot::problem
