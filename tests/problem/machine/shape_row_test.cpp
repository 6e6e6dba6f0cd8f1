// The table of shapes: every shape of the language has a row, and its round surface is where the shape says it is.
#include "problem/machine/shape_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "problem/keys/keys.h"

namespace poinsot::problem {
namespace shape_row_test {

using Vector = Vector3<double>;

TEST(ShapeRow, EveryShapeOfTheLanguageHasOne) {
  std::vector<std::string> kinds = keys_of("shape");
  for (const char* by_arguments : {"closed_cylinder_shell", "annular_sector", "thick_sector"})
    kinds.emplace_back(by_arguments);
  for (const std::string& kind : kinds) {
    const ShapeRow<double>& row = shape_row<double>(kind);
    EXPECT_NE(row.values, nullptr) << kind;
    EXPECT_NE(row.picture, nullptr) << kind;
    EXPECT_FALSE(row.words.empty()) << kind;
    // What has no corners and is curved in no unknown way must have a surface on which it rolls.
    EXPECT_TRUE(row.other != OtherSurface::none || row.round) << kind;
    EXPECT_FALSE(row.other == OtherSurface::none && row.sides) << kind;
  }
}

TEST(ShapeRow, OneThatIsMissingIsNamed) {
  try {
    shape_row<double>("egg");
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "the shape 'egg' is a key and has no row in its table");
  }
}

RollingSurface<double> touched(const RoundSurface<double>& surface, const Vector& p_OC, const Vector& n) {
  const auto found = std::visit([&](const auto& round) { return round.touched_at(p_OC, n); }, surface);
  EXPECT_TRUE(found);
  return found.value_or(RollingSurface<double>{});
}

TEST(RoundSurface, GapIsTheDistanceFromTheSurface) {
  const Vector C{1, 2, 3}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_NEAR(touched(SphereSurface<double>{C, 2}, C + 2.5 * x, x).gap, 0.5, 1e-15);
  EXPECT_NEAR(touched(CircleSurface<double>{C, z, 2}, C + 2.0 * y + 0.3 * z, y).gap, 0.3, 1e-15);
  EXPECT_NEAR(touched(HemisphereSurface<double>{C, z, 2}, C - 0.5 * z + 2.0 * x, x).gap, 0.5, 1e-15);
  const RollingSurface<double> middle = touched(FrustumSurface<double>{C, 1, C + 4.0 * z, 3}, C + 2.0 * z + 2.0 * x, x);
  EXPECT_NEAR(middle.radius, 2, 1e-15);
  EXPECT_NEAR(middle.gap, 0, 1e-15);
  EXPECT_NEAR(norm(middle.center - (C + 2.0 * z)), 0, 1e-15);
}

TEST(RoundSurface, RimOfAHemisphereIsACircleUnlessTheNormalIsThatOfTheSphere) {
  const Vector C{0, 0, 0}, x{1, 0, 0}, z{0, 0, 1};
  const HemisphereSurface<double> half{C, z, 2};
  EXPECT_EQ(norm(touched(half, 2.0 * x, x).axis), 0);
  EXPECT_EQ(norm(touched(half, 2.0 * x, z).axis), 1);
}

TEST(RoundSurface, ArcEndsAtItsHalfAngle) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const ArcSurface<double> quarter{{0, 0, 0}, z, 1, x, 0.8};
  EXPECT_TRUE(quarter.touched_at(std::cos(0.7) * x + std::sin(0.7) * y, x));
  EXPECT_FALSE(quarter.touched_at(std::cos(0.9) * x + std::sin(0.9) * y, x));
  const Vector end = std::cos(0.8) * x + std::sin(0.8) * y;
  EXPECT_TRUE(quarter.touched_at(end, end));
  EXPECT_FALSE(quarter.touched_at(end, x));
}

TEST(RoundSurface, HalfACylinderEndsAtItsFlatFace) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const HalfCylinderSurface<double> half{{{0, 0, 0}, 1, 2.0 * z, 1}, y};
  const auto below = half.touched_at(y + 0.5 * z, y);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->gap, 0, 1e-15);
  EXPECT_NEAR(norm(below->center - 0.5 * z), 0, 1e-15);
  EXPECT_EQ(below->cosine, 0);
  EXPECT_FALSE(half.touched_at(std::cos(0.1) * x - std::sin(0.1) * y + z, x));
  EXPECT_TRUE(half.touched_at(x + z, x));
  EXPECT_FALSE(half.touched_at(x + z, y));
}

}  // namespace shape_row_test
}  // namespace poinsot::problem
