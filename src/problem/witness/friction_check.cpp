// The second road to the laws of dry friction: how contacts come apart and slip is told by the bodies carried along
// from the figure (engine/solve/instant/constraint_check.h), and holds the forces of the answer against Coulomb's law.
// That these forces are those which the bodies need is the check with particles.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/solve/instant/constraint_check.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

double SolvedInstant::friction_misfit() const {
  std::vector<VelocityConstraint<double>> ways;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    ways.insert(ways.end(), contact.motions.begin(), contact.motions.end());
  const solve::ConstraintClaim claim{scales_.length, pace(), true, {}};
  const std::vector<solve::ContactRate> rates =
      solve::contact_rates(machine_.links, ways, claim, machine_.q, v_, mechanism_state_->accelerations());
  double force_size = largest_force(*mechanism_state_, unknowns_);
  for (int i = 0; i < machine_.mechanism.tree.body_count(); ++i)
    force_size =
        std::max(force_size, machine_.mechanism.tree.body(i).inertia.mass * norm(machine_.mechanism.tree.gravity()));
  if (!(force_size > 0)) return 0;
  const double speed = scales_.length * claim.pace, acceleration = speed * claim.pace;
  double worst = 0;
  const auto vanishes = [&](double value, double size) {
    if (value != 0) worst = std::max(worst, size > 0 ? std::abs(value) / size : 1.0);
  };
  for (std::size_t i = 0; i < machine_.rough_contacts.size(); ++i) {
    const RoughContactOf<double>& contact = machine_.rough_contacts[i];
    const RoughForce<double> force = rough_force(*mechanism_state_, unknowns_, contact);
    const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
    const auto* way = &rates[3 * i];
    const auto direction = [&](std::size_t k) { return mechanism_state_->direction(contact.motions[k].along); };
    const Vector3<double> slip = way[1].rate * direction(1) + way[2].rate * direction(2),
                          slip_rate = way[1].change * direction(1) + way[2].change * direction(2);
    vanishes(std::min(0.0, force.push), force_size);
    if (contact.grip == Grip::parts) {
      vanishes(norm(force.friction) + force.push, force_size);
      vanishes(std::min(0.0, way[0].change), acceleration);
      continue;
    }
    vanishes(way[0].rate, speed);
    vanishes(way[0].change, acceleration);
    if (contact.grip == Grip::sticks) {
      vanishes(norm(slip), speed);
      vanishes(norm(slip_rate), acceleration);
      vanishes(std::max(0.0, norm(force.friction) - data_->number(stated.resting, dimensions::none) * force.push),
               force_size);
      continue;
    }
    // A slip that is rounding beside the motion has no direction; the smaller it is the less its direction tells.
    constexpr double rest = 1e-9;
    const bool slips = norm(slip) > rest * speed;
    const Vector3<double> along = slips ? slip : slip_rate;
    const double size = slips ? speed : acceleration;
    if (!(norm(along) > 0)) return 1;
    const double coefficient = data_->number(stated.sliding, dimensions::none);
    vanishes(std::min(1.0, norm(along) / size) * norm(force.friction + (coefficient * force.push) * normalized(along)),
             force_size);
  }
  return worst;
}

}  // namespace poinsot::problem
