#include "poinsot/engine/solve/instant/equations.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "engine/solve/instant/equation_rows.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::solve {
namespace {

// What rounding leaves of a sum that should vanish, as a part of the sizes of its terms: some twenty units in the
// last place.
constexpr double rounding = 4e-15;

// The coefficients of a constraint, with those set to zero that are smaller than any arm in the mechanism could be
// and so must be rounding.
template <class Scalar>
std::vector<Scalar> without_rounding(std::vector<Scalar> coefficients, const VelocityConstraint<Scalar>& constraint,
                                     const Model<Scalar>& tree, const Scales& scales) {
  // Formulas are exact and hold no rounding.
  if constexpr (std::is_same_v<Scalar, Formula>) return coefficients;
  const double least = 2e-14 * (constraint.kind == VelocityConstraintKind::angular ? 1 : scales.length);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const double size = std::abs(plain(coefficients[k]));
    if (size == 0 || (size > least && size * scales.length > least)) continue;
    if (size * (coordinate_turns(tree, static_cast<int>(k)) ? 1 : scales.length) <= least)
      coefficients[k] = coefficients[k] - lifted<Scalar>(plain(coefficients[k]));
  }
  return coefficients;
}

// Names the acceleration of a coordinate after its rate: "angular velocity of disk" becomes "angular acceleration of
// disk".
template <class Scalar>
void add_acceleration(LinearSystemOf<Scalar>& system, std::string_view name, double scale) {
  for (const auto& [rate, acceleration] :
       {std::pair<std::string_view, std::string_view>{"the rate of ", "acceleration of "},
        {"angular velocity", "angular acceleration"},
        {"velocity", "acceleration"}})
    if (const std::size_t found = name.find(rate); found != std::string_view::npos) {
      system.add_unknown({name.substr(0, found), acceleration, name.substr(found + rate.size())}, scale);
      return;
    }
  system.add_unknown({"acceleration of ", name}, scale);
}

}  // namespace

template <class Scalar>
bool coordinate_turns(const Model<Scalar>& tree, int coordinate) {
  for (const Body<Scalar>& body : tree.bodies()) {
    const int k = coordinate - body.v;
    if (k < 0 || k >= velocity_size(body.joint)) continue;
    if (body.joint == JointType::prismatic) return false;
    return !(body.joint == JointType::free && k >= 3);
  }
  return true;
}

template <class Scalar>
Scales natural_scales(const Mechanism<Scalar>& mechanism) {
  Scales scales{0, 0, 1};
  Workspace<Scalar> workspace(mechanism.tree);
  const State<Scalar> drawn = neutral_state(mechanism.tree);
  update_poses<Scalar>(mechanism.tree, workspace, drawn.q);
  std::vector<Vector3<double>> points;
  for (int i = 0; i < mechanism.tree.body_count(); ++i) {
    const SymmetricMatrix3<double> I = plain(mechanism.tree.body(i).inertia.inertia);
    const double mass = plain(mechanism.tree.body(i).inertia.mass);
    scales.mass = std::max(scales.mass, mass);
    points.push_back(plain(workspace.motion[static_cast<std::size_t>(i + 1)].p));
    if (mass > 0) {
      points.push_back(plain(body_mass_center(mechanism.tree, workspace, i)));
      scales.length = std::max(scales.length, std::sqrt((I.xx + I.yy + I.zz) / (2 * mass)));
    }
  }
  const auto add_place = [&](const Place<Scalar>& place) {
    points.push_back(plain(point_position(mechanism.tree, workspace, place.body, place.point)));
  };
  for (const Component<Scalar>& component : mechanism.components) {
    add_place(component.at);
    if (component.toward) add_place(*component.toward);
  }
  // A center that pulls is a place of the mechanism for what may go round it. What turns on joints near the origin is
  // as large as itself, however far the center: beside that distance its moments of inertia would be rounding.
  const bool goes_far = std::ranges::any_of(mechanism.tree.bodies(), [](const Body<Scalar>& body) {
    return body.joint == JointType::free || body.joint == JointType::prismatic;
  });
  for_each_law(mechanism, [&](const auto& law) {
    if constexpr (std::is_same_v<std::decay_t<decltype(law)>, AttractionLaw<Scalar>>)
      if (!goes_far) return;
    if constexpr (requires { add_place(law.toward); }) {
      add_place(law.at);
      add_place(law.toward);
    }
  });
  for (const Vector3<double>& a : points) scales.length = std::max(scales.length, norm(a - points.front()));
  scales.has_length = scales.length > 0;
  if (!scales.has_length) scales.length = 1;
  if (!(scales.mass > 0)) scales.mass = 1;
  return scales;
}

template <class Scalar>
LinearSystemOf<Scalar> velocity_equations(const MechanismStateOf<Scalar>& state, const Scales& scales,
                                          const std::vector<ConditionOf<Scalar>>& conditions) {
  const Mechanism<Scalar>& mechanism = state.mechanism();
  LinearSystemOf<Scalar> system;
  for (int k = 0; k < mechanism.tree.velocity_size(); ++k)
    system.add_unknown(mechanism.coordinate_names[static_cast<std::size_t>(k)],
                       coordinate_turns(mechanism.tree, k) ? 1 : scales.length);
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
    const VelocityConstraint<Scalar>& constraint = mechanism.constraints[i];
    add_constraint(system, mechanism, i,
                   without_rounding(constraint_row(state, constraint).coefficients, constraint, mechanism.tree, scales),
                   scales);
  }
  add_conditions(system, conditions);
  return system;
}

template <class Scalar>
ForceUnknowns force_unknowns(const Mechanism<Scalar>& mechanism) {
  ForceUnknowns unknowns;
  unknowns.accelerations = static_cast<std::size_t>(mechanism.tree.velocity_size());
  unknowns.components = mechanism.components.size();
  for (std::size_t i = 0; i < mechanism.drives.size(); ++i)
    if (mechanism.drives[i].held) unknowns.drive_of_effort.push_back(i);
  unknowns.efforts = unknowns.drive_of_effort.size();
  return unknowns;
}

template <class Scalar>
LinearSystemOf<Scalar> motion_equations(const MechanismStateOf<Scalar>& state, const Scales& scales,
                                        const std::vector<ConditionOf<Scalar>>& conditions) {
  // With all accelerations at zero, what is left of the rates of momenta depends on the velocities alone and goes to
  // the right side.
  if (std::any_of(state.accelerations().begin(), state.accelerations().end(),
                  [](const Scalar& a) { return !vanishes(a); })) {
    MechanismStateOf<Scalar> unaccelerated = state;
    unaccelerated.set_accelerations(std::vector<Scalar>(state.accelerations().size(), Scalar(0)));
    return motion_equations(unaccelerated, scales, conditions);
  }
  using Vector = Vector3<Scalar>;
  using Wrench = SpatialForce<Scalar>;
  const Mechanism<Scalar>& mechanism = state.mechanism();
  const Model<Scalar>& tree = mechanism.tree;
  const double force_scale = scales.mass * scales.length / (scales.time * scales.time);
  const ForceWords words{
      "force", "couple", "drive", "forces on ", "moments on ", force_scale, force_scale * scales.length};
  LinearSystemOf<Scalar> system;
  for (int k = 0; k < tree.velocity_size(); ++k)
    add_acceleration(system, mechanism.coordinate_names[static_cast<std::size_t>(k)],
                     coordinate_turns(tree, k) ? 1 : scales.length);
  const ForceUnknowns unknowns = force_unknowns(mechanism);
  add_force_unknowns(system, mechanism, unknowns.drive_of_effort, words);

  // Newton and Euler for each body that takes part: forces, then moments about its origin. About that point, and not
  // about the mass center, the equations are linear in the body's mass, first moments and inertia.
  std::vector<std::size_t> first_row(static_cast<std::size_t>(tree.body_count()), 0);
  for (int i = 0; i < tree.body_count(); ++i) {
    if (!mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    const SpatialInertia<Scalar>& I = tree.body(i).inertia;
    const BodyMotion<Scalar>& motion = state.workspace().motion[static_cast<std::size_t>(i + 1)];
    const Vector& O = motion.p;
    const std::size_t row = add_balance(system, tree, i, words);
    first_row[static_cast<std::size_t>(i)] = row;
    if (!(plain(I.mass) > 0)) continue;
    const Matrix3<Scalar>& R = motion.R;
    const Vector first_moment = R * I.first_moment;  // m c, from the origin, on ground axes
    const Vector weight_moment = cross(first_moment, tree.gravity());
    const Momentum<Scalar> known = body_momentum_rate(tree, state.workspace(), i, O);
    const double spread = plain(I.inertia.xx + I.inertia.yy + I.inertia.zz);
    const double gyroscopic = spread * norm_squared(plain(motion.w));
    for (std::size_t k = 0; k < 3; ++k) {
      system.add_right_side(row + k, I.mass * tree.gravity()[k] - known.linear[k]);
      system.add_right_side(row + 3 + k, weight_moment[k] - known.angular[k], gyroscopic);
    }
    // m a_G and I_O alpha + m c x a_O per unit acceleration of each coordinate.
    const double mass = plain(I.mass), arm = norm(plain(first_moment)) / mass, distance = norm(plain(O));
    for_each_coordinate_motion(tree, state.workspace(), i, O, [&](int coordinate, const SpatialMotion<Scalar>& S) {
      const Vector m_a = I.mass * S.linear + cross(S.angular, first_moment);
      const Vector H_rate = R * (I.inertia * transpose_times(R, S.angular)) + cross(first_moment, S.linear);
      const double turning = norm(plain(S.angular)), reach = norm(plain(S.linear)) + turning * (distance + arm);
      for (std::size_t k = 0; k < 3; ++k) {
        system.add(row + k, static_cast<std::size_t>(coordinate), m_a[k], rounding * mass * reach);
        system.add(row + 3 + k, static_cast<std::size_t>(coordinate), H_rate[k],
                   rounding * (spread * turning + mass * arm * reach));
      }
    });
  }
  const auto about_ground = [](const Wrench& wrench) {
    return PlacedForce<Scalar>{Vector::zero(), wrench.force, wrench.moment};
  };
  // Every force acts on one body and, reversed, on another. Bodies that take no part have no equations. at: where it
  // acts, whose distance the rounding of its moment goes with, also where that vanishes: the pull of a cord between two
  // particles, one of which lies at the origin.
  const auto on_both = [&](const Action& action, const PlacedForce<Scalar>& placed, const Vector& at, auto&& add) {
    for (const auto& [body, sign] : {std::pair{action.on, Scalar(1)}, std::pair{action.from, Scalar(-1)}}) {
      if (body == ground || !mechanism.takes_part[static_cast<std::size_t>(body)]) continue;
      const std::size_t row = first_row[static_cast<std::size_t>(body)];
      const Vector& O = state.workspace().motion[static_cast<std::size_t>(body + 1)].p;
      const Vector about_origin = placed.couple + cross(Vector(placed.point - O), placed.force);
      const double force = norm(plain(placed.force));
      const double couple = norm(plain(placed.couple)) + (norm(plain(O)) + norm(plain(at))) * force;
      for (std::size_t k = 0; k < 3; ++k) {
        add(row + k, sign * placed.force[k], rounding * force);
        add(row + 3 + k, sign * about_origin[k], rounding * couple);
      }
    }
  };
  const auto action_of = [&](const auto& item) -> const Action& {
    return mechanism.actions[static_cast<std::size_t>(item.action)];
  };
  std::size_t column = unknowns.accelerations;
  for (const Component<Scalar>& component : mechanism.components) {
    on_both(action_of(component), about_ground(state.component_wrench(component)), state.position(component.at),
            [&](std::size_t row, const Scalar& value, double error) { system.add(row, column, -value, error); });
    ++column;
  }
  add_followed_components(system, mechanism, unknowns.accelerations, words.force_scale);
  for (std::size_t drive : unknowns.drive_of_effort) {
    on_both(action_of(mechanism.drives[drive]), about_ground(state.drive_wrench(mechanism.drives[drive])),
            Vector::zero(),
            [&](std::size_t row, const Scalar& value, double error) { system.add(row, column, -value, error); });
    ++column;
  }
  for (const auto& [action, force] : state.known_forces())
    on_both(mechanism.actions[static_cast<std::size_t>(action)], force, Vector::zero(),
            [&](std::size_t row, const Scalar& value, double) { system.add_right_side(row, value); });

  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i) {
    const VelocityConstraint<Scalar>& constraint = mechanism.constraints[i];
    const ConstraintRow<Scalar> r = constraint_row(state, constraint);
    const std::size_t row =
        add_constraint(system, mechanism, i, without_rounding(r.coefficients, constraint, tree, scales), scales);
    system.add_right_side(row, -r.bias);
  }
  add_conditions(system, conditions);
  return system;
}

template <class Scalar>
SpatialForce<Scalar> action_wrench(const MechanismStateOf<Scalar>& state, const std::vector<Scalar>& unknowns,
                                   std::size_t action, const Vector3<Scalar>& about) {
  const ForceUnknowns order = force_unknowns(state.mechanism());
  const int index = static_cast<int>(action);
  const SpatialForce<Scalar> open = unknown_wrench(state, unknowns, order.accelerations, order.drive_of_effort, index);
  return SpatialForce<Scalar>{open.moment - cross(about, open.force), open.force} + state.known_wrench(index, about);
}

template bool coordinate_turns(const Model<double>&, int);
template Scales natural_scales(const Mechanism<double>&);
template LinearSystemOf<double> velocity_equations(const MechanismStateOf<double>&, const Scales&,
                                                   const std::vector<ConditionOf<double>>&);
template ForceUnknowns force_unknowns(const Mechanism<double>&);
template LinearSystemOf<double> motion_equations(const MechanismStateOf<double>&, const Scales&,
                                                 const std::vector<ConditionOf<double>>&);
template SpatialForce<double> action_wrench(const MechanismStateOf<double>&, const std::vector<double>&, std::size_t,
                                            const Vector3<double>&);
template bool coordinate_turns(const Model<Dual<1>>&, int);
template Scales natural_scales(const Mechanism<Dual<1>>&);
template LinearSystemOf<Dual<1>> velocity_equations(const MechanismStateOf<Dual<1>>&, const Scales&,
                                                    const std::vector<ConditionOf<Dual<1>>>&);
template ForceUnknowns force_unknowns(const Mechanism<Dual<1>>&);
template LinearSystemOf<Dual<1>> motion_equations(const MechanismStateOf<Dual<1>>&, const Scales&,
                                                  const std::vector<ConditionOf<Dual<1>>>&);
template SpatialForce<Dual<1>> action_wrench(const MechanismStateOf<Dual<1>>&, const std::vector<Dual<1>>&, std::size_t,
                                             const Vector3<Dual<1>>&);
template bool coordinate_turns(const Model<Formula>&, int);
template Scales natural_scales(const Mechanism<Formula>&);
template LinearSystemOf<Formula> velocity_equations(const MechanismStateOf<Formula>&, const Scales&,
                                                    const std::vector<ConditionOf<Formula>>&);
template ForceUnknowns force_unknowns(const Mechanism<Formula>&);
template LinearSystemOf<Formula> motion_equations(const MechanismStateOf<Formula>&, const Scales&,
                                                  const std::vector<ConditionOf<Formula>>&);
template SpatialForce<Formula> action_wrench(const MechanismStateOf<Formula>&, const std::vector<Formula>&, std::size_t,
                                             const Vector3<Formula>&);

}  // namespace poinsot::solve
