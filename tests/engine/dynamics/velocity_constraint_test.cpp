#include "poinsot/engine/dynamics/velocity_constraint.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/math/algebra/dual.h"

namespace poinsot {
namespace velocity_constraint_test {

using testing::Random;
using Vector = Vector3<double>;
using Kind = VelocityConstraintKind;

// Two bodies that move freely, the second carried by the first or by the ground.
struct Pair {
  Model<double> model;
  Workspace<double> workspace;
  State<double> state;

  explicit Pair(Random& random) : model(made(random)), workspace(model), state(neutral_state(model)) {}

  static Model<double> made(Random& random) {
    ModelBuilder<double> builder;
    const int first = builder.add_body("a", ground, Joint<double>::free(), random.pose(), random.mass());
    builder.add_body("b", random.chance(0.5) ? first : ground, Joint<double>::free(), random.pose(), random.mass());
    return builder.build();
  }
  void move(Random& random) {
    integrate_position<double>(model, state.q, random.numbers(12, 1), 1.0);
    state.v = random.numbers(12, 1.5);
  }
};

VelocityConstraint<double> random_constraint(Random& random, Kind kind) {
  VelocityConstraint<double> c;
  c.kind = kind;
  c.on = 1;
  c.from = random.chance(0.7) ? 0 : ground;
  c.at = {c.on, random.vector()};
  c.toward = {c.from, random.vector(3)};
  c.along = {c.from, random.direction()};
  c.length = 1;
  c.normal = true;
  c.center = random.vector();
  c.radius = random.uniform(0.2, 1);
  if (random.chance(0.6)) c.axis = random.direction();
  c.surface_axis = {c.from, c.along.vector};
  return c;
}

double rate_of(const Pair& pair, const Workspace<double>& w, const VelocityConstraint<double>& c) {
  const PlacedForce<double> unit = constraint_force(pair.model, w, c);
  return dot(unit.force, detail::velocity_at(w, c.on, unit.point) - detail::velocity_at(w, c.from, unit.point)) +
         dot(unit.couple, angular_velocity(w, c.on) - angular_velocity(w, c.from));
}

// The state a time t later with accelerations a.
State<double> later(const Pair& pair, const std::vector<double>& a, double t) {
  State<double> moved = pair.state;
  std::vector<double> mean = moved.v;
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean[k] += 0.5 * t * a[k];
    moved.v[k] += t * a[k];
  }
  integrate_position<double>(pair.model, moved.q, mean, t);
  return moved;
}

TEST(VelocityConstraint, ItsRateChangesByTheRowAndTheBias) {
  Random random(41);
  for (int i = 0; i < 1000; ++i) {
    const Kind kind = static_cast<Kind>(random.integer(0, 3));
    Pair pair(random);
    pair.move(random);
    VelocityConstraint<double> c = random_constraint(random, kind);
    // Teeth of gears meet at a place of a third body, and an edge keeps its direction on its own.
    const auto any = [&] { return random.integer(0, 2) - 1; };
    if (kind == Kind::point) c.at.body = any();
    if (kind == Kind::point || kind == Kind::rolling) c.along.body = any();
    const std::vector<double> a = random.numbers(12, 2);
    const double t = 2e-6;
    const auto rate = [&](double ahead) {
      Workspace<double> w(pair.model);
      update_velocities(pair.model, w, later(pair, a, ahead));
      return rate_of(pair, w, c);
    };
    update_accelerations<double>(pair.model, pair.workspace, pair.state, a);
    const ConstraintLine<double> line = constraint_line(pair.model, pair.workspace, c);
    EXPECT_NEAR((rate(t) - rate(-t)) / (2 * t), line.bias, 1e-7 * (1 + std::abs(line.bias)))
        << "kind " << static_cast<int>(kind) << ", case " << i;
  }
}

TEST(VelocityConstraint, ItsGapChangesWithItsRateWhereItIsClosed) {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const Kind kind = static_cast<Kind>(random.integer(0, 3));
    Pair pair(random);
    VelocityConstraint<double> c = random_constraint(random, kind);
    std::optional<Vector> axis;
    if (kind == Kind::angular) {
      // Turned about a hinge's axis by any angle, on bodies whose axes were drawn alike.
      ModelBuilder<double> builder;
      const int first =
          builder.add_body("a", ground, Joint<double>::free(), SpatialTransform<double>::identity(), random.mass());
      builder.add_body("b", first, Joint<double>::free(), SpatialTransform<double>::identity(), random.mass());
      pair.model = builder.build();
      c.from = c.along.body = 0;
      axis = normalized(cross(c.along.vector, random.direction()));
      const double angle = random.uniform(-3.1, 3.1);
      pair.state.v = {0.3, -0.5, 0.7, 0, 0, 0, angle * axis->x, angle * axis->y, angle * axis->z, 0, 0, 0};
      integrate_position<double>(pair.model, pair.state.q, pair.state.v, 1.0);
      pair.state.v = random.numbers(12, 1.5);
    } else {
      pair.move(random);
      // A shift along the normal closes it.
      update_poses<double>(pair.model, pair.workspace, pair.state.q);
      const double gap = constraint_gap(pair.model, pair.workspace, c, axis);
      if (kind == Kind::cord_length)
        c.length += gap;
      else
        c.toward.point += gap * c.along.vector;
      if (kind == Kind::rolling && norm_squared(c.axis) > 0 && norm(cross(c.axis, c.along.vector)) < 0.1) continue;
    }
    update_velocities(pair.model, pair.workspace, pair.state);
    const double t = 2e-6;
    const auto gap = [&](double ahead) {
      Workspace<double> w(pair.model);
      update_velocities(pair.model, w, later(pair, std::vector<double>(12, 0.0), ahead));
      return constraint_gap(pair.model, w, c, axis);
    };
    EXPECT_NEAR(gap(0), 0, 1e-12);
    EXPECT_NEAR((gap(t) - gap(-t)) / (2 * t), rate_of(pair, pair.workspace, c), 1e-7)
        << "kind " << static_cast<int>(kind) << ", case " << i;
  }
}

TEST(VelocityConstraint, AHingeLeavesItsAxisFreeAndAWeldNone) {
  std::vector<VelocityConstraint<double>> constraints(4);
  for (VelocityConstraint<double>& c : constraints) {
    c.kind = Kind::angular;
    c.on = 1;
    c.from = 0;
  }
  constraints[0].along.vector = {1, 0, 0};
  constraints[1].along.vector = {0, 1, 0};
  constraints[2].kind = Kind::point;
  constraints[3].at.point = {1, 0, 0};  // of another joint
  const auto axis = axis_left_free(constraints, 0);
  ASSERT_TRUE(axis.has_value());
  EXPECT_EQ(std::abs(axis->z), 1);
  EXPECT_FALSE(axis_left_free(constraints, 3).has_value());
  constraints[3].at.point = {0, 0, 0};
  constraints[3].along.vector = {0, 0, 1};
  EXPECT_FALSE(axis_left_free(constraints, 0).has_value());
}

TEST(VelocityConstraint, GapsHaveDerivatives) {
  // How the gap of a rolling disk changes with its radius: by the sine of its axis to the normal.
  using D = Dual<1>;
  ModelBuilder<D> builder;
  builder.add_body("disk", ground, Joint<D>::free(), SpatialTransform<D>::identity(),
                   {D(1), Vector3<D>::zero(), SymmetricMatrix3<D>::diagonal(D(1), D(1), D(1))});
  const Model<D> model = builder.build();
  Workspace<D> workspace(model);
  State<D> state = neutral_state(model);
  update_velocities(model, workspace, state);
  VelocityConstraint<D> c;
  c.kind = Kind::rolling;
  c.on = 0;
  c.at.body = 0;
  c.toward = {ground, {D(0), D(0), D(-1)}};
  c.along = c.surface_axis = {ground, {D(0), D(0), D(1)}};
  c.axis = {D(0.8), D(0), D(0.6)};
  c.radius = D(0.5);
  c.radius.partial[0] = 1;
  const D gap = constraint_gap<D>(model, workspace, c, std::nullopt);
  EXPECT_NEAR(gap.value, 1 - 0.5 * 0.8, 1e-15);
  EXPECT_NEAR(gap.partial[0], -0.8, 1e-15);
}

}  // namespace velocity_constraint_test
}  // namespace poinsot
