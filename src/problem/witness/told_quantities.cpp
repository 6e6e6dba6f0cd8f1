// What was told of an instant against the bodies as particles, which share nothing with it but the figure, the
// coordinates and, for a single force or impulse, the others on its body.
#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <optional>
#include <utility>

#include "engine/solve/instant/particle_paths.h"
#include "problem/instant/instant.h"
#include "problem/witness/free_motion_witness.h"
#include "problem/witness/spring_witness.h"
#include "problem/witness/stated_attraction.h"

namespace poinsot::problem {
namespace {

using solve::ParticlePaths;
using Real = ParticlePaths::Real;
using LongVector = ParticlePaths::Vector;
using Kind = ToldQuantity::Kind;

// What is at rest for this instant has no speed to compare with: what the motion gives it in a small part of its own
// time takes its place. Differences leave less than a thousandth of the misfit that is allowed of this.
constexpr Real small_part = 1e-5L;

bool in_blow(Kind kind) { return kind == Kind::impulse || kind == Kind::impulsive_couple; }

Witness number(Real value, Real size) { return {{value, 0, 0}, size}; }

class ToldCheck {
 public:
  // before: the same bodies just before a blow, if there was one.
  ToldCheck(const ParticlePaths& paths, const std::optional<ParticlePaths>& before, const LongVector& gravity)
      : paths_(paths), before_(before), gravity_(gravity) {}

  // Of forces and impulses: what the particles of a body need, less what else acts on it.
  struct Balance {
    SpatialForce<double> others{};  // about the origin of the ground
    double size = 0, moment_size = 0;
  };
  Witness force(const ToldQuantity& told, const Balance& balance) const {
    const ParticlePaths::Sums sums = paths_.sums(told.body, LongVector::zero()),
                              all = paths_.sums(ParticlePaths::all, LongVector::zero());
    LongVector force, moment;
    // What glides without forces needs none: what would turn its momentum round in the motion's own time takes their
    // place.
    const Real per_time = in_blow(told.kind) ? 1 : paths_.pace();
    Real force_size = std::max(Real(balance.size), per_time * all.momentum_size),
         moment_size = std::max(Real(balance.moment_size), per_time * all.angular_size);
    if (in_blow(told.kind)) {
      const ParticlePaths::Sums before = before_->sums(told.body, LongVector::zero());
      force = sums.momentum - before.momentum;
      moment = sums.angular_momentum - before.angular_momentum;
      force_size += before.momentum_size;
      moment_size += before.angular_size;
    } else {
      force = sums.rate - sums.mass * gravity_;
      moment = sums.angular_rate - cross(sums.first_moment, gravity_);
      force_size += sums.rate_size + std::abs(sums.mass) * norm(gravity_);
      moment_size += sums.angular_rate_size + norm(sums.first_moment) * norm(gravity_);
    }
    force -= wide(balance.others.force);
    moment -= wide(balance.others.moment);
    // Where only couples act the forces are rounding of these over the length of the mechanism, and the other way
    // round.
    const Real length = std::max(paths_.length(), norm(wide(told.place)));
    const Real size = force_size + (length > 0 ? moment_size / length : 0);
    if (told.kind == Kind::force || told.kind == Kind::impulse) return {force, size};
    const LongVector normal = wide(told.first);
    if (told.kind == Kind::normal_force) return number(dot(force, normal), size);
    if (told.kind == Kind::force_along) return {dot(force, normal) * normal, size};
    if (told.kind == Kind::friction) return {cross(normal, cross(force, normal)), size};
    if (told.kind == Kind::tension) return number(std::copysign(norm(force), Real(told.value.x)), size);
    const LongVector couple = moment - cross(wide(told.place), force), along = wide(told.first);
    return {told.kind == Kind::effort ? dot(couple, along) * along : couple, moment_size + length * force_size};
  }

  // Nothing where particles do not tell.
  std::optional<Witness> of(const ToldQuantity& told) const {
    const LongVector place = wide(told.place), first = wide(told.first), second = wide(told.second);
    const Real pace = paths_.pace(), reach = norm(place) + paths_.length();
    const auto with_rest = [](const LongVector& value, Real size) {
      return Witness{value, norm(value) + small_part * size};
    };
    switch (told.kind) {
      case Kind::velocity:
        if (told.body >= 0) return with_rest(paths_.velocity(told.body, place, told.from), pace * reach);
        break;
      case Kind::acceleration:
        if (told.body >= 0) return with_rest(paths_.acceleration(told.body, place, told.from), pace * pace * reach);
        return std::nullopt;
      case Kind::position:
        return Witness{paths_.place(told.body, wide(told.first)), reach + norm(wide(told.first))};
      case Kind::direction:
        return Witness{paths_.turn(told.body) * wide(told.first), norm(wide(told.first))};
      case Kind::distance: {
        const LongVector apart = place - wide(told.first), along = wide(told.second);
        return number(norm(apart - dot(apart, along) * along), norm(place) + norm(wide(told.first)));
      }
      case Kind::direction_angle: {
        const LongVector one = wide(told.first), other = wide(told.second);
        return number(std::atan2(norm(cross(one, other)), dot(one, other)), 1);
      }
      case Kind::angular_velocity:
        return with_rest(paths_.angular_velocity(told.body, told.from), pace);
      case Kind::angular_acceleration:
        return with_rest(paths_.angular_acceleration(told.body), pace * pace);
      default:
        break;
    }
    const int link = told.body < 0 ? ParticlePaths::all : told.body;
    const ParticlePaths::Sums sums = paths_.sums(link, place);
    if (!(sums.mass > 0)) return std::nullopt;
    const LongVector center = sums.mass > 0 ? sums.first_moment / sums.mass : LongVector::zero();
    const auto along = [&](const LongVector& a, const LongVector& b) { return dot(a, sums.moments * b); };
    switch (told.kind) {
      case Kind::center:
        return Witness{center, reach};
      case Kind::velocity:
        return with_rest(sums.momentum / sums.mass, pace * reach);
      case Kind::mass:
        return number(sums.mass, std::abs(sums.mass));
      case Kind::weight:
        if (!(norm(gravity_) > 0)) return std::nullopt;  // asked where nothing weighs
        return number(sums.mass * norm(gravity_), std::abs(sums.mass) * norm(gravity_));
      case Kind::momentum:
        return Witness{sums.momentum, sums.momentum_size + small_part * pace * reach * sums.mass};
      case Kind::angular_momentum:
        return Witness{sums.angular_momentum, sums.angular_size + small_part * pace * reach * reach * sums.mass};
      case Kind::kinetic_energy:
        return number(sums.kinetic_energy, sums.energy_size + square(small_part * pace * reach) * sums.mass);
      case Kind::kinetic_energy_within:
        return number(sums.kinetic_energy - norm_squared(sums.momentum) / (2 * sums.mass),
                      sums.energy_size + square(small_part * pace * reach) * sums.mass);
      case Kind::height_energy:
        return number(-dot(gravity_, sums.first_moment), norm(gravity_) * sums.mass * reach);
      case Kind::moment_of_inertia:
      case Kind::radius_of_gyration: {
        const Real moment = (sums.moments.row0.x + sums.moments.row1.y + sums.moments.row2.z) * norm_squared(first) -
                            along(first, first);
        if (told.kind == Kind::moment_of_inertia) return number(moment, sums.moments_size);
        // Of a thin rod about its line it is the root of rounding: the squares are compared.
        const Real radius = told.value.x, size = std::sqrt(sums.moments_size / sums.mass);
        return number(size > 0 ? radius + (moment / sums.mass - radius * radius) / size : 0, size);
      }
      case Kind::product_of_inertia:
        return number(along(first, second), sums.moments_size);
      default:
        return free_motion_of(told, sums, paths_.angular_velocity(link, -1));
    }
  }

  // The same for rates over time.
  std::optional<Witness> rate(const ToldQuantity& told) const {
    const LongVector place = wide(told.place), carried = wide(told.place_rate);
    const Real pace = paths_.pace(), reach = norm(place) + paths_.length();
    const bool seen_from_ground = told.body >= 0 && told.from == -1;
    switch (told.kind) {
      case Kind::velocity:
        if (seen_from_ground) return Witness{paths_.acceleration(told.body, place, -1), pace * pace * reach};
        return std::nullopt;
      case Kind::position: {
        const LongVector now = paths_.place(told.body, wide(told.first));
        return Witness{paths_.velocity(told.body, now, -1), pace * (norm(now) + paths_.length())};
      }
      case Kind::direction: {
        const LongVector now = paths_.turn(told.body) * wide(told.first);
        return Witness{cross(paths_.angular_velocity(told.body, -1), now), pace * norm(now)};
      }
      case Kind::angular_velocity:
        if (seen_from_ground) return Witness{paths_.angular_acceleration(told.body), pace * pace};
        return std::nullopt;
      default:
        break;
    }
    const ParticlePaths::Sums sums = paths_.sums(told.body < 0 ? ParticlePaths::all : told.body, place);
    if (!(sums.mass > 0)) return std::nullopt;
    const Real weight = norm(gravity_) * sums.mass, rest = small_part * pace * pace * sums.mass;
    switch (told.kind) {
      case Kind::center:
        return Witness{sums.momentum / sums.mass, pace * reach};
      case Kind::momentum:
        return Witness{sums.rate, sums.rate_size + rest * reach};
      case Kind::angular_momentum:
        return Witness{sums.angular_rate - cross(carried, sums.momentum),
                       sums.angular_rate_size + norm(carried) * sums.momentum_size + rest * reach * reach};
      case Kind::kinetic_energy:
        return number(sums.power, sums.power_size + pace * sums.energy_size);
      case Kind::kinetic_energy_within:
        return number(sums.power - dot(sums.momentum, sums.rate) / sums.mass,
                      sums.power_size + pace * sums.energy_size);
      case Kind::height_energy:
        return number(-dot(gravity_, sums.momentum), weight * pace * reach);
      default:
        return std::nullopt;
    }
  }

  static LongVector wide(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

 private:
  static Real square(Real x) { return x * x; }

  const ParticlePaths& paths_;
  const std::optional<ParticlePaths>& before_;
  LongVector gravity_;
};

bool of_forces(Kind kind) {
  return kind == Kind::force || kind == Kind::couple || kind == Kind::tension || kind == Kind::effort ||
         kind == Kind::normal_force || kind == Kind::friction || kind == Kind::force_along || in_blow(kind);
}

// How hard a center pulls a body.
std::optional<Witness> pulled_weight(const ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
                                     int body) {
  for (std::size_t i = 0; i < machine.masses.size(); ++i)
    if (const auto pull = stated_attraction(paths, machine, data, i); pull && machine.masses[i].first == body)
      return number(norm(pull->force), norm(pull->force));
  return std::nullopt;
}

}  // namespace

SolvedInstant::ToldMisfit SolvedInstant::misfit_of_told() const {
  ToldMisfit worst;
  if (told_.empty()) return worst;
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine_.masses) bodies.push_back({link, &mass.particles});
  std::vector<double> a(v_.size(), 0.0);
  if (motion_) a = mechanism_state_->accelerations();
  // Particles that a body has taken up in a blow belong to it from then on.
  std::list<std::vector<Particle<double>>> taken_up;
  const std::vector<ParticlePaths::Body> bodies_before = bodies;
  const std::size_t first_strike = machine_.impulses.size() - situation_.strikes.size();
  for (std::size_t i = 0; before_ && i < situation_.strikes.size(); ++i) {
    const Strike& strike = situation_.strikes[i];
    const double mass = machine_.impulses[first_strike + i].absorbed;
    if (!(mass > 0)) continue;
    taken_up.push_back({{mass, data_->place(strike.at)}});
    bodies.push_back({machine_.index.at(strike.hits), &taken_up.back()});
  }
  const bool attracted = !mechanism.attractions.empty();
  const ParticlePaths paths(machine_.links, bodies, machine_.q, v_, a, attracted ? scales_.length : 0);
  std::optional<ParticlePaths> before;
  if (before_ && std::ranges::any_of(told_, [](const ToldQuantity& told) { return in_blow(told.kind); }))
    before.emplace(machine_.links, bodies_before, machine_.q, before_->state().v, std::vector<double>(v_.size(), 0.0));
  const ToldCheck check(paths, before, ToldCheck::wide(mechanism.tree.gravity()));
  const auto balance = [&](const ToldQuantity& told) {
    ToldCheck::Balance found;
    for (std::size_t i = 0; i < mechanism.actions.size(); ++i) {
      const Action& action = mechanism.actions[i];
      const SpatialForce<double> wrench = in_blow(told.kind) ? solve::action_impulse(*before_, blow_, impulses_, i)
                                                             : solve::action_wrench(*mechanism_state_, unknowns_, i);
      // A force that is nothing is rounding of the others in the mechanism.
      found.size = std::max(found.size, norm(wrench.force));
      found.moment_size = std::max(found.moment_size, norm(wrench.moment));
      if (std::ranges::find(told.actions, i) != told.actions.end()) continue;
      if (action.on == told.body) found.others += wrench;
      if (action.from == told.body) found.others += -1.0 * wrench;
    }
    return found;
  };

  const auto is_driven = [&](int body) {
    return body == ground || !mechanism.takes_part[static_cast<std::size_t>(body)];
  };
  for (ToldQuantity told : told_) {
    const bool of_force = of_forces(told.kind);
    // What a particle brings stands among the impulses of its body, but not among its own momentum before.
    if (in_blow(told.kind) && !taken_up.empty()) continue;
    // Nothing tells what the ground and frames need: what acts on them acts on the other body too.
    if (of_force && is_driven(told.body)) {
      std::swap(told.body, told.from);
      told.value = -told.value;
    }
    if (of_force && is_driven(told.body)) continue;
    const ParticlePaths::Vector value = ToldCheck::wide(told.as_rate ? told.value_rate : told.value);
    std::optional<Witness> witness = told.kind == Kind::spring_energy ? spring_energy(told, paths, machine_, *data_, v_)
                                     : of_force                       ? std::optional(check.force(told, balance(told)))
                                     : told.as_rate                   ? check.rate(told)
                                                                      : check.of(told);
    if (attracted && told.kind == Kind::weight && !told.as_rate)
      witness = pulled_weight(paths, machine_, *data_, told.body);
    if (attracted && told.kind == Kind::height_energy && witness) {
      const StatedPotential pull = stated_potential(paths, machine_, *data_, told.body, told.as_rate);
      witness->value.x += pull.value;
      witness->size += pull.size;
    }
    if (!witness) continue;
    ++worst.checked;
    const Real off = norm(value - witness->value);
    Real size = witness->size + norm(value);
    // An acceleration that is nothing is rounding of the forces that balance.
    if (told.kind == Kind::acceleration && motion_ && told.body >= 0 && !is_driven(told.body) &&
        mechanism.tree.body(told.body).inertia.mass > 0)
      size += balance(told).size / mechanism.tree.body(told.body).inertia.mass;
    const auto misfit = static_cast<double>(off == 0 ? 0 : off / size);
    if (!(misfit <= worst.misfit))
      worst = {std::isfinite(misfit) ? misfit : std::numeric_limits<double>::infinity(), told.words, worst.checked};
  }
  return worst;
}

}  // namespace poinsot::problem
