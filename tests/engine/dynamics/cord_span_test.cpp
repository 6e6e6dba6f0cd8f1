#include "poinsot/engine/dynamics/cord_span.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/dynamics/random_trees.h"
#include "poinsot/engine/dynamics/velocity_constraint.h"

namespace poinsot {
namespace cord_span_test {

using testing::Random;
using Vector = Vector3<double>;

// Three bodies that move in space, or in the plane across z: each on two slides and a hinge.
struct Bodies {
  std::vector<int> body;
  Model<double> model;
  Workspace<double> workspace;
  State<double> state;

  Bodies(Random& random, bool planar)
      : model(made(random, planar, body)), workspace(model), state(neutral_state(model)) {}

  static Model<double> made(Random& random, bool planar, std::vector<int>& body) {
    ModelBuilder<double> builder;
    const SpatialTransform<double> here = SpatialTransform<double>::identity();
    for (int i = 0; i < 3; ++i) {
      const std::string name(1, static_cast<char>('a' + i));
      if (!planar) {
        body.push_back(builder.add_body(name, ground, Joint<double>::free(), random.pose(), random.mass()));
        continue;
      }
      const int x =
          builder.add_body(name + "x", ground, Joint<double>::prismatic(Vector::unit(0)), here, random.mass());
      const int y = builder.add_body(name + "y", x, Joint<double>::prismatic(Vector::unit(1)), here, random.mass());
      body.push_back(builder.add_body(name, y, Joint<double>::revolute(Vector::unit(2)), here, random.mass()));
    }
    return builder.build();
  }
  std::size_t size() const { return static_cast<std::size_t>(model.velocity_size()); }

  State<double> later(const std::vector<double>& a, double t) const {
    State<double> moved = state;
    std::vector<double> mean = moved.v;
    for (std::size_t k = 0; k < a.size(); ++k) {
      mean[k] += 0.5 * t * a[k];
      moved.v[k] += t * a[k];
    }
    integrate_position<double>(model, moved.q, mean, t);
    return moved;
  }
};

// A cord from a point of the first body over a wheel of the second to a point of the third.
VelocityConstraint<double> led_cord(const Bodies& bodies, Random& random, const Vector& axis) {
  const auto end = [&](int i, double reach) {
    return CordEnd<double>{{bodies.body[static_cast<std::size_t>(i)], Vector::zero()}, reach};
  };
  const double reach = random.uniform(0.2, 0.6) * (random.chance(0.5) ? 1 : -1);
  const Direction<double> e{bodies.body[1], axis};
  VelocityConstraint<double> c;
  c.kind = VelocityConstraintKind::led_cord;
  c.on = bodies.body[1];
  c.from = bodies.body[0];
  c.spans = {{end(0, 0), end(1, reach), e}, {end(1, reach), end(2, 0), e}};
  c.keeps_length = true;
  return c;
}

double rate_of(const Bodies& bodies, const Workspace<double>& w, const VelocityConstraint<double>& c) {
  double rate = 0;
  for_each_unit_force(
      bodies.model, w, c, constraint_force(bodies.model, w, c),
      [&](int on, int from, const PlacedForce<double>& unit) { rate += power_between(w, on, from, unit); });
  return rate;
}

// Centers far enough from each other for every wheel.
bool apart(const Bodies& bodies, const Workspace<double>& w, const Vector& axis) {
  const auto center = [&](std::size_t i) { return point_position(bodies.model, w, bodies.body[i], Vector::zero()); };
  const Vector e = direction_on_ground(bodies.model, w, bodies.body[1], axis);
  for (const std::size_t i : {0, 2}) {
    const Vector D = center(i) - center(1);
    if (norm(Vector(D - dot(D, e) * e)) < 0.8) return false;
  }
  return true;
}

TEST(CordSpan, TouchesItsWheelsAlongTangents) {
  Random random(51);
  int tried = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector e = random.direction(), A = random.vector(3), out = random.direction();
    const Vector B = A + 3.0 * normalized(Vector(out - dot(out, e) * e));
    const double a = random.uniform(-1.4, 1.4), b = random.uniform(-1.4, 1.4);
    if (std::abs(dot(out, e)) > 0.99) continue;
    const SpanLine<double> line = line_between(A, B, e, a, b);
    // Both radii stand across the cord, have their lengths, and lie on the sides of their signs.
    EXPECT_NEAR(norm(Vector(line.end - line.start - line.length * line.along)), 0, 1e-12);
    for (const auto& [P, C, reach] : {std::tuple{line.start, A, a}, std::tuple{line.end, B, b}}) {
      EXPECT_NEAR(dot(P - C, line.along), 0, 1e-12);
      EXPECT_NEAR(dot(P - C, cross(e, line.along)), reach, 1e-12);
      EXPECT_NEAR(dot(P - C, e), 0, 1e-12);
    }
    ++tried;
  }
  EXPECT_GT(tried, 1500);
}

TEST(CordSpan, ItsRateChangesByTheRowAndTheBias) {
  Random random(52);
  int tried = 0;
  for (int i = 0; i < 600; ++i) {
    Bodies bodies(random, false);
    const Vector axis = random.direction();
    const VelocityConstraint<double> c = led_cord(bodies, random, axis);
    integrate_position<double>(bodies.model, bodies.state.q, random.numbers(18, 2), 1.0);
    bodies.state.v = random.numbers(18, 1.5);
    const std::vector<double> a = random.numbers(18, 2);
    update_accelerations<double>(bodies.model, bodies.workspace, bodies.state, a);
    if (!apart(bodies, bodies.workspace, axis)) continue;
    ++tried;
    const double t = 2e-6;
    const auto rate = [&](double ahead) {
      Workspace<double> w(bodies.model);
      update_velocities(bodies.model, w, bodies.later(a, ahead));
      return rate_of(bodies, w, c);
    };
    const ConstraintLine<double> line = constraint_line(bodies.model, bodies.workspace, c);
    EXPECT_NEAR((rate(t) - rate(-t)) / (2 * t), line.bias, 1e-6 * (1 + std::abs(line.bias))) << "case " << i;
  }
  EXPECT_GT(tried, 100);
}

// In its plane a cord grows as its ends go apart and as the wheel takes up less of it, however the wheel spins.
TEST(CordSpan, ItsLengthChangesWithItsRateHoweverTheWheelTurns) {
  Random random(53);
  int tried = 0;
  for (int i = 0; i < 600; ++i) {
    Bodies bodies(random, true);
    const Vector axis = random.chance(0.5) ? Vector::unit(2) : Vector(-Vector::unit(2));
    VelocityConstraint<double> c = led_cord(bodies, random, axis);
    integrate_position<double>(bodies.model, bodies.state.q, random.numbers(static_cast<int>(bodies.size()), 2), 1.0);
    bodies.state.v = random.numbers(static_cast<int>(bodies.size()), 1.5);
    update_velocities(bodies.model, bodies.workspace, bodies.state);
    if (!apart(bodies, bodies.workspace, axis)) continue;
    ++tried;
    const SpanLine<double> one = line_of(bodies.model, bodies.workspace, c.spans[0]),
                           other = line_of(bodies.model, bodies.workspace, c.spans[1]);
    c.length = one.length + other.length;
    c.spans[1].turn_cosine = dot(one.along, other.along);
    c.spans[1].turn_sine = dot(axis, cross(one.along, other.along));
    const double t = 2e-6;
    const auto gap = [&](double ahead) {
      Workspace<double> w(bodies.model);
      update_velocities(bodies.model, w, bodies.later(std::vector<double>(bodies.size(), 0.0), ahead));
      return constraint_gap(bodies.model, w, c, std::optional<Vector>());
    };
    EXPECT_NEAR(gap(0), 0, 1e-12);
    EXPECT_NEAR((gap(t) - gap(-t)) / (2 * t), rate_of(bodies, bodies.workspace, c), 1e-6) << "case " << i;
    // The wheel's own turning about its center takes nothing.
    State<double> spun = bodies.state;
    spun.v.assign(bodies.size(), 0);
    spun.v[5] = 3;
    update_velocities(bodies.model, bodies.workspace, spun);
    EXPECT_NEAR(rate_of(bodies, bodies.workspace, c), 0, 1e-12);
  }
  EXPECT_GT(tried, 100);
}

// Over a wheel of radius r from (-r, -a) to (r, -b): a and b straight, and half a turn on the wheel. Drawn with a wheel
// of other arms it is measured from there.
TEST(CordSpan, LengthOverAWheelIsThatOfItsStraightPartsAndItsArc) {
  const double r = 0.3, a = 1.2, b = 0.7;
  const Vector e = Vector::unit(2);
  const SpanLine<double> up = line_between<double>({-r, -a, 0}, {0, 0, 0}, e, 0, r),
                         down = line_between<double>({0, 0, 0}, {r, -b, 0}, e, r, 0);
  EXPECT_NEAR(up.length, a, 1e-15);
  EXPECT_NEAR(down.length, b, 1e-15);
  EXPECT_NEAR(dot(e, cross(up.along, down.along)), 0, 1e-15);
  EXPECT_NEAR(norm(Vector(up.end - Vector{-r, 0, 0})), 0, 1e-15);
}

}  // namespace cord_span_test
}  // namespace poinsot
