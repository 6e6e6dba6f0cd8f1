// Every rule for the data of shapes, and that proper shapes break none.
#include "poinsot/engine/mass/shape_faults.h"

#include <limits>
#include <numbers>

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace shape_faults_test {

using shape_faults::Fault;
using shape_faults::ShapeRule;
using testing::Random;
using Vector = Vector3<double>;
namespace check = shape_faults;

const Vector O{0, 0, 0};
const Vector x{1, 0, 0};
const Vector y{0, 1, 0};
const Vector z{0, 0, 1};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double full_turn = 2 * std::numbers::pi;

void expect_fault(const Fault& fault, ShapeRule rule, const std::string& message) {
  ASSERT_TRUE(fault) << "expected: " << message;
  EXPECT_EQ(fault->rule, rule);
  EXPECT_EQ(fault->message, message);
}
void expect_rule(const Fault& fault, ShapeRule rule) {
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->rule, rule) << fault->message;
}

TEST(ShapeFaults, ProperShapesHaveNone) {
  Random<double> r(17);
  for (int i = 0; i < 300; ++i) {
    const Vector A = r.point();
    const Vector B = r.point_apart_from(A);
    const Vector n = r.direction();
    const Vector d = r.across(n);
    const Vector t = r.across(B - A);
    const double R = r.length();
    const double angle = r.between(0.1, full_turn);
    const auto axes = r.axes();
    const Vector a = r.length() * axes.column(0);
    const Vector b = r.length() * axes.column(1);
    const Vector c = r.length() * axes.column(2);
    const Vector opposite = A + a - b + c;
    const std::vector<Fault> faults{
        check::particle("p", A),
        check::rod("p", A, B),
        check::polyline("p", {A, B, Vector(B + n)}),
        check::arc("p", A, n, d, R, angle),
        check::arc_from_point("p", A, n, Vector(A + cross(n, d)), angle),
        check::ring("p", A, n, R),
        check::semicircular_arc("p", A, B, t),
        check::rectangle("p", A, a, b),
        check::rectangle_from_corners("p", Vector(A + a), A, Vector(A + b)),
        check::triangle("p", A, B, Vector(A + t)),
        check::polygon("p", {A, A + a, A + 0.4 * (a + b), A + b}),
        check::polygon_in_plane("p", {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, A, n, d),
        check::disk("p", A, n, R),
        check::annulus("p", A, n, R, 0.5 * R),
        check::semicircle("p", A, B, t),
        check::sector("p", A, n, R, d, angle),
        check::box_shell("p", A, a, b, c),
        check::box_shell_between("p", A, opposite, axes),
        check::sphere_shell("p", A, R),
        check::hemisphere_shell("p", A, n, R),
        check::cylinder_shell("p", A, B, R),
        check::closed_cylinder_shell("p", A, B, R),
        check::cone_shell("p", A, B, R),
        check::box("p", A, a, b, c),
        check::box_between("p", A, opposite, axes),
        check::cube("p", A, R),
        check::cube_from_diagonal("p", A, B),
        check::sphere("p", A, R),
        check::hemisphere("p", A, n, R),
        check::cylinder("p", A, B, R),
        check::tube("p", A, B, R, 0.9 * R),
        check::cone("p", A, B, R),
        check::frustum("p", A, 0, B, R),
        check::ellipsoid("p", A, a, b, c),
        check::torus("p", A, n, R, R),
        check::tetrahedron("p", A, Vector(A + a), Vector(A + a + b), Vector(A + c)),
        check::prism("p", {A, A + a, A + 0.4 * (a + b), A + b}, Vector(c - 0.5 * a)),
        check::half_cylinder("p", A, B, R, t),
        check::paraboloid("p", A, B, R),
    };
    for (std::size_t k = 0; k < faults.size(); ++k) EXPECT_FALSE(faults[k]) << k << ": " << faults[k]->message;
  }
}

TEST(ShapeFaults, ValuesMustBeFinite) {
  const Vector bad{0, nan, 0};
  expect_fault(check::particle("bob", bad), ShapeRule::finite_values,
               "particle 'bob': the position is (0, nan, 0); coordinates must be finite numbers");
  expect_fault(check::disk("wheel", O, z, infinity), ShapeRule::finite_values,
               "disk 'wheel': the radius is inf; it must be a finite number");
  expect_fault(check::sector("fan", O, z, 1, x, nan), ShapeRule::finite_values,
               "sector 'fan': the angle is nan; it must be a finite number");
  for (const auto& fault : {check::rod("p", O, bad),
                            check::polyline("p", {O, x, bad}),
                            check::arc("p", bad, z, x, 1, 1),
                            check::arc_from_point("p", O, bad, x, 1),
                            check::ring("p", O, bad, 1),
                            check::semicircular_arc("p", O, x, bad),
                            check::rectangle("p", O, x, bad),
                            check::rectangle_from_corners("p", x, O, bad),
                            check::triangle("p", O, x, bad),
                            check::polygon("p", {O, x, bad}),
                            check::polygon_in_plane("p", {{0, 0}, {1, 0}, {0, nan}}, O, x, y),
                            check::annulus("p", O, z, 1, nan),
                            check::semicircle("p", bad, x, y),
                            check::box_shell("p", O, x, y, bad),
                            check::box_shell_between("p", O, bad),
                            check::sphere_shell("p", O, nan),
                            check::hemisphere_shell("p", O, bad, 1),
                            check::cylinder_shell("p", O, bad, 1),
                            check::closed_cylinder_shell("p", O, z, nan),
                            check::cone_shell("p", O, bad, 1),
                            check::box("p", bad, x, y, z),
                            check::box_between("p", bad, O),
                            check::cube("p", O, nan),
                            check::cube_from_diagonal("p", O, bad),
                            check::sphere("p", bad, 1),
                            check::hemisphere("p", bad, z, 1),
                            check::cylinder("p", bad, z, 1),
                            check::tube("p", O, z, nan, 1),
                            check::cone("p", O, z, nan),
                            check::frustum("p", O, nan, z, 1),
                            check::frustum("p", O, 1, z, nan),
                            check::ellipsoid("p", O, x, bad, z),
                            check::torus("p", O, z, nan, 1),
                            check::tetrahedron("p", O, x, y, bad),
                            check::prism("p", {O, x, y}, bad),
                            check::half_cylinder("p", O, bad, 1, x),
                            check::paraboloid("p", O, z, nan)}) {
    expect_rule(fault, ShapeRule::finite_values);
  }
}

TEST(ShapeFaults, SizesMustBePositive) {
  expect_fault(check::sphere("ball", O, 0), ShapeRule::positive_extent,
               "sphere 'ball': the radius is 0 m; it must be more than zero");
  expect_fault(check::frustum("cup", O, -0.5, z, 1), ShapeRule::positive_extent,
               "frustum 'cup': the radius at A is -0.5 m; it must not be negative");
  expect_fault(check::frustum("cup", O, 0, z, 0), ShapeRule::positive_extent,
               "frustum 'cup': the larger radius is 0 m; it must be more than zero");
  expect_fault(check::box("crate", O, x, O, z), ShapeRule::positive_extent,
               "box 'crate': edge b is the zero vector; it must have a length");
  expect_fault(
      check::box_between("crate", O, Vector{1, 2, 0}), ShapeRule::positive_extent,
      "box 'crate': the corners (0, 0, 0) and (1, 2, 0) have the same place along axis z; a box needs three sizes "
      "more than zero");
  for (const auto& fault : {check::arc("p", O, z, x, -1, 1),     check::ring("p", O, z, 0),
                            check::rectangle("p", O, O, y),      check::disk("p", O, z, 0),
                            check::annulus("p", O, z, 1, -0.5),  check::sector("p", O, z, -1, x, 1),
                            check::box_shell("p", O, O, y, z),   check::box_shell_between("p", O, x),
                            check::sphere_shell("p", O, -1),     check::hemisphere_shell("p", O, z, 0),
                            check::cylinder_shell("p", O, z, 0), check::closed_cylinder_shell("p", O, z, 0),
                            check::cone_shell("p", O, z, 0),     check::cube("p", O, 0),
                            check::hemisphere("p", O, z, 0),     check::cylinder("p", O, z, -2),
                            check::tube("p", O, z, 0, 0),        check::cone("p", O, z, 0),
                            check::ellipsoid("p", O, x, O, z),   check::torus("p", O, z, 0, 0),
                            check::torus("p", O, z, 1, 0),       check::prism("p", {O, x, y}, O),
                            check::paraboloid("p", O, z, 0),     check::half_cylinder("p", O, z, 0, x)}) {
    expect_rule(fault, ShapeRule::positive_extent);
  }
}

TEST(ShapeFaults, PointsMustDifferAndDirectionsMustBeGiven) {
  expect_fault(check::rod("arm", x, x), ShapeRule::distinct_points,
               "rod 'arm': end A and end B coincide at (1, 0, 0); give two different points");
  expect_fault(check::polyline("wire", {O, x, x, y}), ShapeRule::distinct_points,
               "wire 'wire': point 2 and point 3 coincide at (1, 0, 0); give two different points");
  expect_fault(check::polyline("wire", {O}), ShapeRule::enough_points,
               "wire 'wire': a wire needs at least 2 points, but 1 is given");
  for (const auto& fault :
       {check::arc_from_point("p", x, z, x, 1), check::semicircular_arc("p", O, O, x),
        check::rectangle_from_corners("p", x, x, y), check::triangle("p", O, x, O), check::semicircle("p", z, z, x),
        check::cylinder_shell("p", O, O, 1), check::closed_cylinder_shell("p", O, O, 1),
        check::cone_shell("p", x, x, 1), check::cube_from_diagonal("p", x, x), check::cylinder("p", O, O, 1),
        check::tube("p", O, O, 1, 0.5), check::cone("p", O, O, 1), check::frustum("p", O, 1, O, 1),
        check::half_cylinder("p", x, x, 1, y), check::paraboloid("p", O, O, 1)}) {
    expect_rule(fault, ShapeRule::distinct_points);
  }
  expect_fault(check::prism("wedge", {O, x, y}, Vector(x + y)), ShapeRule::clear_direction,
               "prism 'wedge': the edge 'along' (1, 1, 0) lies in the plane of the base; give one that leaves it");
  expect_rule(check::half_cylinder("p", O, z, 1, z), ShapeRule::clear_direction);
  expect_fault(check::disk("wheel", O, O, 1), ShapeRule::given_direction,
               "disk 'wheel': the normal is the zero vector; give a direction");
  for (const auto& fault :
       {check::arc("p", O, O, x, 1, 1), check::ring("p", O, O, 1), check::annulus("p", O, O, 1, 0.5),
        check::sector("p", O, z, 1, O, 1), check::hemisphere_shell("p", O, O, 1), check::hemisphere("p", O, O, 1),
        check::torus("p", O, O, 1, 0.5), check::semicircle("p", O, x, O),
        check::box_between("p", O, Vector{1, 1, 1}, Matrix3<double>{x, y, Vector(2.0 * z)})}) {
    expect_rule(fault, ShapeRule::given_direction);
  }
  expect_fault(check::semicircle("cam", O, x, Vector{-2, 0, 0}), ShapeRule::clear_direction,
               "semicircular plate 'cam': the direction 'toward' (-2, 0, 0) is along the diameter (1, 0, 0); give a "
               "direction across it");
  for (const auto& fault :
       {check::arc("p", O, z, z, 1, 1), check::semicircular_arc("p", O, x, x), check::sector("p", O, z, 1, z, 1),
        check::polygon_in_plane("p", {{0, 0}, {1, 0}, {0, 1}}, O, x, x)}) {
    expect_rule(fault, ShapeRule::clear_direction);
  }
}

TEST(ShapeFaults, AnglesAndRadii) {
  expect_fault(
      check::rectangle("door", O, x, Vector{1, 1, 0}), ShapeRule::right_angle,
      "rectangle 'door': edge a (1, 0, 0) and edge b (1, 1, 0) must be perpendicular, but make an angle of 45 deg");
  const Vector skew{0.1, 1, 0};
  for (const auto& fault :
       {check::rectangle_from_corners("p", x, O, skew), check::box_shell("p", O, x, skew, z),
        check::box("p", O, z, x, skew), check::ellipsoid("p", O, skew, z, x),
        check::arc_from_point("p", O, z, Vector{1, 0, 0.1}, 1),
        check::box_between("p", O, Vector{1, 1, 1}, Matrix3<double>::from_columns(x, normalized(skew), z)),
        check::box_shell_between("p", O, Vector{1, 1, 1}, Matrix3<double>::from_columns(x, normalized(skew), z))}) {
    expect_rule(fault, ShapeRule::right_angle);
  }
  // Data with few digits pass, and a caller may ask for more care.
  EXPECT_FALSE(check::rectangle("p", O, x, Vector{1e-7, 1, 0}));
  EXPECT_TRUE(check::rectangle("p", O, x, Vector{1e-7, 1, 0}, 1e-9));

  expect_fault(check::arc("hook", O, z, x, 1, 7), ShapeRule::angle_range,
               "arc 'hook': the angle is 7 rad; it must be more than zero and at most a full turn, 2 pi");
  for (const auto& fault :
       {check::arc("p", O, z, x, 1, 0), check::arc_from_point("p", O, z, x, -1), check::sector("p", O, z, 1, x, 6.3)}) {
    expect_rule(fault, ShapeRule::angle_range);
  }
  EXPECT_FALSE(check::arc("p", O, z, x, 1, full_turn));

  expect_fault(check::annulus("washer", O, z, 0.5, 0.5), ShapeRule::radii_order,
               "annulus 'washer': the inner radius 0.5 m must be less than the outer radius 0.5 m");
  expect_fault(check::torus("tyre", O, z, 0.5, 0.6), ShapeRule::radii_order,
               "torus 'tyre': the section radius 0.6 m must not exceed the ring radius 0.5 m");
  expect_rule(check::tube("p", O, z, 1, 2), ShapeRule::radii_order);
}

TEST(ShapeFaults, CornersMustSpanTheShape) {
  expect_fault(check::triangle("fin", O, x, Vector{3, 0, 0}), ShapeRule::not_collinear,
               "triangle 'fin': the corners (0, 0, 0), (1, 0, 0), (3, 0, 0) lie on one line; a plate needs an area");
  expect_fault(
      check::tetrahedron("block", O, x, y, Vector{1, 1, 0}), ShapeRule::not_collinear,
      "tetrahedron 'block': the corners (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0) lie in one plane; a solid needs "
      "a volume");
  expect_rule(check::tetrahedron("block", O, O, O, O), ShapeRule::not_collinear);
}

TEST(PolygonFaults, OutlinesMustBeFlatAndSimple) {
  const auto at = [](double u, double v) { return Vector{u, v, 1}; };
  expect_fault(check::polygon("plate", {O, x}), ShapeRule::enough_points,
               "polygon 'plate': a polygon needs at least 3 vertices, but 2 are given");
  expect_fault(check::polygon("plate", {O, x, y, O}), ShapeRule::distinct_points,
               "polygon 'plate': vertex 4 and vertex 1 coincide at (0, 0, 0); give two different points");
  expect_fault(check::polygon("plate", {O, x, Vector{2, 0, 0}}), ShapeRule::not_collinear,
               "polygon 'plate': all vertices lie on one line; a plate needs an area");
  expect_fault(
      check::polygon("plate", {O, Vector{4, 0, 0}, Vector{4, 3, 0}, Vector{0, 2, 0.25}}), ShapeRule::flat,
      "polygon 'plate': vertex 4 at (0, 2, 0.25) is 0.25 m off the plane of the others; all vertices must lie in "
      "one plane");
  // A bow tie, whose signed area may even be zero.
  expect_fault(
      check::polygon("plate", {at(0, 0), at(1, 1), at(1, 0), at(0, 1)}), ShapeRule::simple_outline,
      "polygon 'plate': the side from vertex 1 to 2 meets the side from vertex 3 to 4; list the vertices in order "
      "round the plate");
  // A corner that touches another side, a corner met twice, a spike.
  expect_rule(check::polygon("plate", {at(0, 0), at(4, 0), at(4, 4), at(2, 0), at(0, 4)}), ShapeRule::simple_outline);
  expect_rule(check::polygon("plate", {at(0, 0), at(2, 2), at(4, 0), at(4, 4), at(2, 2), at(0, 4)}),
              ShapeRule::simple_outline);
  expect_fault(check::polygon("plate", {at(0, 0), at(4, 0), at(2, 0), at(2, 2)}), ShapeRule::simple_outline,
               "polygon 'plate': the outline turns back on itself at vertex 2 (4, 0, 1)");
  // Vertices in the middle of a straight side are fine, and so are close but separate corners.
  EXPECT_FALSE(check::polygon("plate", {at(0, 0), at(2, 0), at(4, 0), at(4, 4), at(2, 1e-6), at(0, 4)}));
}

TEST(PolygonFaults, RandomOutlinesAndTheSameWithTwoVerticesExchanged) {
  Random<double> r(18);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector> outline;
    const int count = r.whole(5, 12);
    const auto axes = r.axes();
    const Vector center = r.point();
    for (int k = 0; k < count; ++k) {
      const double angle = full_turn * (k + r.between(-0.3, 0.3)) / count;
      const double radius = r.between(0.5, 2);
      outline.push_back(center + axes * Vector{radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    EXPECT_FALSE(check::polygon("star", outline));
    std::vector<Vector> reversed(outline.rbegin(), outline.rend());
    EXPECT_FALSE(check::polygon("star", reversed));
    // On a convex outline an exchange always makes two sides cross.
    for (int k = 0; k < count; ++k) {
      const double angle = full_turn * k / count;
      outline[static_cast<std::size_t>(k)] = center + axes * Vector{2 * std::cos(angle), std::sin(angle), 0};
    }
    EXPECT_FALSE(check::polygon("oval", outline));
    std::swap(outline[1], outline[3]);
    expect_rule(check::polygon("oval", outline), ShapeRule::simple_outline);
  }
}

}  // namespace shape_faults_test
}  // namespace poinsot
