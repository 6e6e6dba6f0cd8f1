#include "problem/witness/stated_blows.h"

#include <algorithm>
#include <cmath>

#include "problem/witness/stated_forces.h"
#include "problem/witness/stated_springs.h"

namespace poinsot::problem {
namespace {

// A vector as it is stated: three components, or a size and a direction.
Vector3<double> stated_vector(DataScope<double>& data, const Expression& size, const Dimension& dimension,
                              const std::optional<Expression>& direction) {
  return direction ? data.number(size, dimension) * data.direction(*direction) : data.vector(size, dimension);
}

// The impulse of which a force that lasts a while, or the impulse itself, is stated.
Vector3<double> stated_impulse(DataScope<double>& data, const Impulse& impulse) {
  const Dimension per_time = impulse.couple ? dimensions::moment : dimensions::force;
  const Expression& size = impulse.couple ? *impulse.couple : impulse.value ? *impulse.value : *impulse.force;
  if (!impulse.lasts) return stated_vector(data, size, per_time * dimensions::time, impulse.direction);
  return data.number(*impulse.lasts, dimensions::time) * stated_vector(data, size, per_time, impulse.direction);
}

}  // namespace

double misfit_of_blow(const solve::MechanismState& before, const Machine& machine, DataScope<double>& data,
                      const solve::Blow& blow, double unit) {
  const Situation& situation = data.situation();
  double worst = 0;
  const auto compare = [&](const solve::ParticlePaths::Vector& off, double size) {
    if (const double misfit = static_cast<double>(norm(off)); misfit != 0)
      worst = std::max(worst, size > 0 ? misfit / size : misfit);
  };
  const auto drawn = [&](int body, const std::optional<Expression>& at, int axes, const Vector3<double>& vector) {
    return drawn_force(before, machine, data, body, at, axes, vector);
  };
  // What acts at a place has this moment about the ground's origin.
  const auto compare_moment = [&](const SpatialForce<double>& known, const StatedForce& stated) {
    const double arm = unit + static_cast<double>(norm(stated.at));
    compare(widened(known.moment) - cross(stated.at, widened(known.force)),
            norm(known.moment) + arm * norm(known.force));
  };
  if (blow.impulses.size() == situation.impulses.size() + situation.strikes.size()) {
    for (std::size_t i = 0; i < situation.impulses.size(); ++i) {
      const Impulse& impulse = situation.impulses[i];
      const SpatialForce<double>& known = blow.impulses[i].wrench;
      const Vector3<double> vector = stated_impulse(data, impulse);
      const StatedForce stated =
          drawn(machine.index.at(impulse.body), impulse.at, machine.index.at(impulse.axes), vector);
      compare(widened(impulse.couple ? known.moment : known.force) - stated.force, norm(vector));
      // The mass center of a body that a particle stays in moves with it.
      if (!impulse.couple && (impulse.at || situation.strikes.empty())) compare_moment(known, stated);
    }
    for (std::size_t i = 0; i < situation.strikes.size(); ++i) {
      const Strike& strike = situation.strikes[i];
      const SpatialForce<double>& known = blow.impulses[situation.impulses.size() + i].wrench;
      const Vector3<double> velocity = data.vector(strike.velocity, dimensions::velocity);
      const StatedForce stated = drawn(machine.index.at(strike.hits), strike.at, ground, velocity);
      compare_moment(known, stated);
      // The particle that becomes part of a body brings all that it has.
      if (strike.stays && !strike.mass_neglected && strike.relative_to == "ground")
        compare(widened(known.force) -
                    StatedForce::Real(blow.impulses[situation.impulses.size() + i].absorbed) * stated.force,
                norm(known.force));
    }
  }
  for (const solve::Impact& impact : blow.impacts) {
    const auto stated = std::ranges::find(situation.impacts, impact.name, &Impact::name);
    if (impact.is_friction || stated == situation.impacts.end()) continue;
    const StatedForce push = drawn(machine.index.at(stated->of), stated->at, machine.index.at(stated->against),
                                   data.direction(stated->pushes));
    compare(widened(before.direction(impact.push)) - push.force, 1);
    compare(widened(before.position(impact.at)) - push.at, unit + norm(before.position(impact.at)));
  }
  return worst;
}

std::optional<double> misfit_of_restitution(const solve::MechanismState& before, const solve::MechanismState& after,
                                            const Machine& machine, DataScope<double>& data) {
  using Real = solve::ParticlePaths::Real;
  const solve::ParticlePaths coming = paths_of(before, machine, 0), leaving = paths_of(after, machine, 0);
  std::optional<double> worst;
  for (const Impact& impact : data.situation().impacts) {
    if (!impact.restitution || impact.friction) continue;
    const int of = machine.index.at(impact.of), against = machine.index.at(impact.against);
    const StatedForce push = drawn_force(before, machine, data, of, impact.at, against, data.direction(impact.pushes));
    const Real e = data.number(*impact.restitution, dimensions::none);
    const Real u = dot(coming.velocity(of, push.at, against), push.force),
               then = dot(leaving.velocity(of, push.at, against), push.force);
    // Velocities that are almost the same leave rounding of their own.
    constexpr double of_velocities = 1e-6;
    const Real size =
        std::max(std::abs(u), std::abs(then)) +
        of_velocities * (norm(coming.velocity(of, push.at, ground)) + norm(leaving.velocity(of, push.at, ground)));
    if (size > 0) worst = std::max(worst.value_or(0), static_cast<double>(std::abs(then + e * u) / size));
  }
  return worst;
}

}  // namespace poinsot::problem
