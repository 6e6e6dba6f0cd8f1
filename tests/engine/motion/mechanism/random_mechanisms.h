// Random mechanisms: trees with drives, springs and loads, on which loops, cords, contacts and rolling bodies close; as
// drawn everything is closed.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/solve/instant/closure.h"
#include "poinsot/engine/solve/instant/equations.h"

namespace poinsot::testing {

using Vector = Vector3<double>;

class MechanismMaker {
 public:
  Mechanism<double> mechanism;

  // A body on a joint whose frame stands at `at` of the parent's axes; with its reactions, and a drive if the joint has
  // one coordinate.
  int add_body(int parent, const Joint<double>& joint, const Vector& at, const MassProperties<double>& mass,
               bool takes_part = true) {
    const int body = builder_.add_body("b" + std::to_string(count_++), parent, joint,
                                       SpatialTransform<double>::translation(at), mass);
    const int v = velocities_, q = positions_;
    velocities_ += velocity_size(joint.type);
    positions_ += position_size(joint.type);
    mechanism.takes_part.push_back(takes_part);
    for (int k = v; k < velocities_; ++k) mechanism.coordinate_names.push_back("rate " + std::to_string(k));
    if (!takes_part) return body;
    const int action = add_action(ActionKind::joint, body, parent);
    const Vector axis = normalized(joint.axis);
    const Matrix3<double> R = axes_with_z_along(axis);
    const auto carry = [&](const Vector& direction, bool couple, double screw = 0) {
      Component<double> c;
      c.action = action;
      c.couple = couple;
      c.at = {body, Vector::zero()};
      c.along = {body, direction};
      c.couple_per_force = screw;
      mechanism.components.push_back(c);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const bool main = i == 2;
      switch (joint.type) {
        case JointType::weld:
          carry(R.column(i), false);
          carry(R.column(i), true);
          break;
        case JointType::revolute:
          carry(R.column(i), false);
          if (!main) carry(R.column(i), true);
          break;
        case JointType::prismatic:
          if (!main) carry(R.column(i), false);
          carry(R.column(i), true);
          break;
        case JointType::screw:
          carry(R.column(i), false, main ? -joint.pitch : 0);
          if (!main) carry(R.column(i), true);
          break;
        case JointType::ball:
          carry(R.column(i), false);
          break;
        case JointType::free:
          break;
      }
    }
    if (velocity_size(joint.type) != 1) return body;
    Drive<double> drive;
    drive.action = add_action(ActionKind::drive, body, parent);
    drive.coordinate = v;
    drive.position = q;
    drive.turning = joint.type != JointType::prismatic;
    drive.at = {body, Vector::zero()};
    drive.along = {body, axis};
    mechanism.drives.push_back(drive);
    return body;
  }

  int add_action(ActionKind kind, int on, int from) {
    mechanism.actions.push_back({kind, "a" + std::to_string(mechanism.actions.size()), "", on, from});
    return static_cast<int>(mechanism.actions.size()) - 1;
  }

  // After the last body: the tree as drawn.
  void finish_tree(const Vector& gravity) {
    builder_.set_gravity(gravity);
    mechanism.tree = builder_.build();
    drawn_ = std::make_unique<Workspace<double>>(mechanism.tree);
    update_poses<double>(mechanism.tree, *drawn_, neutral_state(mechanism.tree).q);
  }
  // The place on a body of a point as drawn.
  Place<double> place(int body, const Vector& drawn) const {
    return {body, direction_on_body(mechanism.tree, *drawn_, body,
                                    Vector(drawn - drawn_->motion[static_cast<std::size_t>(body + 1)].p))};
  }
  Vector origin(int body) const { return drawn_->motion[static_cast<std::size_t>(body + 1)].p; }

  VelocityConstraint<double> constraint(VelocityConstraintKind kind, int action, int on, int from, const Vector& at,
                                        const Vector& along) const {
    VelocityConstraint<double> c;
    c.kind = kind;
    c.action = action;
    c.on = on;
    c.from = from;
    c.at = place(on, at);
    c.toward = place(from, at);
    c.along = {from, along};
    c.words = "constraint";
    return c;
  }
  void add_component(int action, const Place<double>& at, const Direction<double>& along, bool couple) {
    Component<double> c;
    c.action = action;
    c.at = at;
    c.along = along;
    c.couple = couple;
    mechanism.components.push_back(c);
  }

  // A ball joint, or a hinge about an axis, that closes a loop.
  void close_loop(int on, int from, const Vector& at, const std::optional<Vector>& axis) {
    const int action = add_action(ActionKind::joint, on, from);
    for (std::size_t i = 0; i < 3; ++i) {
      mechanism.constraints.push_back(constraint(VelocityConstraintKind::point, -1, on, from, at, Vector::unit(i)));
      add_component(action, place(on, at), {from, Vector::unit(i)}, false);
    }
    if (!axis) return;
    const Matrix3<double> R = axes_with_z_along(*axis);
    for (std::size_t i = 0; i < 2; ++i) {
      mechanism.constraints.push_back(constraint(VelocityConstraintKind::angular, -1, on, from, at, R.column(i)));
      add_component(action, place(on, at), {from, R.column(i)}, true);
    }
  }
  void add_cord(int on, int from, const Vector& end, const Vector& start) {
    const int action = add_action(ActionKind::cord, on, from);
    VelocityConstraint<double> c =
        constraint(VelocityConstraintKind::cord_length, action, on, from, end, normalized(Vector(start - end)));
    c.toward = place(from, start);
    c.length = norm(end - start);
    mechanism.constraints.push_back(c);
    add_component(action, c.at, {ground, normalized(Vector(start - end))}, false);
    mechanism.components.back().toward = c.toward;
    mechanism.components.back().one_sided = true;
  }
  // A corner, a sphere or a circle of `on` touches the plane of `from` with this normal; no_slip: carries friction.
  void add_contact(int on, int from, const Vector& at, const Vector& normal, bool no_slip, double radius,
                   const std::optional<Vector>& axis) {
    const int action = add_action(ActionKind::contact, on, from);
    const Matrix3<double> R = axes_with_z_along(normal);
    const bool round = radius > 0;
    for (const std::size_t i : {2U, 0U, 1U}) {
      if (i != 2 && !no_slip) break;
      VelocityConstraint<double> c = constraint(round ? VelocityConstraintKind::rolling : VelocityConstraintKind::point,
                                                action, on, from, at, R.column(i));
      c.normal = i == 2;
      c.surface_axis = {from, normal};
      if (round) {
        Vector up = normal;
        if (axis) {
          up = normalized(Vector(normal - dot(normal, *axis) * *axis));
          c.axis = *axis;
        }
        c.center = place(on, at + radius * up).point;
        c.radius = radius;
      }
      mechanism.constraints.push_back(c);
      add_component(action, c.at, c.along, false);
      mechanism.components.back().one_sided = c.normal;
    }
  }

 private:
  ModelBuilder<double> builder_;
  std::unique_ptr<Workspace<double>> drawn_;
  int count_ = 0, velocities_ = 0, positions_ = 0;
};

struct MechanismOptions {
  int least_bodies = 1, most_bodies = 5;
  int most_closures = 2;
  bool massless_links = true;
  bool held = true;
};

inline Mechanism<double> random_mechanism(Random& random, const MechanismOptions& options = {}) {
  MechanismMaker maker;
  const int count = random.integer(options.least_bodies, options.most_bodies);
  std::vector<int> bodies{ground};
  if (options.held && random.chance(0.3))
    bodies.push_back(
        maker.add_body(ground, random.chance(0.5) ? Joint<double>::revolute(random.direction()) : Joint<double>::free(),
                       random.vector(), massless<double>(), false));
  for (int i = 0; i < count; ++i) {
    int parent = bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1))];
    Joint<double> joint = random_joint(random);
    // A massless link must carry something.
    if (options.massless_links && joint.type != JointType::free && random.chance(0.2))
      parent = maker.add_body(parent, Joint<double>::revolute(random.direction()), random.vector(), massless<double>());
    joint.axis = normalized(joint.axis);
    bodies.push_back(maker.add_body(parent, joint, random.vector(), random.mass()));
  }
  maker.finish_tree(random.vector(10));
  Mechanism<double>& mechanism = maker.mechanism;
  for (Drive<double>& drive : mechanism.drives) {
    if (options.held && random.chance(0.2)) {
      drive.held = true;
      continue;
    }
    if (random.chance(0.5)) drive.effort = random.uniform(-4, 4);
    if (random.chance(0.4)) {
      drive.stiffness = random.uniform(1, 5);
      drive.free_position = random.uniform(-1, 1);
    }
    if (random.chance(0.4)) drive.damping = random.uniform(0.1, 2);
  }
  const auto any = [&](int other) {
    for (;;) {
      const int body = bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1))];
      if (body != other) return body;
    }
  };
  for (int i = random.integer(0, options.most_closures); i > 0; --i) {
    const int on = bodies[static_cast<std::size_t>(random.integer(1, static_cast<int>(bodies.size()) - 1))];
    const int from = any(on);
    const Vector at = maker.origin(on) + random.vector();
    switch (random.integer(0, 5)) {
      case 0:
        maker.close_loop(on, from, at, std::nullopt);
        break;
      case 1:
        maker.close_loop(on, from, at, random.direction());
        break;
      case 2:
        maker.add_cord(on, from, at, at + random.uniform(0.5, 1.5) * random.direction());
        break;
      case 3:
        maker.add_contact(on, from, at, random.direction(), random.chance(0.5), 0, std::nullopt);
        break;
      case 4:
        maker.add_contact(on, from, at, random.direction(), random.chance(0.7), random.uniform(0.2, 0.8), std::nullopt);
        break;
      default:
        maker.add_contact(on, from, at, random.direction(), random.chance(0.7), random.uniform(0.2, 0.8),
                          random.direction());
    }
  }
  for (int i = random.integer(0, 2); i > 0; --i) {
    KnownForce<double> force;
    const int on = any(ground);
    force.action = maker.add_action(ActionKind::load, on, any(on));
    force.couple = random.chance(0.5);
    force.at = {on, random.vector()};
    force.vector = random.vector(10);
    force.axes = any(-2);
    mechanism.forces.push_back(force);
  }
  for (int i = random.integer(0, 1); i > 0; --i) {
    SpringLaw<double> spring;
    const int on = any(ground), from = any(on);
    spring.action = maker.add_action(ActionKind::spring, on, from);
    spring.at = {on, random.vector()};
    spring.toward = {from, random.vector(2)};
    spring.stiffness = random.uniform(1, 20);
    spring.free_length = random.uniform(0.1, 1);
    spring.damping = random.uniform(0, 2);
    mechanism.springs.push_back(spring);
  }
  for (int i = random.integer(0, 1); i > 0; --i) {
    const int on = any(ground), from = any(on);
    mechanism.torsions.push_back({maker.add_action(ActionKind::spring, on, from),
                                  on,
                                  {from, random.direction()},
                                  random.uniform(1, 20),
                                  random.uniform(-1, 1),
                                  random.uniform(0, 2)});
  }
  return std::move(maker.mechanism);
}

// A state near the drawn one in which every constraint holds; nothing if none was found.
inline std::optional<State<double>> random_closed_state(Random& random, MechanismDynamics& dynamics, double reach) {
  const Model<double>& tree = dynamics.mechanism().tree;
  State<double> state = neutral_state(tree);
  std::vector<double> step = random.numbers(tree.velocity_size(), reach);
  integrate_position<double>(tree, state.q, step, 1.0);
  state.v = random.numbers(tree.velocity_size(), 2);
  const double gap = dynamics.project(state.q, state.v);
  if (gap > 1e-12 || dynamics.largest_rate(state.q, state.v) > 1e-10) return std::nullopt;
  return state;
}

inline double largest_of(const std::vector<double>& list) {
  double largest = 0;
  for (const double x : list) largest = std::max(largest, std::abs(x));
  return largest;
}

inline std::vector<double> accelerations_of(MechanismDynamics& dynamics, const State<double>& state) {
  std::vector<double> a(state.v.size());
  dynamics.accelerations(state.q, state.v, a);
  return a;
}

// The state a time t later on a path with these velocities and accelerations, to third order in t.
inline State<double> later(const MechanismDynamics& dynamics, const State<double>& state, const std::vector<double>& a,
                           double t) {
  State<double> moved = state;
  std::vector<double> mean = state.v;
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean[k] += 0.5 * t * a[k];
    moved.v[k] += t * a[k];
  }
  integrate_position<double>(dynamics.mechanism().tree, moved.q, mean, t);
  return moved;
}

// Accelerations and forces by the equations of solve/instant/equations.h with every force an unknown.
struct NamedMotion {
  Mechanism<double> mechanism;  // with contacts where they are
  solve::LinearSolution solution;
  std::vector<std::string> words;           // of the equations
  std::size_t components = 0, efforts = 0;  // where they begin

  NamedMotion(const MechanismDynamics& dynamics, const State<double>& state, const std::vector<double>& given)
      : mechanism(dynamics.mechanism()) {
    // What does not act is not there.
    std::erase_if(mechanism.constraints,
                  [&](const VelocityConstraint<double>& c) { return c.action >= 0 && !dynamics.is_acting(c.action); });
    solve::MechanismState placed(mechanism);
    placed.set_positions(state.q);
    solve::update_contacts(mechanism, placed);
    placed.set_velocities(state.v);
    const solve::ForceUnknowns unknowns = solve::force_unknowns(mechanism);
    components = unknowns.accelerations;
    efforts = components + unknowns.components;
    std::vector<solve::Condition> conditions;
    const auto set = [&](std::size_t unknown, double value, double scale) {
      solve::Condition condition{"given", std::vector<double>(unknowns.size()), value, scale};
      condition.coefficients[unknown] = 1;
      conditions.push_back(condition);
    };
    for (const int k : dynamics.held_coordinates()) set(static_cast<std::size_t>(k), given[k], 1);
    for (std::size_t j = 0; j < mechanism.components.size(); ++j)
      if (!dynamics.is_acting(mechanism.components[j].action)) set(components + j, 0, 1);
    solve::LinearSystem system;
    system = solve::motion_equations(placed, solve::natural_scales(mechanism), conditions);
    solution = system.solve();
    for (std::size_t i = 0; i < system.equations(); ++i) words.emplace_back(system.words(i));
  }
};

}  // namespace poinsot::testing
