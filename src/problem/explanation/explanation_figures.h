// What an explanation reads of a solved instant: masses, momenta and their rates, and the balances of forces and
// impulses on sets of bodies, as coefficients of what is unknown in them.
//
// Scalar: double, or Formula. All vectors on ground axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "poinsot/engine/dynamics/momentum.h"
#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/instant/impulse.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

template <class Scalar>
struct InstantFigures {
  const MachineOf<Scalar>* machine = nullptr;
  solve::MechanismStateOf<Scalar> now;                      // with accelerations where forces are solved
  bool forces = false;                                      // whether they are
  std::vector<Scalar> unknowns{};                           // of the motion, as solve::force_unknowns orders them
  std::optional<solve::MechanismStateOf<Scalar>> before{};  // a blow
  solve::BlowOf<Scalar> blow{};
  std::vector<Scalar> impulses{};  // as solve::impulse_unknowns orders them

  const Mechanism<Scalar>& mechanism() const { return machine->mechanism; }
};

// Mass, mass center and central inertia of one body where it is now.
template <class Scalar>
MassProperties<Scalar> mass_of(const solve::MechanismStateOf<Scalar>& moment, int body) {
  const Model<Scalar>& tree = moment.mechanism().tree;
  const SpatialInertia<Scalar>& I = tree.body(body).inertia;
  const Vector3<Scalar> c = I.first_moment / I.mass;
  const SymmetricMatrix3<Scalar> central = I.inertia - I.mass * unit_mass_inertia(c);
  const Matrix3<Scalar>& R = moment.workspace().motion[static_cast<std::size_t>(body + 1)].R;
  return {I.mass, body_mass_center(tree, moment.workspace(), body), rotated(R, central)};
}

// The moment of inertia on an axis, and the product of a pair of them (xy, yz, zx) with the plus sign of Eq. 18.6.
template <class Scalar>
const Scalar& moment_on(const SymmetricMatrix3<Scalar>& I, std::size_t axis) {
  return axis == 0 ? I.xx : axis == 1 ? I.yy : I.zz;
}
template <class Scalar>
Scalar product_on(const SymmetricMatrix3<Scalar>& I, std::size_t pair) {
  return -(pair == 0 ? I.xy : pair == 1 ? I.yz : I.zx);
}
inline std::size_t pair_of(std::size_t i, std::size_t j) { return i + j == 1 ? 0 : i + j == 3 ? 1 : 2; }
inline double size_of(const SymmetricMatrix3<double>& I) {
  return std::max({std::abs(I.xx), std::abs(I.yy), std::abs(I.zz)});
}

template <class Scalar>
Momentum<Scalar> momentum_of(const solve::MechanismStateOf<Scalar>& moment, const std::set<int>& bodies,
                             const Vector3<Scalar>& about) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (const int body : bodies) sum += body_momentum(moment.mechanism().tree, moment.workspace(), body, about);
  return sum;
}
template <class Scalar>
Momentum<Scalar> momentum_rate_of(const solve::MechanismStateOf<Scalar>& moment, const std::set<int>& bodies,
                                  const Vector3<Scalar>& about) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (const int body : bodies) sum += body_momentum_rate(moment.mechanism().tree, moment.workspace(), body, about);
  return sum;
}

// A force or impulse on a set of bodies that is unknown.
struct UnknownForce {
  enum class Kind { component, effort, impact } kind = Kind::component;
  std::size_t index = 0;   // among components, drives or impacts
  std::size_t column = 0;  // among the unknowns of the instant
  double sign = 1;         // -1 if what stands in the model acts on the other side
};
// A force or impulse on a set of bodies that is known.
struct KnownAction {
  std::size_t action = 0;
  double sign = 1;
};

// What acts on a set of bodies from outside, and what is open in their motion.
struct BalancePlan {
  std::set<int> bodies;
  std::vector<UnknownForce> unknown;
  std::vector<KnownAction> known;  // springs, loads, drives of given effort, given impulses
  std::vector<std::size_t> open;   // velocity coordinates whose acceleration (velocity after) is unknown
  bool sudden = false;
};

// All about one point; `moment` is the moment about it.
template <class Scalar>
struct Balance {
  std::vector<SpatialForce<Scalar>> unknown;  // of size one
  std::vector<SpatialForce<Scalar>> known;
  std::vector<SpatialForce<Scalar>> weights;  // of each body with mass, in the order of the set
  std::vector<SpatialForce<Scalar>> motion;   // of each open coordinate: rate of momentum (momentum after) for one unit
  SpatialForce<Scalar> rest{};                // the same with all open coordinates zero
  SpatialForce<Scalar> before{};              // momentum before a blow
};

template <class Scalar>
SpatialForce<Scalar> about(const SpatialForce<Scalar>& wrench, const Vector3<Scalar>& point) {
  return {wrench.moment - cross(point, wrench.force), wrench.force};
}

template <class Scalar>
SpatialForce<Scalar> as_wrench(const Momentum<Scalar>& momentum) {
  return {momentum.angular, momentum.linear};
}

// The momentum after a blow that particles which stay have, at the velocities of a moment.
template <class Scalar>
SpatialForce<Scalar> absorbed_momentum(const InstantFigures<Scalar>& figures,
                                       const solve::MechanismStateOf<Scalar>& moment, const std::set<int>& bodies,
                                       const Vector3<Scalar>& point) {
  SpatialForce<Scalar> sum = SpatialForce<Scalar>::zero();
  for (const auto& impulse : figures.blow.impulses) {
    if (!bodies.contains(impulse.on)) continue;
    const Vector3<Scalar> momentum = impulse.absorbed * moment.velocity(impulse.at);
    sum += SpatialForce<Scalar>{cross(moment.position(impulse.at) - point, momentum), momentum};
  }
  return sum;
}

template <class Scalar>
Balance<Scalar> balance_of(const InstantFigures<Scalar>& figures, const BalancePlan& plan,
                           const Vector3<Scalar>& point) {
  using Wrench = SpatialForce<Scalar>;
  const Mechanism<Scalar>& mechanism = figures.mechanism();
  const solve::MechanismStateOf<Scalar>& placed = plan.sudden ? *figures.before : figures.now;
  Balance<Scalar> balance;
  for (const UnknownForce& force : plan.unknown) {
    Wrench one = force.kind == UnknownForce::Kind::component
                     ? placed.component_wrench(mechanism.components[force.index])
                 : force.kind == UnknownForce::Kind::effort ? placed.drive_wrench(mechanism.drives[force.index])
                                                            : impact_wrench(placed, figures.blow.impacts[force.index]);
    balance.unknown.push_back(about(Scalar(static_cast<int>(force.sign)) * one, point));
  }
  for (const KnownAction& known : plan.known) {
    Wrench total = Wrench::zero();
    const int action = static_cast<int>(known.action);
    if (plan.sudden) {
      for (const auto& impulse : figures.blow.impulses)
        if (impulse.action == action) total += impulse.wrench;
    } else {
      for (const Drive<Scalar>& drive : mechanism.drives)
        if (drive.action == action) total += placed.known_effort(drive) * placed.drive_wrench(drive);
      for (const KnownForce<Scalar>& force : mechanism.forces)
        if (force.action == action) total += placed.known_wrench(force);
      for (const SpringLaw<Scalar>& spring : mechanism.springs)
        if (spring.action == action) total += placed.spring_wrench(spring);
    }
    balance.known.push_back(about(Scalar(static_cast<int>(known.sign)) * total, point));
  }
  for (const int body : plan.bodies) {
    if (plan.sudden || !(plain(mechanism.tree.body(body).inertia.mass) > 0)) continue;
    const Vector3<Scalar> weight = mechanism.tree.body(body).inertia.mass * mechanism.tree.gravity();
    const Vector3<Scalar> arm = body_mass_center(mechanism.tree, placed.workspace(), body) - point;
    balance.weights.push_back({cross(arm, weight), weight});
  }
  const auto side = [&](const solve::MechanismStateOf<Scalar>& moment) {
    if (!plan.sudden) return as_wrench(momentum_rate_of(moment, plan.bodies, point));
    return as_wrench(momentum_of(moment, plan.bodies, point)) + absorbed_momentum(figures, moment, plan.bodies, point);
  };
  solve::MechanismStateOf<Scalar> varied = figures.now;
  const auto at = [&](std::vector<Scalar> values) {
    if (plan.sudden)
      varied.set_velocities(values);
    else
      varied.set_accelerations(values);
    return side(varied);
  };
  std::vector<Scalar> values = plan.sudden ? figures.now.state().v : figures.now.accelerations();
  for (const std::size_t k : plan.open) values[k] = Scalar(0);
  balance.rest = at(values);
  for (const std::size_t k : plan.open) {
    values[k] = Scalar(1);
    const Wrench one = at(values);
    balance.motion.push_back(one - balance.rest);
    values[k] = Scalar(0);
  }
  if (plan.sudden) balance.before = as_wrench(momentum_of(*figures.before, plan.bodies, point));
  return balance;
}

// Row 0 to 2: of the force, 3 to 5: of the moment.
template <class Scalar>
const Scalar& entry(const SpatialForce<Scalar>& wrench, std::size_t row) {
  return row < 3 ? wrench.force[row] : wrench.moment[row - 3];
}

// Velocity of the struck point relative to what it strikes, along the push.
template <class Scalar>
Scalar approach_of(const solve::MechanismStateOf<Scalar>& moment, const solve::ImpactOf<Scalar>& impact) {
  const Vector3<Scalar> place = moment.position(impact.at);
  const auto velocity = [&](int body) {
    const auto& motion = moment.workspace().motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, place - motion.p);
  };
  return dot(moment.direction(impact.push), velocity(impact.on) - velocity(impact.from));
}

}  // namespace poinsot::problem
