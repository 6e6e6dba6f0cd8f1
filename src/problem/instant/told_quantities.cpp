// What was told of an instant against the bodies as particles, which share nothing with it but the figure, the
// coordinates and, for a single force or impulse, the others on its body.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/solve/instant/particle_paths.h"
#include "problem/instant/instant.h"

namespace poinsot::problem {
namespace {

using solve::ParticlePaths;
using Real = ParticlePaths::Real;
using Vector = ParticlePaths::Vector;
using Kind = ToldQuantity::Kind;

// What is at rest for this instant has no speed to compare with: what the motion gives it in a small part of its own
// time takes its place. Differences leave less than a thousandth of the misfit that is allowed of this.
constexpr Real small_part = 1e-5L;

// What should have been told, and the size of its terms.
struct Witness {
  Vector value = Vector::zero();
  Real size = 0;
};

bool in_blow(Kind kind) { return kind == Kind::impulse || kind == Kind::impulsive_couple; }

Witness number(Real value, Real size) { return {{value, 0, 0}, size}; }

class ToldCheck {
 public:
  // before: the same bodies just before a blow, if there was one.
  ToldCheck(const ParticlePaths& paths, const std::optional<ParticlePaths>& before, const Vector& gravity)
      : paths_(paths), before_(before), gravity_(gravity) {}

  // Of forces and impulses: what the particles of a body need, less what else acts on it.
  struct Balance {
    SpatialForce<double> others{};  // about the origin of the ground
    double size = 0, moment_size = 0;
  };
  Witness force(const ToldQuantity& told, const Balance& balance) const {
    const ParticlePaths::Sums sums = paths_.sums(told.body, Vector::zero()),
                              all = paths_.sums(ParticlePaths::all, Vector::zero());
    Vector force, moment;
    // What glides without forces needs none: what would turn its momentum round in the motion's own time takes their
    // place.
    const Real per_time = in_blow(told.kind) ? 1 : paths_.pace();
    Real force_size = std::max(Real(balance.size), per_time * all.momentum_size),
         moment_size = std::max(Real(balance.moment_size), per_time * all.angular_size);
    if (in_blow(told.kind)) {
      const ParticlePaths::Sums before = before_->sums(told.body, Vector::zero());
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
    if (told.kind == Kind::force || told.kind == Kind::impulse)
      return {force, force_size + (length > 0 ? moment_size / length : 0)};
    return {moment - cross(wide(told.place), force), moment_size + length * force_size};
  }

  // Nothing where particles do not tell.
  std::optional<Witness> of(const ToldQuantity& told) const {
    const Vector place = wide(told.place), first = wide(told.first), second = wide(told.second);
    const Real pace = paths_.pace(), reach = norm(place) + paths_.length();
    const auto with_rest = [](const Vector& value, Real size) {
      return Witness{value, norm(value) + small_part * size};
    };
    switch (told.kind) {
      case Kind::velocity:
        if (told.body >= 0) return with_rest(paths_.velocity(told.body, place, told.from), pace * reach);
        break;
      case Kind::acceleration:
        if (told.body >= 0) return with_rest(paths_.acceleration(told.body, place, told.from), pace * pace * reach);
        return std::nullopt;
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
    const Vector center = sums.mass > 0 ? sums.first_moment / sums.mass : Vector::zero();
    const auto along = [&](const Vector& a, const Vector& b) { return dot(a, sums.moments * b); };
    switch (told.kind) {
      case Kind::center:
        return Witness{center, reach};
      case Kind::velocity:
        return with_rest(sums.momentum / sums.mass, pace * reach);
      case Kind::mass:
        return number(sums.mass, std::abs(sums.mass));
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
        return number((sums.moments.row0.x + sums.moments.row1.y + sums.moments.row2.z) * norm_squared(first) -
                          along(first, first),
                      sums.moments_size);
      case Kind::product_of_inertia:
        return number(along(first, second), sums.moments_size);
      default:
        return std::nullopt;
    }
  }

  static Vector wide(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

 private:
  static Real square(Real x) { return x * x; }

  const ParticlePaths& paths_;
  const std::optional<ParticlePaths>& before_;
  Vector gravity_;
};

bool of_forces(Kind kind) { return kind == Kind::force || kind == Kind::couple || in_blow(kind); }

}  // namespace

SolvedInstant::ToldMisfit SolvedInstant::misfit_of_told() const {
  ToldMisfit worst;
  if (told_.empty()) return worst;
  const Mechanism<double>& mechanism = machine_.mechanism;
  std::vector<ParticlePaths::Body> bodies;
  for (const auto& [link, mass] : machine_.masses) bodies.push_back({link, &mass.particles});
  std::vector<double> a(v_.size(), 0.0);
  if (motion_) a = mechanism_state_->accelerations();
  const ParticlePaths paths(machine_.links, bodies, machine_.q, v_, a);
  std::optional<ParticlePaths> before;
  if (before_)
    before.emplace(machine_.links, bodies, machine_.q, before_->state().v, std::vector<double>(v_.size(), 0.0));
  const ToldCheck check(paths, before, ToldCheck::wide(mechanism.tree.gravity()));
  // Particles that a body has taken up in a blow are not among its own.
  const bool takes_up = !situation_.strikes.empty();

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
    if (takes_up && told.kind != Kind::velocity && told.kind != Kind::angular_velocity) continue;
    // Nothing tells what the ground and frames need: what acts on them acts on the other body too.
    if (of_force && is_driven(told.body)) {
      std::swap(told.body, told.from);
      told.value = -told.value;
    }
    if (of_force && is_driven(told.body)) continue;
    const std::optional<Witness> witness = of_force ? std::optional(check.force(told, balance(told))) : check.of(told);
    if (!witness) continue;
    ++worst.checked;
    const Real off = norm(ToldCheck::wide(told.value) - witness->value);
    const Real size = witness->size + norm(ToldCheck::wide(told.value));
    const auto misfit = static_cast<double>(off == 0 ? 0 : off / size);
    if (!(misfit <= worst.misfit))
      worst = {std::isfinite(misfit) ? misfit : std::numeric_limits<double>::infinity(), told.words, worst.checked};
  }
  return worst;
}

}  // namespace poinsot::problem
