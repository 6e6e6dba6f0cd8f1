// Shapes and compositions on exact scalars: the formulas of the tables.
#include <gtest/gtest.h>

#include "engine/math/formula/formula_reader.h"
#include "poinsot/engine/mass/composition.h"
#include "poinsot/engine/mass/shapes.h"
#include "poinsot/engine/math/algebra/rotation.h"
#include "poinsot/engine/math/formula/formula.h"
#include "poinsot/engine/math/formula/formula_text.h"

namespace poinsot {
namespace formula_shapes_test {

using Vector = Vector3<Formula>;

const Formula m = Formula::letter("m", Sign::positive);
const Formula r = Formula::letter("r", Sign::positive);
const Formula R = Formula::letter("R", Sign::positive);
const Formula L = Formula::letter("L", Sign::positive);
const Formula h = Formula::letter("h", Sign::positive);
const Formula b = Formula::letter("b", Sign::real);

const Vector origin = Vector::zero();
const Vector up{0, 0, 1};

TEST(FormulaShapes, HaveTheFormulasOfTheTables) {
  const auto cylinder = of_mass(shapes::cylinder<Formula>(origin, L * up, r), m);
  EXPECT_EQ(text(cylinder.inertia_center.xx), "m*(L^2 + 3*r^2)/12");
  EXPECT_EQ(text(cylinder.inertia_center.zz), "m*r^2/2");
  EXPECT_EQ(text(cylinder.center.z), "L/2");

  const auto cone = of_mass(shapes::cone<Formula>(origin, h * up, r), m);
  EXPECT_EQ(text(cone.inertia_center.xx), "3*m*(h^2 + 4*r^2)/80");
  EXPECT_EQ(text(cone.inertia_center.zz), "3*m*r^2/10");

  EXPECT_EQ(text(of_mass(shapes::sphere<Formula>(origin, r), m).inertia_center.xx), "2*m*r^2/5");
  EXPECT_EQ(text(of_mass(shapes::hemisphere<Formula>(origin, up, r), m).inertia_center.xx), "83*m*r^2/320");
  EXPECT_EQ(text(of_mass(shapes::rod<Formula>(origin, L * up), m).inertia_center.xx), "m*L^2/12");
  const auto tube = of_mass(shapes::tube<Formula>(origin, L * up, R, r), m);
  EXPECT_EQ(text(tube.inertia_center.zz), "m*(R^2 + r^2)/2");
  const auto torus = of_mass(shapes::torus<Formula>(origin, up, R, r), m);
  EXPECT_EQ(text(torus.inertia_center.zz), "m*(R^2 + 3*r^2/4)");
  EXPECT_EQ(text(shapes::torus<Formula>(origin, up, R, r).measure), "2*pi^2*R*r^2");
  EXPECT_EQ(text(shapes::sphere<Formula>(origin, r).measure), "4*pi*r^3/3");
  EXPECT_EQ(text(shapes::semicircle<Formula>(-r * up, r * up, Vector{1, 0, 0}).center.x), "4*r/(3*pi)");
  const auto cube = of_mass(shapes::cube_from_diagonal<Formula>(origin, L * up), m);
  EXPECT_EQ(text(cube.inertia_center.xy), "0");
  EXPECT_EQ(text(cube.inertia_center.zz), "m*L^2/18");
}

TEST(FormulaShapes, MoveByTheTheoremOfParallelAxes) {
  const auto disk = of_mass(shapes::disk<Formula>(origin, up, r), m);
  EXPECT_EQ(text(moment_about_axis(disk, Vector{r, 0, 0}, up)), "3*m*r^2/2");
  EXPECT_EQ(text(moment_about_axis(disk, Vector{0, 0, h}, Vector{1, 0, 0})), "m*(h^2 + r^2/4)");
  EXPECT_EQ(text(moment_about_axis(disk, origin, Vector{0, sin(b), cos(b)})), "m*r^2*(cos(b)^2 + 1)/4");
}

TEST(FormulaShapes, TurnByTheAngle) {
  const auto rod = of_mass(shapes::rod<Formula>(origin, L * up), m);
  const auto turned_rod = transformed(rotation_about(Vector{1, 0, 0}, b), origin, rod);
  EXPECT_EQ(text(turned_rod.inertia_center.yy), "m*L^2*cos(b)^2/12");
  EXPECT_EQ(text(turned_rod.inertia_center.zz), "m*L^2*sin(b)^2/12");
  EXPECT_EQ(text(turned_rod.inertia_center.yz), "m*L^2*sin(2*b)/24");
  // The same from its ends.
  const auto stated = of_mass(shapes::rod<Formula>(origin, L * Vector{0, -sin(b), cos(b)}), m);
  EXPECT_EQ(stated.inertia_center.yz, turned_rod.inertia_center.yz);
  EXPECT_EQ(stated.center.y, turned_rod.center.y);
}

// A plate of two halves is the plate, in whatever order they are added.
TEST(FormulaShapes, AddUp) {
  const auto plate = [](const Formula& from, const Formula& to) {
    const Vector center{(from + to) / 2, 0, 0};
    return shapes::rectangle<Formula>(center, Vector{to - from, 0, 0}, Vector{0, h, 0});
  };
  const auto whole = united<Formula>({plate(0, r + L)});
  const auto halves = united<Formula>({plate(r, r + L), plate(0, r)});
  EXPECT_EQ(halves.measure, whole.measure);
  EXPECT_EQ(halves.center.x, whole.center.x);
  EXPECT_EQ(text(of_mass(halves, m).inertia_center.zz), "m*((L + r)^2 + h^2)/12");
}

}  // namespace formula_shapes_test
}  // namespace poinsot
