// Shapes that become other shapes, shapes cut and put together again, and values printed in tables of textbooks.
#include <numbers>

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace shape_limits_test {

using testing::near;
using testing::Random;
using Vector = Vector3<double>;
constexpr double pi_value = std::numbers::pi;

constexpr int cases = 200;

TEST(ShapeLimits, SpecialCasesAreOtherShapes) {
  Random<double> r(1);
  for (int i = 0; i < cases; ++i) {
    const Vector C = r.point();
    const Vector n = r.direction();
    const Vector d = r.across(n);
    const Vector E = r.point_apart_from(C);
    const double R = r.length();
    EXPECT_TRUE(near(shapes::sector(C, n, R, d, 2 * pi_value), shapes::disk(C, n, R), 1e-13));
    EXPECT_TRUE(near(shapes::arc(C, n, d, R, 2 * pi_value), shapes::ring(C, n, R), 1e-13));
    const double part = r.between(0.1, 6), inner = R * r.between(0, 0.95), thick = r.length();
    EXPECT_TRUE(near(shapes::annular_sector(C, n, R, 0.0, d, part), shapes::sector(C, n, R, d, part), 1e-13));
    EXPECT_TRUE(near(shapes::annular_sector(C, n, R, inner, d, 2 * pi_value), shapes::annulus(C, n, R, inner), 1e-13));
    // A narrow one is an arc, to the square of its width, of which nothing cancels.
    const Vector along = normalized(perpendicular_part(d, normalized(n))), beside = cross(normalized(n), along);
    const Vector start = std::cos(part / 2) * along - std::sin(part / 2) * beside;
    EXPECT_TRUE(near(of_mass(shapes::annular_sector(C, n, R * (1 + 1e-9), R * (1 - 1e-9), d, part), 1.0),
                     of_mass(shapes::arc(C, n, start, R, part), 1.0), 1e-12));
    const Vector up = 0.5 * thick * normalized(n);
    EXPECT_TRUE(near(shapes::thick_sector(C, n, R, inner, d, 2 * pi_value, thick),
                     shapes::tube(Vector(C - up), Vector(C + up), R, inner), 1e-13));
    EXPECT_TRUE(near(shapes::thick_sector(C, n, R, 0.0, d, pi_value, thick),
                     shapes::half_cylinder(Vector(C - up), Vector(C + up), R, d), 1e-13));
    EXPECT_TRUE(near(shapes::annulus(C, n, R, 0.0), shapes::disk(C, n, R), 1e-14));
    EXPECT_TRUE(near(shapes::tube(C, E, R, 0.0), shapes::cylinder(C, E, R), 1e-14));
    EXPECT_TRUE(near(shapes::frustum(C, R, E, R), shapes::cylinder(C, E, R), 1e-13));
    EXPECT_TRUE(near(shapes::frustum(C, 0.0, E, R), shapes::cone(C, E, R), 1e-13));
    EXPECT_TRUE(near(shapes::frustum(C, R, E, 0.0), shapes::cone(E, C, R), 1e-13));

    // A quarter turn either side of the middle: the half disk and the half circle on the diameter across it.
    const Vector middle = normalized(perpendicular_part(d, normalized(n)));
    const Vector side = R * normalized(cross(n, middle));
    EXPECT_TRUE(near(shapes::sector(C, n, R, d, pi_value),
                     shapes::semicircle(Vector(C + side), Vector(C - side), middle), 1e-13));
    EXPECT_TRUE(near(shapes::arc(C, n, Vector(-side), R, pi_value),
                     shapes::semicircular_arc(Vector(C + side), Vector(C - side), middle), 1e-13));

    const auto axes = r.axes();
    const auto edge = [&](std::size_t k) { return Vector(R * axes.column(k)); };
    EXPECT_TRUE(near(shapes::ellipsoid(C, edge(0), edge(1), edge(2)), shapes::sphere(C, R), 1e-13));
    EXPECT_TRUE(near(shapes::box(C, edge(0), edge(1), edge(2)), shapes::cube(C, R), 1e-13));
    const Vector diagonal = edge(0) + edge(1) + edge(2);
    EXPECT_TRUE(near(shapes::cube_from_diagonal(C, Vector(C + diagonal)),
                     shapes::box_between(C, Vector(C + diagonal), axes), 1e-13));
    EXPECT_TRUE(near(shapes::polygon<double>({C, C + edge(0), C + edge(0) + edge(1), C + edge(1)}),
                     shapes::rectangle_from_corners(Vector(C + edge(0)), C, Vector(C + edge(1))), 1e-13));
  }
}

TEST(ShapeLimits, ThinShapesTendToSheetsAndLines) {
  // Errors are of the order of the thickness t, or of its square where the sheet is in the middle.
  const Vector C{0.5, -1, 2};
  const Vector n{1, 2, -2};
  const Vector E = C + n;
  const double R = 1.3;
  const double t = 1e-6;
  const double squared = 1e-10;
  EXPECT_TRUE(near(of_mass(shapes::annulus(C, n, R + t, R - t), 1.0), of_mass(shapes::ring(C, n, R), 1.0), squared));
  EXPECT_TRUE(near(of_mass(shapes::torus(C, n, R, t), 1.0), of_mass(shapes::ring(C, n, R), 1.0), squared));
  EXPECT_TRUE(
      near(of_mass(shapes::tube(C, E, R + t, R - t), 1.0), of_mass(shapes::cylinder_shell(C, E, R), 1.0), squared));
  EXPECT_TRUE(near(of_mass(shapes::cylinder(C, E, t), 1.0), of_mass(shapes::rod(C, E), 1.0), squared));
  EXPECT_TRUE(near(of_mass(shapes::cylinder_shell(C, E, t), 1.0), of_mass(shapes::rod(C, E), 1.0), squared));
  const Vector thin = t * n;
  EXPECT_TRUE(near(of_mass(shapes::cylinder(Vector(C - thin), Vector(C + thin), R), 1.0),
                   of_mass(shapes::disk(C, n, R), 1.0), squared));
  // Here the wall's share of the area is of the order of t, so that it must be much thinner.
  const Vector O = Vector::zero();
  EXPECT_TRUE(near(of_mass(shapes::closed_cylinder_shell(Vector(-t * thin), Vector(t * thin), R), 1.0),
                   of_mass(shapes::disk(O, n, R), 1.0), squared));
  EXPECT_TRUE(
      near(of_mass(shapes::cone_shell(Vector(-t * thin), O, R), 1.0), of_mass(shapes::disk(O, n, R), 1.0), squared));

  // A circle of large radius is straight: 1 mm of height in 1 m. Moments of short arcs lose digits by cancellation.
  const double angle = 1e-3;
  const auto arc = shapes::arc(Vector::zero(), Vector::unit(2), Vector::unit(0), 1 / angle, angle);
  const auto chord = shapes::rod(Vector{1 / angle, 0, 0}, Vector{std::cos(angle) / angle, std::sin(angle) / angle, 0});
  EXPECT_NEAR(arc.measure, chord.measure, 1e-6);
  EXPECT_TRUE(near(arc.inertia_center, chord.inertia_center, 1e-6));
}

TEST(ShapeLimits, ShellsAreDifferencesOfSolids) {
  const double t = 1e-5;
  const Vector C{1, 2, 3};
  const Vector n{1, -1, 0.5};
  const double R = 0.8;
  const auto difference = [](const ShapeProperties<double>& outer, const ShapeProperties<double>& inner) {
    const auto shell = sum<double>({of_density(outer, 1.0), of_density(inner, -1.0)});
    return scaled(1 / shell.mass, shell);
  };
  EXPECT_TRUE(near(difference(shapes::sphere(C, R + t), shapes::sphere(C, R - t)),
                   of_mass(shapes::sphere_shell(C, R), 1.0), 1e-8));
  EXPECT_TRUE(near(difference(shapes::hemisphere(C, n, R + t), shapes::hemisphere(C, n, R - t)),
                   of_mass(shapes::hemisphere_shell(C, n, R), 1.0), 1e-8));
  const auto box = [&](double grown) {
    return shapes::box(C, Vector{0.7 + grown, 0, 0}, Vector{0, 1.1 + grown, 0}, Vector{0, 0, 1.6 + grown});
  };
  EXPECT_TRUE(near(difference(box(t), box(-t)),
                   of_mass(shapes::box_shell(C, Vector{0.7, 0, 0}, Vector{0, 1.1, 0}, Vector{0, 0, 1.6}), 1.0), 1e-8));
  const auto cylinder = [&](double grown) {
    return shapes::cylinder(Vector(C - (1 + grown) * Vector::unit(2)), Vector(C + (1 + grown) * Vector::unit(2)),
                            R + grown);
  };
  EXPECT_TRUE(near(
      difference(cylinder(t), cylinder(-t)),
      of_mass(shapes::closed_cylinder_shell(Vector(C - Vector::unit(2)), Vector(C + Vector::unit(2)), R), 1.0), 1e-8));
}

TEST(ShapeLimits, CutShapesAddUp) {
  Random<double> r(2);
  const double density = 2.5;
  const auto joined = [&](std::initializer_list<ShapeProperties<double>> parts) {
    std::vector<MassProperties<double>> bodies;
    for (const auto& part : parts) bodies.push_back(of_density(part, density));
    return sum(bodies);
  };
  for (int i = 0; i < cases; ++i) {
    const Vector A = r.point();
    const Vector B = r.point_apart_from(A);
    const double s = r.between(0.1, 0.9);
    const Vector M = A + s * (B - A);
    const double R = r.length();
    const Vector n = B - A;
    EXPECT_TRUE(near(joined({shapes::rod(A, M), shapes::rod(M, B)}), of_density(shapes::rod(A, B), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::rod(A, M), shapes::rod(M, B)}),
                     of_density(shapes::polyline<double>({A, M, B}), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::cylinder(A, M, R), shapes::cylinder(M, B, R)}),
                     of_density(shapes::cylinder(A, B, R), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::cone(A, M, s * R), shapes::frustum(M, s * R, B, R)}),
                     of_density(shapes::cone(A, B, R), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::hemisphere(A, n, R), shapes::hemisphere(A, Vector(-n), R)}),
                     of_density(shapes::sphere(A, R), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::hemisphere_shell(A, n, R), shapes::hemisphere_shell(A, Vector(-n), R)}),
                     of_density(shapes::sphere_shell(A, R), density), 1e-12));
    EXPECT_TRUE(near(joined({shapes::cylinder_shell(A, B, R), shapes::disk(A, n, R), shapes::disk(B, n, R)}),
                     of_density(shapes::closed_cylinder_shell(A, B, R), density), 1e-12));

    // A hole is a part of negative mass.
    const auto disk = of_density(shapes::disk(A, n, R), density);
    const auto hole = of_density(shapes::disk(A, n, s * R), -density);
    EXPECT_TRUE(near(sum<double>({disk, hole}), of_density(shapes::annulus(A, n, R, s * R), density), 1e-11));

    // Wire and plate by three sectors of unequal width.
    const Vector u = normalized(perpendicular_part(r.across(n), normalized(n)));
    const Vector v = cross(normalized(n), u);
    const auto at = [&](double angle) { return Vector(std::cos(angle) * u + std::sin(angle) * v); };
    const double a = r.between(0.5, 2);
    const double b = r.between(0.5, 2);
    const double c = 2 * pi_value - a - b;
    EXPECT_TRUE(near(joined({shapes::sector(A, n, R, at(a / 2), a), shapes::sector(A, n, R, at(a + b / 2), b),
                             shapes::sector(A, n, R, at(a + b + c / 2), c)}),
                     disk, 1e-12));
    EXPECT_TRUE(
        near(joined({shapes::arc(A, n, u, R, a), shapes::arc(A, n, at(a), R, b), shapes::arc(A, n, at(a + b), R, c)}),
             of_density(shapes::ring(A, n, R), density), 1e-12));

    // A tetrahedron cut by a plane through one edge, a triangle by a line through one corner.
    const Vector C = A + r.across(n);
    const Vector D = A + cross(B - A, C - A) + 0.3 * (C - A);
    EXPECT_TRUE(near(joined({shapes::tetrahedron(A, M, C, D), shapes::tetrahedron(M, B, C, D)}),
                     of_density(shapes::tetrahedron(A, B, C, D), density), 1e-11));
    EXPECT_TRUE(near(joined({shapes::triangle(A, M, C), shapes::triangle(M, B, C)}),
                     of_density(shapes::triangle(A, B, C), density), 1e-12));
  }
}

TEST(ShapeLimits, PolygonDoesNotDependOnFirstVertexOrSense) {
  const std::vector<Vector> outline{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {3, 3, 1},
                                    {3, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};
  const auto plate = shapes::polygon(outline);
  EXPECT_NEAR(plate.measure, 8, 1e-14);
  std::vector<Vector> turned = outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    EXPECT_TRUE(near(shapes::polygon(turned), plate, 1e-13));
    const std::vector<Vector> reversed(turned.rbegin(), turned.rend());
    EXPECT_TRUE(near(shapes::polygon(reversed), plate, 1e-13));
  }
  // A U of three rectangles.
  const auto u = sum<double>({of_density(shapes::rectangle(Vector{2, 0.5, 1}, Vector{4, 0, 0}, Vector{0, 1, 0}), 1.0),
                              of_density(shapes::rectangle(Vector{0.5, 2, 1}, Vector{1, 0, 0}, Vector{0, 2, 0}), 1.0),
                              of_density(shapes::rectangle(Vector{3.5, 2, 1}, Vector{1, 0, 0}, Vector{0, 2, 0}), 1.0)});
  EXPECT_TRUE(near(of_density(plate, 1.0), u, 1e-13));
}

// Moments as printed in tables, on simple axes: mass 3, sizes 2 and so on.
TEST(ShapeTables, MomentsOfCommonShapes) {
  const Vector O = Vector::zero();
  const Vector z = Vector::unit(2);
  const auto expect_moments = [](const ShapeProperties<double>& shape, double x, double y, double zz) {
    EXPECT_NEAR(shape.inertia_center.xx, x, 1e-14);
    EXPECT_NEAR(shape.inertia_center.yy, y, 1e-14);
    EXPECT_NEAR(shape.inertia_center.zz, zz, 1e-14);
    EXPECT_NEAR(shape.inertia_center.xy, 0, 1e-14);
    EXPECT_NEAR(shape.inertia_center.yz, 0, 1e-14);
    EXPECT_NEAR(shape.inertia_center.zx, 0, 1e-14);
  };
  expect_moments(shapes::rod(O, Vector{0, 0, 6}), 3, 3, 0);
  expect_moments(shapes::rectangle(O, Vector{2, 0, 0}, Vector{0, 4, 0}), 4.0 / 3, 1.0 / 3, 5.0 / 3);
  expect_moments(shapes::box(O, Vector{2, 0, 0}, Vector{0, 4, 0}, Vector{0, 0, 6}), 52.0 / 12, 40.0 / 12, 20.0 / 12);
  expect_moments(shapes::disk(O, z, 2.0), 1, 1, 2);
  expect_moments(shapes::cylinder(O, Vector{0, 0, 6}, 2.0), 4, 4, 2);
  expect_moments(shapes::sphere(O, 5.0), 10, 10, 10);
  expect_moments(shapes::sphere_shell(O, 3.0), 6, 6, 6);
  expect_moments(shapes::cone(O, Vector{0, 0, 4}, 2.0), 0.6 + 0.6, 0.6 + 0.6, 1.2);
  expect_moments(shapes::torus(O, z, 2.0, 1.0), 2.625, 2.625, 4.75);
  expect_moments(shapes::ring(O, z, 2.0), 2, 2, 4);
  // A right triangle with legs b, h along x and y: h^2/18, b^2/18 and I_xy = -bh/36.
  const auto triangle = shapes::triangle(O, Vector{6, 0, 0}, Vector{0, 3, 0});
  EXPECT_NEAR(triangle.inertia_center.xx, 0.5, 1e-14);
  EXPECT_NEAR(triangle.inertia_center.yy, 2, 1e-14);
  EXPECT_NEAR(products_of_inertia(triangle.inertia_center).xy, -0.5, 1e-14);
  EXPECT_TRUE(near(shapes::semicircle(Vector{-1, 0, 0}, Vector{1, 0, 0}, Vector{3, 1, 0}).center,
                   Vector{0, 4 / (3 * pi_value), 0}, 1e-15));
  EXPECT_TRUE(near(shapes::hemisphere(O, z, 8.0).center, Vector{0, 0, 3}, 1e-15));
  EXPECT_TRUE(near(shapes::cone(O, z, 1.0).center, Vector{0, 0, 0.75}, 1e-15));
  EXPECT_TRUE(near(shapes::cone_shell(O, z, 1.0).center, Vector{0, 0, 2.0 / 3}, 1e-15));
}

}  // namespace shape_limits_test
}  // namespace poinsot
