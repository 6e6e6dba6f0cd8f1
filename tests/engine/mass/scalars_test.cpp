// The formulas of shapes, meshes and compositions on duals and packs: derivatives against differences of doubles, lanes
// against runs in double.
#include <functional>
#include <numbers>

#include "engine/mass/mesh_examples.h"
#include "engine/mass/random_shapes.h"
#include "poinsot/engine/math/algebra/dual.h"
#include "poinsot/engine/math/algebra/pack.h"

namespace poinsot {
namespace scalars_test {

using testing::Random;

// Every shape as a function of ten numbers: three points A, B, C and a length.
template <class S>
std::vector<MassProperties<S>> all_shapes(const std::array<S, 10>& u) {
  const Vector3<S> A{u[0], u[1], u[2]};
  const Vector3<S> B{u[3], u[4], u[5]};
  const Vector3<S> C{u[6], u[7], u[8]};
  const S r = u[9];
  const S half = S(0.5) * r;
  const Vector3<S> a = B - A;
  const Vector3<S> b = C - A;
  const Vector3<S> c = cross(a, b);
  const Vector3<S> d = cross(c, a);
  const Vector3<S> D = A + c;
  const std::vector<ShapeProperties<S>> shapes{
      shapes::particle(A),
      shapes::rod(A, B),
      shapes::polyline<S>({A, B, C}),
      shapes::arc(A, a, b, r, S(r + S(1))),
      shapes::arc_from_point(A, a, C, r),
      shapes::ring(A, a, r),
      shapes::semicircular_arc(A, B, b),
      shapes::rectangle(C, a, d),
      shapes::rectangle_from_corners(B, A, Vector3<S>(A + d)),
      shapes::triangle(A, B, C),
      shapes::polygon<S>({A, B, A + S(0.3) * (a + b), C}),
      shapes::polygon_in_plane<S>({{S(0), S(0)}, {r, S(0)}, {r, half}, {S(0), S(2) * r}}, A, a, b),
      shapes::disk(A, a, r),
      shapes::annulus(A, a, r, half),
      shapes::semicircle(A, B, b),
      shapes::sector(A, a, r, b, r),
      shapes::annular_sector(A, a, r, half, b, r),
      shapes::thick_sector(A, a, r, half, b, r, half),
      shapes::box_shell(A, a, c, d),
      shapes::box_shell_between(A, Vector3<S>(A + Vector3<S>{r, half, r})),
      shapes::sphere_shell(A, r),
      shapes::hemisphere_shell(A, a, r),
      shapes::cylinder_shell(A, B, r),
      shapes::closed_cylinder_shell(A, B, r),
      shapes::cone_shell(A, B, r),
      shapes::box(A, a, b, c),
      shapes::box_between(A, Vector3<S>(A + Vector3<S>{r, half, r})),
      shapes::cube(A, r),
      shapes::cube_from_diagonal(A, B),
      shapes::sphere(A, r),
      shapes::hemisphere(A, a, r),
      shapes::cylinder(A, B, r),
      shapes::tube(A, B, r, half),
      shapes::cone(A, B, r),
      shapes::frustum(A, r, B, half),
      shapes::ellipsoid(A, a, c, d),
      shapes::torus(A, a, r, half),
      shapes::tetrahedron(A, B, C, D),
      shapes::prism<S>({A, B, C}, Vector3<S>(D - A)),
      shapes::half_cylinder(A, B, r, b),
      shapes::paraboloid(A, B, r),
      solid_of_mesh(testing::tetrahedron_mesh(A, C, B, D)),
      shell_of_mesh(testing::box_mesh(A, a, b, c))};
  std::vector<MassProperties<S>> bodies;
  for (const auto& shape : shapes) bodies.push_back(of_density(shape, r));
  bodies.push_back(of_mass(shapes::particle(A), r));

  // Compositions of some of them.
  const Matrix3<S> R = Matrix3<S>::from_columns(normalized(a), normalized(c), normalized(d));
  const auto cone = shapes::cone(A, B, r);
  bodies.push_back(sum<S>({bodies[1], bodies[23], scaled(S(0.5), bodies[29])}));
  bodies.push_back(transformed(R, C, mirrored(A, b, of_mass(cone, r))));
  bodies.push_back(from_radii_of_gyration_about(C, r, A, a, R));
  bodies.push_back(axisymmetric_about(B, r, A, a, r, half));
  bodies.push_back(from_moments_and_products(B, r, A, a, ProductsOfInertia<S>{b.x, b.y, b.z}));
  bodies.push_back({moment_about_axis(of_mass(cone, r), C, b), C, bodies[2].inertia_center});
  return bodies;
}

template <class S>
std::vector<S> numbers(const std::vector<MassProperties<S>>& bodies) {
  std::vector<S> all;
  for (const auto& body : bodies) {
    const auto& I = body.inertia_center;
    for (const S& value :
         {body.mass, body.center.x, body.center.y, body.center.z, I.xx, I.yy, I.zz, I.xy, I.yz, I.zx}) {
      all.push_back(value);
    }
  }
  return all;
}

template <class S>
std::array<S, 10> random_data(Random<S>& random) {
  const auto A = random.point();
  const auto B = random.point_apart_from(A);
  const auto C = A + random.across(B - A);
  return {A.x, A.y, A.z, B.x, B.y, B.z, C.x, C.y, C.z, random.length()};
}

TEST(MassOfDuals, DerivativesAreThoseOfDifferences) {
  Random<long double> random(19);
  for (int i = 0; i < 100; ++i) {
    const auto data = random_data(random);
    std::array<Dual<10>, 10> variables;
    for (std::size_t k = 0; k < 10; ++k)
      variables[k] = Dual<10>::variable(static_cast<double>(data[k]), static_cast<int>(k));
    const auto duals = numbers(all_shapes(variables));
    const auto values = numbers(all_shapes(data));
    ASSERT_EQ(duals.size(), values.size());
    for (std::size_t n = 0; n < duals.size(); ++n) {
      const auto expected = static_cast<double>(values[n]);
      EXPECT_NEAR(duals[n].value, expected, 1e-10 * (1 + std::abs(expected))) << n;
    }
    for (std::size_t k = 0; k < 10; ++k) {
      // Central differences of fourth order in long double: error of 1e-14 or so.
      const long double h = 5e-4L;
      const auto at = [&](long double steps) {
        auto moved = data;
        moved[k] += steps * h;
        return numbers(all_shapes(moved));
      };
      const auto minus2 = at(-2);
      const auto minus1 = at(-1);
      const auto plus1 = at(1);
      const auto plus2 = at(2);
      for (std::size_t n = 0; n < duals.size(); ++n) {
        const auto slope = static_cast<double>((8 * (plus1[n] - minus1[n]) - (plus2[n] - minus2[n])) / (12 * h));
        const double scale = 1 + std::abs(slope) + std::abs(duals[n].value);
        ASSERT_NEAR(duals[n].partial[k], slope, 1e-7 * scale) << "number " << n << " by " << k;
      }
    }
  }
}

template <int W>
void expect_lanes_of_doubles() {
  Random<double> random(20);
  for (int i = 0; i < 100; ++i) {
    std::array<std::array<double, 10>, W> lanes;
    std::array<Pack<W>, 10> packs;
    for (int lane = 0; lane < W; ++lane) {
      lanes[static_cast<std::size_t>(lane)] = random_data(random);
      for (std::size_t k = 0; k < 10; ++k) packs[k].set_lane(lane, lanes[static_cast<std::size_t>(lane)][k]);
    }
    const auto results = numbers(all_shapes(packs));
    for (int lane = 0; lane < W; ++lane) {
      const auto expected = numbers(all_shapes(lanes[static_cast<std::size_t>(lane)]));
      ASSERT_EQ(results.size(), expected.size());
      for (std::size_t n = 0; n < expected.size(); ++n) {
        ASSERT_NEAR(results[n].lane(lane), expected[n], 1e-12 * (1 + std::abs(expected[n]))) << "number " << n;
      }
    }
  }
}
TEST(MassOfPacks, LanesAreRunsInDouble) {
  expect_lanes_of_doubles<4>();
  expect_lanes_of_doubles<8>();
}

}  // namespace scalars_test
}  // namespace poinsot
