// Closed forms of every shape against its particles, which know no moment of inertia.
#include "poinsot/engine/mass/shapes.h"

#include <numbers>

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace shapes_test {

using testing::near;
using testing::Random;

template <class Scalar>
struct Pair {
  ShapeProperties<Scalar> shape;
  ParticleSet<Scalar> particles;
};

// 1,000 random placements of one shape.
template <class Scalar, class Make>
void expect_agreement(Make make, double tolerance) {
  Random<Scalar> random(20240518);
  for (int i = 0; i < 1000; ++i) {
    const Pair<Scalar> pair = make(random);
    const Scalar mass = random.between(0.1, 5);
    ASSERT_TRUE(near(of_mass(pair.shape, mass), mass_properties(particles_of_mass(pair.particles, mass)), tolerance));
    ASSERT_TRUE(
        near(of_density(pair.shape, mass), mass_properties(particles_of_density(pair.particles, mass)), tolerance));
  }
}

template <class Scalar>
class Shapes : public ::testing::Test {
 protected:
  static constexpr double tolerance = std::is_same_v<Scalar, double> ? 1e-10 : 1e-13;
};
using Scalars = ::testing::Types<double, long double>;
TYPED_TEST_SUITE(Shapes, Scalars);

// The same arguments go to the closed form and to the particles.
#define POINSOT_EXPECT_AGREEMENT(shape, ...)                                       \
  expect_agreement<TypeParam>(                                                     \
      [&](Random<TypeParam>& random) {                                             \
        const auto arguments = __VA_ARGS__(random);                                \
        return std::apply(                                                         \
            [](const auto&... a) {                                                 \
              return Pair<TypeParam>{shapes::shape(a...), particles::shape(a...)}; \
            },                                                                     \
            arguments);                                                            \
      },                                                                           \
      TestFixture::tolerance)

TYPED_TEST(Shapes, LinesAgreeWithParticles) {
  const auto two_points = [](auto& r) {
    const auto A = r.point();
    return std::tuple(A, r.point_apart_from(A));
  };
  const auto points = [](auto& r) {
    std::vector<Vector3<TypeParam>> wire{r.point()};
    for (int n = r.whole(1, 6); n > 0; --n) wire.push_back(r.point_apart_from(wire.back()));
    return std::tuple(wire);
  };
  const auto arc = [](auto& r) {
    const auto normal = r.direction();
    return std::tuple(r.point(), normal, r.across(normal), r.length(), r.between(0.3, 2 * std::numbers::pi));
  };
  const auto arc_from_point = [](auto& r) {
    const auto center = r.point();
    const auto normal = r.direction();
    return std::tuple(center, normal, Vector3<TypeParam>(center + cross(normal, r.across(normal))),
                      r.between(0.3, 2 * std::numbers::pi));
  };
  const auto half = [](auto& r) {
    const auto A = r.point();
    const auto B = r.point_apart_from(A);
    return std::tuple(A, B, r.across(B - A));
  };
  POINSOT_EXPECT_AGREEMENT(rod, two_points);
  POINSOT_EXPECT_AGREEMENT(polyline, points);
  POINSOT_EXPECT_AGREEMENT(arc, arc);
  POINSOT_EXPECT_AGREEMENT(arc_from_point, arc_from_point);
  POINSOT_EXPECT_AGREEMENT(ring, [](auto& r) { return std::tuple(r.point(), r.direction(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(semicircular_arc, half);
}

// A star-shaped outline in a random plane; radii vary enough for reflex corners.
template <class Scalar>
std::vector<std::array<Scalar, 2>> random_outline(Random<Scalar>& random) {
  std::vector<std::array<Scalar, 2>> outline;
  const int count = random.whole(3, 12);
  const Scalar sense = random.whole(0, 1) == 0 ? 1 : -1;
  for (int i = 0; i < count; ++i) {
    const Scalar angle = sense * 2 * std::numbers::pi_v<Scalar> * (Scalar(i) + random.between(-0.3, 0.3)) / count;
    const Scalar radius = random.between(0.3, 2);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

TYPED_TEST(Shapes, PlatesAgreeWithParticles) {
  const auto rectangle = [](auto& r) {
    const auto axes = r.axes();
    return std::tuple(r.point(), Vector3<TypeParam>(r.length() * axes.column(0)),
                      Vector3<TypeParam>(r.length() * axes.column(1)));
  };
  const auto corners = [](auto& r) {
    const auto axes = r.axes();
    const auto B = r.point();
    return std::tuple(Vector3<TypeParam>(B + r.length() * axes.column(0)), B,
                      Vector3<TypeParam>(B + r.length() * axes.column(1)));
  };
  const auto triangle = [](auto& r) {
    const auto A = r.point();
    const auto B = r.point_apart_from(A);
    return std::tuple(A, B, Vector3<TypeParam>(A + r.across(B - A)));
  };
  const auto polygon = [](auto& r) {
    const auto axes = r.axes();
    return std::tuple(shapes::points_in_plane(random_outline(r), r.point(), axes.column(0), axes.column(1)));
  };
  const auto polygon_in_plane = [](auto& r) {
    const auto u = r.direction();
    return std::tuple(random_outline(r), r.point(), u, r.across(u));
  };
  const auto annulus = [](auto& r) {
    const TypeParam outer = r.length();
    return std::tuple(r.point(), r.direction(), outer, TypeParam(outer * r.between(0, 0.99)));
  };
  const auto half = [](auto& r) {
    const auto A = r.point();
    const auto B = r.point_apart_from(A);
    return std::tuple(A, B, r.across(B - A));
  };
  const auto sector = [](auto& r) {
    const auto normal = r.direction();
    return std::tuple(r.point(), normal, r.length(), r.across(normal), r.between(0.3, 2 * std::numbers::pi));
  };
  POINSOT_EXPECT_AGREEMENT(rectangle, rectangle);
  POINSOT_EXPECT_AGREEMENT(rectangle_from_corners, corners);
  POINSOT_EXPECT_AGREEMENT(triangle, triangle);
  POINSOT_EXPECT_AGREEMENT(polygon, polygon);
  POINSOT_EXPECT_AGREEMENT(polygon_in_plane, polygon_in_plane);
  POINSOT_EXPECT_AGREEMENT(disk, [](auto& r) { return std::tuple(r.point(), r.direction(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(annulus, annulus);
  POINSOT_EXPECT_AGREEMENT(semicircle, half);
  POINSOT_EXPECT_AGREEMENT(sector, sector);
  const auto annular_sector = [](auto& r) {
    const auto normal = r.direction();
    const TypeParam outer = r.length();
    return std::tuple(r.point(), normal, outer, TypeParam(outer * r.between(0, 0.99)), r.across(normal),
                      r.between(0.3, 2 * std::numbers::pi));
  };
  POINSOT_EXPECT_AGREEMENT(annular_sector, annular_sector);
}

template <class Scalar>
auto edges_of(Random<Scalar>& r) {
  const auto axes = r.axes();
  return std::tuple(r.point(), Vector3<Scalar>(r.length() * axes.column(0)),
                    Vector3<Scalar>(r.length() * axes.column(1)), Vector3<Scalar>(r.length() * axes.column(2)));
}
template <class Scalar>
auto opposite_corners(Random<Scalar>& r) {
  const auto axes = r.axes();
  const auto corner = r.point();
  const Vector3<Scalar> size{r.length(), r.length(), -r.length()};
  return std::tuple(corner, Vector3<Scalar>(corner + axes * size), axes);
}
template <class Scalar>
auto bar(Random<Scalar>& r) {
  const auto A = r.point();
  return std::tuple(A, r.point_apart_from(A), r.length());
}

TYPED_TEST(Shapes, ShellsAgreeWithParticles) {
  POINSOT_EXPECT_AGREEMENT(box_shell, edges_of);
  POINSOT_EXPECT_AGREEMENT(box_shell_between, opposite_corners);
  POINSOT_EXPECT_AGREEMENT(sphere_shell, [](auto& r) { return std::tuple(r.point(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(hemisphere_shell, [](auto& r) { return std::tuple(r.point(), r.direction(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(cylinder_shell, bar);
  POINSOT_EXPECT_AGREEMENT(closed_cylinder_shell, bar);
  POINSOT_EXPECT_AGREEMENT(cone_shell, bar);
}

TYPED_TEST(Shapes, SolidsAgreeWithParticles) {
  const auto diagonal = [](auto& r) {
    const auto B = r.point();
    return std::tuple(B, r.point_apart_from(B));
  };
  const auto tube = [](auto& r) {
    const auto A = r.point();
    const TypeParam outer = r.length();
    return std::tuple(A, r.point_apart_from(A), outer, TypeParam(outer * r.between(0, 0.99)));
  };
  const auto frustum = [](auto& r) {
    const auto A = r.point();
    return std::tuple(A, r.between(0, 2), r.point_apart_from(A), r.between(0.1, 2));
  };
  const auto torus = [](auto& r) {
    const TypeParam ring = r.length();
    return std::tuple(r.point(), r.direction(), ring, TypeParam(ring * r.between(0.05, 1)));
  };
  const auto tetrahedron = [](auto& r) {
    const auto A = r.point();
    const auto B = r.point_apart_from(A);
    const auto C = Vector3<TypeParam>(A + r.across(B - A));
    return std::tuple(A, B, C, Vector3<TypeParam>(A + r.across(B - A) + cross(B - A, C - A)));
  };
  POINSOT_EXPECT_AGREEMENT(box, edges_of);
  POINSOT_EXPECT_AGREEMENT(box_between, opposite_corners);
  POINSOT_EXPECT_AGREEMENT(cube, [](auto& r) { return std::tuple(r.point(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(cube_from_diagonal, diagonal);
  POINSOT_EXPECT_AGREEMENT(sphere, [](auto& r) { return std::tuple(r.point(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(hemisphere, [](auto& r) { return std::tuple(r.point(), r.direction(), r.length()); });
  POINSOT_EXPECT_AGREEMENT(cylinder, bar);
  POINSOT_EXPECT_AGREEMENT(tube, tube);
  POINSOT_EXPECT_AGREEMENT(cone, bar);
  POINSOT_EXPECT_AGREEMENT(frustum, frustum);
  POINSOT_EXPECT_AGREEMENT(ellipsoid, edges_of);
  POINSOT_EXPECT_AGREEMENT(torus, torus);
  POINSOT_EXPECT_AGREEMENT(tetrahedron, tetrahedron);
  const auto prism = [](auto& r) {
    const auto axes = r.axes();
    return std::tuple(shapes::points_in_plane(random_outline(r), r.point(), axes.column(0), axes.column(1)),
                      Vector3<TypeParam>(r.between(-2, 2) * axes.column(0) + r.length() * axes.column(2)));
  };
  const auto half_cylinder = [](auto& r) {
    const auto A = r.point();
    const auto B = r.point_apart_from(A);
    return std::tuple(A, B, r.length(), r.across(B - A));
  };
  const auto thick_sector = [](auto& r) {
    const auto n = r.direction();
    const TypeParam outer = r.length();
    return std::tuple(r.point(), n, outer, TypeParam(outer * r.between(0, 0.999)), r.across(n), r.between(0.05, 6.2),
                      r.length());
  };
  POINSOT_EXPECT_AGREEMENT(thick_sector, thick_sector);
  POINSOT_EXPECT_AGREEMENT(prism, prism);
  POINSOT_EXPECT_AGREEMENT(half_cylinder, half_cylinder);
  POINSOT_EXPECT_AGREEMENT(paraboloid, bar);
}

TYPED_TEST(Shapes, ParticleIsAllAtItsPoint) {
  const Vector3<TypeParam> P{1, -2, 3};
  const auto body = of_mass(shapes::particle(P), TypeParam(4));
  EXPECT_TRUE(near(body, mass_properties(particles_of_mass(particles::particle(P), TypeParam(4))), 0));
  EXPECT_EQ(testing::largest_entry(body.inertia_center), 0);
  // About the origin: m (y^2 + z^2) = 4 * 13, m x y = -8 with the sign of the tensor.
  const auto about_origin = inertia_about(body, Vector3<TypeParam>::zero());
  EXPECT_EQ(about_origin.xx, 52);
  EXPECT_EQ(about_origin.xy, 8);
}

}  // namespace shapes_test
}  // namespace poinsot
