#include "poinsot/solve/equations.h"

#include <algorithm>
#include <cmath>

namespace poinsot::solve {
namespace {

using Vector = Vector3<double>;
using Wrench = SpatialForce<double>;

constexpr const char* axis_names[] = {"x", "y", "z"};

// What is left of a vector's vanishing components and of vanishing differences, as part of their sizes.
constexpr double rounding = 4e-15;

SpatialForce<double> force_at(const Vector& position, const Vector& force) { return {cross(position, force), force}; }

// One row of a constraint: coefficients of the velocity coordinates, and the rate that the velocities bring.
struct Row {
  std::vector<double> coefficients;
  double bias = 0;
};

// Velocity of the place where a rolling body of revolution touches.
Vector contact_velocity(const Moment& moment, const VelocityConstraint<double>& c) {
  const Workspace<double>& w = moment.workspace();
  const Model<double>& tree = moment.mechanism().tree;
  const Vector center_velocity = point_velocity(tree, w, c.on, c.center);
  const Vector r = moment.position(c.at) - point_position(tree, w, c.on, c.center);
  const Vector b = moment.direction(c.surface_axis);
  const Vector b_rate = cross(angular_velocity(w, c.surface_axis.body), b);
  if (norm_squared(c.axis) == 0) return center_velocity + (dot(r, b) < 0 ? -1.0 : 1.0) * norm(r) * b_rate;
  // The point of the circle in the plane of its axis e and the surface's axis b: r along u = b - (b . e) e.
  const Vector e = direction_on_ground(tree, w, c.on, c.axis);
  const Vector e_rate = cross(angular_velocity(w, c.on), e);
  const double along = dot(b, e);
  const Vector u = b - along * e;
  const double size = norm(u);
  if (size < 1e-9) return center_velocity;
  const Vector u_rate = b_rate - (dot(b_rate, e) + dot(b, e_rate)) * e - along * e_rate;
  const Vector direction = u / size;
  const Vector direction_rate = (u_rate - dot(u_rate, direction) * direction) / size;
  return center_velocity + dot(r, direction) * direction_rate;
}

Row constraint_row(const Moment& moment, const VelocityConstraint<double>& c) {
  const Model<double>& tree = moment.mechanism().tree;
  const Workspace<double>& w = moment.workspace();
  Row row;
  row.coefficients.assign(static_cast<std::size_t>(tree.velocity_size()), 0.0);
  const auto add = [&](int body, const Vector& p, double sign, const Vector& d, bool angular) {
    for_each_coordinate_motion(tree, w, body, p, [&](int k, const SpatialMotion<double>& S) {
      row.coefficients[static_cast<std::size_t>(k)] += sign * dot(d, angular ? S.angular : S.linear);
    });
  };
  const Vector P = moment.position(c.at);
  const Vector w_from = angular_velocity(w, c.from);
  const auto velocity_at = [&](int body, const Vector& p) {
    return w.motion[static_cast<std::size_t>(body + 1)].v +
           cross(angular_velocity(w, body), p - w.motion[static_cast<std::size_t>(body + 1)].p);
  };
  // Acceleration of the body's point at p without accelerations of the coordinates.
  const auto centripetal_at = [&](int body, const Vector& p) {
    const BodyMotion<double>& motion = w.motion[static_cast<std::size_t>(body + 1)];
    const Vector r = p - motion.p;
    return motion.a + cross(motion.alpha, r) + cross(motion.w, cross(motion.w, r));
  };
  switch (c.kind) {
    case VelocityConstraintKind::angular: {
      const Vector d = moment.direction(c.along);
      add(c.on, P, 1, d, true);
      add(c.from, P, -1, d, true);
      const Vector relative = angular_velocity(w, c.on) - w_from;
      row.bias =
          dot(d, angular_acceleration(w, c.on) - angular_acceleration(w, c.from)) + dot(cross(w_from, d), relative);
      break;
    }
    case VelocityConstraintKind::point:
    case VelocityConstraintKind::rolling: {
      const Vector d = moment.direction(c.along);
      add(c.on, P, 1, d, false);
      add(c.from, P, -1, d, false);
      const Vector v_on = velocity_at(c.on, P), v_from = velocity_at(c.from, P);
      const Vector v_contact = c.kind == VelocityConstraintKind::point ? v_on : contact_velocity(moment, c);
      const Vector relative = centripetal_at(c.on, P) + cross(angular_velocity(w, c.on), v_contact - v_on) -
                              centripetal_at(c.from, P) - cross(w_from, v_contact - v_from);
      row.bias = dot(d, relative) + dot(cross(w_from, d), v_on - v_from);
      break;
    }
    case VelocityConstraintKind::cord_length: {
      const Vector Q = moment.position(c.toward);
      const double length = norm(P - Q);
      const Vector u = (P - Q) / length;
      add(c.on, P, 1, u, false);
      add(c.from, Q, -1, u, false);
      const Vector relative = velocity_at(c.on, P) - velocity_at(c.from, Q);
      const double lengthening = dot(u, relative);
      row.bias = dot(u, centripetal_at(c.on, P) - centripetal_at(c.from, Q)) +
                 (norm_squared(relative) - lengthening * lengthening) / length;
      break;
    }
  }
  return row;
}

bool is_angular(const VelocityConstraint<double>& c) { return c.kind == VelocityConstraintKind::angular; }

// The name of the second derivative from that of the first: "angular velocity of disk" -> "angular acceleration of
// disk".
std::string acceleration_name(std::string name) {
  for (const auto& [rate, acceleration] :
       {std::pair{"the rate of ", "acceleration of "}, std::pair{"angular velocity", "angular acceleration"},
        std::pair{"velocity", "acceleration"}}) {
    const std::size_t found = name.find(rate);
    if (found != std::string::npos) return name.replace(found, std::string_view(rate).size(), acceleration);
  }
  return "acceleration of " + name;
}

void add_condition(LinearSystem& system, const Condition& condition) {
  const std::size_t row = system.add_equation(condition.words, condition.scale);
  for (std::size_t k = 0; k < condition.coefficients.size(); ++k)
    if (condition.coefficients[k] != 0) system.add(row, k, condition.coefficients[k]);
  system.add_right_side(row, condition.value);
}

}  // namespace

bool coordinate_turns(const Model<double>& tree, int coordinate) {
  for (const Body<double>& body : tree.bodies()) {
    const int k = coordinate - body.v;
    if (k < 0 || k >= velocity_size(body.joint)) continue;
    if (body.joint == JointType::prismatic) return false;
    return !(body.joint == JointType::free && k >= 3);
  }
  return true;
}

std::vector<double> constraint_coefficients(const Moment& moment, const VelocityConstraint<double>& constraint) {
  return constraint_row(moment, constraint).coefficients;
}

Scales natural_scales(const Mechanism<double>& mechanism) {
  Scales scales{0, 0, 1};
  Workspace<double> workspace(mechanism.tree);
  const State<double> drawn = neutral_state(mechanism.tree);
  update_poses<double>(mechanism.tree, workspace, drawn.q);
  std::vector<Vector> points;
  for (int i = 0; i < mechanism.tree.body_count(); ++i) {
    const SpatialInertia<double>& I = mechanism.tree.body(i).inertia;
    scales.mass = std::max(scales.mass, I.mass);
    points.push_back(workspace.motion[static_cast<std::size_t>(i + 1)].p);
    if (I.mass > 0) {
      points.push_back(body_mass_center(mechanism.tree, workspace, i));
      scales.length = std::max(scales.length, std::sqrt((I.inertia.xx + I.inertia.yy + I.inertia.zz) / (2 * I.mass)));
    }
  }
  for (const Component<double>& component : mechanism.components)
    points.push_back(point_position(mechanism.tree, workspace, component.at.body, component.at.point));
  for (const Vector& a : points) scales.length = std::max(scales.length, norm(a - points.front()));
  if (!(scales.length > 0)) scales.length = 1;
  if (!(scales.mass > 0)) scales.mass = 1;
  return scales;
}

Moment::Moment(const Mechanism<double>& mechanism)
    : mechanism_(mechanism), workspace_(mechanism.tree), state_(neutral_state(mechanism.tree)) {
  accelerations_.assign(static_cast<std::size_t>(mechanism.tree.velocity_size()), 0.0);
  set_positions(state_.q);
}

void Moment::set_positions(const std::vector<double>& q) {
  state_.q = q;
  std::fill(state_.v.begin(), state_.v.end(), 0.0);
  set_velocities(state_.v);
}

void Moment::set_velocities(const std::vector<double>& v) {
  state_.v = v;
  std::fill(accelerations_.begin(), accelerations_.end(), 0.0);
  set_accelerations(accelerations_);
}

void Moment::set_accelerations(const std::vector<double>& a) {
  accelerations_ = a;
  update_accelerations<double>(mechanism_.tree, workspace_, state_, accelerations_);
}

Vector Moment::position(const Place<double>& place) const {
  return point_position(mechanism_.tree, workspace_, place.body, place.point);
}
Vector Moment::velocity(const Place<double>& place) const {
  return point_velocity(mechanism_.tree, workspace_, place.body, place.point);
}
Vector Moment::direction(const Direction<double>& direction) const {
  return direction_on_ground(mechanism_.tree, workspace_, direction.body, direction.vector);
}
Vector Moment::on_ground_axes(int axes, const Vector& vector) const {
  return direction_on_ground(mechanism_.tree, workspace_, axes, vector);
}

Wrench Moment::component_wrench(const Component<double>& component) const {
  if (component.toward) {
    const Vector P = position(component.at);
    return force_at(P, normalized(position(*component.toward) - P));
  }
  const Vector d = direction(component.along);
  if (component.couple) return {d, Vector::zero()};
  Wrench wrench = force_at(position(component.at), d);
  wrench.moment += component.couple_per_force * d;
  return wrench;
}

// What a motor about one axis passes on through gimbals that turn freely: a couple with moment one about its own axis
// and none about the others.
Wrench Moment::drive_wrench(const Drive<double>& drive) const {
  const Vector d = direction(drive.along);
  if (!drive.turning) return force_at(position(drive.at), d);
  Vector couple = d;
  if (drive.others.size() == 1) {
    const Vector other = direction(drive.others[0]);
    couple = d - dot(d, other) * other;
  } else if (drive.others.size() == 2) {
    couple = cross(direction(drive.others[0]), direction(drive.others[1]));
  }
  // Axes in one plane leave no such couple; then it is that of the axis alone.
  const double about_own = dot(couple, d);
  return {std::abs(about_own) < 1e-9 ? d : couple / about_own, Vector::zero()};
}

Wrench Moment::known_wrench(const KnownForce<double>& force) const {
  const Vector vector = on_ground_axes(force.axes, force.vector);
  return force.couple ? Wrench{vector, Vector::zero()} : force_at(position(force.at), vector);
}

Wrench Moment::spring_wrench(const SpringLaw<double>& spring) const {
  const Vector P = position(spring.at), Q = position(spring.toward);
  const Vector span = Q - P;
  const double length = norm(span);
  const Vector u = span / length;
  const double lengthening = dot(u, velocity(spring.toward) - velocity(spring.at));
  return force_at(P, (spring.stiffness * (length - spring.free_length) + spring.damping * lengthening) * u);
}

double Moment::known_effort(const Drive<double>& drive) const {
  const double position = state_.q[static_cast<std::size_t>(drive.position)];
  const double rate = state_.v[static_cast<std::size_t>(drive.coordinate)];
  return drive.effort - drive.stiffness * (position - drive.free_position) - drive.damping * rate;
}

LinearSolution solve_velocities(const Moment& moment, const Scales& scales, const std::vector<Condition>& conditions,
                                LinearSystem* equations) {
  const Mechanism<double>& mechanism = moment.mechanism();
  LinearSystem system;
  for (int k = 0; k < mechanism.tree.velocity_size(); ++k)
    system.add_unknown(mechanism.coordinate_names[static_cast<std::size_t>(k)],
                       coordinate_turns(mechanism.tree, k) ? 1 : scales.length);
  for (const VelocityConstraint<double>& constraint : mechanism.constraints) {
    const std::size_t row = system.add_equation(constraint.words, is_angular(constraint) ? 1 : scales.length);
    const Row coefficients = constraint_row(moment, constraint);
    for (std::size_t k = 0; k < coefficients.coefficients.size(); ++k)
      if (coefficients.coefficients[k] != 0) system.add(row, k, coefficients.coefficients[k]);
  }
  for (const Condition& condition : conditions) add_condition(system, condition);
  LinearSolution solution = system.solve();
  if (equations) *equations = std::move(system);
  return solution;
}

ForceUnknowns force_unknowns(const Mechanism<double>& mechanism) {
  ForceUnknowns unknowns;
  unknowns.accelerations = static_cast<std::size_t>(mechanism.tree.velocity_size());
  unknowns.components = mechanism.components.size();
  for (std::size_t i = 0; i < mechanism.drives.size(); ++i)
    if (mechanism.drives[i].held) unknowns.drive_of_effort.push_back(i);
  unknowns.efforts = unknowns.drive_of_effort.size();
  return unknowns;
}

LinearSolution solve_motion(const Moment& given, const Scales& scales, const std::vector<Condition>& conditions,
                            LinearSystem* equations) {
  const Mechanism<double>& mechanism = given.mechanism();
  const Model<double>& tree = mechanism.tree;
  const double force_scale = scales.mass * scales.length / (scales.time * scales.time);
  const double couple_scale = force_scale * scales.length;
  // With velocities but without accelerations: what is left of the momentum rates is known.
  Moment moment = given;
  moment.set_accelerations(std::vector<double>(given.accelerations().size(), 0.0));

  LinearSystem system;
  for (int k = 0; k < tree.velocity_size(); ++k)
    system.add_unknown(acceleration_name(mechanism.coordinate_names[static_cast<std::size_t>(k)]),
                       coordinate_turns(tree, k) ? 1 : scales.length);
  for (const Component<double>& component : mechanism.components) {
    const Action& action = mechanism.actions[static_cast<std::size_t>(component.action)];
    system.add_unknown(std::string(component.couple ? "couple" : "force") + "(" + action.name + ")" +
                           (component.axis.empty() ? "" : " along " + component.axis),
                       component.couple ? couple_scale : force_scale);
  }
  const ForceUnknowns unknowns = force_unknowns(mechanism);
  for (std::size_t drive : unknowns.drive_of_effort)
    system.add_unknown(
        "drive(" + mechanism.actions[static_cast<std::size_t>(mechanism.drives[drive].action)].joint + ")",
        mechanism.drives[drive].turning ? couple_scale : force_scale);

  // Newton and Euler for each body that takes part: forces, then moments about its origin. About that point, and not
  // about the mass center, the equations are linear in the body's mass, first moments and inertia.
  std::vector<std::size_t> first_row(static_cast<std::size_t>(tree.body_count()), 0);
  std::vector<Vector> center(static_cast<std::size_t>(tree.body_count()));
  for (int i = 0; i < tree.body_count(); ++i) {
    if (!mechanism.takes_part[static_cast<std::size_t>(i)]) continue;
    const double mass = tree.body(i).inertia.mass;
    const Vector O = moment.workspace().motion[static_cast<std::size_t>(i + 1)].p;
    center[static_cast<std::size_t>(i)] = O;
    std::size_t row = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t added =
          system.add_equation("forces on " + tree.name(i) + " along " + axis_names[k], force_scale);
      if (k == 0) row = added;
    }
    for (int k = 0; k < 3; ++k)
      system.add_equation("moments on " + tree.name(i) + " about " + axis_names[k], couple_scale);
    first_row[static_cast<std::size_t>(i)] = row;
    if (!(mass > 0)) continue;
    const Vector first_moment = moment.workspace().motion[static_cast<std::size_t>(i + 1)].R *
                                tree.body(i).inertia.first_moment;  // m c, from the origin, on ground axes
    const Vector weight_moment = cross(first_moment, tree.gravity());
    const Momentum<double> known = body_momentum_rate(tree, moment.workspace(), i, O);
    const SymmetricMatrix3<double>& about_origin = tree.body(i).inertia.inertia;
    const double gyroscopic = (about_origin.xx + about_origin.yy + about_origin.zz) *
                              norm_squared(moment.workspace().motion[static_cast<std::size_t>(i + 1)].w);
    for (std::size_t k = 0; k < 3; ++k) {
      system.add_right_side(row + k, mass * tree.gravity()[k] - known.linear[k]);
      system.add_right_side(row + 3 + k, weight_moment[k] - known.angular[k], gyroscopic);
    }
    // m a_G and I_O alpha + m c x a_O per unit acceleration of each coordinate.
    const Matrix3<double> R = moment.workspace().motion[static_cast<std::size_t>(i + 1)].R;
    const SpatialInertia<double>& I = tree.body(i).inertia;
    const double spread = I.inertia.xx + I.inertia.yy + I.inertia.zz, arm = norm(first_moment) / mass;
    for_each_coordinate_motion(tree, moment.workspace(), i, O, [&](int coordinate, const SpatialMotion<double>& S) {
      const Vector m_a = mass * S.linear + cross(S.angular, first_moment);
      const Vector H_rate = R * (I.inertia * transpose_times(R, S.angular)) + cross(first_moment, S.linear);
      const double turning = norm(S.angular);
      const double reach = norm(S.linear) + turning * (norm(O) + arm);
      for (std::size_t k = 0; k < 3; ++k) {
        system.add(row + k, static_cast<std::size_t>(coordinate), m_a[k], rounding * mass * reach);
        system.add(row + 3 + k, static_cast<std::size_t>(coordinate), H_rate[k],
                   rounding * (spread * turning + mass * arm * reach));
      }
    });
  }
  // Every wrench acts on one body and, reversed, on another.
  const auto on_both = [&](const Action& action, const Wrench& wrench, auto&& add) {
    for (const auto& [body, sign] : {std::pair{action.on, 1.0}, std::pair{action.from, -1.0}}) {
      if (body == ground || !mechanism.takes_part[static_cast<std::size_t>(body)]) continue;
      const std::size_t row = first_row[static_cast<std::size_t>(body)];
      const Vector moment_G = wrench.moment - cross(center[static_cast<std::size_t>(body)], wrench.force);
      const double force = norm(wrench.force);
      const double couple = norm(wrench.moment) + norm(center[static_cast<std::size_t>(body)]) * force;
      for (std::size_t k = 0; k < 3; ++k) {
        add(row + k, sign * wrench.force[k], rounding * force);
        add(row + 3 + k, sign * moment_G[k], rounding * couple);
      }
    }
  };
  const auto action_of = [&](const auto& item) -> const Action& {
    return mechanism.actions[static_cast<std::size_t>(item.action)];
  };
  std::size_t column = unknowns.accelerations;
  for (const Component<double>& component : mechanism.components) {
    on_both(action_of(component), moment.component_wrench(component),
            [&](std::size_t row, double value, double error) { system.add(row, column, -value, error); });
    ++column;
  }
  for (std::size_t drive : unknowns.drive_of_effort) {
    on_both(action_of(mechanism.drives[drive]), moment.drive_wrench(mechanism.drives[drive]),
            [&](std::size_t row, double value, double error) { system.add(row, column, -value, error); });
    ++column;
  }
  const auto known = [&](const auto& item, const Wrench& wrench) {
    on_both(action_of(item), wrench, [&](std::size_t row, double value, double) { system.add_right_side(row, value); });
  };
  for (const Drive<double>& drive : mechanism.drives)
    known(drive, moment.known_effort(drive) * moment.drive_wrench(drive));
  for (const KnownForce<double>& force : mechanism.forces) known(force, moment.known_wrench(force));
  for (const SpringLaw<double>& spring : mechanism.springs) known(spring, moment.spring_wrench(spring));

  for (const VelocityConstraint<double>& constraint : mechanism.constraints) {
    const std::size_t row = system.add_equation(constraint.words, is_angular(constraint) ? 1 : scales.length);
    const Row r = constraint_row(moment, constraint);
    for (std::size_t k = 0; k < r.coefficients.size(); ++k)
      if (r.coefficients[k] != 0) system.add(row, k, r.coefficients[k]);
    system.add_right_side(row, -r.bias);
  }
  for (const Condition& condition : conditions) add_condition(system, condition);
  LinearSolution solution = system.solve();
  if (equations) *equations = std::move(system);
  return solution;
}

Wrench action_wrench(const Moment& moment, const std::vector<double>& unknowns, std::size_t action) {
  const Mechanism<double>& mechanism = moment.mechanism();
  const ForceUnknowns order = force_unknowns(mechanism);
  const int index = static_cast<int>(action);
  Wrench total = Wrench::zero();
  std::size_t column = order.accelerations;
  for (const Component<double>& component : mechanism.components) {
    if (component.action == index) total += unknowns[column] * moment.component_wrench(component);
    ++column;
  }
  for (std::size_t drive : order.drive_of_effort) {
    if (mechanism.drives[drive].action == index)
      total += unknowns[column] * moment.drive_wrench(mechanism.drives[drive]);
    ++column;
  }
  for (const Drive<double>& drive : mechanism.drives)
    if (drive.action == index) total += moment.known_effort(drive) * moment.drive_wrench(drive);
  for (const KnownForce<double>& force : mechanism.forces)
    if (force.action == index) total += moment.known_wrench(force);
  for (const SpringLaw<double>& spring : mechanism.springs)
    if (spring.action == index) total += moment.spring_wrench(spring);
  return total;
}

}  // namespace poinsot::solve
