// The instant after a blow.
#include <algorithm>
#include <cmath>

#include "statement/instant.h"
#include "statement/reader.h"

namespace poinsot::statement {
namespace {

using Vector = Vector3<double>;

}  // namespace

void SolvedInstant::solve_blow() {
  before_.emplace(*moment_);
  blow_ = {};
  for (const StatedImpulse& stated : machine_.impulses) {
    solve::KnownImpulse impulse{stated.action, stated.on, SpatialForce<double>::zero(), stated.absorbed, stated.at};
    Vector vector = moment_->on_ground_axes(stated.axes, stated.vector);
    if (stated.relative_to) {
      // The particle's momentum, less what it keeps of it relative to the body.
      const auto center_velocity = [&](int body) {
        if (body == ground) return Vector::zero();
        const double mass = machine_.mechanism.tree.body(body).inertia.mass;
        return mass > 0
                   ? body_momentum(machine_.mechanism.tree, moment_->workspace(), body, Vector::zero()).linear / mass
                   : Vector::zero();
      };
      const Vector absolute = vector + stated.particle_mass * center_velocity(*stated.relative_to);
      const Vector relative = absolute - stated.particle_mass * center_velocity(stated.on);
      vector = stated.absorbed > 0 ? absolute : (1 - stated.kept) * relative;
    }
    impulse.wrench = stated.couple ? SpatialForce<double>{vector, Vector::zero()}
                                   : SpatialForce<double>{cross(moment_->position(stated.at), vector), vector};
    blow_.impulses.push_back(impulse);
  }
  for (const solve::Impact& impact : machine_.impacts) {
    if (approach(*moment_, impact) >= 0) {
      const auto stated = std::find_if(problem_.impacts.begin(), problem_.impacts.end(),
                                       [&](const Impact& i) { return i.name == impact.name; });
      fail(problem_.file, stated->mark,
           "nothing strikes at impact '" + impact.name +
               "': before it the two do not approach each other along the push",
           "check the direction under pushes: and the motion before");
    }
    blow_.impacts.push_back(impact);
  }
  for (const Frame& frame : problem_.frames) {
    const auto& body = machine_.mechanism.tree.body(machine_.index.at(frame.name));
    for (int k = 0; k < velocity_size(body.joint); ++k) blow_.held_coordinates.push_back(body.v + k);
  }
  std::vector<const Instant*> after;
  for (const Instant& instant : problem_.instants)
    if (instant.name == "after") after.push_back(&instant);
  const std::vector<solve::Condition> conditions = velocity_facts(after);

  // Cords and pushing contacts act, or give way, as the blow decides: the choice in which none has to push or pull and
  // none is overstretched or pressed in.
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<std::size_t> one_sided;
  for (const Component<double>& component : mechanism.components)
    if (component.one_sided) one_sided.push_back(static_cast<std::size_t>(component.action));
  if (one_sided.size() > 12) fail(problem_.file, {1, 1}, "more than 12 cords and contacts in one blow are too many");
  const std::size_t n = static_cast<std::size_t>(mechanism.tree.velocity_size());
  const double impulse_unit = natural_unit(dimensions::momentum);
  for (std::size_t choice = 0; choice < (std::size_t{1} << one_sided.size()); ++choice) {
    std::vector<bool> acting(mechanism.actions.size(), true);
    for (std::size_t k = 0; k < one_sided.size(); ++k) acting[one_sided[k]] = !(choice >> k & 1);
    solve::LinearSystem equations;
    solve::LinearSolution solution = solve::solve_impulse(*before_, scales_, blow_, conditions, acting, &equations);
    const bool last = choice + 1 == (std::size_t{1} << one_sided.size());
    double largest = 0;
    for (std::size_t k = n; k < solution.value.size(); ++k) largest = std::max(largest, std::abs(solution.value[k]));
    bool good = choice_.trial || solution.conflict.empty();
    for (std::size_t k = 0; good && k < mechanism.components.size(); ++k) {
      const auto action = static_cast<std::size_t>(mechanism.components[k].action);
      if (mechanism.components[k].one_sided && acting[action])
        good = solution.value[n + k] >= -1e-9 * (largest + 1e-6 * impulse_unit);
    }
    for (std::size_t i = 0; good && i < mechanism.constraints.size(); ++i) {
      const VelocityConstraint<double>& constraint = mechanism.constraints[i];
      if (constraint.action < 0 || acting[static_cast<std::size_t>(constraint.action)]) continue;
      const std::vector<double> row = solve::constraint_coefficients(*before_, constraint);
      double rate = 0, size = 0;
      for (std::size_t k = 0; k < n; ++k) {
        rate += row[k] * solution.value[k];
        size += std::abs(row[k] * solution.value[k]);
      }
      good = constraint.kind == VelocityConstraintKind::cord_length ? rate <= 1e-9 * size : rate >= -1e-9 * size;
    }
    if (!good && !last && !choice_.trial) continue;
    blow_equations_ = std::move(equations);
    blow_solution_ = std::move(solution);
    if (choice_.trial) take_misfits(blow_solution_);
    if (!good && !choice_.trial) {
      facts_.insert(facts_.end(), after.begin(), after.end());
      if (one_sided.empty()) contradiction(blow_equations_, blow_solution_, true);
      fail(problem_.file, {1, 1},
           "no motion after the blow fits: whichever cords and contacts act, one would have to push or pull the wrong "
           "way");
    }
    break;
  }
  impulses_ = blow_solution_.value;
  if (choice_.forces) move_along(blow_solution_, impulses_);
  for (std::size_t k = 0; k < blow_.impacts.size(); ++k)
    if (impulses_[impulses_.size() - blow_.impacts.size() + k] < -1e-9 * impulse_unit && !choice_.forces)
      fail(problem_.file, {1, 1}, "the impact '" + blow_.impacts[k].name + "' would have to pull",
           "check the direction under pushes:");
  v_.assign(impulses_.begin(), impulses_.begin() + static_cast<std::ptrdiff_t>(n));
  moment_->set_velocities(v_);
}

}  // namespace poinsot::statement
