// More contacts than needed: refused only where no distribution of the load does without pull.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "problem/course/motion_support.h"

namespace poinsot::problem {
namespace one_sided_shares_test {

// A box of a kilogram, 1 m x 0.6 m on four corners, with a load at (x, z) pushing down with the force F.
std::string box(double F, double x, double z, const std::string& asks, const std::string& mass = "1 kg") {
  const auto text = [](double value) { return std::to_string(value); };
  return "points: {O: [0, 0, 0], P: [1 m, 0.5 m, 0.6 m]}\nbodies: {box: {box: {corners: [O, P]}, mass: " + mass +
         "}}\ncontacts:\n  A: {of: box, at: [0, 0, 0], normal: y}\n  B: {of: box, at: [1 m, 0, 0], normal: y}\n"
         "  C: {of: box, at: [1 m, 0, 0.6 m], normal: y}\n  D: {of: box, at: [0, 0, 0.6 m], normal: y}\n"
         "loads: {push: {force: [0, -(" +
         text(F) + " N), 0], at: ['" + text(x) + " m', 0.5 m, '" + text(z) +
         " m'], body: box}}\ngravity: -y\ninstants: {now: rest}\nask: {" + asks + "}\n";
}

// The resultant of weight and load goes through the base, or the box tips: that is all that decides.
TEST(OneSidedShares, ABoxStandsWhileTheResultantMeetsItsBase) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> along(-0.8, 1.8), across(-0.5, 1.1);
  const double F = 30, W = 9.80665;
  int stands = 0;
  constexpr int cases = 60;
  for (int n = 0; n < cases; ++n) {
    const double x = along(random), z = across(random);
    const double px = (W * 0.5 + F * x) / (W + F), pz = (W * 0.3 + F * z) / (W + F);
    const double inside = std::min({px, 1 - px, pz, 0.6 - pz});
    if (std::abs(inside) < 1e-3) continue;
    SolvedText solved(box(F, x, z, "a: acceleration(box), right: force(B on box).y + force(C on box).y"));
    if (inside > 0) {
      ++stands;
      EXPECT_NEAR(norm(solved.vector("a")), 0, 1e-9) << x << " " << z;
      EXPECT_NEAR(solved.number("right"), px * (W + F), 1e-4) << x << " " << z;
    } else {
      EXPECT_NE(solved.reason("a").find("would have to pull"), std::string::npos) << x << " " << z;
    }
  }
  EXPECT_GT(stands, 15);
  EXPECT_LT(stands, cases - 15);
}

// Of a load over an edge, or a corner, the corners beyond carry nothing: the shares are determined.
TEST(OneSidedShares, ALoadOverAnEdgeIsDividedInOneWay) {
  SolvedText edge(box(5000, 1, 0.2, "A: force(A on box).y, B: force(B on box).y, C: force(C on box).y", "1e-12 kg"));
  EXPECT_NEAR(edge.number("A"), 0, 1e-6);
  EXPECT_NEAR(edge.number("B"), 5000 * 2. / 3, 1e-6);
  EXPECT_NEAR(edge.number("C"), 5000 / 3., 1e-6);
  SolvedText inner(box(5, 0.7, 0.4, "A: force(A on box).y, all: touching(A)"));
  EXPECT_NE(inner.reason("A").find("share the same load"), std::string::npos);
}

}  // namespace one_sided_shares_test
}  // namespace poinsot::problem
