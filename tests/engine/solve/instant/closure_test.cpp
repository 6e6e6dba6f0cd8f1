#include "poinsot/engine/solve/instant/closure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/motion/mechanism/random_mechanisms.h"
#include "engine/solve/instant/linkage.h"

namespace poinsot::solve {
namespace closure_test {

// A crank of length a on the origin, a coupler of length b, and a slider on the x axis: x = a cos q + sqrt(b^2 - a^2
// sin^2 q).
Mechanism<double> slider_crank(double a, double b) {
  Linkage linkage;
  const Vector z{0.0, 0.0, 1.0};
  const int crank = linkage.add("crank", ground, Joint<double>::revolute(z), Vector::zero());
  const int coupler = linkage.add("coupler", crank, Joint<double>::revolute(z), {a, 0.0, 0.0});
  const int slider = linkage.add("slider", ground, Joint<double>::prismatic({1.0, 0.0, 0.0}), {a + b, 0.0, 0.0});
  linkage.pin({slider, Vector::zero()}, {coupler, {b, 0.0, 0.0}});
  return linkage.mechanism;
}

TEST(Closure, ASliderCrankFollowsItsCrank) {
  for (const double q : {-2.5, -1.0, 0.01, 0.7, 1.5707963, 2.9}) {
    const double a = 0.3, b = 0.8;
    const Closure closure = close_pose(slider_crank(a, b), {q, 0.0, 0.0}, {true, false, false});
    EXPECT_LT(closure.gap, 1e-12);
    EXPECT_EQ(closure.q[0], q);
    EXPECT_NEAR(closure.q[2], a * std::cos(q) + std::sqrt(b * b - std::pow(a * std::sin(q), 2)) - (a + b), 1e-9);
  }
}

// A parallelogram lies flat on its way, where it could go over into its crossed form: it goes on as it went.
TEST(Closure, AParallelogramPassesItsFlatPose) {
  Linkage linkage;
  const Vector z{0.0, 0.0, 1.0};
  const double a = 1.0, d = 2.0;
  const int crank = linkage.add("crank", ground, Joint<double>::revolute(z), Vector::zero());
  const int coupler = linkage.add("coupler", crank, Joint<double>::revolute(z), {0.0, a, 0.0});
  const int rocker = linkage.add("rocker", ground, Joint<double>::revolute(z), {d, 0.0, 0.0});
  linkage.pin({rocker, {0.0, a, 0.0}}, {coupler, {d, 0.0, 0.0}});
  for (const double q : {0.5, 1.5, 1.7, 2.1, 3.0, 4.0, -2.0, -3.0}) {
    const Closure closure = close_pose(linkage.mechanism, {q, 0.0, 0.0}, {true, false, false});
    EXPECT_LT(closure.gap, 1e-14) << q;
    EXPECT_NEAR(closure.q[1], -q, 1e-10) << q;
    EXPECT_NEAR(closure.q[2], q, 1e-10) << q;
  }
}

TEST(Closure, AnImpossiblePoseKeepsItsGapAndNamesTheConstraint) {
  const Mechanism<double> impossible = slider_crank(0.8, 0.3);
  const Closure closure = close_pose(impossible, {1.5, 0.0, 0.0}, {true, false, false});
  EXPECT_GT(closure.gap, 1e-3);
  ASSERT_LT(closure.constraint, impossible.constraints.size());
  EXPECT_EQ(impossible.constraints[closure.constraint].words, "pin");
}

TEST(Closure, TheDrawnPoseIsKeptWhenNothingMoves) {
  const Closure closure = close_pose(slider_crank(0.3, 0.8), {0.0, 0.0, 0.0}, {true, false, false});
  EXPECT_EQ(closure.gap, 0);
  EXPECT_EQ(closure.q, (std::vector<double>{0, 0, 0}));
}

TEST(Closure, AHingeThatClosesALoopMayTurnFar) {
  // A body on a ball joint at the end of a crank; its hinge keeps its axis on a block that does not turn.
  const Vector axis = normalized(Vector{1, 1, 0.3});
  const MassProperties<double> none{};
  for (const double q : {0.5, 1.9, 2.2, 2.6, 3.0, 5.0}) {
    poinsot::testing::MechanismMaker maker;
    const int crank = maker.add_body(ground, Joint<double>::revolute(axis), Vector::zero(), none);
    const int rod = maker.add_body(crank, Joint<double>::ball(), {0.3, 0, 0}, none);
    const int block = maker.add_body(ground, Joint<double>::free(), {0.5, 0, 0}, none);
    maker.finish_tree(Vector::zero());
    maker.close_loop(rod, block, {0.5, 0, 0}, axis);
    for (std::size_t k = 0; k < 3; ++k)
      maker.mechanism.constraints.push_back(
          maker.constraint(VelocityConstraintKind::angular, -1, block, ground, {0.5, 0, 0}, Vector::unit(k)));
    std::vector<double> target(12, 0.0);
    std::vector<bool> given(12, false);
    target[0] = q;
    target[1] = target[5] = 1;
    given[0] = true;
    EXPECT_LT(close_pose(maker.mechanism, target, given).gap, 1e-12) << q;
  }
}

}  // namespace closure_test
}  // namespace poinsot::solve
