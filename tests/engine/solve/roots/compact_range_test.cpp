#include "engine/solve/roots/compact_range.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/solve/roots/roots_problems.h"

namespace poinsot::solve {
namespace compact_range_test {

const RootRange ranges[] = {{-3, 5, 2}, {4, infinity, 2}, {-infinity, 4, 2}, {-infinity, infinity, 2}};

TEST(CompactRange, ItsEndsAreThoseOfTheRangeOrTheReach) {
  constexpr double reach = 1e6;
  for (const RootRange& range : ranges) {
    const CompactRange compact(range, reach);
    const double lower = compact.u(compact.lower()), upper = compact.u(compact.upper());
    if (std::isfinite(range.lower))
      EXPECT_DOUBLE_EQ(lower, range.lower / range.scale);
    else
      EXPECT_NEAR(lower, -reach, 3);
    if (std::isfinite(range.upper))
      EXPECT_DOUBLE_EQ(upper, range.upper / range.scale);
    else
      EXPECT_NEAR(upper, reach, 3);
    EXPECT_EQ(compact.infinite(), !(std::isfinite(range.lower) && std::isfinite(range.upper)));
  }
}

TEST(CompactRange, TheSlopeIsThatOfDifferences) {
  for (const RootRange& range : ranges) {
    const CompactRange compact(range, 1e6);
    for (const double t : {-0.9, -0.3, 0.1, 0.8})
      EXPECT_NEAR(compact.slope(t), (compact.u(t + 1e-6) - compact.u(t - 1e-6)) / 2e-6, 1e-6 * compact.slope(t));
  }
}

TEST(CompactRange, TheWeightTurnsGrowthIntoAFiniteLimit) {
  for (const RootRange& range : ranges) {
    CompactRange compact(range, 1e6);
    if (!compact.infinite()) continue;
    compact.set_growth(3);
    for (const bool up : {true, false}) {
      const double end = up ? compact.upper() : compact.lower();
      if (std::abs(compact.u(end)) < 1e3) continue;
      const double weighted = std::pow(std::abs(compact.u(end)), 3) * compact.weight(end);
      EXPECT_NEAR(weighted, 1, 1e-4);
    }
  }
}

}  // namespace compact_range_test
}  // namespace poinsot::solve
