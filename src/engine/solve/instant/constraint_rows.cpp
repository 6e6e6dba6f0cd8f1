// The constraints of a mechanism as equations for its velocities and accelerations.
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::solve {
template <class Scalar>
ConstraintRow<Scalar> constraint_row(const MechanismStateOf<Scalar>& state, const VelocityConstraint<Scalar>& c) {
  const Model<Scalar>& tree = state.mechanism().tree;
  const Workspace<Scalar>& w = state.workspace();
  const ConstraintLine<Scalar> line = constraint_line(tree, w, c, state.position(c.at));
  ConstraintRow<Scalar> row;
  row.coefficients.assign(static_cast<std::size_t>(tree.velocity_size()), Scalar(0));
  row.bias = line.bias;
  // The two bodies meet at one point. A cord pulls each of them along one line, and of the arms of a long one rounding
  // would be left if they were taken to its other end.
  const auto add = [&](int body, const Vector3<Scalar>& p, double sign, const PlacedForce<Scalar>& unit) {
    for_each_coordinate_motion(tree, w, body, p, [&](int k, const SpatialMotion<Scalar>& S) {
      row.coefficients[static_cast<std::size_t>(k)] +=
          Scalar(sign) * (dot(unit.force, S.linear) + dot(unit.couple, S.angular));
    });
  };
  for_each_unit_force(tree, w, c, line.unit, [&](int on, int from, const PlacedForce<Scalar>& unit) {
    add(on, unit.point, 1, unit);
    add(from, c.kind == VelocityConstraintKind::cord_length ? state.position(c.toward) : unit.point, -1, unit);
  });
  return row;
}

template <class Scalar>
std::vector<Scalar> constraint_coefficients(const MechanismStateOf<Scalar>& state,
                                            const VelocityConstraint<Scalar>& constraint) {
  return constraint_row(state, constraint).coefficients;
}

template ConstraintRow<double> constraint_row(const MechanismStateOf<double>&, const VelocityConstraint<double>&);
template ConstraintRow<Dual<1>> constraint_row(const MechanismStateOf<Dual<1>>&, const VelocityConstraint<Dual<1>>&);
template std::vector<double> constraint_coefficients(const MechanismStateOf<double>&,
                                                     const VelocityConstraint<double>&);
template std::vector<Dual<1>> constraint_coefficients(const MechanismStateOf<Dual<1>>&,
                                                      const VelocityConstraint<Dual<1>>&);
template ConstraintRow<Formula> constraint_row(const MechanismStateOf<Formula>&, const VelocityConstraint<Formula>&);
template std::vector<Formula> constraint_coefficients(const MechanismStateOf<Formula>&,
                                                      const VelocityConstraint<Formula>&);

}  // namespace poinsot::solve
