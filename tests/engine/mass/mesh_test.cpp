#include "poinsot/engine/mass/mesh.h"

#include <limits>

#include "engine/mass/mesh_examples.h"
#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace mesh_test {

using testing::box_mesh;
using testing::near;
using testing::prism_mesh;
using testing::Random;
using testing::tetrahedron_mesh;
using Vector = Vector3<double>;
using Mesh = TriangleMesh<double>;

const Mesh cube = box_mesh(Vector{0, 0, 0}, Vector::unit(0), Vector::unit(1), Vector::unit(2));

// A star-shaped outline with reflex corners, counter-clockwise in the first two axes.
std::vector<Vector> random_outline(Random<double>& random, const Vector& center, const Matrix3<double>& axes) {
  std::vector<std::array<double, 2>> outline;
  const int count = random.whole(3, 12);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.between(-0.3, 0.3)) / count;
    const double radius = random.between(0.3, 2);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return shapes::points_in_plane(outline, center, axes.column(0), axes.column(1));
}

TEST(Mesh, PolyhedraHaveTheirClosedForms) {
  Random<double> random(15);
  for (int i = 0; i < 1000; ++i) {
    const Vector P = random.point();
    const auto axes = random.axes();
    const Vector a = random.length() * axes.column(0);
    const Vector b = random.length() * axes.column(1);
    const Vector c = random.length() * axes.column(2);
    const Mesh box = box_mesh(P, a, b, c);
    ASSERT_TRUE(find_faults(box, "box").empty());
    ASSERT_TRUE(near(solid_of_mesh(box), shapes::box_between(P, Vector(P + a + b + c), axes), 1e-10));
    ASSERT_TRUE(near(shell_of_mesh(box), shapes::box_shell_between(P, Vector(P + a + b + c), axes), 1e-10));
    // A parallelepiped.
    const Vector d = c + random.between(-1, 1) * a + random.between(-1, 1) * b;
    ASSERT_TRUE(near(solid_of_mesh(box_mesh(P, a, b, d)), shapes::box(Vector(P + 0.5 * (a + b + d)), a, b, d), 1e-10));

    const Vector D = P + d;
    const Mesh tetrahedron = tetrahedron_mesh(P, Vector(P + b), Vector(P + a), D);
    ASSERT_TRUE(find_faults(tetrahedron, "tetrahedron").empty());
    ASSERT_TRUE(near(solid_of_mesh(tetrahedron), shapes::tetrahedron(P, Vector(P + a), Vector(P + b), D), 1e-10));

    // A right prism is its outline spread along a rod.
    const auto outline = random_outline(random, P, axes);
    const Mesh prism = prism_mesh(outline, c);
    ASSERT_TRUE(find_faults(prism, "prism").empty());
    const auto plate = shapes::polygon(outline);
    const auto rod = shapes::rod(Vector::zero(), c);
    const ShapeProperties<double> expected{plate.measure * rod.measure, plate.center + rod.center,
                                           plate.inertia_center + rod.inertia_center};
    ASSERT_TRUE(near(solid_of_mesh(prism), expected, 1e-10));

    // And all of them are what their particles are.
    for (const Mesh& mesh : {box, tetrahedron, prism}) {
      ASSERT_TRUE(near(of_mass(solid_of_mesh(mesh), 2.0),
                       mass_properties(particles_of_mass(particles::solid_of_mesh(mesh), 2.0)), 1e-10));
    }
  }
}

TEST(Mesh, FineBallTendsToSphere) {
  // The error of a mesh of flat triangles falls as the square of their size.
  const auto error = [](std::uint32_t n) {
    const auto ball = solid_of_mesh(testing::ball_mesh(2, n, 2 * n));
    return shapes::sphere(Vector::zero(), 2.0).measure - ball.measure;
  };
  EXPECT_NEAR(error(20) / error(40), 4, 0.02);
  EXPECT_NEAR(error(40) / error(80), 4, 0.01);
  const Mesh fine = testing::ball_mesh(2, 100, 200);
  EXPECT_TRUE(find_faults(fine, "ball").empty());
  EXPECT_TRUE(near(solid_of_mesh(fine), shapes::sphere(Vector::zero(), 2.0), 1e-3));
  EXPECT_TRUE(near(shell_of_mesh(fine), shapes::sphere_shell(Vector::zero(), 2.0), 1e-3));
}

TEST(Mesh, CavitiesAndSeparatePartsAreTaken) {
  const Mesh outer = box_mesh(Vector{0, 0, 0}, Vector{4, 0, 0}, Vector{0, 4, 0}, Vector{0, 0, 4});
  const Mesh inner = box_mesh(Vector{1, 1, 0.5}, Vector{1, 0, 0}, Vector{0, 2, 0}, Vector{0, 0, 3});
  const Mesh hollow = testing::together(outer, testing::inside_out(inner));
  EXPECT_TRUE(find_faults(hollow, "hollow").empty());
  EXPECT_TRUE(near(of_density(solid_of_mesh(hollow), 3.0),
                   sum<double>({of_density(solid_of_mesh(outer), 3.0), of_density(solid_of_mesh(inner), -3.0)}),
                   1e-12));
  const Mesh far = box_mesh(Vector{10, 0, 0}, Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1});
  EXPECT_TRUE(find_faults(testing::together(outer, far), "pair").empty());
}

TEST(Mesh, BodiesFarFromTheOriginLoseNoDigits) {
  const Vector shift{1048576, -2097152, 524288};
  Mesh moved = cube;
  for (auto& v : moved.vertices) v += shift;
  const auto here = solid_of_mesh(cube);
  const auto there = solid_of_mesh(moved);
  EXPECT_NEAR(there.measure, 1, 1e-13);
  EXPECT_TRUE(near(there.inertia_center, here.inertia_center, 1e-13));
}

std::vector<MeshFault> faults_of(const Mesh& mesh) { return find_faults(mesh, "part"); }

// Boxes of random places and turns, made of the same twelve triangles each.
TEST(MeshFaults, PartsInEachOther) {
  Random<double> random(17);
  const auto faults_of_pair = [](const Mesh& a, const Mesh& b) { return find_faults(testing::together(a, b), "pair"); };
  for (int i = 0; i < 200; ++i) {
    const Matrix3<double> turn = random.axes();
    const auto box = [&](const Vector& corner, const Vector& sides) {
      return box_mesh(Vector(turn * corner), Vector(sides.x * turn.column(0)), Vector(sides.y * turn.column(1)),
                      Vector(sides.z * turn.column(2)));
    };
    const Mesh outer = box({0, 0, 0}, {4, 4, 4});
    const Vector place{random.between(0.1, 1.9), random.between(0.1, 1.9), random.between(0.1, 1.9)};
    const Mesh inner = box(place, {2, 2, 2});
    EXPECT_TRUE(faults_of_pair(outer, testing::inside_out(inner)).empty());
    // Only corners lie in each other.
    const Mesh crossing = box({place.x + 2, place.y + 2, place.z + 2}, {5, 5, 5}), far = box({5, 0, 0}, {1, 1, 1}),
               beside = box({4, 0, 0}, {1, 1, 1});
    for (const Mesh* wrong : {&inner, &crossing, &outer}) {
      const auto faults = faults_of_pair(outer, *wrong);
      ASSERT_EQ(faults.size(), 1u);
      EXPECT_EQ(faults[0].rule, MeshRule::separate_parts);
      EXPECT_NE(faults[0].message.find("would count twice"), std::string::npos) << faults[0].message;
    }
    EXPECT_TRUE(faults_of_pair(outer, far).empty());
    EXPECT_TRUE(faults_of_pair(outer, beside).empty());
    const auto turned = faults_of_pair(outer, testing::inside_out(far));
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_NE(turned[0].message.find("is inside out and no cavity"), std::string::npos) << turned[0].message;
  }
}

TEST(MeshFaults, MissingTrianglesLeaveOpenEdges) {
  EXPECT_EQ(faults_of(Mesh{})[0].message, "mesh 'part': it has no triangles; a body needs a closed surface");
  EXPECT_EQ(faults_of(Mesh{})[0].rule, MeshRule::has_triangles);
  Mesh open = cube;
  open.triangles.pop_back();
  const auto faults = faults_of(open);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rule, MeshRule::closed_surface);
  EXPECT_EQ(faults[0].count, 3u);
  EXPECT_EQ(faults[0].message,
            "mesh 'part': 3 edges are not shared by exactly two triangles, first from (0, 1, 0) to (0, 0, 1), which "
            "belongs to 1 triangle; a body needs a closed surface: fill the holes and remove double or inner faces");
}

TEST(MeshFaults, DoubleFaces) {
  Mesh twice = cube;
  twice.triangles.push_back(cube.triangles[0]);
  const auto faults = faults_of(twice);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rule, MeshRule::closed_surface);
  EXPECT_NE(faults[0].message.find("belongs to 3 triangles"), std::string::npos) << faults[0].message;
}

TEST(MeshFaults, OddTrianglesAndWholeMeshesTurnedOver) {
  Mesh odd = cube;
  std::swap(odd.triangles[0][0], odd.triangles[0][1]);
  auto faults = faults_of(odd);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rule, MeshRule::consistent_orientation);
  EXPECT_EQ(faults[0].count, 3u);
  EXPECT_NE(
      faults[0].message.find("3 edges have two triangles that run along them the same way, first from (0, 0, 0) to"),
      std::string::npos)
      << faults[0].message;
  faults = faults_of(testing::inside_out(cube));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rule, MeshRule::outward_orientation);
  EXPECT_EQ(
      faults[0].message,
      "mesh 'part': it is inside out (its volume is -1 m^3); reverse the corners of every triangle so that they run "
      "counter-clockwise seen from outside");
  // Beyond the range of numbers there is no telling.
  Mesh vast = cube;
  for (auto& v : vast.vertices) v *= 1e150;
  faults = faults_of(vast);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].message.substr(0, 53), "mesh 'part': its volume is beyond all numbers (inf); ");
  // Flat meshes on skew planes have volumes that are rounding of either sign.
  Random<double> random(21);
  for (int i = 0; i < 200; ++i) {
    const Vector A = random.point();
    const Vector B = random.point();
    const Vector C = random.point();
    const Mesh skew = tetrahedron_mesh(A, B, C, Vector(A + 0.3 * (B - A) + 0.4 * (C - A)));
    ASSERT_EQ(faults_of(skew).size(), 1u);
    EXPECT_NE(faults_of(skew)[0].message.find("it encloses no volume"), std::string::npos);
  }
  // A sheet with two sides is closed but empty.
  const Mesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}, {{0, 2, 1}}}};
  faults = faults_of(flat);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].message, "mesh 'part': it encloses no volume; a body needs a closed surface around some space");
}

TEST(MeshFaults, DegenerateTriangles) {
  Mesh repeated = cube;
  repeated.triangles.push_back({0, 0, 1});
  auto faults = faults_of(repeated);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].rule, MeshRule::proper_triangles);
  EXPECT_EQ(faults[0].count, 1u);
  EXPECT_EQ(
      faults[0].message,
      "mesh 'part': 1 triangle has its corners on one line, first triangle 12 with the corners (0, 0, 0), (0, 0, 0), "
      "(1, 0, 0); remove them and join their neighbours");
  const Mesh line{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{{0, 1, 2}}, {{0, 2, 1}}}};
  EXPECT_EQ(faults_of(line)[0].rule, MeshRule::proper_triangles);
  EXPECT_EQ(faults_of(line)[0].count, 2u);
  // Size does not matter, only shape.
  Mesh tiny = cube;
  for (auto& v : tiny.vertices) v *= 1e-60;
  EXPECT_TRUE(faults_of(tiny).empty());
}

TEST(MeshFaults, UnknownAndNotFiniteVertices) {
  Mesh unknown = cube;
  unknown.triangles[3][1] = 8;
  auto faults = faults_of(unknown);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].rule, MeshRule::known_vertices);
  EXPECT_EQ(
      faults[0].message,
      "mesh 'part': 1 corner names a vertex that does not exist, first vertex 8 of triangle 3; vertices are numbered "
      "from 0 to below 8");
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Mesh infinite = cube;
    infinite.vertices[5].z = bad;
    faults = faults_of(infinite);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].rule, MeshRule::finite_vertices);
    EXPECT_NE(faults[0].message.find("first vertex 5 at (1, 0, "), std::string::npos) << faults[0].message;
  }
}

}  // namespace mesh_test
}  // namespace poinsot
