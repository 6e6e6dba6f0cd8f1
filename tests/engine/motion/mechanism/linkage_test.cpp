// Linkages whose loops repeat their constraints, and such that lie flat on the way.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/motion/mechanism/sample_mechanisms.h"
#include "poinsot/engine/motion/integrator/integrate.h"
#include "poinsot/engine/motion/mechanism/mechanism_equations.h"

namespace poinsot::testing {
namespace linkage_test {

using std::numbers::pi;

// What a motion has met at the ends of its steps.
struct Followed {
  IntegrationResult result;
  double gap = 0, rate = 0;
};

Followed follow(MechanismDynamics& dynamics, const State<double>& start, double end) {
  const MotionEquations equations = mechanism_equations(dynamics);
  IntegrationOptions options;
  options.tolerance = 1e-10;
  options.most_steps = 20'000;
  Followed followed;
  followed.result = integrate(equations, 0, start.q, start.v, end, options);
  const Trajectory& path = followed.result.trajectory;
  for (std::size_t i = 1; i < path.step_count(); ++i) {
    const State<double> at = path.state(path.step(i).start);
    followed.gap = std::max(followed.gap, dynamics.largest_gap(at.q));
    followed.rate = std::max(followed.rate, dynamics.largest_rate(at.q, at.v));
  }
  return followed;
}

// Opposite bars are equal. Twice in a turn all lie on one line, where it could go on crossed.
TEST(Linkage, AParallelogramPassesItsFlatPose) {
  Random random(5);
  int turned = 0;
  for (int i = 0; i < 40; ++i) {
    FourBar bars;
    bars.a = bars.c = random.uniform(0.2, 0.6);
    bars.b = bars.d = random.uniform(0.7, 1.2);
    if (i % 4 == 0) std::swap(bars.a, bars.b), std::swap(bars.c, bars.d);
    bars.crank_angle = random.uniform(0.4, 2.5);
    bars.R = random.rotation();
    bars.hinge = i % 2 == 1;
    MechanismDynamics dynamics(bars.mechanism());
    State<double> start = neutral_state(dynamics.mechanism().tree);
    start.v[0] = random.uniform(10, 20);
    dynamics.project(start.q, start.v);
    const Followed followed = follow(dynamics, start, 3);
    const IntegrationResult& result = followed.result;
    ASSERT_TRUE(result.complete()) << describe(result);
    // It never goes over to the crossed form: the coupler keeps its attitude, and the rocker turns as the crank.
    EXPECT_NEAR(result.q[0] + result.q[1], 0, 1e-6);
    EXPECT_NEAR(std::remainder(result.q[0] - result.q[2], 2 * pi), 0, 1e-6);
    EXPECT_LT(followed.gap, 1e-7);
    const double energy = dynamics.kinetic_energy(start.q, start.v);
    EXPECT_LT(result.drift[0].largest, 1e-5 * energy);
    turned += std::abs(result.q[0]) > 2 * pi;
  }
  EXPECT_GT(turned, 30);
}

TEST(Linkage, WhatIsDrawnFlatSaysSo) {
  FourBar bars;
  bars.a = bars.c = 0.3;
  bars.b = bars.d = 0.8;
  bars.crank_angle = 0;
  MechanismDynamics dynamics(bars.mechanism());
  EXPECT_EQ(follow(dynamics, {{0, 0, 0}, {1, -1, 1}}, 1).result.ending, Ending::singular_pose);
}

// Bennett's linkage: four skew hinges, bars of lengths a, b, a, b and twists alpha, beta with a sin(beta) = b
// sin(alpha). Only because of that does it move: three of the five constraints that close it are redundant.
TEST(Linkage, BennettsLinkageStaysClosedAndKeepsItsEnergy) {
  Random random(9);
  for (int i = 0; i < 10; ++i) {
    const double alpha = random.uniform(0.4, 0.9), beta = random.uniform(1.1, 1.5);
    const double a = random.uniform(0.3, 0.6), b = a * std::sin(beta) / std::sin(alpha);
    const double first = random.uniform(0.7, 2.2);
    const double second =
        2 * std::atan(std::sin((alpha + beta) / 2) / std::sin((beta - alpha) / 2) / std::tan(first / 2));
    // Hinge after hinge: turned about z, then along x by the length and about x by the twist.
    Vector place[5] = {};
    Matrix3<double> axes[5] = {random.rotation()};
    const double angle[] = {first, second, -first, -second};
    for (std::size_t k = 0; k < 4; ++k) {
      const Matrix3<double> turned = axes[k] * rotation_about(Vector{0, 0, 1}, angle[k]);
      place[k + 1] = place[k] + (k % 2 == 0 ? a : b) * (turned * Vector{1, 0, 0});
      axes[k + 1] = turned * rotation_about(Vector{1, 0, 0}, k % 2 == 0 ? alpha : beta);
    }
    ASSERT_LT(norm(place[4] - place[0]), 1e-14);
    ASSERT_LT(norm((axes[4] - axes[0]) * Vector{1, 2, 3}), 1e-14);

    MechanismMaker maker;
    int body = ground;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector bar = place[k + 1] - place[k];
      const MassProperties<double> mass{
          1, 0.5 * bar, (1.0 / 12) * unit_mass_inertia(bar) + SymmetricMatrix3<double>::diagonal(0.01, 0.01, 0.01)};
      body = maker.add_body(body, about(axes[k].column(2)), k == 0 ? place[0] : Vector(place[k] - place[k - 1]), mass);
    }
    maker.finish_tree(random.vector(2));
    maker.close_loop(body, ground, place[3], axes[3].column(2));
    MechanismDynamics dynamics(maker.mechanism);
    EXPECT_EQ(dynamics.redundant_constraints().size(), 3U);
    State<double> start = neutral_state(dynamics.mechanism().tree);
    start.v[0] = 15;
    dynamics.project(start.q, start.v);
    const Followed followed = follow(dynamics, start, 5);
    const IntegrationResult& result = followed.result;
    ASSERT_EQ(result.ending, Ending::reached_end) << describe(result);
    EXPECT_GT(std::abs(result.q[0]), 2 * pi);
    EXPECT_LT(followed.gap, 1e-12);
    EXPECT_LT(followed.rate, 1e-10);
    EXPECT_LT(result.drift[0].largest, 1e-7 * dynamics.kinetic_energy(start.q, start.v));
    // The law of the linkage, up to the turns.
    const double tangents = std::tan((first + result.q[0]) / 2) * std::tan((second + result.q[1]) / 2);
    EXPECT_NEAR(tangents, std::sin((alpha + beta) / 2) / std::sin((beta - alpha) / 2), 1e-7);
  }
}

}  // namespace linkage_test
}  // namespace poinsot::testing
