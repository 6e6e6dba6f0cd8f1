// Short arcs and sectors against sums over their points, taken from the middle of the arc.
#include "poinsot/engine/mass/lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "poinsot/engine/mass/plates.h"

namespace poinsot {
namespace lines_test {

// Mean squares of the distances from the centroid along the middle and across it, of the points at r (cos, sin) with
// the weight r^power; r up to 1.
std::pair<double, double> spread(double angle, int power) {
  // Gauss's rule of five points, in pieces.
  constexpr long double node[] = {0, 0.538469310105683091036314420700208805L, 0.906179845938663992797626878299392965L};
  constexpr long double weight[] = {0.568888888888888888888888888888888889L, 0.478628670499366468041291514835638193L,
                                    0.236926885056189087514264040719917362L};
  constexpr int pieces = 40;
  const auto mean = [&](auto f) {
    long double sum = 0;
    for (int piece = 0; piece < pieces; ++piece)
      for (int k = -2; k <= 2; ++k) {
        const long double x = ((k < 0 ? -node[-k] : node[k]) + 2 * piece + 1) / pieces - 1;
        sum += weight[std::abs(k)] * f(x * angle / 2) / (2 * pieces);
      }
    return sum;
  };
  // Along the middle, from the point in it: r cos - 1 = (r - 1) cos - 2 sin^2(phi/2), the radii's means in closed form.
  const long double r1 = power == 0 ? 1 : 2.0L / 3, r2 = power == 0 ? 1 : 0.5L;
  const long double across = r2 * mean([](long double phi) { return std::sin(phi) * std::sin(phi); });
  const auto sagitta = [](long double phi) { return 2 * std::sin(phi / 2) * std::sin(phi / 2); };
  const long double s = mean(sagitta);
  // Of the cosines, then of the radii: <r^2 cos^2> - <r>^2 <cos>^2.
  const long double spread_of_cosine = mean([&](long double phi) { return (sagitta(phi) - s) * (sagitta(phi) - s); });
  const long double along = r2 * spread_of_cosine + (r2 - r1 * r1) * (1 - s) * (1 - s);
  return {static_cast<double>(along), static_cast<double>(across)};
}

TEST(Lines, ShortArcsKeepTheirDigits) {
  const Vector3<double> center{0.3, -0.2, 0.5}, z{0, 0, 1};
  for (double angle = 6; angle > 1e-7; angle *= 0.6) {
    const auto [along, across] = spread(angle, 0);
    const Vector3<double> start{std::cos(angle / 2), -std::sin(angle / 2), 0};
    const ShapeProperties<double> arc = shapes::arc(center, z, start, 1.0, angle);
    // The middle is along x.
    EXPECT_NEAR(arc.inertia_center.xx, across, 1e-12 * across) << angle;
    EXPECT_NEAR(arc.inertia_center.zz, along + across, 1e-12 * across) << angle;
    const auto [deep, wide] = spread(angle, 1);
    const ShapeProperties<double> sector = shapes::sector(center, z, 1.0, Vector3<double>{1, 0, 0}, angle);
    EXPECT_NEAR(sector.inertia_center.xx, wide, 1e-12 * wide) << angle;
    EXPECT_NEAR(sector.inertia_center.yy, deep, 1e-12 * deep) << angle;
  }
}

// Its moment about the tangent is the fourth power of the angle.
TEST(Lines, TheDepthOfAnArcKeepsItsDigits) {
  for (double angle = 6; angle > 1e-3; angle *= 0.6)
    EXPECT_NEAR(shapes::detail::arc_depth(angle), spread(angle, 0).first, 3e-13 * spread(angle, 0).first) << angle;
}

}  // namespace lines_test
}  // namespace poinsot
