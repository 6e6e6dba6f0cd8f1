// Blows where contacts meet along a motion.
#include <algorithm>
#include <cmath>

#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "problem/instant/instant.h"
#include "problem/language/diagnostic.h"
#include "problem/quantities/slip_constraint.h"
#include "problem/quantities/tooth_flanks.h"

namespace poinsot::problem {

void SolvedInstant::strike_later(const std::vector<Met>& met, const std::vector<bool>& acting,
                                 const std::vector<bool>& touching, const Mark& mark) {
  const Mechanism<double>& mechanism = machine_.mechanism;
  before_.emplace(*mechanism_state_);
  rough_blow_.reset();
  solve::Blow smooth;
  for (const StatedRate& rate : machine_.accelerations) smooth.held_coordinates.push_back(rate.velocity);
  std::vector<bool> besides = acting;
  for (const Met& one : met) {
    const VelocityConstraint<double>& c =
        *std::ranges::find_if(mechanism.constraints, [&](const VelocityConstraint<double>& constraint) {
          return constraint.action == static_cast<int>(one.action) && constraint.normal;
        });
    besides[one.action] = false;
    solve::Impact impact;
    impact.name = mechanism.actions[one.action].name;
    impact.action = static_cast<int>(one.action);
    impact.on = c.on;
    impact.from = c.from;
    const PlacedForce<double> push = constraint_force(mechanism.tree, before_->workspace(), c);
    impact.at = {ground, push.point};
    impact.push = {ground, push.force};
    impact.restitution = one.restitution;
    impact.friction = one.friction;
    smooth.impacts.push_back(std::move(impact));
  }
  // Cords and contacts that act take part, or give way.
  std::vector<std::size_t> one_sided;
  const auto together = [&](std::size_t one, std::size_t other) {
    return one == other || act_together(mechanism.actions[one], mechanism.actions[other]);
  };
  for (const Component<double>& component : mechanism.components) {
    const auto action = static_cast<std::size_t>(component.action);
    if (component.one_sided && besides[action] &&
        std::ranges::none_of(one_sided, [&](std::size_t other) { return together(action, other); }))
      one_sided.push_back(action);
  }
  if (one_sided.size() > 12) fail(situation_.file, mark, "more than 12 cords and contacts in one blow are too many");
  const auto n = v_.size();
  std::string why =
      "no motion after the blow fits: whichever cords and contacts act, one would pull or push the wrong way";
  for (std::size_t choice = 0; choice < std::size_t{1} << one_sided.size(); ++choice) {
    std::vector<bool> act = besides;
    for (std::size_t k = 0; k < one_sided.size(); ++k)
      for (std::size_t i = 0; i < act.size() && (choice >> k & 1); ++i)
        if (together(one_sided[k], i)) act[i] = false;
    blow_ = smooth;
    if (met.size() == 1 && met.front().friction) {
      RoughBlowResult along = follow_rough_blow({*before_, scales_, smooth, act, &touching});
      if (!along.found) {
        why = along.words;
        if (along.by_others) continue;
        break;
      }
      rough_blow_ = std::move(along.found);
      put_friction(blow_, *before_, *rough_blow_);
    }
    untie_flanks(machine_.mechanism);
    blow_solution_ = solve::solve_impulse(*before_, scales_, blow_, {}, act, &blow_equations_);
    const std::vector<double>& solved = blow_solution_.value;
    double largest = 0;
    for (std::size_t k = n; k < solved.size(); ++k) largest = std::max(largest, std::abs(solved[k]));
    constexpr double rounding = 1e-9;  // of the largest impulse, and of the terms of a rate
    bool good = blow_solution_.conflict.empty();
    for (std::size_t k = 0; good && k < mechanism.components.size(); ++k)
      if (mechanism.components[k].one_sided && act[static_cast<std::size_t>(mechanism.components[k].action)])
        good = solved[n + k] >= -rounding * largest;
    for (std::size_t k = 0; good && k < blow_.impacts.size(); ++k)
      good = blow_.impacts[k].is_friction || solved[solved.size() - blow_.impacts.size() + k] >= -rounding * largest;
    for (const VelocityConstraint<double>& constraint : mechanism.constraints) {
      const auto action = static_cast<std::size_t>(constraint.action);
      if (constraint.kind == VelocityConstraintKind::led_cord && !constraint.keeps_length) continue;
      if (!good || constraint.action < 0 || act[action] || !besides[action]) continue;
      // What has parted may slip either way.
      if (against_slipping(mechanism, constraint)) continue;
      const std::vector<double> row = solve::constraint_coefficients(*before_, constraint);
      double rate = 0, size = 0;
      for (std::size_t k = 0; k < n; ++k) {
        rate += row[k] * solved[k];
        size += std::abs(row[k] * solved[k]);
      }
      good = (is_cord_length(constraint) ? -rate : rate) >= -rounding * size;
    }
    if (!good) continue;
    blow_acting_ = act;
    impulses_ = solved;
    v_.assign(solved.begin(), solved.begin() + static_cast<std::ptrdiff_t>(n));
    velocities_.value = v_;
    mechanism_state_->set_velocities(v_);
    return;
  }
  throw UnansweredError(situation_.file, mark, why, "let the motion end before");
}

}  // namespace poinsot::problem
