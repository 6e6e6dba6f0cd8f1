// Poses in which a loop could part are met to rounding, so that what is open there is open.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/solve/instant/linkage.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot::solve {
namespace singular_pose_test {

constexpr double pi = std::numbers::pi;

// A crank of length a drawn at right angles to the slider's line, a coupler of length b and a slider, all turned by an
// angle. Coordinates: crank, coupler, slider.
struct SliderCrank : Linkage {
  SliderCrank(double a, double b, double turned) {
    const Matrix3<double> R = rotation_about(Vector{0, 0, 1}, turned);
    const Vector z{0, 0, 1}, knee = R * Vector{0, a, 0}, end = R * Vector{std::sqrt(b * b - a * a), 0, 0};
    const int crank = add("crank", ground, Joint<double>::revolute(z), Vector::zero());
    const int coupler = add("coupler", crank, Joint<double>::revolute(z), knee);
    const int slider = add("slider", ground, Joint<double>::prismatic(R * Vector{1, 0, 0}), end);
    pin({slider, Vector::zero()}, {coupler, end - knee});
    drawn = std::sqrt(b * b - a * a);
  }
  double drawn = 0;
};

TEST(SingularPose, OfASliderCrankIsMetToRounding) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double a = 0.1 + unit(random), b = a * (1.2 + unit(random));
    const SliderCrank linkage(a, b, 6 * unit(random));
    const bool outer = i % 2 == 0;
    // The slider stated at its farthest, or nearest: how far the crank has turned is exact all the same.
    const double farthest = outer ? a + b - linkage.drawn : b - a - linkage.drawn;
    const Closure closure = close_pose(linkage.mechanism, {0, 0, farthest}, {false, false, true});
    EXPECT_LT(closure.gap, 1e-13);
    EXPECT_NEAR(std::remainder(closure.q[0] - (outer ? -pi / 2 : pi / 2), 2 * pi), 0, 1e-13) << i;
    const LinearSolution by_slider = linkage.with_rate(closure.q, 2, 0);
    EXPECT_EQ(by_slider.open.size(), 1U);
    EXPECT_FALSE(by_slider.determined(0));
    EXPECT_TRUE(by_slider.determined(2));
    const LinearSolution by_crank = linkage.with_rate(closure.q, 0, 3);
    EXPECT_TRUE(by_crank.open.empty());
    EXPECT_NEAR(by_crank.value[2], 0, 1e-13);
    // And the slider cannot move there.
    EXPECT_FALSE(linkage.with_rate(closure.q, 2, 1).conflict.empty());
  }
}

TEST(SingularPose, OfAParallelogramThatLiesFlatLeavesTheRockerOpen) {
  for (const double turned : {0.0, 0.3, 1.9}) {
    Linkage linkage;
    const Matrix3<double> R = rotation_about(Vector{0, 0, 1}, turned);
    const Vector z{0, 0, 1}, knee = R * Vector{0, 1, 0}, base = R * Vector{2, 0, 0};
    const int crank = linkage.add("crank", ground, Joint<double>::revolute(z), Vector::zero());
    const int coupler = linkage.add("coupler", crank, Joint<double>::revolute(z), knee);
    const int rocker = linkage.add("rocker", ground, Joint<double>::revolute(z), base);
    linkage.pin({rocker, knee}, {coupler, base});
    for (const double flat : {pi / 2, -pi / 2, 3 * pi / 2}) {
      const Closure closure = close_pose(linkage.mechanism, {flat, 0, 0}, {true, false, false});
      const LinearSolution solution = linkage.with_rate(closure.q, 0, 3);
      EXPECT_EQ(solution.open.size(), 1U) << turned << " " << flat;
      EXPECT_FALSE(solution.determined(2));
    }
    // Beside it the rocker goes as the crank does.
    for (const double beside : {1e-3, -1e-2, 0.1}) {
      const Closure closure = close_pose(linkage.mechanism, {pi / 2 + beside, 0, 0}, {true, false, false});
      EXPECT_NEAR(closure.q[2], pi / 2 + beside, 1e-9);
      const LinearSolution solution = linkage.with_rate(closure.q, 0, 3);
      EXPECT_TRUE(solution.open.empty());
      EXPECT_NEAR(solution.value[2], 3, 1e-6);
    }
  }
}

// Near its end, but not at it, the crank stands where the triangle says.
TEST(SingularPose, ThatIsNotReachedIsNotTaken) {
  const double a = 0.4, b = 1.1;
  const SliderCrank linkage(a, b, 0.7);
  for (const double short_of : {1e-10, 1e-8, 1e-6, 1e-3}) {
    const double reach = a + b - short_of;
    const Closure closure = close_pose(linkage.mechanism, {0, 0, reach - linkage.drawn}, {false, false, true});
    // 1 - cos of the crank's angle with the slider's line, without cancellation.
    const double versine = short_of * (2 * b - short_of) / (2 * a * reach);
    const double angle = 2 * std::asin(std::sqrt(versine / 2));
    EXPECT_NEAR(pi / 2 + closure.q[0], angle, 1e-14 / angle + 1e-6 * angle) << short_of;
  }
}

}  // namespace singular_pose_test
}  // namespace poinsot::solve
