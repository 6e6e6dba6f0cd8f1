// Shapes and compositions on exact scalars: the formulas of the tables.
#include <gtest/gtest.h>

#include "math/formula_reader.h"
#include "poinsot/mass/composition.h"
#include "poinsot/mass/shapes.h"
#include "poinsot/math/expression.h"
#include "poinsot/math/expression_text.h"
#include "poinsot/math/rotation.h"

namespace poinsot {
namespace {

using Vector = Vector3<Expression>;

const Expression m = Expression::letter("m", Sign::positive);
const Expression r = Expression::letter("r", Sign::positive);
const Expression R = Expression::letter("R", Sign::positive);
const Expression L = Expression::letter("L", Sign::positive);
const Expression h = Expression::letter("h", Sign::positive);
const Expression b = Expression::letter("b", Sign::real);

const Vector origin = Vector::zero();
const Vector up{0, 0, 1};

TEST(ExpressionShapes, HaveTheFormulasOfTheTables) {
  const auto cylinder = of_mass(shapes::cylinder<Expression>(origin, L * up, r), m);
  EXPECT_EQ(text(cylinder.inertia_center.xx), "m*(L^2 + 3*r^2)/12");
  EXPECT_EQ(text(cylinder.inertia_center.zz), "m*r^2/2");
  EXPECT_EQ(text(cylinder.center.z), "L/2");

  const auto cone = of_mass(shapes::cone<Expression>(origin, h * up, r), m);
  EXPECT_EQ(text(cone.inertia_center.xx), "3*m*(h^2 + 4*r^2)/80");
  EXPECT_EQ(text(cone.inertia_center.zz), "3*m*r^2/10");

  EXPECT_EQ(text(of_mass(shapes::sphere<Expression>(origin, r), m).inertia_center.xx), "2*m*r^2/5");
  EXPECT_EQ(text(of_mass(shapes::hemisphere<Expression>(origin, up, r), m).inertia_center.xx), "83*m*r^2/320");
  EXPECT_EQ(text(of_mass(shapes::rod<Expression>(origin, L * up), m).inertia_center.xx), "L^2*m/12");
  const auto tube = of_mass(shapes::tube<Expression>(origin, L * up, R, r), m);
  EXPECT_EQ(text(tube.inertia_center.zz), "m*(R^2 + r^2)/2");
  const auto torus = of_mass(shapes::torus<Expression>(origin, up, R, r), m);
  EXPECT_EQ(text(torus.inertia_center.zz), "m*(R^2 + 3*r^2/4)");
  EXPECT_EQ(text(shapes::torus<Expression>(origin, up, R, r).measure), "2*pi^2*R*r^2");
  EXPECT_EQ(text(shapes::sphere<Expression>(origin, r).measure), "4*pi*r^3/3");
  EXPECT_EQ(text(shapes::semicircle<Expression>(-r * up, r * up, Vector{1, 0, 0}).center.x), "4*r/(3*pi)");
  const auto cube = of_mass(shapes::cube_from_diagonal<Expression>(origin, L * up), m);
  EXPECT_EQ(text(cube.inertia_center.xy), "0");
  EXPECT_EQ(text(cube.inertia_center.zz), "L^2*m/18");
}

TEST(ExpressionShapes, MoveByTheTheoremOfParallelAxes) {
  const auto disk = of_mass(shapes::disk<Expression>(origin, up, r), m);
  EXPECT_EQ(text(moment_about_axis(disk, Vector{r, 0, 0}, up)), "3*m*r^2/2");
  EXPECT_EQ(text(moment_about_axis(disk, Vector{0, 0, h}, Vector{1, 0, 0})), "m*(h^2 + r^2/4)");
  EXPECT_EQ(text(moment_about_axis(disk, origin, Vector{0, sin(b), cos(b)})), "m*r^2*(cos(b)^2 + 1)/4");
}

TEST(ExpressionShapes, TurnByTheAngle) {
  const auto rod = of_mass(shapes::rod<Expression>(origin, L * up), m);
  const auto turned_rod = transformed(rotation_about(Vector{1, 0, 0}, b), origin, rod);
  EXPECT_EQ(text(turned_rod.inertia_center.yy), "L^2*m*cos(b)^2/12");
  EXPECT_EQ(text(turned_rod.inertia_center.zz), "L^2*m*sin(b)^2/12");
  EXPECT_EQ(text(turned_rod.inertia_center.yz), "L^2*m*sin(2*b)/24");
  // The same from its ends.
  const auto stated = of_mass(shapes::rod<Expression>(origin, L * Vector{0, -sin(b), cos(b)}), m);
  EXPECT_EQ(stated.inertia_center.yz, turned_rod.inertia_center.yz);
  EXPECT_EQ(stated.center.y, turned_rod.center.y);
}

// A plate of two halves is the plate, in whatever order they are added.
TEST(ExpressionShapes, AddUp) {
  const auto plate = [](const Expression& from, const Expression& to) {
    const Vector center{(from + to) / 2, 0, 0};
    return shapes::rectangle<Expression>(center, Vector{to - from, 0, 0}, Vector{0, h, 0});
  };
  const auto whole = united<Expression>({plate(0, r + L)});
  const auto halves = united<Expression>({plate(r, r + L), plate(0, r)});
  EXPECT_EQ(halves.measure, whole.measure);
  EXPECT_EQ(halves.center.x, whole.center.x);
  EXPECT_EQ(text(of_mass(halves, m).inertia_center.zz), "m*((L + r)^2 + h^2)/12");
}

}  // namespace
}  // namespace poinsot
