// Solves for the instant after a blow (Eq. 17.4).
#include <algorithm>
#include <cmath>

#include "problem/instant/instant.h"
#include "problem/instant/one_sided_shares.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/contact_limits.h"
#include "problem/quantities/slip_constraint.h"
#include "problem/quantities/tooth_flanks.h"

namespace poinsot::problem {
namespace {

Mark place_of_blow(const Situation& situation) {
  if (!situation.impulses.empty()) return situation.impulses.front().mark;
  if (!situation.impacts.empty()) return situation.impacts.front().mark;
  return situation.strikes.front().mark;
}

const Impact& impact_named(const Situation& situation, const std::string& name) {
  return *std::find_if(situation.impacts.begin(), situation.impacts.end(),
                       [&](const Impact& impact) { return impact.name == name; });
}

}  // namespace

void SolvedInstant::solve_blow() {
  before_.emplace(*mechanism_state_);
  blow_ = stated_blow(view());
  for (const solve::Impact& impact : machine_.impacts) {
    const double toward = approach(*mechanism_state_, impact);
    if (toward >= 0) {
      for (std::size_t d = 0; d < velocities_.open.size() && !choice_.trial; ++d) {
        std::vector<double> moved = v_;
        for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += velocities_.open[d][k];
        mechanism_state_->set_velocities(moved);
        constexpr double noticed = 1e-9;  // of a natural rate, which an open direction has that moves the impact at all
        const bool depends =
            std::abs(approach(*mechanism_state_, impact) - toward) > noticed * scales_.length / scales_.time;
        mechanism_state_->set_velocities(v_);
        if (!depends) continue;
        std::string names;
        for (std::size_t k : velocities_.share[d])
          names.append(names.empty() ? "" : ", ").append(velocity_equations_.name(k));
        throw UnansweredError(
            situation_.file, impact_named(situation_, impact.name).mark,
            "whether impact '" + impact.name + "' happens is not determined: nothing fixes " + names + " before it",
            "state it under joints: or instants:");
      }
      fail(situation_.file, impact_named(situation_, impact.name).mark,
           "nothing strikes at impact '" + impact.name +
               "': before it the two do not approach each other along the push",
           "check the direction under pushes: and the motion before; what strikes after another blow is a contact with "
           "restitution: and open: true");
    }
  }
  StatedConditions<double> stated = blow_conditions(view(), blow_);
  sources_[System::blow] = stated.sources;
  const solve::Blow smooth = blow_;

  // Cords and one-sided contacts may act in the blow or give way. The right choice is the one in which no cord that
  // acts pushes, no contact that acts pulls, no cord is stretched and no contact penetrated.
  if (situation_.has_rough_blow() && machine_.impacts.size() + machine_.impulses.size() > 1)
    fail(situation_.file, place_of_blow(situation_),
         "with friction, what strikes at the same time as another thing is not followed: it matters which is first",
         "state one impact in each situation, or leave out the friction");
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<std::size_t> one_sided;
  const auto together = [&](std::size_t one, std::size_t other) {
    return one == other || act_together(mechanism.actions[one], mechanism.actions[other]);
  };
  for (const Component<double>& component : mechanism.components) {
    const auto action = static_cast<std::size_t>(component.action);
    const auto same = [&](std::size_t other) { return together(action, other); };
    if (component.one_sided && std::ranges::none_of(one_sided, same)) one_sided.push_back(action);
  }
  // Each set of those that act is solved for: four thousand sets take a second.
  if (one_sided.size() > 12)
    fail(situation_.file, place_of_blow(situation_), "more than 12 cords and contacts in one blow are too many");
  const std::size_t n = static_cast<std::size_t>(mechanism.tree.velocity_size());
  // An impulse that pulls by less than this part of the largest, or of the momenta before and after, is the rounding of
  // its equation: some thousand roundings of the momenta, and as much more as impulses beyond them add.
  constexpr double of_largest = 1e-9, of_momenta = 1e-13;
  const double momenta_before = natural_size(dimensions::momentum);
  const auto rounding = [&](const std::vector<double>& solved) {
    double largest = 0, fastest = 0;
    for (std::size_t k = 0; k < solved.size(); ++k) {
      if (k >= n)
        largest = std::max(largest, std::abs(solved[k]));
      else
        fastest =
            std::max(fastest, std::abs(solved[k]) *
                                  (solve::coordinate_turns(mechanism.tree, static_cast<int>(k)) ? scales_.length : 1));
    }
    return std::max(of_largest * largest, of_momenta * std::max(momenta_before, scales_.mass * fastest));
  };
  bool all_contradict = true;  // for all choices of cords and contacts that act
  const std::size_t choices = std::size_t{1} << one_sided.size();
  for (std::size_t choice = choice_.trial ? choice_.giving_way % choices : 0; choice < choices; ++choice) {
    std::vector<bool> acting(mechanism.actions.size(), true);
    for (std::size_t k = 0; k < one_sided.size(); ++k)
      for (std::size_t i = 0; i < acting.size(); ++i)
        if (together(one_sided[k], i)) acting[i] = !(choice >> k & 1);
    const bool last = choice + 1 == choices;
    if (situation_.has_rough_blow()) {
      RoughBlowResult along = follow_rough_blow({*before_, scales_, smooth, acting});
      if (!along.found) {
        if (along.by_others && !last && !choice_.trial) continue;
        fail(situation_.file, place_of_blow(situation_), along.words, along.hint);
      }
      rough_blow_ = std::move(along.found);
      blow_ = smooth;
      put_friction(blow_, *before_, *rough_blow_);
      stated = blow_conditions(view(), blow_);
    }
    solve::LinearSystem equations;
    untie_flanks(machine_.mechanism);
    solve::LinearSolution solution = solve::solve_impulse(*before_, scales_, blow_, stated.linear, acting, &equations);
    while (tie_flanks(machine_.mechanism, solution, n)) {
      equations = {};
      solution = solve::solve_impulse(*before_, scales_, blow_, stated.linear, acting, &equations);
    }
    if (!choice_.trial) {
      const std::vector<std::size_t> pushing = one_sided_unknowns(n);
      share_without_pull(solution, pushing, n);
      if (const std::vector<FrictionCone> cones = friction_cones(n); !cones.empty())
        share_within_cones(solution, pushing, cones, n);
    }
    bool good = choice_.trial || solution.conflict.empty();
    all_contradict = all_contradict && !good;
    if (!good && choice == 0) {
      blow_equations_ = equations;
      blow_solution_ = solution;
    }
    for (std::size_t k = 0; good && k < mechanism.components.size(); ++k) {
      const auto action = static_cast<std::size_t>(mechanism.components[k].action);
      if (mechanism.components[k].one_sided && acting[action])
        good = solution.value[n + k] >= -rounding(solution.value);
    }
    constexpr double of_terms = 1e-9;  // what sums of velocities leave that are solved for, to 1e-11 at worst
    struct Rate {
      double value = 0, rounding = 0;
    };
    const auto rate_of = [&](const VelocityConstraint<double>& constraint) {
      const std::vector<double> row = solve::constraint_coefficients(*before_, constraint);
      Rate rate;
      for (std::size_t k = 0; k < n; ++k) {
        rate.value += row[k] * solution.value[k];
        rate.rounding += of_terms * std::abs(row[k] * solution.value[k]);
      }
      return rate;
    };
    const auto parts = [&](int action, double slip) {
      return std::ranges::any_of(mechanism.constraints, [&](const VelocityConstraint<double>& constraint) {
        if (constraint.action != action || !constraint.normal) return false;
        const Rate rate = rate_of(constraint);
        return rate.value > rate.rounding + of_terms * slip;
      });
    };
    for (std::size_t i = 0; good && i < mechanism.constraints.size(); ++i) {
      const VelocityConstraint<double>& constraint = mechanism.constraints[i];
      if (constraint.action < 0 || acting[static_cast<std::size_t>(constraint.action)]) continue;
      // A part of a cord between wheels that it turns says nothing of the whole.
      if (constraint.kind == VelocityConstraintKind::led_cord && !constraint.keeps_length) continue;
      const Rate rate = rate_of(constraint);
      // Of a contact that has parted nothing holds its sides from slipping; one that has not does not slip.
      if (against_slipping(mechanism, constraint))
        good = std::abs(rate.value) <= rate.rounding || parts(constraint.action, std::abs(rate.value));
      else
        good = is_cord_length(constraint) ? rate.value <= rate.rounding : rate.value >= -rate.rounding;
    }
    if (!good && !last && !choice_.trial) continue;
    if (!good && !choice_.trial) {
      // The reason is not in the cords and contacts. With all of them acting the contradiction is named most clearly.
      if (all_contradict) contradiction(System::blow, blow_solution_);
      fail(situation_.file, place_of_blow(situation_),
           "no motion after the blow fits: whichever cords and contacts act, one would have to push or pull the wrong "
           "way");
    }
    blow_equations_ = std::move(equations);
    blow_solution_ = std::move(solution);
    blow_acting_ = acting;
    blow_flanks_ = flanks_of(mechanism);
    if (choice_.trial) take_misfits(blow_solution_);
    break;
  }
  hold_nonlinear(System::blow, stated.nonlinear, blow_solution_);
  impulses_ = blow_solution_.value;
  if (choice_.forces) move_along(blow_solution_, impulses_, blow_solution_.size > 0 ? blow_solution_.size : 1);
  for (std::size_t k = 0; k < blow_.impacts.size(); ++k)
    if (!blow_.impacts[k].is_friction &&
        impulses_[impulses_.size() - blow_.impacts.size() + k] < -rounding(impulses_) && !choice_.forces)
      fail(situation_.file, impact_named(situation_, blow_.impacts[k].name).mark,
           "the impact '" + blow_.impacts[k].name + "' would have to pull", "check the direction under pushes:");
  v_.assign(impulses_.begin(), impulses_.begin() + static_cast<std::ptrdiff_t>(n));
  mechanism_state_->set_velocities(v_);
  if (choice_.trial) return;
  for (const ContactLimit& limit : machine_.contact_limits)
    if (blow_acting_[static_cast<std::size_t>(limit.action)] && !is_of_rod(limit, situation_) &&
        leaves_plane(limit, *mechanism_state_, pace()))
      fail(situation_.file, limit.mark, words_of_side(limit), hint_of_flat_side(limit));
}

}  // namespace poinsot::problem
