// Blows at rough contacts against closed forms, a published law and steps of the push.
#include "poinsot/engine/solve/instant/rough_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poinsot::solve {
namespace rough_impact_test {

using Vector = Vector3<double>;
using Course = RoughImpactCourse;
constexpr double still = 1e-12;

// A random positive definite matrix, and a velocity of approach.
struct Case {
  Matrix3<double> W;
  Vector before;
  double friction = 0, restitution = 0;
};
Case random_case(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> part(-1, 1);
  Matrix3<double> A;
  for (std::size_t i = 0; i < 3; ++i) A.row(i) = {part(engine), part(engine), part(engine)};
  Case one{transpose(A) * A,
           {-1 - part(engine) / 2, part(engine), part(engine)},
           0.6 + part(engine) / 2,
           0.5 + part(engine) / 2};
  for (std::size_t i = 0; i < 3; ++i) one.W(i, i) += 0.2;
  return one;
}

double energy_change(const Case& one, const Course& course) {
  return dot(course.impulse, one.before) + 0.5 * dot(course.impulse, one.W * course.impulse);
}

TEST(RoughImpact, OfASphereSlidesOrGrips) {
  const Matrix3<double> sphere{{2, 0, 0}, {0, 7, 0}, {0, 0, 7}};  // of mass 1/2: 1/m and 7/(2 m)
  for (const double friction : {0.05, 0.5}) {
    const Vector before{-3, 1.2, -0.9};
    const Course course = follow_rough_impact(sphere, before, {0.6, friction}, still);
    ASSERT_EQ(course.end, Course::End::found);
    const double push = 1.6 * 3 / 2, slip = 1.5, grips = slip / 7;
    EXPECT_NEAR(course.impulse.x, push, 1e-13);
    const double rubbed = std::min(friction * push, grips);
    EXPECT_NEAR(course.impulse.y, -0.8 * rubbed, 1e-13);
    EXPECT_NEAR(course.impulse.z, 0.6 * rubbed, 1e-13);
    EXPECT_EQ(course.stretches.back().sticks, friction * push > grips);
  }
}

// Routh's line of impulses of a planar blow bends where the slip vanishes: Stronge, Impact Mechanics, sec. 3.4.
TEST(RoughImpact, OfARodSlipsBack) {
  const double n = 2.5, t = 1.9, c = 1.2, mu = 0.2, e = 0.7;
  const Matrix3<double> W{{n, c, 0}, {c, t, 0}, {0, 0, 1}};
  const Vector before{-1, -0.3, 0};  // at first the friction is along +y
  const double stop = 0.3 / (c + mu * t), v = -1 + (n + mu * c) * stop, f = n - mu * c;
  ASSERT_LT(v, 0);
  const double compression = stop - v / f;
  const double work = 0.5 * (v - 1) * stop - 0.5 * v * v / f;
  const double rest = std::sqrt(2 * e * e * -work / f);
  const Course course = follow_rough_impact(W, before, {e, mu}, still);
  ASSERT_EQ(course.stretches.size(), 2u);
  EXPECT_FALSE(course.stretches.back().sticks);
  EXPECT_NEAR(course.compression, compression, 1e-13);
  EXPECT_NEAR(course.impulse.x, compression + rest, 1e-12);
  EXPECT_NEAR(course.impulse.y, mu * stop - mu * (course.impulse.x - stop), 1e-12);
  const Course poisson = follow_rough_impact(W, before, {e, mu, RestitutionLaw::poisson}, still);
  EXPECT_NEAR(poisson.impulse.x, (1 + e) * compression, 1e-12);
  const Course newton = follow_rough_impact(W, before, {e, mu, RestitutionLaw::newton}, still);
  EXPECT_NEAR(newton.velocity.x, e, 1e-12);
}

TEST(RoughImpact, HoldsItsLawsWhereTheSlipTurns) {
  std::mt19937_64 engine(7);
  int turned = 0, stuck = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Case one = random_case(engine);
    const Course course = follow_rough_impact(one.W, one.before, {one.restitution, one.friction}, still);
    if (course.end != Course::End::found) continue;
    turned += course.stretches.front().turned > 0.1;
    stuck += course.stretches.back().sticks;
    EXPECT_LT(norm(course.velocity - (one.before + one.W * course.impulse)), 1e-12 * norm(course.impulse) * 10);
    EXPECT_LE(std::hypot(course.impulse.y, course.impulse.z), one.friction * course.impulse.x * (1 + 1e-12));
    EXPECT_NEAR(course.work_in_restitution, -one.restitution * one.restitution * course.work_in_compression,
                1e-12 * -course.work_in_compression);
    EXPECT_LT(energy_change(one, course), 0);
    // Friction never gives energy: what is gained is at most what the push gives.
    EXPECT_LE(energy_change(one, course), course.work_in_compression + course.work_in_restitution + 1e-12);
  }
  EXPECT_GT(turned, 100);
  EXPECT_GT(stuck, 20);
}

// Small steps of the push in each of which the friction opposes the slip before it.
TEST(RoughImpact, IsWhatSmallStepsTell) {
  std::mt19937_64 engine(11);
  int compared = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Case one = random_case(engine);
    const Course course = follow_rough_impact(one.W, one.before, {0, one.friction}, still);
    if (course.end != Course::End::found || course.stretches.size() > 1) continue;
    const double dp = course.compression / 100'000;
    Vector u = one.before, P{};
    while (u.x < 0) {
      const double speed = std::hypot(u.y, u.z);
      const Vector step{dp, -one.friction * dp * u.y / speed, -one.friction * dp * u.z / speed};
      P += step;
      u += one.W * step;
    }
    ++compared;
    EXPECT_LT(norm(P - course.impulse), 1e-3 * norm(P));
  }
  EXPECT_GT(compared, 5);
}

TEST(RoughImpact, WedgesWhereFrictionHoldsWhatIsHinged) {
  // The point of a hinged bar moves along one line only.
  const Matrix3<double> W{{0.25, 0.35, 0}, {0.35, 0.49, 0}, {0, 0, 0}};
  const Vector before{-0.5, -0.7, 0};
  EXPECT_EQ(follow_rough_impact(W, before, {0.6, 0.9}, still).end, Course::End::wedged);
  const Course plastic = follow_rough_impact(W, before, {0, 0.9}, still);
  EXPECT_EQ(plastic.end, Course::End::found);
  EXPECT_LT(norm(plastic.velocity), 1e-12);
  const Course free = follow_rough_impact(W, before, {0.6, 0.2}, still);
  EXPECT_EQ(free.end, Course::End::found);
  EXPECT_NEAR(free.velocity.y / free.velocity.x, 1.4, 1e-9);
}

TEST(RoughImpact, RaisesTheEnergyByNewtonsHypothesisOnly) {
  std::mt19937_64 engine(23);
  int raised = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Case one = random_case(engine);
    one.restitution = 1;
    const Course newton = follow_rough_impact(one.W, one.before, {1, one.friction, RestitutionLaw::newton}, still);
    if (newton.end != Course::End::found) continue;
    raised += energy_change(one, newton) > 1e-9;
    const Course energetic = follow_rough_impact(one.W, one.before, {1, one.friction}, still);
    EXPECT_LE(energy_change(one, energetic), 1e-12);
  }
  EXPECT_GT(raised, 1);
}

}  // namespace rough_impact_test
}  // namespace poinsot::solve
