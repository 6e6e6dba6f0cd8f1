// Pictures of shapes against the closed forms of what they show: measure, center, inertia, normals, edges.
#include "poinsot/engine/mass/outlines.h"

#include <functional>
#include <set>

#include "engine/mass/random_shapes.h"

namespace poinsot {
namespace outlines_test {

using testing::near;
using testing::Random;
using Vector = Vector3<double>;

enum class Kind { line, surface, shell, solid };

struct Case {
  std::string name;
  Kind kind;
  bool exact;  // whether it has no round part
  ShapeProperties<double> properties;
  std::function<Outline(int per_turn)> outline;
};

std::vector<Case> cases(std::uint64_t seed) {
  Random<double> random(seed);
  const Vector A = random.point(), n = random.unit(), B = A + random.length() * n, across = random.across(n);
  const Vector C = A + random.across(n), D = A + cross(n, C - A) + 0.3 * n;
  const double r = random.length(), inner = 0.6 * r, thin = 0.2 * r, angle = random.between(0.3, 6);
  const Vector start = A + r * normalized(across - dot(across, n) * n);
  const Vector a = random.length() * n, b = random.length() * normalized(cross(n, across));
  const Vector c = random.length() * normalized(cross(a, b)) * (seed % 2 == 0 ? 1.0 : -1.0);
  const Vector side = random.across(B - A);
  std::vector<Case> all;
  const auto add = [&](const std::string& name, Kind kind, bool exact, const ShapeProperties<double>& properties,
                       std::function<Outline(int)> outline) {
    all.push_back({name, kind, exact, properties, std::move(outline)});
  };
  namespace s = shapes;
  namespace o = outlines;
  add("rod", Kind::line, true, s::rod(A, B), [=](int) { return o::rod(A, B); });
  add("wire", Kind::line, true, s::polyline<double>({A, B, C, A}), [=](int) { return o::polyline({A, B, C, A}); });
  add("arc", Kind::line, false, s::arc_from_point(A, n, start, angle),
      [=](int k) { return o::arc_from_point(A, n, start, angle, k); });
  add("arc turned back", Kind::line, false, s::arc_from_point(A, Vector(-n), start, angle),
      [=](int k) { return o::arc_from_point(A, n, start, -angle, k); });
  add("ring", Kind::line, false, s::ring(A, n, r), [=](int k) { return o::ring(A, n, r, k); });
  add("semicircular arc", Kind::line, false, s::semicircular_arc(A, B, side),
      [=](int k) { return o::semicircular_arc(A, B, side, k); });
  add("rectangle", Kind::surface, true, s::rectangle(A, a, b), [=](int) { return o::rectangle(A, a, b); });
  add("triangle", Kind::surface, true, s::triangle(A, B, C), [=](int) { return o::triangle(A, B, C); });
  // An L, a notched star and one that goes round the other way.
  const std::vector<Vector> ell{A, A + 2.0 * a, A + 2.0 * a + b, A + a + b, A + a + 3.0 * b, A + 3.0 * b};
  add("polygon", Kind::surface, true, s::polygon(ell), [=](int) { return o::polygon(ell); });
  std::vector<Vector> star;
  for (int k = 0; k < 14; ++k)
    star.push_back(A + (k % 2 == 0 ? r : 0.4 * r) *
                           (std::cos(k * 0.448) * normalized(a) + std::sin(k * 0.448) * normalized(b)));
  add("star", Kind::surface, true, s::polygon(star), [=](int) { return o::polygon(star); });
  add("disk", Kind::surface, false, s::disk(A, n, r), [=](int k) { return o::disk(A, n, r, k); });
  add("annulus", Kind::surface, false, s::annulus(A, n, r, inner),
      [=](int k) { return o::annulus(A, n, r, inner, k); });
  add("semicircle", Kind::surface, false, s::semicircle(A, B, side),
      [=](int k) { return o::semicircle(A, B, side, k); });
  add("sector", Kind::surface, false, s::sector(A, n, r, across, angle),
      [=](int k) { return o::sector(A, n, r, across, angle, k); });
  add("annular sector", Kind::surface, false, s::annular_sector(A, n, r, inner, across, angle),
      [=](int k) { return o::annular_sector(A, n, r, inner, across, angle, k); });
  add("box shell", Kind::shell, true, s::box_shell_between(A, Vector(A + Vector{1, -2, 0.5})), [=](int) {
    return o::box_shell_between(A, A + Vector{1, -2, 0.5});
  });
  add("sphere shell", Kind::shell, false, s::sphere_shell(A, r), [=](int k) { return o::sphere_shell(A, r, k); });
  add("hemisphere shell", Kind::shell, false, s::hemisphere_shell(A, n, r),
      [=](int k) { return o::hemisphere_shell(A, n, r, k); });
  add("cylinder shell", Kind::shell, false, s::cylinder_shell(A, B, r),
      [=](int k) { return o::cylinder_shell(A, B, r, k); });
  add("closed cylinder shell", Kind::shell, false, s::closed_cylinder_shell(A, B, r),
      [=](int k) { return o::closed_cylinder_shell(A, B, r, k); });
  add("cone shell", Kind::shell, false, s::cone_shell(A, B, r), [=](int k) { return o::cone_shell(A, B, r, k); });
  add("box", Kind::solid, true, s::box(A, a, b, c), [=](int) { return o::box(A, a, b, c); });
  add("box between", Kind::solid, true, s::box_between(A, Vector(A + Vector{1, -2, 0.5})), [=](int) {
    return o::box_between(A, A + Vector{1, -2, 0.5});
  });
  add("cube", Kind::solid, true, s::cube(A, r), [=](int) { return o::cube(A, r); });
  add("cube from diagonal", Kind::solid, true, s::cube_from_diagonal(A, B),
      [=](int) { return o::cube_from_diagonal(A, B); });
  add("sphere", Kind::solid, false, s::sphere(A, r), [=](int k) { return o::sphere(A, r, k); });
  add("hemisphere", Kind::solid, false, s::hemisphere(A, n, r), [=](int k) { return o::hemisphere(A, n, r, k); });
  add("cylinder", Kind::solid, false, s::cylinder(A, B, r), [=](int k) { return o::cylinder(A, B, r, k); });
  add("tube", Kind::solid, false, s::tube(A, B, r, inner), [=](int k) { return o::tube(A, B, r, inner, k); });
  add("cone", Kind::solid, false, s::cone(A, B, r), [=](int k) { return o::cone(A, B, r, k); });
  add("frustum", Kind::solid, false, s::frustum(A, r, B, inner), [=](int k) { return o::frustum(A, r, B, inner, k); });
  add("ellipsoid", Kind::solid, false, s::ellipsoid(A, a, b, c), [=](int k) { return o::ellipsoid(A, a, b, c, k); });
  add("torus", Kind::solid, false, s::torus(A, n, r, thin), [=](int k) { return o::torus(A, n, r, thin, k); });
  add("tetrahedron", Kind::solid, true, s::tetrahedron(A, B, C, D), [=](int) { return o::tetrahedron(A, B, C, D); });
  add("prism", Kind::solid, true, s::prism(star, Vector(c + 0.3 * a)),
      [=](int) { return o::prism(star, c + 0.3 * a); });
  add("prism, down", Kind::solid, true, s::prism(star, Vector(-c)), [=](int) { return o::prism(star, -c); });
  add("thick sector", Kind::solid, false, s::thick_sector(A, n, r, inner, across, angle, 0.7),
      [=](int k) { return o::thick_sector(A, n, r, inner, across, angle, 0.7, k); });
  add("thick sector to its tip", Kind::solid, false, s::thick_sector(A, n, r, 0.0, across, angle, 0.7),
      [=](int k) { return o::thick_sector(A, n, r, 0, across, angle, 0.7, k); });
  add("half cylinder", Kind::solid, false, s::half_cylinder(A, B, r, side),
      [=](int k) { return o::half_cylinder(A, B, r, side, k); });
  add("paraboloid", Kind::solid, false, s::paraboloid(A, B, r), [=](int k) { return o::paraboloid(A, B, r, k); });
  add("mesh", Kind::solid, true, s::tetrahedron(A, B, C, D), [=](int) {
    const Outline solid = o::tetrahedron(Vector::zero(), B - A, C - A, D - A);
    return o::solid_of_mesh({solid.vertices, solid.triangles}, A);
  });
  return all;
}

ShapeProperties<double> properties_of(const Outline& outline, Kind kind) {
  if (kind == Kind::line) {
    std::vector<Vector> points;
    for (const std::uint32_t k : outline.edges.at(0)) points.push_back(outline.vertices[k]);
    return shapes::polyline(points);
  }
  const TriangleMesh<double> mesh{outline.vertices, outline.triangles};
  return kind == Kind::solid ? solid_of_mesh(mesh) : shell_of_mesh(mesh);
}

Vector facet_normal(const Outline& outline, std::size_t t) {
  const auto& [i, j, k] = outline.triangles[t];
  const std::vector<Vector>& P = outline.vertices;
  return normalized(Vector(cross(P[j] - P[i], P[k] - P[i])));
}

// The largest angle between the normal of a facet and that of the surface at its corners.
double largest_lean(const Outline& outline) {
  double largest = 0;
  for (std::size_t t = 0; t < outline.triangles.size(); ++t)
    for (const Vector& normal : outline.normals[t])
      largest = std::max(largest, norm(Vector(cross(normal, facet_normal(outline, t)))));
  return largest;
}

TEST(Outlines, MeasureCenterAndInertiaConvergeToTheClosedForms) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const Case& one : cases(seed)) {
      const ShapeProperties<double> coarse = properties_of(one.outline(48), one.kind);
      const ShapeProperties<double> fine = properties_of(one.outline(96), one.kind);
      const double size = std::cbrt(norm(coarse.center) + 1);
      const auto error = [&](const ShapeProperties<double>& found) {
        return std::abs(found.measure / one.properties.measure - 1);
      };
      if (one.exact) {
        EXPECT_LT(error(coarse), 1e-12) << one.name;
        EXPECT_TRUE(near(coarse.center, one.properties.center, 1e-12)) << one.name;
        EXPECT_TRUE(near(coarse.inertia_center, one.properties.inertia_center, 1e-10)) << one.name;
        continue;
      }
      EXPECT_LT(error(coarse), 0.02) << one.name;
      EXPECT_LT(error(fine), 0.5 * error(coarse) + 1e-12) << one.name << " " << error(coarse) << " " << error(fine);
      EXPECT_LE(norm(Vector(fine.center - one.properties.center)),
                0.5 * norm(Vector(coarse.center - one.properties.center)) + 1e-9 * size)
          << one.name;
      EXPECT_TRUE(near(coarse.inertia_center, one.properties.inertia_center, 0.05)) << one.name;
      EXPECT_TRUE(near(fine.inertia_center, one.properties.inertia_center, 0.015)) << one.name;
    }
}

TEST(Outlines, SolidsAreClosedAndOutward) {
  std::size_t solids = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const Case& one : cases(seed)) {
      if (one.kind != Kind::solid) continue;
      ++solids;
      const Outline outline = one.outline(48);
      const auto faults = find_faults({outline.vertices, outline.triangles}, one.name);
      EXPECT_TRUE(faults.empty()) << faults.front().message;
    }
  EXPECT_EQ(solids, 4 * 20U);
}

TEST(Outlines, NormalsAreThoseOfTheTrueSurface) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const Case& one : cases(seed)) {
      const Outline outline = one.outline(48);
      ASSERT_EQ(outline.normals.size(), outline.triangles.size());
      for (std::size_t t = 0; t < outline.triangles.size(); ++t)
        for (const Vector& normal : outline.normals[t]) {
          ASSERT_NEAR(norm(normal), 1, 1e-12) << one.name;
          ASSERT_GT(dot(normal, facet_normal(outline, t)), 0) << one.name;
        }
      const double coarse = largest_lean(outline), fine = largest_lean(one.outline(96));
      EXPECT_LE(fine, 0.62 * coarse + 1e-7) << one.name << " " << coarse << " " << fine;
    }
}

TEST(Outlines, EdgesAreSidesOfTriangles) {
  for (const Case& one : cases(5)) {
    const Outline outline = one.outline(48);
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const auto& [i, j, k] : outline.triangles)
      for (const auto& [p, q] : {std::pair{i, j}, {j, k}, {k, i}}) sides.insert(std::minmax(p, q));
    for (const auto& edge : outline.edges) {
      ASSERT_GE(edge.size(), 2U);
      for (std::size_t k = 0; k + 1 < edge.size(); ++k) {
        ASSERT_LT(edge[k + 1], outline.vertices.size());
        if (one.kind != Kind::line) {
          EXPECT_TRUE(sides.contains(std::minmax(edge[k], edge[k + 1]))) << one.name;
        }
      }
    }
  }
}

// What a draughtsman draws from any side.
TEST(Outlines, EdgesAreRimsAndCorners) {
  const std::map<std::string, std::size_t> counts{
      {"sphere", 0},     {"torus", 0},          {"ellipsoid", 0},  {"cylinder", 2}, {"tube", 4},
      {"cone", 1},       {"frustum", 2},        {"hemisphere", 1}, {"disk", 1},     {"annulus", 2},
      {"cone shell", 1}, {"cylinder shell", 2}, {"paraboloid", 1}};
  std::size_t seen = 0;
  for (const Case& one : cases(7)) {
    const auto count = counts.find(one.name);
    if (count == counts.end()) continue;
    ++seen;
    EXPECT_EQ(one.outline(48).edges.size(), count->second) << one.name;
    for (const auto& edge : one.outline(48).edges) EXPECT_EQ(edge.front(), edge.back()) << one.name;
  }
  EXPECT_EQ(seen, counts.size());
}

// A cylinder that comes as a mesh is round and has two rims.
TEST(Outlines, MeshesAreRoundWhereTheyTurnLittle) {
  const Outline cylinder = outlines::cylinder({0, 0, 0}, {0, 0, 2}, 0.5, 24);
  const Outline mesh = outlines::solid_of_mesh({cylinder.vertices, cylinder.triangles}, {1, 0, 0});
  EXPECT_EQ(mesh.edges.size(), 2U);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_GT(dot(mesh.normals[t][c], cylinder.normals[t][c]), 0.99);
  const Outline box = outlines::box_of_mesh({cylinder.vertices, cylinder.triangles}, {1, 0, 0});
  EXPECT_NEAR(solid_of_mesh(TriangleMesh<double>{box.vertices, box.triangles}).measure, 2, 1e-12);
}

}  // namespace outlines_test
}  // namespace poinsot
