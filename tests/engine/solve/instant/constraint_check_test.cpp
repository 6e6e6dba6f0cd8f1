#include "poinsot/engine/solve/instant/constraint_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poinsot::solve {
namespace constraint_check_test {

using Vector = Vector3<double>;
using Constraint = VelocityConstraint<double>;

const Vector x_axis{1.0, 0.0, 0.0}, y_axis{0.0, 1.0, 0.0}, z_axis{0.0, 0.0, 1.0};

// A crank of length a about z at the origin, a coupler of length b at its end, and a slider on the x axis that a pin
// joins to the coupler: x = a cos q + b cos(q + p) with a sin q + b sin(q + p) = 0.
struct SliderCrank {
  double a, b;
  std::vector<CheckLink> links;
  std::vector<Constraint> constraints;
  std::vector<double> q, v, acceleration;

  SliderCrank(double size, double crank, double rate, double quickening) : a(0.3 * size), b(0.8 * size) {
    links = {{JointType::revolute, -1, Vector::zero(), z_axis, 0, 0, 0},
             {JointType::revolute, 0, {a, 0.0, 0.0}, z_axis, 0, 1, 1},
             {JointType::prismatic, -1, {a + b, 0.0, 0.0}, x_axis, 0, 2, 2}};
    for (const Vector& d : {x_axis, y_axis}) {
      Constraint c;
      c.kind = VelocityConstraintKind::point;
      c.on = 2;
      c.from = 1;
      c.at = {2, Vector::zero()};
      c.toward = {1, {b, 0.0, 0.0}};
      c.along = {1, d};
      constraints.push_back(c);
    }
    // s = q + p is the coupler's angle: sin s = -(a/b) sin q.
    const double k = a / b, s = -std::asin(k * std::sin(crank));
    const double s1 = -k * std::cos(crank) * rate / std::cos(s);
    const double s2 =
        (-k * std::cos(crank) * quickening + k * std::sin(crank) * rate * rate + std::sin(s) * s1 * s1) / std::cos(s);
    const double x1 = -a * std::sin(crank) * rate - b * std::sin(s) * s1;
    const double x2 = -a * (std::sin(crank) * quickening + std::cos(crank) * rate * rate) -
                      b * (std::sin(s) * s2 + std::cos(s) * s1 * s1);
    q = {crank, s - crank, a * std::cos(crank) + b * std::cos(s) - (a + b)};
    v = {rate, s1 - rate, x1};
    acceleration = {quickening, s2 - quickening, x2};
  }
  double checked(double pace = 0) const {
    return check_constraints(links, constraints, {a + b, pace, true, {}}, q, v, acceleration);
  }
};

TEST(ConstraintCheck, ConfirmsALoopAtAnySizeAndPace) {
  for (const double size : {1e-9, 1e-3, 1.0, 1e9})
    for (const double rate : {1e-6, 1.0, 1e6}) {
      const SliderCrank machine(size, 0.7, rate, 0.4 * rate * rate);
      EXPECT_LT(machine.checked(), 1e-12) << size << " " << rate;
    }
}

TEST(ConstraintCheck, SeesALoopThatIsOpenOrComesApart) {
  for (const double size : {1e-9, 1.0, 1e9}) {
    const double part = 1e-6;
    SliderCrank open(size, 0.7, 2, 1), parting = open, leaving = open;
    open.q[2] += part * size;
    parting.v[2] += part * size;
    leaving.acceleration[2] += part * size;
    for (const SliderCrank* machine : {&open, &parting, &leaving}) {
      EXPECT_GT(machine->checked(), 1e-3 * part) << size;
      EXPECT_LT(machine->checked(), part) << size;
    }
  }
}

TEST(ConstraintCheck, DoesNotAskForAccelerationsThatAreNotKnown) {
  SliderCrank machine(1, 0.7, 2, 1);
  machine.acceleration[2] += 0.1;
  EXPECT_GT(machine.checked(), 1e-3);
  machine.acceleration = {0, 0, 0};
  EXPECT_LT(check_constraints(machine.links, machine.constraints, {1, 0, false, {}}, machine.q, machine.v,
                              machine.acceleration),
            1e-12);
}

TEST(ConstraintCheck, NumbersThatAreNoneDoNotPass) {
  SliderCrank machine(1, 0.7, 2, 1);
  machine.v[2] = std::nan("");
  EXPECT_FALSE(machine.checked() < 1e6);
}

// A free body with a ball-and-socket turn in its pose, by the quaternion (cos h, u sin h).
struct FreeBody {
  std::vector<CheckLink> links{{JointType::free, -1, Vector::zero(), z_axis, 0, 0, 0}};
  std::vector<double> q{1, 0, 0, 0, 0, 0, 0}, v = std::vector<double>(6), a = std::vector<double>(6);
};

// A ball of radius r at the lowest point of a bowl of radius R, which rolls there: the center goes round at R - r.
TEST(ConstraintCheck, ABallThatRollsInABowlAndOneThatDoesNot) {
  const double r = 0.4, R = 1.3, W = 3, quickens = 2, reach = R - r;
  FreeBody ball;
  std::vector<Constraint> constraints;
  CurvedContact<double> both;
  both.on.kind = both.from.kind = SurfaceKind::sphere;
  both.on.radius = r;
  both.from.radius = R;
  both.from.center = {0.0, 0.0, reach};
  both.from.inside = true;
  both.shape_on = both.on;
  both.shape_from = both.from;
  both.normal = z_axis;
  both.tangent = y_axis;
  for (const Vector& d : {z_axis, x_axis, y_axis}) {
    Constraint c;
    c.kind = VelocityConstraintKind::touching;
    c.action = 0;
    c.on = 0;
    c.from = ground;
    c.at = {0, {0.0, 0.0, -r}};
    c.toward = {ground, {0.0, 0.0, -r}};
    c.along = {ground, d};
    c.normal = d.z == 1;
    c.surfaces = std::make_shared<const CurvedContact<double>>(both);
    constraints.push_back(c);
  }
  const auto checked = [&] {
    return check_constraints(ball.links, constraints, {r, W, true, {}}, ball.q, ball.v, ball.a);
  };
  const double spin = reach * W / r;
  ball.v = {0, spin, 0, reach * W, 0, 0};
  const std::vector<double> right{0, reach * quickens / r, 0, reach * quickens, 0, reach * W * W + spin * reach * W};
  ball.a = right;
  EXPECT_LT(checked(), 1e-12);
  // On a plane its center would not rise.
  ball.a[5] = spin * reach * W;
  EXPECT_GT(checked(), 0.01);
  ball.a = right;
  ball.a[1] *= 1.001;
  EXPECT_GT(checked(), 1e-6);
  ball.a = right;
  ball.v[1] *= 1.001;
  EXPECT_GT(checked(), 1e-5);
  ball.v[1] = spin;
  ball.q[6] = 1e-5 * r;
  EXPECT_GT(checked(), 5e-6);
}

// A wheel of radius r about the y axis that rolls along x: its center goes with w r, and not otherwise.
TEST(ConstraintCheck, AWheelThatRollsAndOneThatSlips) {
  const double r = 0.4, w = 3;
  FreeBody wheel;
  std::vector<Constraint> constraints;
  for (const Vector& d : {z_axis, x_axis, y_axis}) {
    Constraint c;
    c.kind = VelocityConstraintKind::rolling;
    c.action = 0;
    c.on = 0;
    c.from = ground;
    c.at = {0, {0.0, 0.0, -r}};
    c.toward = {ground, {0.0, 0.0, -r}};
    c.along = {ground, d};
    c.normal = d.z == 1;
    c.center = Vector::zero();
    c.axis = y_axis;
    c.radius = r;
    c.surface_axis = {ground, z_axis};
    constraints.push_back(c);
  }
  const auto checked = [&] {
    return check_constraints(wheel.links, constraints, {r, w, true, {}}, wheel.q, wheel.v, wheel.a);
  };
  wheel.v = {0, w, 0, w * r, 0, 0};
  // The velocity of the center stands on the body's axes, which turn: its rate there is -w x v.
  wheel.a = {0, 0, 0, 0, 0, w * w * r};
  EXPECT_LT(checked(), 1e-12);
  // It speeds up: alpha r.
  wheel.a = {0, 2, 0, 2 * r, 0, w * w * r};
  EXPECT_LT(checked(), 1e-12);
  wheel.a[3] = 1.001 * 2 * r;
  EXPECT_GT(checked(), 1e-6);
  wheel.a = {0, 0, 0, 0, 0, w * w * r};
  wheel.v[3] = 1.001 * w * r;
  EXPECT_GT(checked(), 1e-5);
  // Raised from the plane, or sinking into it.
  wheel.v[3] = w * r;
  wheel.q[6] = 1e-5 * r;
  EXPECT_GT(checked(), 5e-6);
}

// A body at the end of a cord goes around on a sphere.
TEST(ConstraintCheck, ACordKeepsItsLengthUnlessItLetsGo) {
  const double l = 2, w = 1.5;
  FreeBody bob;
  Constraint cord;
  cord.kind = VelocityConstraintKind::cord_length;
  cord.action = 0;
  cord.on = 0;
  cord.from = ground;
  cord.at = {0, Vector::zero()};
  cord.toward = {ground, {l, 0.0, 0.0}};
  cord.length = l;
  bob.v = {0, 0, 0, 0, w * l, 0};
  bob.a = {0, 0, 0, w * w * l, 0, 0};
  const auto checked = [&](const ConstraintClaim& claim) {
    return check_constraints(bob.links, {cord}, claim, bob.q, bob.v, bob.a);
  };
  EXPECT_LT(checked({l, w, true, {}}), 1e-12);
  bob.v[3] = -0.1;
  EXPECT_GT(checked({l, w, true, {}}), 1e-3);
  // After a blow it may go slack, but not be longer than it is.
  EXPECT_LT(checked({l, w, true, {true}}), 1e-12);
  bob.q[4] = -1e-5;
  EXPECT_GT(checked({l, w, true, {true}}), 1e-6);
}

// A hinge about z that closes a loop keeps the axes together, and leaves turning about them.
TEST(ConstraintCheck, AnAxisThatTiltsIsSeen) {
  FreeBody body;
  std::vector<Constraint> hinge;
  for (const Vector& d : {x_axis, y_axis}) {
    Constraint c;
    c.kind = VelocityConstraintKind::angular;
    c.on = 0;
    c.from = ground;
    c.along = {ground, d};
    hinge.push_back(c);
  }
  const auto checked = [&] { return check_constraints(body.links, hinge, {1, 1, true, {}}, body.q, body.v, body.a); };
  const double half = 0.4;
  body.q = {std::cos(half), 0, 0, std::sin(half), 0, 0, 0};
  body.v = {0, 0, 2, 0, 0, 0};
  body.a = {0, 0, 1, 0, 0, 0};
  EXPECT_LT(checked(), 1e-12);
  body.v[0] = 1e-4;
  EXPECT_GT(checked(), 1e-5);
  body.v[0] = 0;
  body.q = {std::cos(1e-4), std::sin(1e-4), 0, 0, 0, 0, 0};
  EXPECT_NEAR(checked(), 2e-4, 1.5e-4);
  // With a third, not even turning about z is left.
  body.q = {1, 0, 0, 0, 0, 0, 0};
  EXPECT_LT(checked(), 1e-12);
  Constraint last = hinge.front();
  last.along.vector = z_axis;
  hinge.push_back(last);
  EXPECT_GT(checked(), 0.01);
}

}  // namespace constraint_check_test
}  // namespace poinsot::solve
