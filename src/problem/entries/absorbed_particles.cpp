#include "problem/entries/absorbed_particles.h"

#include <algorithm>

namespace poinsot::problem {

std::optional<Situation> with_absorbed_particles(const Situation& situation) {
  const auto stays = [](const Strike& strike) { return strike.stays && !strike.mass_neglected; };
  if (std::ranges::none_of(situation.strikes, stays)) return std::nullopt;
  Situation after = situation;
  for (const Strike& strike : situation.strikes) {
    if (!stays(strike)) continue;
    Part particle;
    particle.name = strike.name;
    particle.shape.kind = "particle";
    particle.shape.arguments.push_back({"points", strike.at, strike.mark});
    particle.shape.mark = particle.mark = strike.mark;
    particle.amount = strike.amount;
    std::ranges::find(after.bodies, strike.hits, &Body::name)->absorbed.push_back(std::move(particle));
  }
  after.impulses.clear();
  after.impacts.clear();
  after.strikes.clear();
  std::erase_if(after.instants,
                [](const Instant& instant) { return instant.name == "before" || instant.name == "after"; });
  return after;
}

}  // namespace poinsot::problem
