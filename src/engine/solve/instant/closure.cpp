#include "poinsot/engine/solve/instant/closure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/solve/instant/singular_pose.h"
#include "poinsot/engine/dynamics/capstan.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"
#include "poinsot/engine/math/algebra/plain.h"
#include "poinsot/engine/math/formula/formula.h"

namespace poinsot::solve {
namespace {

// The distance (m) or angle (rad) by which a constraint is open in this pose.
template <class Scalar>
Scalar gap_of(const MechanismStateOf<Scalar>& state, std::size_t constraint) {
  const Mechanism<Scalar>& mechanism = state.mechanism();
  return constraint_gap(mechanism.tree, state.workspace(), mechanism.constraints[constraint],
                        axis_left_free(mechanism.constraints, constraint));
}

template <class Scalar>
std::vector<std::size_t> constraints_on_positions(const Mechanism<Scalar>& mechanism) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i)
    if (binds_positions(mechanism.constraints[i])) found.push_back(i);
  return found;
}

// Marks the velocity coordinates that the closing may move: those of joints whose positions are not given.
template <class Scalar>
std::vector<bool> movable_coordinates(const Model<Scalar>& tree, const std::vector<bool>& given) {
  std::vector<bool> movable(static_cast<std::size_t>(tree.velocity_size()), true);
  for (const Body<Scalar>& body : tree.bodies())
    for (int k = 0; k < velocity_size(body.joint); ++k)
      if (position_size(body.joint) == 1 && given[static_cast<std::size_t>(body.q)])
        movable[static_cast<std::size_t>(body.v + k)] = false;
  return movable;
}

// One step of Newton's method: the displacements of the movable coordinates that close the linearised gaps.
class ClosingStep {
 public:
  // The vector `movable` must outlive the step.
  template <class Scalar>
  ClosingStep(const Model<Scalar>& tree, double length, const std::vector<bool>& movable)
      : length_(length), movable_(movable) {
    for (int k = 0; k < tree.velocity_size(); ++k) system_.add_unknown("", coordinate_turns(tree, k) ? 1 : length);
  }
  double unit(VelocityConstraintKind kind) const { return kind == VelocityConstraintKind::angular ? 1 : length_; }
  void add(VelocityConstraintKind kind, const std::vector<double>& coefficients, double gap) {
    const std::size_t row = system_.add_equation("", unit(kind));
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      if (movable_[k] && coefficients[k] != 0) system_.add(row, k, coefficients[k]);
    system_.add_right_side(row, -gap);
  }
  std::vector<double> displacements() const { return system_.solve().value; }

 private:
  LinearSystem system_;
  double length_;
  const std::vector<bool>& movable_;
};

}  // namespace

Closure close_pose(const Mechanism<double>& mechanism, const std::vector<double>& target,
                   const std::vector<bool>& given) {
  const Model<double>& tree = mechanism.tree;
  Closure result;
  result.q = neutral_state(tree).q;
  const std::vector<std::size_t> rows = constraints_on_positions(mechanism);
  bool moved = false;
  for (std::size_t k = 0; k < target.size(); ++k) moved = moved || (given[k] && target[k] != result.q[k]);
  if (rows.empty() || !moved) {
    result.q = target;
    return result;
  }
  const std::vector<bool> movable = movable_coordinates(tree, given);
  const double length = natural_scales(mechanism).length;
  MechanismState state(mechanism);
  // The pose is reached in steps of this many radians, or lengths of the machine: in a step twice as long a loop near a
  // pose in which it could part may come to close in another way.
  constexpr double step_size = 0.05;
  double largest = 0;
  for (const Body<double>& body : tree.bodies())
    for (int k = 0; k < position_size(body.joint); ++k) {
      const bool shift = body.joint == JointType::prismatic || (body.joint == JointType::free && k >= 4);
      const auto place = static_cast<std::size_t>(body.q + k);
      if (given[place]) largest = std::max(largest, std::abs(target[place]) / (shift ? length : 1));
    }
  // At least four, so that a small change too starts with a straight line that is none of the drawn pose; at most what
  // twenty radians take, since whoever states more turns means an angle that has gone round, and its loop has closed.
  const int steps = static_cast<int>(std::clamp(std::ceil(largest / step_size), 4.0, 400.0));
  std::vector<double> before = result.q;
  for (int step = 1; step <= steps; ++step) {
    // The start of each step continues the last one in a straight line: this leads through poses in which the loop
    // could part, and lies close to the next closed pose.
    const std::vector<double> last = result.q;
    for (const Body<double>& body : tree.bodies())
      if (position_size(body.joint) == 1) {
        const auto k = static_cast<std::size_t>(body.q);
        result.q[k] += last[k] - before[k];
      }
    before = last;
    for (std::size_t k = 0; k < target.size(); ++k)
      if (given[k]) result.q[k] = target[k] * step / steps;
    // Newton's method doubles the digits: six rounds are enough on the way. At a pose in which the loop could part each
    // round only halves what is left, and the last digit takes fifty.
    const int most = step == steps ? 60 : 6;
    double previous = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most; ++iteration) {
      state.set_positions(result.q);
      ClosingStep newton(tree, length, movable);
      double worst = 0;
      for (std::size_t i : rows) {
        const VelocityConstraint<double>& c = mechanism.constraints[i];
        const double gap = gap_of(state, i);
        if (std::abs(gap) / newton.unit(c.kind) >= worst) {
          worst = std::abs(gap) / newton.unit(c.kind);
          result.gap = std::abs(gap);
          result.relative = worst;
          result.constraint = i;
        }
        newton.add(c.kind, constraint_coefficients(state, c), gap);
      }
      // Near a pose in which the loop could part a gap is the square of the distance from that pose, so that it
      // becomes small long before the pose is reached. The last part goes on as long as its steps still help.
      const bool closed = worst < 1e-14 && (step < steps || worst > 0.25 * previous);
      if (closed || worst < 4 * std::numeric_limits<double>::epsilon()) break;
      previous = worst;
      integrate_position<double>(tree, result.q, newton.displacements(), 1.0);
    }
  }
  settle_on_singular_pose(mechanism, rows, movable, length, result.q);
  return result;
}

std::vector<Dual<1>> varied_pose(const Mechanism<Dual<1>>& mechanism, const std::vector<double>& closed,
                                 const std::vector<Dual<1>>& target, const std::vector<bool>& given) {
  const Model<Dual<1>>& tree = mechanism.tree;
  const std::vector<std::size_t> rows = constraints_on_positions(mechanism);
  if (rows.empty()) return target;
  std::vector<Dual<1>> q(closed.begin(), closed.end());
  for (std::size_t k = 0; k < q.size(); ++k)
    if (given[k]) q[k].partial = target[k].partial;
  // The dual parts of the given coordinates open the gaps at first order. One Newton step of the movable coordinates
  // closes them again and so gives their derivatives.
  const std::vector<bool> movable = movable_coordinates(tree, given);
  MechanismStateOf<Dual<1>> state(mechanism);
  state.set_positions(q);
  ClosingStep newton(tree, natural_scales(mechanism).length, movable);
  for (std::size_t i : rows) {
    const VelocityConstraint<Dual<1>>& c = mechanism.constraints[i];
    newton.add(c.kind, plain(constraint_coefficients(state, c)), gap_of(state, i).partial[0]);
  }
  std::vector<Dual<1>> step;
  for (double displacement : newton.displacements()) step.push_back({0.0, {displacement}});
  integrate_position<Dual<1>>(tree, q, step, Dual<1>(1));
  return q;
}

namespace {

// The change from one vector to another. Where it is nothing but rounding, it must not move what it is added to, but
// its derivatives count. size: of what rounding is measured by.
template <class Scalar>
Vector3<Scalar> change_beyond_rounding(const Vector3<Scalar>& from, const Vector3<Scalar>& to, double size) {
  constexpr double rounding = 1e-12;  // of the radius, beside which a contact may be carried far
  Vector3<Scalar> change = to - from;
  // Formulas hold no rounding.
  if constexpr (std::is_same_v<Scalar, Formula>) return change;
  return norm(plain(change)) < rounding * size ? change - lifted<Scalar>(plain(change)) : change;
}

// Moves the place and the directions of a contact to where its curved surfaces touch now. The constraints of the
// contact follow one after another, its components with the one along the normal.
template <class Scalar>
void update_touching(Mechanism<Scalar>& mechanism, VelocityConstraint<Scalar>& c,
                     const MechanismStateOf<Scalar>& state) {
  using Vector = Vector3<Scalar>;
  const Model<Scalar>& tree = mechanism.tree;
  const Workspace<Scalar>& w = state.workspace();
  const Touching<Scalar> now = detail::touching_now(tree, w, c);
  const Vector was = point_position(tree, w, c.at.body, c.at.point);
  c.at.point +=
      direction_on_body(tree, w, c.on, change_beyond_rounding(was, now.on, norm(plain(now.on)) + norm(plain(was))));
  const auto turn = [&](Vector& d) {
    const Vector old = direction_on_ground(tree, w, c.from, d);
    const Vector next = detail::with_normal(tree, w, c, now.normal, old);
    d += direction_on_body(tree, w, c.from, change_beyond_rounding(old, next, 1));
  };
  turn(c.along.vector);
  auto turned = std::make_shared<CurvedContact<Scalar>>(*c.surfaces);
  turn(turned->tangent);
  turn(turned->normal);
  if (c.normal)
    for (Component<Scalar>& component : mechanism.components)
      if (component.action == c.action) {
        component.at = c.at;
        turn(component.along.vector);
      }
  c.surfaces = std::move(turned);
}

}  // namespace

template <class Scalar>
void update_contacts(Mechanism<Scalar>& mechanism, const MechanismStateOf<Scalar>& state) {
  using Vector = Vector3<Scalar>;
  const Model<Scalar>& tree = mechanism.tree;
  const Workspace<Scalar>& w = state.workspace();
  // Where a cord touches its wheels now.
  for (Component<Scalar>& component : mechanism.components) {
    if (!component.span) continue;
    const SpanLine<Scalar> line = line_of(tree, w, *component.span);
    const auto place = [&](int body, const Vector& P) {
      return Place<Scalar>{body,
                           direction_on_body<Scalar>(tree, w, body, P - point_position(tree, w, body, Vector::zero()))};
    };
    component.at = place(component.at.body, line.end);
    component.toward = place(component.toward->body, line.start);
  }
  update_capstans(mechanism, w);
  for (VelocityConstraint<Scalar>& c : mechanism.constraints) {
    if (c.kind == VelocityConstraintKind::touching) update_touching(mechanism, c, state);
    if (c.kind != VelocityConstraintKind::rolling) continue;
    const std::optional<Vector> r = detail::reach_of_rolling(tree, w, c);
    if (!r) continue;
    const Vector was = state.position(c.at) - point_position(tree, w, c.on, c.center);
    const Vector change = change_beyond_rounding(was, *r, plain(c.radius));
    if (vanishes(change.x) && vanishes(change.y) && vanishes(change.z)) continue;
    c.at.point += direction_on_body(tree, w, c.on, change);
    for (Component<Scalar>& component : mechanism.components)
      if (component.action == c.action) component.at = c.at;
  }
}

template void update_contacts(Mechanism<double>&, const MechanismStateOf<double>&);
template void update_contacts(Mechanism<Dual<1>>&, const MechanismStateOf<Dual<1>>&);
template void update_contacts(Mechanism<Formula>&, const MechanismStateOf<Formula>&);

}  // namespace poinsot::solve
