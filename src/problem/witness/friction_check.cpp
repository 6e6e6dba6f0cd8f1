// The second road to the laws of dry friction: how contacts come apart and slip is told by the bodies carried along
// from the figure (engine/solve/instant/constraint_check.h), and holds the forces of the answer against Coulomb's law.
// That these forces are those which the bodies need is the check with particles.
#include <algorithm>
#include <cmath>
#include <utility>

#include "poinsot/engine/solve/instant/constraint_check.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {

// Of friction in a joint: what the relative motion of its bodies tells of the effort, as a part of the largest; by what
// it exceeds the limit at which it holds is weighed by the largest force, as of contacts, since its rounding is that of
// the whole mechanism.
double SolvedInstant::misfit_in_joint(const RoughContactOf<double>& contact) const {
  const Joint& joint = *std::ranges::find(situation_.joints, contact.name, &Joint::name);
  const Friction& stated = *joint.freedoms.front().friction;
  const Dimension dimension = contact.turning ? dimensions::moment : dimensions::force;
  const Vector3<double> axis = mechanism_state_->direction(contact.motions[1].along),
                        friction = rough_force(*mechanism_state_, unknowns_, contact).friction;
  const double effort = dot(friction, axis);
  const double limit = data_->number(contact.grip == Grip::sticks ? stated.resting : stated.sliding, dimension);
  if (!(limit > 0)) return effort == 0 ? 0 : 1;
  if (contact.grip == Grip::sticks)
    return std::max(0.0, std::abs(effort) - limit) /
           std::max(limit, largest_force(*mechanism_state_, unknowns_) * (contact.turning ? scales_.length : 1));
  // How `to` turns over `from`, or how a point of it slides.
  const int on = machine_.index.at(joint.to), from = machine_.index.at(joint.from);
  const Workspace<double>& w = mechanism_state_->workspace();
  const auto along = [&](const Vector3<double>& one, const Vector3<double>& other) { return dot(one - other, axis); };
  const Vector3<double> P = mechanism_state_->position(machine_.joints.at(contact.name).at);
  const auto velocity_at = [&](int body) {
    const BodyMotion<double>& motion = w.motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, P - motion.p);
  };
  double rate = contact.turning ? along(angular_velocity(w, on), angular_velocity(w, from))
                                : along(velocity_at(on), velocity_at(from));
  constexpr double rest = 1e-9;  // of the pace
  if (std::abs(rate) <= rest * (contact.turning ? 1 : scales_.length) * pace())
    rate = mechanism_state_->accelerations()[static_cast<std::size_t>(contact.coordinate)];
  return std::abs(effort + (rate > 0 ? limit : -limit)) / limit;
}

double SolvedInstant::friction_misfit() const {
  std::vector<VelocityConstraint<double>> ways;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    if (contact.coordinate < 0) ways.insert(ways.end(), contact.motions.begin(), contact.motions.end());
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
  const auto* next = rates.data();
  for (const RoughContactOf<double>& contact : machine_.rough_contacts) {
    if (contact.coordinate >= 0) {
      worst = std::max(worst, misfit_in_joint(contact));
      continue;
    }
    const RoughForce<double> force = rough_force(*mechanism_state_, unknowns_, contact);
    const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
    const auto* way = std::exchange(next, next + 3);
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
    // A slip that is rounding beside the motion has no direction; the smaller it is the less its direction tells. One
    // that turns is followed until there is next to nothing of it.
    constexpr double rest = 1e-9;
    const bool slips = norm(slip) > (contact.turns ? 0 : rest * speed);
    const Vector3<double> along = slips ? slip : slip_rate;
    const double size = slips ? speed : acceleration;
    if (!(norm(along) > 0)) return 1;
    const double coefficient = data_->number(stated.sliding, dimensions::none);
    vanishes(std::min(1.0, norm(along) / size) * norm(force.friction + (coefficient * force.push) * normalized(along)),
             force_size);
  }
  return worst;
}

// The same for the impulses of a blow that starts from rest, and the velocities after it.
double SolvedInstant::blow_friction_misfit() const {
  std::vector<VelocityConstraint<double>> ways;
  for (const RoughContactOf<double>& contact : machine_.rough_contacts)
    ways.insert(ways.end(), contact.motions.begin(), contact.motions.end());
  const solve::ConstraintClaim claim{scales_.length, pace(), false, {}};
  const std::vector<solve::ContactRate> rates =
      solve::contact_rates(machine_.links, ways, claim, machine_.q, v_, std::vector<double>(v_.size(), 0.0));
  double largest = 0;
  for (std::size_t i = 0; i < machine_.mechanism.actions.size(); ++i)
    largest = std::max(largest, norm(solve::action_impulse(*before_, blow_, impulses_, i).force));
  if (!(largest > 0)) return 0;
  const double speed = scales_.length * claim.pace;
  double worst = 0;
  for (std::size_t i = 0; i < machine_.rough_contacts.size(); ++i) {
    const RoughContactOf<double>& contact = machine_.rough_contacts[i];
    const Friction& stated = *std::ranges::find(situation_.contacts, contact.name, &Contact::name)->friction;
    const auto direction = [&](std::size_t k) { return before_->direction(contact.motions[k].along); };
    const Vector3<double> impulse =
        solve::action_impulse(*before_, blow_, impulses_, static_cast<std::size_t>(contact.action)).force;
    const double push = dot(impulse, direction(0)), apart = rates[3 * i].rate / speed;
    const Vector3<double> friction = impulse - push * direction(0);
    const Vector3<double> slip = rates[3 * i + 1].rate * direction(1) + rates[3 * i + 2].rate * direction(2);
    worst = std::max({worst, -push / largest, -apart});
    // Either it parts, and nothing acts, or it stays, and its friction is that of its slip.
    worst = std::max(worst, std::min(std::abs(push) / largest + norm(friction) / largest, std::abs(apart)));
    const double resting = data_->number(stated.resting, dimensions::none) * push,
                 sliding = data_->number(stated.sliding, dimensions::none) * push;
    constexpr double rest = 1e-9;
    worst = std::max(worst, norm(slip) > rest * speed ? std::min(1.0, norm(slip) / speed) *
                                                            norm(friction + sliding * normalized(slip)) / largest
                                                      : (norm(friction) - resting) / largest);
  }
  return worst;
}

}  // namespace poinsot::problem
