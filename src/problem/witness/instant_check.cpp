// What was solved of an instant against the bodies as particles, its constraints by geometry, and the motion near it.
#include <algorithm>
#include <cmath>

#include "engine/solve/instant/particle_paths.h"
#include "poinsot/engine/solve/instant/constraint_check.h"
#include "poinsot/engine/solve/stability/spectrum_check.h"
#include "problem/instant/instant.h"
#include "problem/witness/riding_witness.h"
#include "problem/witness/stated_blows.h"
#include "problem/witness/stated_forces.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

// What the equations of a body leave over at a solution that does not meet them, about the ground's origin. They are
// its forces and its moments about a point.
SpatialForce<double> left_over(const solve::LinearSystem& system, const solve::LinearSolution& solution, int body,
                               const Vector3<double>& point) {
  const std::vector<std::vector<double>> coefficients = system.coefficients();
  const std::vector<double> right_sides = system.right_sides();
  std::vector<double> left;
  for (std::size_t i = 0; i < right_sides.size(); ++i) {
    const solve::EquationSource& source = system.source(i);
    if (source.kind != solve::EquationKind::balance || source.index != static_cast<std::size_t>(body)) continue;
    left.push_back(right_sides[i]);
    for (std::size_t k = 0; k < solution.value.size(); ++k) left.back() -= coefficients[i][k] * solution.value[k];
  }
  if (left.size() != 6) return SpatialForce<double>::zero();
  const Vector3<double> force{left[0], left[1], left[2]}, moment{left[3], left[4], left[5]};
  return {moment + cross(point, force), force};
}

// What was solved of a body about its mass center; unknowns: null if forces were not.
solve::CheckBody::Within within(const solve::MechanismState& state, int body, const std::vector<double>* unknowns) {
  const Mechanism<double>& mechanism = state.mechanism();
  const SpatialInertia<double>& I = mechanism.tree.body(body).inertia;
  const Vector3<double> c = I.first_moment / I.mass, G = body_mass_center(mechanism.tree, state.workspace(), body);
  const BodyMotion<double>& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
  const SymmetricMatrix3<double> own = I.inertia - I.mass * unit_mass_inertia(c);
  solve::CheckBody::Within found;
  found.angular_momentum = motion.R * (own * transpose_times(motion.R, motion.w));
  found.angular_momentum_size = I.mass * norm_squared(c) * norm(motion.w);
  for (std::size_t i = 0; unknowns && i < mechanism.actions.size(); ++i) {
    const Action& action = mechanism.actions[i];
    if (action.on != body && action.from != body) continue;
    const SpatialForce<double> wrench = solve::action_wrench(state, *unknowns, i, G);
    if (action.on == body) found.moment += wrench.moment;
    if (action.from == body) found.moment = found.moment - wrench.moment;
    found.moment_size += norm(wrench.moment) + norm(c) * norm(wrench.force);
  }
  return found;
}

// By how much the conditions of a steady motion, as they were solved or as a trial leaves them, differ from what the
// bodies carried along from the figure tell of the turning of those that spin: a spin is carried by its frame as an
// arrow fixed in that. A part of the square of the pace. rows: these conditions in the system, body by body.
double steady_misfit(const Situation& situation, DataScope<double>& data, const Machine& machine,
                     const solve::MechanismState& state, const solve::LinearSystem& system,
                     const solve::LinearSolution& solution, const std::vector<std::size_t>& rows) {
  const Steady& steady = *situation.steady;
  struct Turned {
    const Spin* spin;
    int body;
    std::size_t rows;
  };
  std::vector<Turned> turned;
  std::size_t all = 0;
  for (int i = 0; i < machine.mechanism.tree.body_count(); ++i)
    for (const Spin& spin : steady.spins)
      if (spin.body == machine.mechanism.tree.name(i)) {
        const bool rides = std::ranges::any_of(situation.frames, [&](const Frame& frame) {
          return frame.name == steady.frame && frame.rides_on == spin.body;
        });
        turned.push_back({&spin, i, rides ? 3U : 6U});
        all += turned.back().rows;
      }
  // Where other bodies rest in the frame by their joints it is not known which rows are theirs.
  if (turned.empty() || all != rows.size()) return 0;
  std::vector<solve::ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine.masses) bodies.push_back({link, &mass.particles});
  const solve::ParticlePaths paths(machine.links, bodies, state.state().q, state.state().v, state.accelerations());
  using Vector = solve::ParticlePaths::Vector;
  const int frame = machine.index.at(steady.frame);
  const auto change_of = [&](const Vector& arrow) {
    return frame < 0 ? Vector::zero() : paths.velocity(frame, arrow, -1) - paths.velocity(frame, Vector::zero(), -1);
  };
  const std::vector<std::vector<double>> coefficients = system.coefficients();
  const std::vector<double> right_sides = system.right_sides();
  const auto left_of = [&](std::size_t row) {
    double left = -right_sides[row];
    for (std::size_t k = 0; k < solution.value.size(); ++k) left += coefficients[row][k] * solution.value[k];
    return left;
  };
  double worst = 0;
  auto row = rows.begin();
  for (const Turned& one : turned) {
    const Call* call = one.spin->about.as<Call>();
    const bool about_joint = call && call->function == "axis" && call->arguments.size() == 1;
    const Vector3<double> axis =
        about_joint ? state.direction(*machine.joints.at(to_string(call->arguments.front().value)).axis)
                    : data.direction(one.spin->about);
    const Vector spin = widened(data.number(one.spin->rate, dimensions::angular_velocity) * axis);
    const Vector frame_turns = frame < 0 ? Vector::zero() : paths.angular_acceleration(frame);
    const Vector off = paths.angular_acceleration(one.body) - frame_turns - change_of(spin);
    const solve::ParticlePaths::Real size = paths.pace() * paths.pace();
    for (std::size_t k = 0; k < 3 && size > 0; ++k)
      worst =
          std::max(worst, static_cast<double>(std::abs(off[k] - left_of(row[static_cast<std::ptrdiff_t>(k)])) / size));
    row += static_cast<std::ptrdiff_t>(one.rows);
  }
  return worst;
}

}  // namespace

SolvedInstant::Residuals SolvedInstant::check() const {
  Residuals residuals;
  if (linearisation_) {
    Mechanism<double> near;
    residuals.stability = solve::spectrum_misfit(steady_motion({1, 1}, near), *linearisation_);
    const Vector3<double> taken = machine_.mechanism.tree.gravity() - near.tree.gravity();
    if (const double riding = riding_misfit(situation_, machine_, mechanism_state_->state(), taken); riding > 0)
      residuals.stability = std::max(residuals.stability.value_or(0), riding);
  }
  residuals.response = response_misfit_;
  std::vector<solve::CheckBody> bodies;
  double impulse_size = 0, impulse_moment_size = 0, impulse_misfit = 0, impulse_moment_misfit = 0;
  const Mechanism<double>& mechanism = machine_.mechanism;
  const bool attracted = !mechanism.attractions.empty();
  std::vector<double> a(v_.size(), 0.0);
  if (motion_) a = mechanism_state_->accelerations();
  for (const auto& [index, mass] : machine_.masses) {
    solve::CheckBody body;
    body.link = index;
    body.particles = mass.particles;
    const Momentum<double> momentum =
        body_momentum(mechanism.tree, mechanism_state_->workspace(), index, Vector3<double>::zero());
    body.momentum = momentum.linear;
    body.angular_momentum = momentum.angular;
    body.kinetic_energy = body_kinetic_energy(mechanism.tree, mechanism_state_->workspace(), index);
    body.forces_known = motion_.has_value();
    if (motion_) {
      const double m = mechanism.tree.body(index).inertia.mass;
      body.wrench = SpatialForce<double>::zero();
      if (m > 0) {
        const Vector3<double> weight = m * mechanism.tree.gravity();
        body.wrench = {cross(body_mass_center(mechanism.tree, mechanism_state_->workspace(), index), weight), weight};
        body.force_size = norm(weight);
      }
      for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
        const Action& action = mechanism.actions[i];
        if (action.on != index && action.from != index) continue;
        const SpatialForce<double> wrench = solve::action_wrench(*mechanism_state_, unknowns_, i);
        body.force_size += norm(wrench.force);
        body.moment_size += norm(wrench.moment);
        if (action.on == index) body.wrench += wrench;
        if (action.from == index) body.wrench += -1.0 * wrench;
      }
    }
    if (const double m = mechanism.tree.body(index).inertia.mass; attracted && !choice_.trial && m > 0)
      body.within = within(*mechanism_state_, index, motion_ ? &unknowns_ : nullptr);
    // What trial values leave of the equations is known: the particles must need just that besides.
    if (motion_ && choice_.trial) {
      const SpatialForce<double> left =
          left_over(motion_equations_, *motion_, index,
                    mechanism_state_->workspace().motion[static_cast<std::size_t>(index + 1)].p);
      body.wrench = body.wrench - left;
      body.force_size += norm(left.force);
      body.moment_size += norm(left.moment);
    }
    if (before_) {
      const Momentum<double> earlier =
          body_momentum(mechanism.tree, before_->workspace(), index, Vector3<double>::zero());
      SpatialForce<double> given = SpatialForce<double>::zero();
      for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
        const Action& action = mechanism.actions[i];
        if (action.on != index && action.from != index) continue;
        const SpatialForce<double> wrench = solve::action_impulse(*before_, blow_, impulses_, i);
        impulse_size = std::max(impulse_size, norm(wrench.force));
        impulse_moment_size = std::max(impulse_moment_size, norm(wrench.moment));
        given += (action.on == index ? 1.0 : -1.0) * wrench;
      }
      if (choice_.trial) {
        const SpatialForce<double> left = left_over(blow_equations_, blow_solution_, index,
                                                    body_mass_center(mechanism.tree, before_->workspace(), index));
        given = given - left;
        impulse_size = std::max(impulse_size, norm(left.force));
        impulse_moment_size = std::max(impulse_moment_size, norm(left.moment));
      }
      impulse_size = std::max({impulse_size, norm(momentum.linear), norm(earlier.linear)});
      impulse_moment_size = std::max({impulse_moment_size, norm(momentum.angular), norm(earlier.angular)});
      impulse_misfit = std::max(impulse_misfit, norm(momentum.linear - earlier.linear - given.force));
      impulse_moment_misfit = std::max(impulse_moment_misfit, norm(momentum.angular - earlier.angular - given.moment));
    }
    bodies.push_back(std::move(body));
  }
  // Where all is drawn at one point no arm gives moments a size: theirs is rounding of the equations, which have it in
  // the unit of the length that they were set up with.
  const bool has_arms = std::ranges::any_of(bodies, [](const solve::CheckBody& body) {
    return std::ranges::any_of(body.particles, [](const auto& one) { return norm(one.position) > 0; });
  });
  // Where nothing has mass and nothing pushes, forces and couples are rounding of the equations, too.
  const double natural_force = scales_.mass * scales_.length * pace() * pace();
  const bool idle = std::ranges::all_of(bodies, [&](const solve::CheckBody& body) {
    constexpr double rounding = 1e-12;
    return !(mechanism.tree.body(body.link).inertia.mass > 0) &&
           std::max(body.force_size, body.moment_size / scales_.length) <= rounding * natural_force;
  });
  for (solve::CheckBody& body : bodies) {
    if (idle) body.force_size += natural_force;
    if (!has_arms || idle) body.moment_size += scales_.length * body.force_size;
  }
  // A couple alone leaves nothing but rounding of momenta, and a push towards the origin of moments.
  const double impulse_scale = std::max(impulse_size, impulse_moment_size / scales_.length);
  if (impulse_scale > 0)
    residuals.impulse = std::max(impulse_misfit, impulse_moment_misfit / scales_.length) / impulse_scale;
  residuals.particles =
      solve::check_with_particles(machine_.links, bodies, machine_.q, v_, a, attracted ? scales_.length : 0);
  if (motion_ && situation_.steady && !moving_ && !before_) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < motion_equations_.equations(); ++i)
      if (motion_equations_.source(i).kind == solve::EquationKind::condition &&
          source_of(System::motion, i).is_steady_motion())
        rows.push_back(i);
    residuals.particles.newton_euler =
        std::max(residuals.particles.newton_euler,
                 steady_misfit(situation_, *data_, machine_, *mechanism_state_, motion_equations_, *motion_, rows));
  }
  if (!mechanism.constraints.empty()) {
    solve::ConstraintClaim claim{scales_.length, pace(), motion_.has_value(), {}};
    if (before_) {
      // What gives way in the blow may part.
      for (const bool acts : blow_acting_) claim.lets_go.push_back(!acts);
    }
    residuals.constraints = solve::check_constraints(machine_.links, mechanism.constraints, claim, machine_.q, v_, a);
  }
  if (motion_ && !machine_.rough_contacts.empty()) residuals.friction = friction_misfit();
  if (rough_blow_) residuals.blow = rough_blow_misfit();
  if (before_ && !moving_ && !machine_.rough_contacts.empty()) residuals.friction = blow_friction_misfit();
  if (motion_) residuals.laws = std::max(law_misfit(), tooth_misfit());
  if (before_ && !moving_ && !choice_.trial) {
    residuals.laws =
        std::max(residuals.laws.value_or(0), misfit_of_blow(*before_, machine_, *data_, blow_, scales_.length));
    if (const std::optional<double> off = misfit_of_restitution(*before_, *mechanism_state_, machine_, *data_))
      residuals.laws = std::max(*residuals.laws, *off);
  }
  if (linearisation_) {
    const std::size_t stage = built_stage_.value_or(0);
    const auto acting = stage < situation_.stages.size() ? situation_.stages[stage].loads : std::nullopt;
    // So fast that springs and dampers tell: where all rests and nothing weighs as fast as it swings.
    double fast = pace();
    for (const solve::Mode& mode : linearisation_->modes)
      fast = std::max(fast, std::hypot(mode.growth_rate, mode.frequency));
    residuals.laws = std::max(residuals.laws.value_or(0),
                              misfit_of_laws_beside(*mechanism_state_, machine_, *data_, acting, scales_.length, fast));
  }
  return residuals;
}

}  // namespace poinsot::problem
