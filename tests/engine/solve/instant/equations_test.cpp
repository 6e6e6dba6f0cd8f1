#include "poinsot/engine/solve/instant/equations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/newton_euler_oracle.h"
#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/hybrid_dynamics.h"
#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot::solve {
namespace equations_test {

using poinsot::testing::Random;
using poinsot::testing::StatedBody;
using poinsot::testing::StatedTree;
using Vector = Vector3<double>;
using Timed = Dual<1>;

Action action(ActionKind kind, const std::string& name, const std::string& joint, int on, int from) {
  Action result;
  result.kind = kind;
  result.name = name;
  result.joint = joint;
  result.on = on;
  result.from = from;
  return result;
}

// Two unit vectors across u.
std::pair<Vector, Vector> across(const Vector& u) {
  const Vector first = normalized(cross(u, std::abs(u.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0}));
  return {first, cross(u, first)};
}

// What each joint can carry, on the axes of the parent, at the origin of the body; then a drive for each coordinate.
Mechanism<double> mechanism_of(const StatedTree& stated, const Model<double>& tree) {
  Mechanism<double> mechanism;
  mechanism.tree = tree;
  mechanism.takes_part.assign(stated.bodies.size(), true);
  mechanism.coordinate_names.assign(static_cast<std::size_t>(tree.velocity_size()), "a coordinate");
  for (int i = 0; i < tree.body_count(); ++i) {
    const StatedBody& body = stated.bodies[static_cast<std::size_t>(i)];
    const Joint<double>& joint = body.joint;
    const int joint_action = static_cast<int>(mechanism.actions.size());
    mechanism.actions.push_back(action(ActionKind::joint, "joint " + std::to_string(i), "", i, body.parent));
    const auto carry = [&](bool couple, const Vector& d_F, double couple_per_force = 0) {
      Component<double> c;
      c.action = joint_action;
      c.couple = couple;
      c.at = {i, Vector::zero()};
      c.along = {body.parent, body.placement.R * d_F};
      c.couple_per_force = couple_per_force;
      mechanism.components.push_back(c);
    };
    const Vector axis = normalized(joint.axis);
    const auto [a, b] = across(axis);
    const std::vector<Vector> all{Vector::unit(0), Vector::unit(1), Vector::unit(2)}, sides{a, b};
    const bool slides = joint.type == JointType::prismatic || joint.type == JointType::screw;
    if (joint.type != JointType::free)
      for (const Vector& d : slides ? sides : all) carry(false, d);
    if (joint.type == JointType::screw) carry(false, axis, -joint.pitch);
    if (joint.type == JointType::weld || joint.type == JointType::prismatic)
      for (const Vector& d : all) carry(true, d);
    if (joint.type == JointType::revolute || joint.type == JointType::screw)
      for (const Vector& d : sides) carry(true, d);
    for (int k = 0; k < velocity_size(joint.type); ++k) {
      Drive<double> drive;
      drive.action = static_cast<int>(mechanism.actions.size());
      mechanism.actions.push_back(action(ActionKind::drive, "drive", "joint " + std::to_string(i), i, body.parent));
      drive.coordinate = tree.body(i).v + k;
      drive.position = tree.body(i).q;
      drive.turning = !(joint.type == JointType::prismatic || (joint.type == JointType::free && k >= 3));
      drive.at = {i, Vector::zero()};
      drive.along = {i, velocity_size(joint.type) == 1 ? axis : Vector::unit(static_cast<std::size_t>(k % 3))};
      mechanism.drives.push_back(drive);
    }
  }
  return mechanism;
}

// A mechanism in a random state, with random efforts or given accelerations.
struct Trial {
  StatedTree stated;
  Model<double> tree;
  State<double> state;
  std::vector<double> acceleration, force;
  Mechanism<double> mechanism;
  std::vector<Condition> conditions;

  explicit Trial(Random& random, const testing::TreeOptions& options = {.given_coordinates = true})
      : stated(testing::random_tree(random, options)),
        tree(testing::built(stated)),
        state(testing::random_state(random, tree)),
        acceleration(random.numbers(tree.velocity_size(), 3)),
        force(random.numbers(tree.velocity_size(), 3)),
        mechanism(mechanism_of(stated, tree)) {
    const std::size_t unknowns = [&] {
      for (Drive<double>& drive : mechanism.drives) drive.held = tree.mode(drive.coordinate) != CoordinateMode::free;
      return force_unknowns(mechanism).size();
    }();
    for (Drive<double>& drive : mechanism.drives) {
      const auto k = static_cast<std::size_t>(drive.coordinate);
      if (tree.mode(drive.coordinate) == CoordinateMode::locked) acceleration[k] = 0;
      if (!drive.held) {
        drive.effort = force[k];
        continue;
      }
      Condition condition{"stated", std::vector<double>(unknowns), acceleration[k], 1};
      condition.coefficients[k] = 1;
      conditions.push_back(std::move(condition));
    }
  }
  MechanismState mechanism_state() const {
    MechanismState now(mechanism);
    now.set_positions(state.q);
    now.set_velocities(state.v);
    return now;
  }
};

double largest_of(const std::vector<double>& x) {
  double largest = 1;
  for (double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

// Engine and equations know the same of each coordinate, and find the same.
TEST(Equations, MotionAgreesWithHybridDynamics) {
  Random random(21);
  for (int trial = 0; trial < 1000; ++trial) {
    const Trial t(random);
    const MechanismState state = t.mechanism_state();
    const LinearSolution solution = motion_equations(state, natural_scales(t.mechanism), t.conditions).solve();
    ASSERT_TRUE(solution.conflict.empty()) << trial;
    ASSERT_TRUE(solution.open.empty()) << trial;
    std::vector<double> acceleration = t.acceleration, force = t.force;
    Workspace<double> workspace(t.tree);
    hybrid_dynamics<double>(t.tree, workspace, t.state, acceleration, force);
    const ForceUnknowns order = force_unknowns(t.mechanism);
    const double size = std::max(largest_of(acceleration), largest_of(force));
    for (std::size_t k = 0; k < acceleration.size(); ++k)
      EXPECT_NEAR(solution.value[k], acceleration[k], 1e-10 * size) << trial << " coordinate " << k;
    for (std::size_t j = 0; j < order.efforts; ++j) {
      const Drive<double>& drive = t.mechanism.drives[order.drive_of_effort[j]];
      EXPECT_NEAR(solution.value[order.accelerations + order.components + j],
                  force[static_cast<std::size_t>(drive.coordinate)], 1e-10 * size)
          << trial << " drive " << j;
    }
  }
}

// What passes through each joint is what the redundant equations of the oracle find, loads, springs and drives
// included.
TEST(Equations, ReactionsAgreeWithNewtonAndEuler) {
  Random random(22);
  for (int trial = 0; trial < 1000; ++trial) {
    Trial t(random);
    const int count = t.tree.body_count();
    // Loads and springs, told to the oracle as wrenches on the body's axes about its origin.
    MechanismState drawn = t.mechanism_state();
    std::vector<SpatialForce<double>> external(static_cast<std::size_t>(count), SpatialForce<double>::zero());
    const auto apply = [&](int body, const Vector& place, const Vector& force, const Vector& couple) {
      if (body == ground) return;
      const SpatialTransform<double> pose = body_pose(t.tree, drawn.workspace(), body);
      const Vector r = place - pose.p;
      external[static_cast<std::size_t>(body)] +=
          SpatialForce<double>{transpose_times(pose.R, couple + cross(r, force)), transpose_times(pose.R, force)};
    };
    for (int n = random.integer(0, 3); n > 0; --n) {
      KnownForce<double> force;
      const int on = random.integer(0, count - 1);
      force.action = static_cast<int>(t.mechanism.actions.size());
      t.mechanism.actions.push_back(action(ActionKind::load, "load", "", on, ground));
      force.couple = random.chance(0.5);
      force.at = {on, random.vector()};
      force.axes = random.integer(-1, count - 1);
      force.vector = random.vector(5);
      t.mechanism.forces.push_back(force);
      const Vector vector = direction_on_ground(t.tree, drawn.workspace(), force.axes, force.vector);
      apply(on, point_position(t.tree, drawn.workspace(), on, force.at.point), force.couple ? Vector::zero() : vector,
            force.couple ? vector : Vector::zero());
    }
    for (int n = random.integer(0, 2); n > 0; --n) {
      SpringLaw<double> spring;
      const int on = random.integer(0, count - 1), from = random.integer(-1, count - 1);
      if (on == from) continue;
      spring.action = static_cast<int>(t.mechanism.actions.size());
      t.mechanism.actions.push_back(action(ActionKind::spring, "spring", "", on, from));
      spring.at = {on, random.vector()};
      spring.toward = {from, random.vector()};
      spring.stiffness = random.uniform(1, 5);
      spring.free_length = random.uniform(0, 1);
      spring.damping = random.uniform(0, 2);
      t.mechanism.springs.push_back(spring);
      const Vector P = point_position(t.tree, drawn.workspace(), on, spring.at.point);
      const Vector Q = point_position(t.tree, drawn.workspace(), from, spring.toward.point);
      const Vector u = normalized(Q - P);
      const double lengthening = dot(u, point_velocity(t.tree, drawn.workspace(), from, spring.toward.point) -
                                            point_velocity(t.tree, drawn.workspace(), on, spring.at.point));
      const Vector pull = (spring.stiffness * (norm(Q - P) - spring.free_length) + spring.damping * lengthening) * u;
      apply(on, P, pull, Vector::zero());
      apply(from, Q, -pull, Vector::zero());
    }
    // Springs and dampers in drives that are not held.
    for (Drive<double>& drive : t.mechanism.drives) {
      if (drive.held ||
          velocity_size(t.tree.body(t.mechanism.actions[static_cast<std::size_t>(drive.action)].on).joint) != 1)
        continue;
      drive.stiffness = random.uniform(0, 2);
      drive.free_position = random.uniform(-1, 1);
      drive.damping = random.uniform(0, 2);
      const auto k = static_cast<std::size_t>(drive.coordinate);
      t.force[k] = drive.effort -
                   drive.stiffness * (t.state.q[static_cast<std::size_t>(drive.position)] - drive.free_position) -
                   drive.damping * t.state.v[k];
    }
    const MechanismState state = t.mechanism_state();
    const LinearSolution solution = motion_equations(state, natural_scales(t.mechanism), t.conditions).solve();
    ASSERT_TRUE(solution.conflict.empty()) << trial;
    ASSERT_TRUE(solution.open.empty()) << trial;
    std::vector<CoordinateMode> modes;
    for (int k = 0; k < t.tree.velocity_size(); ++k) modes.push_back(t.tree.mode(k));
    const testing::OracleResult oracle =
        testing::oracle_dynamics(t.stated, t.state, modes, t.force, t.acceleration, external);
    double size = std::max(largest_of(oracle.acceleration), largest_of(oracle.force));
    for (const testing::OracleBody& body : oracle.bodies) size = std::max({size, body.f.norm(), body.n.norm()});
    for (std::size_t k = 0; k < modes.size(); ++k)
      EXPECT_NEAR(solution.value[k], oracle.acceleration[k], 1e-10 * size) << trial;
    for (int i = 0; i < count; ++i) {
      SpatialForce<double> wrench = SpatialForce<double>::zero();
      for (std::size_t a = 0; a < t.mechanism.actions.size(); ++a) {
        const Action& action = t.mechanism.actions[a];
        if (action.on == i && (action.kind == ActionKind::joint || action.kind == ActionKind::drive))
          wrench += action_wrench(state, solution.value, a);
      }
      const testing::OracleBody& body = oracle.bodies[static_cast<std::size_t>(i)];
      const Vector origin{body.p.x(), body.p.y(), body.p.z()};
      const Vector about_origin = wrench.moment - cross(origin, wrench.force);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(wrench.force[static_cast<std::size_t>(k)], body.f[k], 1e-10 * size) << trial << " body " << i;
        EXPECT_NEAR(about_origin[static_cast<std::size_t>(k)], body.n[k], 1e-10 * size) << trial << " body " << i;
      }
    }
  }
}

// The state on the way through now with rates v and accelerations a, to first order in time.
State<Timed> path(const Model<double>& tree, const State<double>& state, const std::vector<double>& a) {
  State<Timed> timed;
  std::vector<double> rate(state.q.size());
  position_rate<double>(tree, state.q, state.v, rate);
  for (std::size_t i = 0; i < state.q.size(); ++i) timed.q.push_back(Timed(state.q[i], {rate[i]}));
  for (std::size_t i = 0; i < state.v.size(); ++i) timed.v.push_back(Timed(state.v[i], {a[i]}));
  return timed;
}

Vector3<Timed> constant(const Vector& a) { return {Timed(a.x), Timed(a.y), Timed(a.z)}; }

// The velocity that a constraint forbids, with its rate, from the motion of both bodies.
Timed forbidden(const Model<Timed>& tree, const Workspace<Timed>& w, const VelocityConstraint<double>& c) {
  const Vector3<Timed> d = direction_on_ground(tree, w, c.from, constant(c.along.vector));
  if (c.kind == VelocityConstraintKind::angular) return dot(d, angular_velocity(w, c.on) - angular_velocity(w, c.from));
  const BodyMotion<Timed>& on = w.motion[static_cast<std::size_t>(c.on + 1)];
  const BodyMotion<Timed>& from = w.motion[static_cast<std::size_t>(c.from + 1)];
  const Vector3<Timed> P = point_position(tree, w, c.on, constant(c.at.point));
  if (c.kind == VelocityConstraintKind::cord_length) {
    const Vector3<Timed> Q = point_position(tree, w, c.from, constant(c.toward.point));
    return dot(normalized(P - Q), point_velocity(tree, w, c.on, constant(c.at.point)) -
                                      point_velocity(tree, w, c.from, constant(c.toward.point)));
  }
  Vector3<Timed> contact = P;
  if (c.kind == VelocityConstraintKind::rolling) {
    // Where the sphere or circle touches a plane with this normal at any time.
    const Vector3<Timed> n = direction_on_ground(tree, w, c.surface_axis.body, constant(c.surface_axis.vector));
    const Vector3<Timed> center = point_position(tree, w, c.on, constant(c.center));
    if (norm_squared(c.axis) == 0) {
      contact = center - Timed(c.radius) * n;
    } else {
      const Vector3<Timed> e = direction_on_ground(tree, w, c.on, constant(c.axis));
      contact = center - Timed(c.radius) * normalized(Vector3<Timed>(n - dot(n, e) * e));
    }
  }
  const Vector3<Timed> relative =
      on.v + cross(on.w, Vector3<Timed>(contact - on.p)) - from.v - cross(from.w, Vector3<Timed>(contact - from.p));
  return dot(d, relative);
}

// Constraints between bodies of a random tree: the velocities found keep them, and so do the accelerations.
TEST(Equations, VelocitiesAndAccelerationsKeepTheConstraints) {
  Random random(23);
  int constrained = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Trial t(random, {.least_bodies = 2, .most_bodies = 5, .given_coordinates = false});
    const int count = t.tree.body_count();
    const MechanismState placed = t.mechanism_state();
    for (int n = random.integer(1, 2); n > 0; --n) {
      VelocityConstraint<double> c;
      c.words = "constraint";
      c.on = random.integer(0, count - 1);
      c.from = random.integer(-1, count - 1);
      if (c.on == c.from) continue;
      c.at = {c.on, random.vector()};
      c.along = {c.from, random.direction()};
      switch (random.integer(0, 4)) {
        case 0:
          c.kind = VelocityConstraintKind::angular;
          break;
        case 1:
          c.kind = VelocityConstraintKind::cord_length;
          c.toward = {c.from, random.vector()};
          break;
        case 2:
        case 3: {
          c.kind = VelocityConstraintKind::rolling;
          c.radius = random.uniform(0.2, 1);
          c.surface_axis = {c.from, random.direction()};
          const Vector n_G = placed.direction(c.surface_axis);
          c.center = random.vector();
          const Vector center = point_position(t.tree, placed.workspace(), c.on, c.center);
          Vector touching = center - c.radius * n_G;
          if (random.chance(0.6)) {
            c.axis = random.direction();
            const Vector e = direction_on_ground(t.tree, placed.workspace(), c.on, c.axis);
            if (norm(cross(n_G, e)) < 0.1) continue;
            touching = center - c.radius * normalized(n_G - dot(n_G, e) * e);
          }
          const SpatialTransform<double> pose = body_pose(t.tree, placed.workspace(), c.on);
          c.at = {c.on, transpose_times(pose.R, touching - pose.p)};
          break;
        }
        default:
          c.kind = VelocityConstraintKind::point;
      }
      Component<double> carried;
      carried.action = static_cast<int>(t.mechanism.actions.size());
      t.mechanism.actions.push_back(action(ActionKind::contact, "contact", "", c.on, c.from));
      carried.couple = c.kind == VelocityConstraintKind::angular;
      carried.at = c.at;
      carried.along = c.along;
      if (c.kind == VelocityConstraintKind::cord_length) carried.toward = c.toward;
      t.mechanism.components.push_back(carried);
      t.mechanism.constraints.push_back(c);
    }
    if (t.mechanism.constraints.empty()) continue;
    const Scales scales = natural_scales(t.mechanism);
    MechanismState state = t.mechanism_state();
    const LinearSolution slow = velocity_equations(state, scales, {}).solve();
    ASSERT_TRUE(slow.conflict.empty());
    // Any of the motions that the constraints leave.
    std::vector<double> v = slow.value;
    for (const auto& direction : slow.open) {
      const double amount = random.uniform(-2, 2);
      for (std::size_t k = 0; k < v.size(); ++k) v[k] += amount * direction[k];
    }
    const double speed = largest_of(v);
    if (slow.condition > 1e4 || speed > 20) continue;
    state.set_velocities(v);
    for (const auto& c : t.mechanism.constraints) {
      const std::vector<double> row = constraint_coefficients(state, c);
      double rate = 0;
      for (std::size_t k = 0; k < v.size(); ++k) rate += row[k] * v[k];
      EXPECT_NEAR(rate, 0, 1e-10 * speed);
    }
    const LinearSolution solution = motion_equations(state, scales, {}).solve();
    // A body held in place may not allow the constraint's acceleration; then this is said, and nothing else.
    if (!solution.conflict.empty() || solution.condition > 1e6) continue;
    const std::vector<double> a(solution.value.begin(), solution.value.begin() + static_cast<std::ptrdiff_t>(v.size()));
    const Model<Timed> tree = convert<Timed>(t.tree);
    Workspace<Timed> workspace(tree);
    update_velocities(tree, workspace, path(t.tree, {t.state.q, v}, a));
    const double size = speed * speed + largest_of(a);
    for (const auto& c : t.mechanism.constraints) {
      const Timed gap = forbidden(tree, workspace, c);
      EXPECT_NEAR(gap.value, 0, 1e-10 * speed) << trial;
      EXPECT_NEAR(gap.partial[0], 0, 1e-10 * size) << trial << " kind " << static_cast<int>(c.kind);
    }
    ++constrained;
  }
  EXPECT_GT(constrained, 500);
}

// A disk of radius r that rolls upright on level ground with the speed v: the spin is v/r.
TEST(Equations, ARollingDisk) {
  const double r = 0.3, v = 1.2;
  ModelBuilder<double> builder;
  builder.set_gravity({0, 0, -9.81});
  const MassProperties<double> disk{2, Vector::zero(), SymmetricMatrix3<double>::diagonal(0.09, 0.045, 0.045)};
  builder.add_body("disk", ground, Joint<double>::free(), SpatialTransform<double>::translation({0, 0, r}), disk);
  Mechanism<double> mechanism;
  mechanism.tree = builder.build();
  mechanism.takes_part = {true};
  mechanism.coordinate_names.assign(6, "rate");
  mechanism.actions.push_back(action(ActionKind::contact, "floor", "", 0, ground));
  for (std::size_t k = 0; k < 3; ++k) {
    VelocityConstraint<double> c;
    c.kind = VelocityConstraintKind::rolling;
    c.words = "rolling";
    c.on = 0;
    c.at = {0, {0, 0, -r}};
    c.along = {ground, Vector::unit(k)};
    c.axis = {1, 0, 0};
    c.radius = r;
    c.surface_axis = {ground, {0, 0, 1}};
    mechanism.constraints.push_back(c);
    Component<double> carried;
    carried.at = c.at;
    carried.along = c.along;
    mechanism.components.push_back(carried);
  }
  // Forward along y, no turning about the vertical, no tilting.
  const auto stated = [&](std::size_t k, double value) {
    Condition condition{"stated", std::vector<double>(6), value, 1};
    condition.coefficients[k] = 1;
    return condition;
  };
  MechanismState state(mechanism);
  const LinearSolution motion =
      velocity_equations(state, natural_scales(mechanism), {stated(4, v), stated(2, 0), stated(1, 0)}).solve();
  ASSERT_TRUE(motion.conflict.empty());
  EXPECT_TRUE(motion.open.empty());
  EXPECT_NEAR(motion.value[0], -v / r, 1e-14);
  EXPECT_NEAR(motion.value[3], 0, 1e-14);
  state.set_velocities(motion.value);
  const LinearSolution forces = motion_equations(state, natural_scales(mechanism), {}).solve();
  ASSERT_TRUE(forces.conflict.empty());
  EXPECT_TRUE(forces.open.empty());
  // The last three are rates of components on the axes of the disk, which turn: -w x v.
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(forces.value[k], k == 5 ? v * v / r : 0, 1e-12) << k;
  EXPECT_NEAR(forces.value[8], 2 * 9.81, 1e-12);
  EXPECT_NEAR(forces.value[6], 0, 1e-12);
  EXPECT_NEAR(forces.value[7], 0, 1e-12);
}

// A four-bar linkage whose middle bar is parallel to the ground: both cranks turn at the same rate, and the bar does
// not.
TEST(Equations, AParallelogramLinkage) {
  ModelBuilder<double> builder;
  const MassProperties<double> bar{1, Vector::zero(), SymmetricMatrix3<double>::diagonal(0.1, 0.1, 0.1)};
  const auto at = [](double x, double y) { return SpatialTransform<double>::translation({x, y, 0}); };
  const Joint<double> pin = Joint<double>::revolute({0, 0, 1});
  builder.add_body("left", ground, pin, at(0, 0), bar);
  builder.add_body("middle", 0, pin, at(0, 1), bar);
  builder.add_body("right", ground, pin, at(2, 0), bar);
  Mechanism<double> mechanism;
  mechanism.tree = builder.build();
  mechanism.takes_part = {true, true, true};
  mechanism.coordinate_names.assign(3, "rate");
  for (std::size_t k = 0; k < 2; ++k) {
    VelocityConstraint<double> c;
    c.words = "the last pin";
    c.on = 1;
    c.from = 2;
    c.at = {1, {2, 0, 0}};
    c.along = {2, Vector::unit(k)};
    mechanism.constraints.push_back(c);
  }
  Condition condition{"the crank", {1, 0, 0}, 5, 1};
  MechanismState state(mechanism);
  const LinearSolution motion = velocity_equations(state, natural_scales(mechanism), {condition}).solve();
  ASSERT_TRUE(motion.conflict.empty());
  EXPECT_TRUE(motion.open.empty());
  EXPECT_NEAR(motion.value[0], 5, 1e-13);
  EXPECT_NEAR(motion.value[1], -5, 1e-13);
  EXPECT_NEAR(motion.value[2], 5, 1e-13);
  // A second stated rate that does not fit is a contradiction that names what takes part in it.
  const LinearSystem equations =
      velocity_equations(state, natural_scales(mechanism), {condition, {"the other crank", {0, 0, 1}, 4, 1}});
  const LinearSolution wrong = equations.solve();
  std::vector<std::string> names;
  for (std::size_t row : wrong.conflict) names.emplace_back(equations.words(row));
  EXPECT_NE(std::find(names.begin(), names.end(), "the other crank"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "the crank"), names.end());
}

TEST(Equations, TellWhatTheyWereMadeOf) {
  Random random(7);
  Trial t(random);
  VelocityConstraint<double> pin;
  pin.words = "a pin";
  pin.on = 0;
  t.mechanism.constraints = {pin, pin};
  const auto n = static_cast<std::size_t>(t.tree.velocity_size());
  const MechanismState state = t.mechanism_state();
  const auto sources = [](const LinearSystem& system, EquationKind kind) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < system.equations(); ++i)
      if (system.source(i).kind == kind) found.push_back(system.source(i).index);
    return found;
  };
  const Condition rate{"stated", std::vector<double>(n, 1.0), 2, 1};
  const LinearSystem velocities = velocity_equations(state, natural_scales(t.mechanism), {rate, rate, rate});
  EXPECT_EQ(sources(velocities, EquationKind::constraint), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(sources(velocities, EquationKind::condition), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(velocities.equations(), 5U);
  const Condition force{"stated", std::vector<double>(force_unknowns(t.mechanism).size(), 1.0), 2, 1};
  const LinearSystem motion = motion_equations(state, natural_scales(t.mechanism), {force});
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.tree.body_count()); ++i)
    if (t.mechanism.takes_part[i]) bodies.insert(bodies.end(), 6, i);
  EXPECT_FALSE(bodies.empty());
  EXPECT_EQ(sources(motion, EquationKind::balance), bodies);
  EXPECT_EQ(sources(motion, EquationKind::condition), std::vector<std::size_t>{0});
}

TEST(Equations, NaturalScalesAreThoseOfTheMechanism) {
  ModelBuilder<double> builder;
  const MassProperties<double> mass{5, Vector::zero(), SymmetricMatrix3<double>::diagonal(1e-4, 1e-4, 1e-4)};
  builder.add_body("a", ground, Joint<double>::ball(), SpatialTransform<double>::translation({100, 0, 0}), mass);
  builder.add_body("b", 0, Joint<double>::ball(), SpatialTransform<double>::translation({0, 3, 0}), mass);
  Mechanism<double> mechanism;
  mechanism.tree = builder.build();
  const Scales scales = natural_scales(mechanism);
  EXPECT_DOUBLE_EQ(scales.mass, 5);
  EXPECT_DOUBLE_EQ(scales.length, 3);  // the extent of the figure, wherever its origin lies
  const Scales empty = natural_scales(Mechanism<double>{});
  EXPECT_EQ(empty.length, 1);
  EXPECT_EQ(empty.mass, 1);
}

// A body a million times smaller than its neighbour still has its own equations.
TEST(Equations, ASmallBodyBesideALargeOne) {
  for (double size : {1.0, 1e-1, 1e-2, 1e-3}) {
    ModelBuilder<double> builder;
    builder.set_gravity({0, -9.81, 0});
    const MassProperties<double> large{1000, {5, 0, 0}, SymmetricMatrix3<double>::diagonal(1e3, 1e4, 1e4)};
    const double m = size * size * size, I = m * size * size;
    const MassProperties<double> small{m, {0.3 * size, 0, 0}, SymmetricMatrix3<double>::diagonal(I, I, I)};
    StatedTree stated;
    stated.gravity = {0, -9.81, 0};
    stated.bodies.push_back({ground,
                             Joint<double>::revolute({0, 0, 1}),
                             SpatialTransform<double>::identity(),
                             large,
                             {CoordinateMode::free}});
    stated.bodies.push_back({0,
                             Joint<double>::revolute({0, 0.6, 0.8}),
                             SpatialTransform<double>::translation({10, 0, 0}),
                             small,
                             {CoordinateMode::free}});
    const Model<double> tree = testing::built(stated);
    Mechanism<double> mechanism = mechanism_of(stated, tree);
    mechanism.drives[1].effort = 4 * I;
    MechanismState placed(mechanism);
    const State<double> state{{0.2, 0.4}, {1.5, -2}};
    placed.set_positions(state.q);
    placed.set_velocities(state.v);
    const LinearSolution solution = motion_equations(placed, natural_scales(mechanism), {}).solve();
    EXPECT_TRUE(solution.conflict.empty()) << size;
    EXPECT_TRUE(solution.open.empty()) << size;
    std::vector<double> acceleration(2), force{0, 4 * I};
    Workspace<double> workspace(tree);
    hybrid_dynamics<double>(tree, workspace, state, acceleration, force);
    EXPECT_NEAR(solution.value[0], acceleration[0], 1e-9 * std::abs(acceleration[0])) << size;
    EXPECT_NEAR(solution.value[1], acceleration[1], 1e-9 * std::abs(acceleration[1])) << size;
  }
}

}  // namespace equations_test
}  // namespace poinsot::solve
