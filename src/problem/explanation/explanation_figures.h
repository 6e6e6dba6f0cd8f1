// The numbers of a solved instant that an explanation shows: masses, momenta and their rates, and the balances of
// forces or impulses on sets of bodies, with coefficients for their unknowns.
//
// The scalar is double or Formula. All vectors are on ground axes.
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
  solve::MechanismStateOf<Scalar> now;                      // with accelerations if forces are solved
  bool forces = false;                                      // whether forces are solved
  std::vector<Scalar> unknowns{};                           // of the motion, in the order of solve::force_unknowns
  std::optional<solve::MechanismStateOf<Scalar>> before{};  // the state before a blow
  solve::BlowOf<Scalar> blow{};
  std::vector<Scalar> impulses{};  // in the order of solve::impulse_unknowns

  const Mechanism<Scalar>& mechanism() const { return machine->mechanism; }
};

// The mass, mass center and central inertia of a body in its present pose.
template <class Scalar>
MassProperties<Scalar> mass_of(const solve::MechanismStateOf<Scalar>& state, int body) {
  const Model<Scalar>& tree = state.mechanism().tree;
  const SpatialInertia<Scalar>& I = tree.body(body).inertia;
  const Vector3<Scalar> c = I.first_moment / I.mass;
  const SymmetricMatrix3<Scalar> central = I.inertia - I.mass * unit_mass_inertia(c);
  const Matrix3<Scalar>& R = state.workspace().motion[static_cast<std::size_t>(body + 1)].R;
  return {I.mass, body_mass_center(tree, state.workspace(), body), rotated(R, central)};
}

// The moment of inertia about an axis, and the product for a pair of axes (xy, yz, zx) with the plus sign of Eq.
// 18.6.
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
Momentum<Scalar> momentum_of(const solve::MechanismStateOf<Scalar>& state, const std::set<int>& bodies,
                             const Vector3<Scalar>& about) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (const int body : bodies) sum += body_momentum(state.mechanism().tree, state.workspace(), body, about);
  return sum;
}
template <class Scalar>
Momentum<Scalar> momentum_rate_of(const solve::MechanismStateOf<Scalar>& state, const std::set<int>& bodies,
                                  const Vector3<Scalar>& about) {
  Momentum<Scalar> sum{Vector3<Scalar>::zero(), Vector3<Scalar>::zero()};
  for (const int body : bodies) sum += body_momentum_rate(state.mechanism().tree, state.workspace(), body, about);
  return sum;
}

// An unknown force or impulse on a set of bodies.
struct UnknownForce {
  enum class Kind { component, effort, impact } kind = Kind::component;
  std::size_t index = 0;   // of the component, drive or impact
  std::size_t column = 0;  // of the unknown of the instant
  double sign = 1;         // -1 if the set of bodies is on the other side of the action than in the model
};
// A known force or impulse on a set of bodies.
struct KnownAction {
  std::size_t action = 0;
  double sign = 1;
};

// The external forces on a set of bodies, and what is unknown in their motion.
struct BalancePlan {
  std::set<int> bodies;
  std::vector<UnknownForce> unknown;
  std::vector<KnownAction> known;  // springs, loads, drives with given effort, given impulses
  std::vector<std::size_t> open;   // velocity coordinates whose acceleration (in a blow, velocity after) is unknown
  bool sudden = false;
};

// The terms of the balance of forces and the change of momentum. All are about one point.
template <class Scalar>
struct MotionBalance {
  std::vector<SpatialForce<Scalar>> unknown;  // for a unit of each unknown
  std::vector<SpatialForce<Scalar>> known;
  std::vector<SpatialForce<Scalar>> weights;  // of each body with mass, in the order of the set
  // For each open coordinate: the rate of momentum (momentum after) per unit of it.
  std::vector<SpatialForce<Scalar>> motion;
  SpatialForce<Scalar> rest{};    // the same with all open coordinates at zero
  SpatialForce<Scalar> before{};  // the momentum before a blow
};

template <class Scalar>
SpatialForce<Scalar> about(const SpatialForce<Scalar>& wrench, const Vector3<Scalar>& point) {
  return {wrench.moment - cross(point, wrench.force), wrench.force};
}

template <class Scalar>
SpatialForce<Scalar> as_wrench(const Momentum<Scalar>& momentum) {
  return {momentum.angular, momentum.linear};
}

// The momentum of particles that stay after a blow, with the velocities of a state.
template <class Scalar>
SpatialForce<Scalar> absorbed_momentum(const InstantFigures<Scalar>& figures,
                                       const solve::MechanismStateOf<Scalar>& state, const std::set<int>& bodies,
                                       const Vector3<Scalar>& point) {
  SpatialForce<Scalar> sum = SpatialForce<Scalar>::zero();
  for (const auto& impulse : figures.blow.impulses) {
    if (!bodies.contains(impulse.on)) continue;
    const Vector3<Scalar> momentum = impulse.absorbed * state.velocity(impulse.at);
    sum += SpatialForce<Scalar>{cross(state.position(impulse.at) - point, momentum), momentum};
  }
  return sum;
}

// What a component of size one exerts, with the force by which teeth that it turns push their wheels apart.
template <class Scalar>
SpatialForce<Scalar> wrench_with_parting(const solve::MechanismStateOf<Scalar>& placed, std::size_t index) {
  const std::vector<Component<Scalar>>& components = placed.mechanism().components;
  SpatialForce<Scalar> sum = placed.component_wrench(components[index]);
  for_each_follower(components, index, [&](std::size_t k) {
    if (k != index && components[k].parts_wheels && components[k].flank != 0)
      sum += components[k].followed_part() * placed.component_wrench(components[k]);
  });
  return sum;
}

template <class Scalar>
MotionBalance<Scalar> balance_of(const InstantFigures<Scalar>& figures, const BalancePlan& plan,
                                 const Vector3<Scalar>& point) {
  using Wrench = SpatialForce<Scalar>;
  const Mechanism<Scalar>& mechanism = figures.mechanism();
  const solve::MechanismStateOf<Scalar>& placed = plan.sudden ? *figures.before : figures.now;
  MotionBalance<Scalar> balance;
  for (const UnknownForce& force : plan.unknown) {
    Wrench one = force.kind == UnknownForce::Kind::component
                     ? (plan.sudden ? placed.component_wrench(mechanism.components[force.index])
                                    : wrench_with_parting(placed, force.index))
                 : force.kind == UnknownForce::Kind::effort ? placed.drive_wrench(mechanism.drives[force.index])
                                                            : impact_wrench(placed, figures.blow.impacts[force.index]);
    if (force.kind == UnknownForce::Kind::component && mechanism.components[force.index].span &&
        mechanism.components[force.index].follows >= 0)
      one = mechanism.components[force.index].followed_part() * one;
    balance.unknown.push_back(about(Scalar(static_cast<int>(force.sign)) * one, point));
  }
  for (const KnownAction& known : plan.known) {
    Wrench total = Wrench::zero();
    const int action = static_cast<int>(known.action);
    if (plan.sudden) {
      for (const auto& impulse : figures.blow.impulses)
        if (impulse.action == action) total += impulse.wrench;
    } else {
      balance.known.push_back(Scalar(static_cast<int>(known.sign)) * placed.known_wrench(action, point));
      continue;
    }
    balance.known.push_back(about(Scalar(static_cast<int>(known.sign)) * total, point));
  }
  // What the sides of belts have of the initial tension.
  for (const UnknownForce& force : plan.unknown) {
    if (plan.sudden || force.kind != UnknownForce::Kind::component) continue;
    const Component<Scalar>& component = mechanism.components[force.index];
    if (!poinsot::vanishes(component.offset))
      balance.known.push_back(
          about(Scalar(static_cast<int>(force.sign)) * (component.offset * placed.component_wrench(component)), point));
  }
  for (const int body : plan.bodies) {
    if (plan.sudden || !(plain(mechanism.tree.body(body).inertia.mass) > 0)) continue;
    const Vector3<Scalar> weight = mechanism.tree.body(body).inertia.mass * mechanism.tree.gravity();
    const Vector3<Scalar> arm = body_mass_center(mechanism.tree, placed.workspace(), body) - point;
    balance.weights.push_back({cross(arm, weight), weight});
  }
  const auto side = [&](const solve::MechanismStateOf<Scalar>& state) {
    if (!plan.sudden) return as_wrench(momentum_rate_of(state, plan.bodies, point));
    return as_wrench(momentum_of(state, plan.bodies, point)) + absorbed_momentum(figures, state, plan.bodies, point);
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

// Rows 0 to 2 are those of the force, 3 to 5 those of the moment.
template <class Scalar>
const Scalar& entry(const SpatialForce<Scalar>& wrench, std::size_t row) {
  return row < 3 ? wrench.force[row] : wrench.moment[row - 3];
}

// The velocity of the struck point relative to what it strikes, along the push.
template <class Scalar>
Scalar approach_of(const solve::MechanismStateOf<Scalar>& state, const solve::ImpactOf<Scalar>& impact) {
  const Vector3<Scalar> place = state.position(impact.at);
  const auto velocity = [&](int body) {
    const auto& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
    return motion.v + cross(motion.w, place - motion.p);
  };
  return dot(state.direction(impact.push), velocity(impact.on) - velocity(impact.from));
}

}  // namespace poinsot::problem
