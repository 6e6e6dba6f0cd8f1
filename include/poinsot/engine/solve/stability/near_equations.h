// The equations of motion near a motion, over any scalar: numbers with a bound on their rounding, or formulas.
//
// Of the accelerations a of the coordinates and the sizes y of the components that supports, contacts and cords exert,
// the equations of motion (dynamics/equations_of_motion.h) leave
//
//   r(q, v; a, y) = (M a + h - Q - C y,  J a + b),
//
// with a column of C for each component. It is zero along the motion, so that deviations dq and dv, both measured like
// velocities, change a and y by
//
//   M da - C dy = -(the first part of r_q dq + r_v dv),      J da = -(the second part of it).
//
// The slopes r_q and r_v come from dual numbers: exact but for the scalar's rounding.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/convert_mechanism.h"
#include "poinsot/engine/dynamics/equations_of_motion.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/work/budget.h"

namespace poinsot::solve {

template <class Scalar>
using Rows = std::vector<std::vector<Scalar>>;
template <class Scalar>
Rows<Scalar> zero_rows(std::size_t rows, std::size_t columns) {
  return Rows<Scalar>(rows, std::vector<Scalar>(columns, Scalar(0)));
}

// A component of size one where it acts now: that of a contact whose point moves over a body of revolution, at the
// point that touches. After update_poses.
template <class Scalar>
PlacedForce<Scalar> touching_force(const Mechanism<Scalar>& mechanism, const Workspace<Scalar>& workspace,
                                   const Component<Scalar>& component) {
  PlacedForce<Scalar> force = component_force(mechanism.tree, workspace, component);
  for (const VelocityConstraint<Scalar>& c : mechanism.constraints)
    if (moves_over_surfaces(c) && c.action == component.action) {
      follow_contact(mechanism.tree, workspace, c, force);
      break;
    }
  return force;
}

// What the equations leave at a state with accelerations.
template <class Scalar>
struct Remainder {
  std::vector<Scalar> forces;   // M a + h - Q - C y, of every velocity coordinate
  std::vector<Scalar> changes;  // J a + b, of every constraint
  std::vector<Scalar> rates;    // J v
};

// y: a number for each component, or none at all if no component does work.
template <class Scalar>
Remainder<Scalar> remainder_of(const Mechanism<Scalar>& mechanism, const State<Scalar>& state,
                               const std::vector<Scalar>& a, const std::vector<Scalar>& y) {
  const Model<Scalar>& tree = mechanism.tree;
  Remainder<Scalar> left{needed_generalised_forces(mechanism, state, a), {}, {}};
  if (mechanism.constraints.empty() && y.empty()) return left;
  Workspace<Scalar> workspace(tree);
  update_accelerations<Scalar>(tree, workspace, state, a);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Component<Scalar>& component = mechanism.components[i];
    const Scalar size =
        component.follows < 0
            ? y[i]
            : component.followed_part() * y[static_cast<std::size_t>(component.follows)] + component.offset;
    if (vanishes(size)) continue;
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    PlacedForce<Scalar> force = touching_force(mechanism, workspace, component);
    force.force = -size * force.force;
    force.couple = -size * force.couple;
    add_generalised_force(tree, workspace, action.on, action.from, force, left.forces);
  }
  // With the accelerations in the workspace the biases are J a + b.
  EquationsOfMotion<Scalar> constraints;
  add_constraint_rows(mechanism, workspace, constraints);
  left.changes = std::move(constraints.bias);
  for (const std::vector<Scalar>& row : constraints.jacobian) {
    Scalar rate(0);
    for (std::size_t k = 0; k < row.size(); ++k) rate += row[k] * state.v[k];
    left.rates.push_back(rate);
  }
  return left;
}

// M at a pose.
template <class Scalar>
Rows<Scalar> mass_rows(const Model<Scalar>& tree, const std::vector<Scalar>& q) {
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  Workspace<Scalar> workspace(tree);
  std::vector<Scalar> mass(n * n, Scalar(0));
  mass_matrix<Scalar>(tree, workspace, q, mass);
  mirror_lower_triangle<Scalar>(mass, static_cast<int>(n));
  Rows<Scalar> M;
  for (std::size_t i = 0; i < n; ++i)
    M.emplace_back(mass.begin() + static_cast<std::ptrdiff_t>(i * n),
                   mass.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
  return M;
}

// The matrices by which accelerations and components enter the equations, at a pose.
template <class Scalar>
struct EquationMatrices {
  Rows<Scalar> M, C, J;  // a row of C for each coordinate, one of J for each constraint
};
template <class Scalar>
EquationMatrices<Scalar> equation_matrices(const Mechanism<Scalar>& mechanism, const std::vector<Scalar>& q) {
  const Model<Scalar>& tree = mechanism.tree;
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  EquationMatrices<Scalar> matrices{mass_rows(tree, q), zero_rows<Scalar>(n, mechanism.components.size()), {}};
  Workspace<Scalar> workspace(tree);
  const std::vector<Scalar> rest(n, Scalar(0));
  update_accelerations<Scalar>(tree, workspace, State<Scalar>{q, rest}, rest);
  for (std::size_t j = 0; j < mechanism.components.size(); ++j) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(mechanism.components[j].action)];
    std::vector<Scalar> column(n, Scalar(0));
    add_generalised_force(tree, workspace, action.on, action.from,
                          touching_force(mechanism, workspace, mechanism.components[j]), column);
    // What follows another component has no size of its own.
    const int follows = mechanism.components[j].follows;
    const std::size_t own = follows < 0 ? j : static_cast<std::size_t>(follows);
    for (std::size_t k = 0; k < n; ++k)
      matrices.C[k][own] += follows < 0 ? column[k] : mechanism.components[j].followed_part() * column[k];
  }
  EquationsOfMotion<Scalar> constraints;
  add_constraint_rows(mechanism, workspace, constraints);
  matrices.J = std::move(constraints.jacobian);
  return matrices;
}

// How the remainder varies with each coordinate and with its velocity, at fixed a and y.
template <class Scalar>
class RemainderSlopes {
 public:
  using Varied = Dual<1, Scalar>;

  RemainderSlopes(const Mechanism<Scalar>& mechanism, State<Scalar> state, const std::vector<Scalar>& a,
                  const std::vector<Scalar>& y)
      : mechanism_(convert_mechanism<Varied>(mechanism, [](const Scalar& x) { return Varied(x); })),
        tree_(mechanism.tree),
        state_(std::move(state)),
        a_(a.begin(), a.end()),
        y_(y.begin(), y.end()) {}

  Remainder<Scalar> by_position(std::size_t coordinate) const {
    std::vector<Scalar> rate(state_.q.size(), Scalar(0));
    position_rate<Scalar>(tree_, state_.q, unit(coordinate), rate);
    return slope(rate, std::vector<Scalar>(state_.v.size(), Scalar(0)));
  }
  Remainder<Scalar> by_velocity(std::size_t coordinate) const {
    return slope(std::vector<Scalar>(state_.q.size(), Scalar(0)), unit(coordinate));
  }

 private:
  std::vector<Scalar> unit(std::size_t coordinate) const {
    std::vector<Scalar> along(state_.v.size(), Scalar(0));
    along[coordinate] = Scalar(1);
    return along;
  }
  Remainder<Scalar> slope(const std::vector<Scalar>& q_change, const std::vector<Scalar>& v_change) const {
    check_budget();
    State<Varied> state;
    for (std::size_t i = 0; i < state_.q.size(); ++i) state.q.push_back({state_.q[i], {q_change[i]}});
    for (std::size_t i = 0; i < state_.v.size(); ++i) state.v.push_back({state_.v[i], {v_change[i]}});
    const Remainder<Varied> near = remainder_of(mechanism_, state, a_, y_);
    const auto partials = [](const std::vector<Varied>& list) {
      std::vector<Scalar> result;
      result.reserve(list.size());
      for (const Varied& x : list) result.push_back(x.partial[0]);
      return result;
    };
    return {partials(near.forces), partials(near.changes), partials(near.rates)};
  }

  Mechanism<Varied> mechanism_;
  const Model<Scalar>& tree_;
  State<Scalar> state_;
  std::vector<Varied> a_, y_;
};

// The adjoint of the twists of some bodies on ball or free joints, on their own axes: d/dt of a deviation's components
// on axes that move with these twists is its product with the deviation.
template <class Scalar>
Rows<Scalar> adjoint_rows(const Model<Scalar>& tree, const std::vector<std::pair<int, SpatialMotion<Scalar>>>& twists) {
  const auto n = static_cast<std::size_t>(tree.velocity_size());
  Rows<Scalar> A = zero_rows<Scalar>(n, n);
  for (const auto& [body, twist] : twists) {
    const auto first = static_cast<std::size_t>(tree.body(body).v);
    const auto put = [&](std::size_t row, std::size_t column, const Vector3<Scalar>& w) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3<Scalar> turned = cross(w, Vector3<Scalar>::unit(k));
        for (std::size_t i = 0; i < 3; ++i) A[first + row + i][first + column + k] = turned[i];
      }
    };
    put(0, 0, twist.angular);
    if (tree.body(body).joint != JointType::free) continue;
    put(3, 0, twist.linear);
    put(3, 3, twist.angular);
  }
  return A;
}

// The twists of all bodies on ball and free joints, which are these joints' velocity coordinates.
template <class Scalar>
std::vector<std::pair<int, SpatialMotion<Scalar>>> own_twists(const Model<Scalar>& tree, const std::vector<Scalar>& v) {
  std::vector<std::pair<int, SpatialMotion<Scalar>>> twists;
  for (int i = 0; i < tree.body_count(); ++i) {
    const Body<Scalar>& body = tree.body(i);
    if (body.joint != JointType::ball && body.joint != JointType::free) continue;
    SpatialMotion<Scalar> twist = SpatialMotion<Scalar>::zero();
    for (std::size_t k = 0; k < 3; ++k) {
      twist.angular[k] = v[static_cast<std::size_t>(body.v) + k];
      if (body.joint == JointType::free) twist.linear[k] = v[static_cast<std::size_t>(body.v) + 3 + k];
    }
    twists.emplace_back(i, twist);
  }
  return twists;
}

}  // namespace poinsot::solve
