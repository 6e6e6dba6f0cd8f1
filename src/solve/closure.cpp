#include "poinsot/solve/closure.h"

#include <algorithm>
#include <cmath>

namespace poinsot::solve {
namespace {

using Vector = Vector3<double>;

// The rotation vector of a rotation matrix, for angles below a half turn.
Vector rotation_vector(const Matrix3<double>& R) {
  const Vector twice_sine{R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)};
  const double sine = 0.5 * norm(twice_sine), cosine = 0.5 * (R(0, 0) + R(1, 1) + R(2, 2) - 1);
  if (sine < 1e-12) return 0.5 * twice_sine;
  return (std::atan2(sine, cosine) / (2 * sine)) * twice_sine;
}

// By how much a constraint is open.
double gap_of(const Moment& moment, const VelocityConstraint<double>& c) {
  const Model<double>& tree = moment.mechanism().tree;
  const Workspace<double>& w = moment.workspace();
  switch (c.kind) {
    case VelocityConstraintKind::angular: {
      const Matrix3<double> R_from = body_rotation(tree, w, c.from), R_on = body_rotation(tree, w, c.on);
      return dot(c.along.vector, rotation_vector(transpose(R_from) * R_on));
    }
    case VelocityConstraintKind::point:
      return dot(moment.direction(c.along), moment.position(c.at) - moment.position(c.toward));
    case VelocityConstraintKind::cord_length:
      return norm(moment.position(c.at) - moment.position(c.toward)) - c.length;
    case VelocityConstraintKind::rolling: {
      const Vector n = moment.direction(c.along);
      const Vector center = point_position(tree, w, c.on, c.center);
      double reach = c.radius;
      if (norm_squared(c.axis) > 0) {
        const double along = dot(n, direction_on_ground(tree, w, c.on, c.axis));
        reach *= std::sqrt(std::max(0.0, 1 - along * along));
      }
      const double height = dot(n, center - moment.position(c.toward));
      return height < 0 ? height + reach : height - reach;
    }
  }
  return 0;
}

}  // namespace

bool binds_positions(const VelocityConstraint<double>& c) {
  return c.action < 0 || c.kind == VelocityConstraintKind::cord_length || c.normal;
}

Closure close_pose(const Mechanism<double>& mechanism, const std::vector<double>& target,
                   const std::vector<bool>& given) {
  const Model<double>& tree = mechanism.tree;
  Closure result;
  result.q = neutral_state(tree).q;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < mechanism.constraints.size(); ++i)
    if (binds_positions(mechanism.constraints[i])) rows.push_back(i);
  bool moved = false;
  for (std::size_t k = 0; k < target.size(); ++k) moved = moved || (given[k] && target[k] != result.q[k]);
  if (rows.empty() || !moved) {
    result.q = target;
    return result;
  }
  // Velocity coordinates that may move: those of coordinates without a value.
  std::vector<bool> movable(static_cast<std::size_t>(tree.velocity_size()), true);
  for (const Body<double>& body : tree.bodies())
    for (int k = 0; k < velocity_size(body.joint); ++k)
      if (position_size(body.joint) == 1 && given[static_cast<std::size_t>(body.q)])
        movable[static_cast<std::size_t>(body.v + k)] = false;
  const Scales scales = natural_scales(mechanism);
  Moment moment(mechanism);
  double largest = 0;
  for (std::size_t k = 0; k < target.size(); ++k)
    if (given[k]) largest = std::max(largest, std::abs(target[k]));
  const int steps = std::clamp(static_cast<int>(std::ceil(largest / 0.05)), 4, 400);
  for (int step = 1; step <= steps; ++step) {
    for (std::size_t k = 0; k < target.size(); ++k)
      if (given[k]) result.q[k] = target[k] * step / steps;
    const int most = step == steps ? 60 : 6;
    for (int iteration = 0; iteration < most; ++iteration) {
      moment.set_positions(result.q);
      LinearSystem system;
      for (int k = 0; k < tree.velocity_size(); ++k)
        system.add_unknown("", coordinate_turns(tree, k) ? 1 : scales.length);
      double worst = 0;
      for (std::size_t i : rows) {
        const VelocityConstraint<double>& c = mechanism.constraints[i];
        const double unit = c.kind == VelocityConstraintKind::angular ? 1 : scales.length;
        const double gap = gap_of(moment, c);
        if (std::abs(gap) / unit >= worst) {
          worst = std::abs(gap) / unit;
          result.gap = std::abs(gap);
          result.where = c.words;
        }
        const std::size_t row = system.add_equation("", unit);
        const std::vector<double> coefficients = constraint_coefficients(moment, c);
        for (std::size_t k = 0; k < coefficients.size(); ++k)
          if (movable[k] && coefficients[k] != 0) system.add(row, k, coefficients[k]);
        system.add_right_side(row, -gap);
      }
      if (worst < 1e-14) break;
      const LinearSolution correction = system.solve();
      integrate_position<double>(tree, result.q, correction.value, 1.0);
    }
  }
  return result;
}

void update_contacts(Mechanism<double>& mechanism, const Moment& moment) {
  const Model<double>& tree = mechanism.tree;
  const Workspace<double>& w = moment.workspace();
  for (VelocityConstraint<double>& c : mechanism.constraints) {
    if (c.kind != VelocityConstraintKind::rolling) continue;
    const Vector center = point_position(tree, w, c.on, c.center);
    const Vector b = moment.direction(c.surface_axis);
    const Vector was = moment.position(c.at) - center;
    Vector u = b;
    if (norm_squared(c.axis) > 0) {
      const Vector e = direction_on_ground(tree, w, c.on, c.axis);
      u = b - dot(b, e) * e;
    }
    if (norm(u) < 1e-9) continue;
    // The side of the center that faces the surface.
    const double side = dot(center - moment.position(c.toward), b) > 0 ? -1 : 1;
    const Vector r = (side * c.radius) * normalized(u);
    if (norm(r - was) < 1e-12 * c.radius) continue;
    c.at.point = c.center + direction_on_body(tree, w, c.on, r);
    for (Component<double>& component : mechanism.components)
      if (component.action == c.action) component.at = c.at;
  }
}

}  // namespace poinsot::solve
