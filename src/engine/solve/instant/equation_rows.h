// Rows that several systems of equations have in common.
#pragma once

#include <string_view>
#include <vector>

#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {

inline constexpr const char* axis_names[] = {"x", "y", "z"};

// Adds the equation sum_k coefficients[k] x_k = 0; the caller sets the right side. Coefficients that are zero for
// every value of the letters or of the dual part are left out.
template <class Scalar>
std::size_t add_row(LinearSystemOf<Scalar>& system, std::string_view words, double scale, EquationSource source,
                    const std::vector<Scalar>& coefficients) {
  const std::size_t row = system.add_equation(words, scale, source);
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    if (!vanishes(coefficients[k])) system.add(row, k, coefficients[k]);
  return row;
}

// index: the place of the constraint in its mechanism.
template <class Scalar>
std::size_t add_constraint(LinearSystemOf<Scalar>& system, const Mechanism<Scalar>& mechanism, std::size_t index,
                           const std::vector<Scalar>& coefficients, const Scales& scales) {
  const VelocityConstraint<Scalar>& constraint = mechanism.constraints[index];
  const bool angular = constraint.kind == VelocityConstraintKind::angular;
  return add_row(system, constraint.words, angular ? 1 : scales.length, {EquationKind::constraint, index},
                 coefficients);
}

template <class Scalar>
void add_conditions(LinearSystemOf<Scalar>& system, const std::vector<ConditionOf<Scalar>>& conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const ConditionOf<Scalar>& condition = conditions[i];
    const std::size_t row =
        add_row(system, condition.words, condition.scale, {EquationKind::condition, i}, condition.coefficients);
    system.add_right_side(row, condition.value);
  }
}

// What forces and their moments are called in a system of equations, and their scales: forces at an instant, impulses
// in a blow.
struct ForceWords {
  std::string_view force, couple, drive;  // of an action
  std::string_view forces_on_body, moments_on_body;
  double force_scale, couple_scale;
};

// Adds the unknowns of the components of all actions, then of the drives whose effort is open.
template <class Scalar>
void add_force_unknowns(LinearSystemOf<Scalar>& system, const Mechanism<Scalar>& mechanism,
                        const std::vector<std::size_t>& open_drives, const ForceWords& words) {
  for (const Component<Scalar>& component : mechanism.components) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    system.add_unknown({component.couple ? words.couple : words.force, "(", action.name, ")",
                        component.axis.empty() ? "" : " along ", component.axis},
                       component.couple ? words.couple_scale : words.force_scale);
  }
  for (const std::size_t index : open_drives) {
    const Drive<Scalar>& drive = mechanism.drives[index];
    system.add_unknown({words.drive, "(", mechanism.actions[static_cast<std::size_t>(drive.action)].joint, ")"},
                       drive.turning ? words.couple_scale : words.force_scale);
  }
}

// Adds that components which follow others are parts of these, with their offsets unless they are impulses. column: of
// the first component.
template <class Scalar>
void add_followed_components(LinearSystemOf<Scalar>& system, const Mechanism<Scalar>& mechanism, std::size_t column,
                             double scale, bool impulses = false) {
  for (std::size_t k = 0; k < mechanism.components.size(); ++k) {
    const Component<Scalar>& component = mechanism.components[k];
    if (component.follows < 0 || (component.parts_wheels && component.flank == 0)) continue;
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    const std::size_t row =
        system.add_equation({component.parts_wheels ? "what leaning teeth exert beside '" : "what '", action.name,
                             component.parts_wheels ? "'" : "' exerts on its other side"},
                            scale);
    system.add(row, column + k, Scalar(1));
    system.add(row, column + static_cast<std::size_t>(component.follows), -component.followed_part());
    if (!impulses && !vanishes(component.offset)) system.add_right_side(row, component.offset);
  }
}

// What an action exerts by these unknowns. column: of the first of them.
template <class Scalar>
SpatialForce<Scalar> unknown_wrench(const MechanismStateOf<Scalar>& state, const std::vector<Scalar>& unknowns,
                                    std::size_t column, const std::vector<std::size_t>& open_drives, int action) {
  const Mechanism<Scalar>& mechanism = state.mechanism();
  SpatialForce<Scalar> total = SpatialForce<Scalar>::zero();
  for (const Component<Scalar>& component : mechanism.components) {
    if (component.action == action) total += unknowns[column] * state.component_wrench(component);
    ++column;
  }
  for (const std::size_t drive : open_drives) {
    if (mechanism.drives[drive].action == action)
      total += unknowns[column] * state.drive_wrench(mechanism.drives[drive]);
    ++column;
  }
  return total;
}

// Adds the equations of the forces on a body along the axes, then of their moments, and returns the first.
template <class Scalar>
std::size_t add_balance(LinearSystemOf<Scalar>& system, const Model<Scalar>& tree, int body, const ForceWords& words) {
  const EquationSource source{EquationKind::balance, static_cast<std::size_t>(body)};
  const std::size_t first = system.equations();
  for (const char* axis : axis_names)
    system.add_equation({words.forces_on_body, tree.name(body), " along ", axis}, words.force_scale, source);
  for (const char* axis : axis_names)
    system.add_equation({words.moments_on_body, tree.name(body), " about ", axis}, words.couple_scale, source);
  return first;
}

}  // namespace poinsot::solve
