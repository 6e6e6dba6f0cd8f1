// Solves for the accelerations and forces of an instant.
#include <algorithm>
#include <utility>

#include "problem/instant/instant.h"
#include "problem/instant/one_sided_shares.h"
#include "problem/language/diagnostic.h"
#include "problem/machine/contact_limits.h"

namespace poinsot::problem {

void SolvedInstant::solve_forces() {
  if (!motion_) solve_motion_equations(state_motion_equations());
}

void SolvedInstant::assemble_forces() {
  if (motion_) return;
  const std::vector<const Fact*> nonlinear = state_motion_equations();
  if (!nonlinear.empty()) solve_motion_equations(nonlinear);
}

Diagnostic unknown_surface(const Situation& situation, const Machine& machine,
                           const VelocityConstraint<double>& constraint) {
  const std::string& name = machine.mechanism.actions[static_cast<std::size_t>(constraint.action)].name;
  const auto contact = std::find_if(situation.contacts.begin(), situation.contacts.end(),
                                    [&](const Contact& c) { return c.name == name; });
  return {
      situation.file, contact->mark,
      "how the point of contact '" + name +
          "' moves is not known: the surfaces there are no circle, sphere or corner on a plane",
      "velocities can be asked; for forces, accelerations and stability give the body a round shape, or its inertia "
      "by axis:, axial:, transverse:"};
}

std::vector<const Fact*> SolvedInstant::state_motion_equations() {
  for (const Strike& strike : situation_.strikes)
    if (before_ && strike.stays && !strike.mass_neglected)
      throw UnansweredError(situation_.file, strike.mark,
                            "with the particle of strike '" + strike.name +
                                "', which stays, the body moves on as another one than before",
                            "ask for its accelerations and forces in the motion that follows: @ 0 s");
  for (const VelocityConstraint<double>& constraint : machine_.mechanism.constraints)
    if (constraint.shape_unknown && !constraint.carried_by)
      throw StatementError(unknown_surface(situation_, machine_, constraint));
  if (!choice_.trial && !moving_)
    for (const ContactLimit& limit : machine_.contact_limits) {
      if (goes_beyond(limit, *mechanism_state_))
        throw UnansweredError(situation_.file, limit.mark, words_of_end(limit) + " as it moves on",
                              "it turns about a corner there: give it a shape with that corner, such as a polygon");
      if (leaves_plane(limit, *mechanism_state_))
        throw UnansweredError(situation_.file, limit.mark, words_of_side(limit), hint_of_side(limit));
    }
  StatedConditions<double> stated = force_conditions(view(), facts_, !moving_);
  motion_equations_ = solve::motion_equations(*mechanism_state_, scales_, stated.linear);
  sources_[System::motion] = std::move(stated.sources);
  return stated.nonlinear;
}

void SolvedInstant::solve_motion_equations(const std::vector<const Fact*>& nonlinear) {
  solve::LinearSolution solution = motion_equations_.solve();
  if (choice_.trial)
    take_misfits(solution);
  else if (!solution.conflict.empty())
    contradiction(System::motion, solution);
  const std::size_t accelerations = solve::force_unknowns(machine_.mechanism).accelerations;
  // The forces set the pace by which facts are held.
  motion_ = std::move(solution);
  unknowns_ = motion_->value;
  try {
    hold_nonlinear(System::motion, nonlinear, *motion_);
  } catch (...) {
    motion_.reset();
    throw;
  }
  if (!choice_.trial) share_without_pull(*motion_, one_sided_unknowns(accelerations), accelerations);
  unknowns_ = motion_->value;
  if (choice_.forces) {
    // By about as much as acts here: moved by more, the forces that stay the same would change by its rounding.
    move_along(*motion_, unknowns_, motion_->size > 0 ? motion_->size : 1);
    keep_pushing(motion_->value, one_sided_unknowns(accelerations), unknowns_);
  }
  const auto n = static_cast<std::ptrdiff_t>(machine_.mechanism.tree.velocity_size());
  mechanism_state_->set_accelerations(std::vector<double>(unknowns_.begin(), unknowns_.begin() + n));
}

std::vector<std::size_t> SolvedInstant::one_sided_unknowns(std::size_t first) const {
  std::vector<std::size_t> unknowns;
  for (std::size_t k = 0; k < machine_.mechanism.components.size(); ++k)
    if (machine_.mechanism.components[k].one_sided) unknowns.push_back(first + k);
  return unknowns;
}

std::optional<std::vector<SolvedInstant::Between>> SolvedInstant::over_all_shares(
    const Expression& expression, const std::optional<Expression>& axes) {
  if (!motion_ || motion_->open.empty()) return std::nullopt;
  const std::vector<double> found = unknowns_;
  // Other shares are not what is told.
  const bool writes_told = std::exchange(writes_told_, false);
  const auto numbers_at = [&](const std::vector<double>& forces) {
    unknowns_ = forces;
    const Value<double> value = ask(expression, axes, nullptr);
    return value.is_vector()   ? std::vector<double>{value.vector.x, value.vector.y, value.vector.z}
           : value.is_number() ? std::vector<double>{value.number}
                               : std::vector<double>{};
  };
  const std::size_t directions = motion_->open.size();
  // One more place shows whether the value is linear; rounding leaves a millionth of a millionth of its terms.
  constexpr double rounding = 1e-10;
  std::vector<double> here, size;
  std::vector<std::vector<double>> slopes;  // of each number, along each direction
  bool linear = true;
  try {
    const auto moved = [&](const std::vector<double>& t) {
      std::vector<double> forces = found;
      for (std::size_t d = 0; d < directions; ++d)
        for (std::size_t k = 0; k < forces.size(); ++k) forces[k] += t[d] * motion_->open[d][k];
      return numbers_at(forces);
    };
    here = numbers_at(found);
    slopes.assign(here.size(), std::vector<double>(directions, 0));
    const double amount = motion_->size > 0 ? motion_->size : 1;
    std::vector<double> all(directions), expected = here;
    size.assign(here.size(), 0);
    for (std::size_t d = 0; d < directions; ++d) {
      std::vector<double> one(directions, 0);
      one[d] = amount;
      all[d] = (d % 2 == 0 ? -0.7 : 1.3) * amount;
      const std::vector<double> there = moved(one);
      for (std::size_t i = 0; i < here.size(); ++i) {
        slopes[i][d] = (there[i] - here[i]) / amount;
        expected[i] += all[d] * slopes[i][d];
        size[i] += std::abs(all[d] * slopes[i][d]) + std::abs(here[i]);
      }
    }
    const std::vector<double> there = moved(all);
    for (std::size_t i = 0; i < here.size(); ++i)
      linear = linear && std::abs(there[i] - expected[i]) <= rounding * size[i];
  } catch (const StatementError&) {
    linear = false;
  }
  unknowns_ = found;
  writes_told_ = writes_told;
  if (!linear || here.empty()) return std::nullopt;
  const std::size_t accelerations = solve::force_unknowns(machine_.mechanism).accelerations;
  const std::vector<std::size_t> one_sided = one_sided_unknowns(accelerations);
  std::vector<Between> ranges;
  for (std::size_t i = 0; i < here.size(); ++i) {
    std::vector<double> down = slopes[i];
    for (double& slope : down) slope = -slope;
    const std::optional<double> more = largest_over_shares(*motion_, one_sided, accelerations, slopes[i]),
                                less = largest_over_shares(*motion_, one_sided, accelerations, down);
    if (!more || !less) return std::nullopt;
    const auto without_rounding = [&](double end) { return std::abs(end) <= rounding * size[i] ? 0 : end; };
    ranges.push_back({without_rounding(here[i] - *less), without_rounding(here[i] + *more)});
  }
  return ranges;
}

std::vector<SolvedInstant::OneSidedFault> SolvedInstant::one_sided_faults() const {
  std::vector<OneSidedFault> found;
  const Mechanism<double>& mechanism = machine_.mechanism;
  const std::size_t first = solve::force_unknowns(mechanism).accelerations;
  // A force is rounding if it is small beside all other forces on the body that it holds.
  const auto on_body = [&](int body, std::size_t without) {
    if (body == ground) return 0.0;
    double size = mechanism.tree.body(body).inertia.mass * norm(mechanism.tree.gravity());
    for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
      const Action& action = mechanism.actions[i];
      if (i == without || (action.on != body && action.from != body)) continue;
      size = std::max(size, norm(solve::action_wrench(*mechanism_state_, unknowns_, i).force));
    }
    return size;
  };
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    const Component<double>& component = mechanism.components[k];
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    if (!component.one_sided) continue;
    if (unknowns_[first + k] >= 0) continue;
    const auto own = static_cast<std::size_t>(component.action);
    const double on = on_body(action.on, own), from = on_body(action.from, own);
    const double beside = on > 0 && from > 0 ? std::min(on, from) : std::max(on, from);
    // A single force on its body is what the motion requires; if nothing moves, it is rounding.
    double mass = scales_.mass;
    for (const int body : {action.on, action.from})
      if (body != ground && mechanism.tree.body(body).inertia.mass > 0)
        mass = std::min(mass, mechanism.tree.body(body).inertia.mass);
    constexpr double of_others = 1e-9, of_natural = 1e-13;
    const double rounding = of_natural * natural_size(dimensions::force) * mass / scales_.mass;
    if (unknowns_[first + k] >= -std::max(of_others * beside, rounding)) continue;
    found.push_back({own, action.kind == ActionKind::cord});
  }
  return found;
}

std::vector<std::string> SolvedInstant::unphysical() const {
  std::vector<std::string> words;
  for (const OneSidedFault& fault : one_sided_faults()) {
    const std::string& name = machine_.mechanism.actions[fault.action].name;
    words.push_back(fault.cord ? "the cord '" + name + "' would have to push: it goes slack"
                               : "the contact '" + name + "' would have to pull: it is lost");
  }
  return words;
}

}  // namespace poinsot::problem
