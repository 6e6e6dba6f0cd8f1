#include "poinsot/engine/solve/instant/impulse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solve/instant/equation_rows.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::solve {
namespace {

template <class Scalar>
Vector3<Scalar> point_rate(const MechanismStateOf<Scalar>& state, int body, const Vector3<Scalar>& p) {
  const BodyMotion<Scalar>& motion = state.workspace().motion[static_cast<std::size_t>(body + 1)];
  return motion.v + cross(motion.w, p - motion.p);
}

}  // namespace

template <class Scalar>
ImpulseUnknowns impulse_unknowns(const Mechanism<Scalar>& mechanism, const BlowOf<Scalar>& blow) {
  ImpulseUnknowns unknowns;
  ForceUnknowns forces = force_unknowns(mechanism);
  unknowns.velocities = forces.accelerations;
  unknowns.components = forces.components;
  unknowns.efforts = forces.efforts;
  unknowns.drive_of_effort = std::move(forces.drive_of_effort);
  unknowns.impacts = blow.impacts.size();
  return unknowns;
}

template <class Scalar>
LinearSystemOf<Scalar> impulse_equations(const MechanismStateOf<Scalar>& before, const Scales& scales,
                                         const BlowOf<Scalar>& blow, const std::vector<ConditionOf<Scalar>>& conditions,
                                         const std::vector<bool>& acting) {
  using Vector = Vector3<Scalar>;
  using Wrench = SpatialForce<Scalar>;
  const Mechanism<Scalar>& mechanism = before.mechanism();
  const Model<Scalar>& tree = mechanism.tree;
  const ImpulseUnknowns unknowns = impulse_unknowns(mechanism, blow);
  const double impulse_scale = scales.mass * scales.length / scales.time;
  const ForceWords words{
      "impulse",     "impulsive couple",           "impulsive drive", "impulses on ", "moments of the impulses on ",
      impulse_scale, impulse_scale * scales.length};

  LinearSystemOf<Scalar> system;
  for (int k = 0; k < tree.velocity_size(); ++k)
    system.add_unknown({mechanism.coordinate_names[static_cast<std::size_t>(k)], " after the blow"},
                       coordinate_turns(tree, k) ? 1 : scales.length);
  add_force_unknowns(system, mechanism, unknowns.drive_of_effort, words);
  for (const ImpactOf<Scalar>& impact : blow.impacts)
    system.add_unknown({impact.is_friction ? "impulse of friction(" : "impulse(", impact.name, ")"}, impulse_scale);

  // System momenta before + external impulses = system momenta after (Eq. 17.4), body by body, about its mass center.
  std::vector<std::size_t> first_row(static_cast<std::size_t>(tree.body_count()), 0);
  std::vector<Vector> center(static_cast<std::size_t>(tree.body_count()));
  for (int i = 0; i < tree.body_count(); ++i) {
    if (!mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    const Scalar& mass = tree.body(i).inertia.mass;
    const bool massive = plain(mass) > 0;
    const Vector G = massive ? body_mass_center(tree, before.workspace(), i)
                             : before.workspace().motion[static_cast<std::size_t>(i + 1)].p;
    center[static_cast<std::size_t>(i)] = G;
    const std::size_t row = add_balance(system, tree, i, words);
    first_row[static_cast<std::size_t>(i)] = row;
    if (!massive) continue;
    const Momentum<Scalar> momentum = body_momentum(tree, before.workspace(), i, G);
    for (std::size_t k = 0; k < 3; ++k) {
      system.add_right_side(row + k, momentum.linear[k]);
      system.add_right_side(row + 3 + k, momentum.angular[k]);
    }
    const Matrix3<Scalar> R = before.workspace().motion[static_cast<std::size_t>(i + 1)].R;
    const SpatialInertia<Scalar>& I = tree.body(i).inertia;
    const SymmetricMatrix3<Scalar> I_G = I.inertia - mass * unit_mass_inertia(I.first_moment / mass);
    for_each_coordinate_motion(tree, before.workspace(), i, G, [&](int coordinate, const SpatialMotion<Scalar>& S) {
      const Vector H = R * (I_G * transpose_times(R, S.angular));
      for (std::size_t k = 0; k < 3; ++k) {
        system.add(row + k, static_cast<std::size_t>(coordinate), mass * S.linear[k]);
        system.add(row + 3 + k, static_cast<std::size_t>(coordinate), H[k]);
      }
    });
  }
  const auto on_body = [&](int body, const Scalar& sign, const Wrench& wrench, auto&& add) {
    if (body == ground || !mechanism.takes_part[static_cast<std::size_t>(body)]) return;
    const std::size_t row = first_row[static_cast<std::size_t>(body)];
    const Vector moment_G = wrench.moment - cross(center[static_cast<std::size_t>(body)], wrench.force);
    for (std::size_t k = 0; k < 3; ++k) {
      add(row + k, sign * wrench.force[k]);
      add(row + 3 + k, sign * moment_G[k]);
    }
  };
  const auto act = [&](std::size_t column, int on, int from, const Wrench& wrench) {
    const auto add = [&](std::size_t row, const Scalar& value) { system.add(row, column, -value); };
    on_body(on, Scalar(1), wrench, add);
    on_body(from, Scalar(-1), wrench, add);
  };
  std::size_t column = unknowns.velocities;
  for (const Component<Scalar>& component : mechanism.components) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    act(column++, action.on, action.from, before.component_wrench(component));
  }
  for (std::size_t drive : unknowns.drive_of_effort) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(mechanism.drives[drive].action)];
    act(column++, action.on, action.from, before.drive_wrench(mechanism.drives[drive]));
  }
  for (const ImpactOf<Scalar>& impact : blow.impacts)
    act(column++, impact.on, impact.from, impact_wrench(before, impact));
  for (const KnownImpulseOf<Scalar>& impulse : blow.impulses) {
    on_body(impulse.on, Scalar(1), impulse.wrench,
            [&](std::size_t row, const Scalar& value) { system.add_right_side(row, value); });
    if (vanishes(impulse.absorbed)) continue;
    const Vector P = before.position(impulse.at);
    for_each_coordinate_motion(tree, before.workspace(), impulse.on, P, [&](int k, const SpatialMotion<Scalar>& S) {
      const Vector taken = impulse.absorbed * S.linear;
      on_body(impulse.on, Scalar(1), {cross(P, taken), taken},
              [&](std::size_t row, const Scalar& value) { system.add(row, static_cast<std::size_t>(k), value); });
    });
  }

  // A joint, contact or taut cord constrains the velocities after the blow as it did before. What does not act at
  // this blow gives no equation.
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
    const VelocityConstraint<Scalar>& constraint = mechanism.constraints[i];
    if (constraint.action >= 0 && !acting[static_cast<std::size_t>(constraint.action)]) continue;
    add_constraint(system, mechanism, i, constraint_coefficients(before, constraint), scales);
  }
  for (std::size_t i = 0; i < mechanism.components.size(); ++i) {
    const Component<Scalar>& component = mechanism.components[i];
    if (acting[static_cast<std::size_t>(component.action)] || component.follows >= 0) continue;
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    system.add(system.add_equation({"no impulse of '", action.name, "'"}, impulse_scale), unknowns.velocities + i,
               Scalar(1));
  }
  add_followed_components(system, mechanism, unknowns.velocities, impulse_scale, true);
  const auto hold = [&](int coordinate) {
    const auto k = static_cast<std::size_t>(coordinate);
    const std::size_t row = system.add_equation({mechanism.coordinate_names[k], " is held"},
                                                coordinate_turns(tree, coordinate) ? 1 : scales.length);
    system.add(row, k, Scalar(1));
    system.add_right_side(row, before.state().v[k]);
  };
  for (std::size_t drive : unknowns.drive_of_effort) hold(mechanism.drives[drive].coordinate);
  for (int k : blow.held_coordinates) hold(k);
  // Newton's restitution: along the push the relative velocity after the impact is -e times the one before.
  std::size_t own = unknowns.velocities + unknowns.components + unknowns.efforts;
  for (const ImpactOf<Scalar>& impact : blow.impacts) {
    const std::size_t here = own++;
    if (impact.given || impact.per_push) {
      const std::size_t row = system.add_equation({"friction at '", impact.name, "'"}, impulse_scale);
      system.add(row, here, Scalar(1));
      if (impact.given) system.add_right_side(row, *impact.given);
      if (impact.per_push) system.add(row, here - 1, -*impact.per_push);
      continue;
    }
    const std::size_t row = system.add_equation({"restitution at '", impact.name, "'"}, scales.length);
    const Vector P = before.position(impact.at), n = before.direction(impact.push);
    for (const auto& [body, sign] : {std::pair{impact.on, Scalar(1)}, std::pair{impact.from, Scalar(-1)}})
      for_each_coordinate_motion(tree, before.workspace(), body, P,
                                 [&, side = sign](int k, const SpatialMotion<Scalar>& S) {
                                   system.add(row, static_cast<std::size_t>(k), side * dot(n, S.linear));
                                 });
    system.add_right_side(row, impact.leaves ? *impact.leaves : -impact.restitution * approach(before, impact));
  }
  add_conditions(system, conditions);
  return system;
}

LinearSolution solve_impulse(const MechanismState& before, const Scales& scales, const Blow& blow,
                             const std::vector<Condition>& conditions, const std::vector<bool>& acting,
                             LinearSystem* equations) {
  LinearSystem system = impulse_equations(before, scales, blow, conditions, acting);
  LinearSolution solution = system.solve();
  if (equations) *equations = std::move(system);
  return solution;
}

template <class Scalar>
SpatialForce<Scalar> impact_wrench(const MechanismStateOf<Scalar>& state, const ImpactOf<Scalar>& impact) {
  const Vector3<Scalar> n = state.direction(impact.push);
  return {cross(state.position(impact.at), n), n};
}

template <class Scalar>
Vector3<Scalar> impact_velocity(const MechanismStateOf<Scalar>& state, const ImpactOf<Scalar>& impact) {
  const Vector3<Scalar> P = state.position(impact.at);
  return point_rate(state, impact.on, P) - point_rate(state, impact.from, P);
}

template <class Scalar>
Scalar approach(const MechanismStateOf<Scalar>& state, const ImpactOf<Scalar>& impact) {
  return dot(state.direction(impact.push), impact_velocity(state, impact));
}

template <class Scalar>
SpatialForce<Scalar> action_impulse(const MechanismStateOf<Scalar>& state, const BlowOf<Scalar>& blow,
                                    const std::vector<Scalar>& unknowns, std::size_t action) {
  using Vector = Vector3<Scalar>;
  using Wrench = SpatialForce<Scalar>;
  const Mechanism<Scalar>& mechanism = state.mechanism();
  const ImpulseUnknowns order = impulse_unknowns(mechanism, blow);
  const int index = static_cast<int>(action);
  Wrench total = unknown_wrench(state, unknowns, order.velocities, order.drive_of_effort, index);
  std::size_t column = order.velocities + order.components + order.efforts;
  for (const ImpactOf<Scalar>& impact : blow.impacts) {
    if (impact.action == index) total += unknowns[column] * impact_wrench(state, impact);
    ++column;
  }
  for (const KnownImpulseOf<Scalar>& impulse : blow.impulses) {
    if (impulse.action != index) continue;
    total += impulse.wrench;
    const Vector P = state.position(impulse.at);
    for_each_coordinate_motion(
        mechanism.tree, state.workspace(), impulse.on, P, [&](int k, const SpatialMotion<Scalar>& S) {
          const Vector kept = (-impulse.absorbed * unknowns[static_cast<std::size_t>(k)]) * S.linear;
          total += Wrench{cross(P, kept), kept};
        });
  }
  return total;
}

template ImpulseUnknowns impulse_unknowns(const Mechanism<double>&, const BlowOf<double>&);
template LinearSystemOf<double> impulse_equations(const MechanismStateOf<double>&, const Scales&, const BlowOf<double>&,
                                                  const std::vector<ConditionOf<double>>&, const std::vector<bool>&);
template SpatialForce<double> impact_wrench(const MechanismStateOf<double>&, const ImpactOf<double>&);
template Vector3<double> impact_velocity(const MechanismStateOf<double>&, const ImpactOf<double>&);
template double approach(const MechanismStateOf<double>&, const ImpactOf<double>&);
template SpatialForce<double> action_impulse(const MechanismStateOf<double>&, const BlowOf<double>&,
                                             const std::vector<double>&, std::size_t);
template ImpulseUnknowns impulse_unknowns(const Mechanism<Dual<1>>&, const BlowOf<Dual<1>>&);
template LinearSystemOf<Dual<1>> impulse_equations(const MechanismStateOf<Dual<1>>&, const Scales&,
                                                   const BlowOf<Dual<1>>&, const std::vector<ConditionOf<Dual<1>>>&,
                                                   const std::vector<bool>&);
template SpatialForce<Dual<1>> impact_wrench(const MechanismStateOf<Dual<1>>&, const ImpactOf<Dual<1>>&);
template Vector3<Dual<1>> impact_velocity(const MechanismStateOf<Dual<1>>&, const ImpactOf<Dual<1>>&);
template Dual<1> approach(const MechanismStateOf<Dual<1>>&, const ImpactOf<Dual<1>>&);
template SpatialForce<Dual<1>> action_impulse(const MechanismStateOf<Dual<1>>&, const BlowOf<Dual<1>>&,
                                              const std::vector<Dual<1>>&, std::size_t);
template ImpulseUnknowns impulse_unknowns(const Mechanism<Formula>&, const BlowOf<Formula>&);
template LinearSystemOf<Formula> impulse_equations(const MechanismStateOf<Formula>&, const Scales&,
                                                   const BlowOf<Formula>&, const std::vector<ConditionOf<Formula>>&,
                                                   const std::vector<bool>&);
template SpatialForce<Formula> impact_wrench(const MechanismStateOf<Formula>&, const ImpactOf<Formula>&);
template Vector3<Formula> impact_velocity(const MechanismStateOf<Formula>&, const ImpactOf<Formula>&);
template Formula approach(const MechanismStateOf<Formula>&, const ImpactOf<Formula>&);
template SpatialForce<Formula> action_impulse(const MechanismStateOf<Formula>&, const BlowOf<Formula>&,
                                              const std::vector<Formula>&, std::size_t);

}  // namespace poinsot::solve
