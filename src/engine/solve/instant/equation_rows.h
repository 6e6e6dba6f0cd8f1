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
std::size_t add_row(LinearSystemOf<Scalar>& system, std::string_view words, double scale,
                    const std::vector<Scalar>& coefficients) {
  const std::size_t row = system.add_equation(words, scale);
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    if (!vanishes(coefficients[k])) system.add(row, k, coefficients[k]);
  return row;
}

template <class Scalar>
std::size_t add_constraint(LinearSystemOf<Scalar>& system, const VelocityConstraint<Scalar>& constraint,
                           const std::vector<Scalar>& coefficients, const Scales& scales) {
  const bool angular = constraint.kind == VelocityConstraintKind::angular;
  return add_row(system, constraint.words, angular ? 1 : scales.length, coefficients);
}

template <class Scalar>
void add_condition(LinearSystemOf<Scalar>& system, const ConditionOf<Scalar>& condition) {
  system.add_right_side(add_row(system, condition.words, condition.scale, condition.coefficients), condition.value);
}

}  // namespace poinsot::solve
