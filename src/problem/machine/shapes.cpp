#include "problem/machine/shapes.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "poinsot/engine/mass/particles.h"
#include "poinsot/engine/mass/shapes.h"
#include "problem/entries/read_meshes.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/shape_arguments.h"
#include "problem/machine/shape_row.h"
#include "problem/machine/shape_surfaces.h"

namespace poinsot::problem {
namespace {

// The solid inside a mesh that the statement has read. The origin of the file's coordinates lies at p_OM.
template <class Scalar>
ShapeValues<Scalar> mesh_shape(const ShapeArguments<Scalar>& arguments, const Vector3<Scalar>& p_OM) {
  if (is_exact<Scalar>) throw NoFormula("the numbers of a mesh are not exact");
  if (!arguments.shape().mesh) throw std::logic_error("a mesh of the statement has not been read");
  const MeshSolid& solid = *arguments.shape().mesh;
  // The solid itself is constant, but its place may vary.
  const ShapeProperties<Scalar> properties{lifted<Scalar>(solid.properties.measure),
                                           lifted<Scalar>(solid.properties.center) + p_OM,
                                           lifted<Scalar>(solid.properties.inertia_center)};
  return arguments.values(Extent::volume, properties, [&] {
    ParticleSet<double> set = particles::solid_of_mesh(solid.mesh);
    for (WeightedParticle<double>& particle : set.particles) particle.position += plain(p_OM);
    return set;
  });
}

template <class Scalar>
ShapeValues<Scalar> arc(const ShapeArguments<Scalar>& a) {
  if (a.has("diameter")) {
    const auto ends = a.places("diameter", 2);
    const auto toward = a.toward("toward", Scalar(0.5) * (ends[0] + ends[1]));
    a.check(shape_faults::semicircular_arc(a.owner(), plain(ends[0]), plain(ends[1]), plain(toward)));
    return a.values(Extent::length, shapes::semicircular_arc(ends[0], ends[1], toward),
                    [&] { return particles::semicircular_arc(plain(ends[0]), plain(ends[1]), plain(toward)); });
  }
  const auto center = a.place("center"), start = a.place("start"), normal = a.direction("normal");
  const auto angle = a.angle("angle");
  a.check(shape_faults::arc_from_point(a.owner(), plain(center), plain(normal), plain(start), plain(angle)));
  return a.values(Extent::length, shapes::arc_from_point(center, normal, start, angle),
                  [&] { return particles::arc_from_point(plain(center), plain(normal), plain(start), plain(angle)); });
}

template <class Scalar>
ShapeValues<Scalar> rectangle(const ShapeArguments<Scalar>& a) {
  if (a.has("sides")) {
    const auto center = a.place("center");
    const auto sides = a.sides(2);
    a.check(shape_faults::rectangle(a.owner(), plain(center), plain(sides[0]), plain(sides[1])));
    return a.values(Extent::area, shapes::rectangle(center, sides[0], sides[1]),
                    [&] { return particles::rectangle(plain(center), plain(sides[0]), plain(sides[1])); });
  }
  const auto corners = a.places("corners");
  if (corners.size() != 3 && corners.size() != 4) a.refuse("it needs three corners in turn, or all four");
  a.check(shape_faults::rectangle_from_corners(a.owner(), plain(corners[0]), plain(corners[1]), plain(corners[2])));
  const auto fourth = corners[0] + corners[2] - corners[1];
  if (corners.size() == 4 &&
      norm(plain(corners[3] - fourth)) > shape_faults::default_tolerance * norm(plain(corners[2] - corners[0])))
    a.refuse("its fourth corner does not complete the rectangle",
             "list the corners in turn; other plates are a polygon:");
  return a.values(Extent::area, shapes::rectangle_from_corners(corners[0], corners[1], corners[2]), [&] {
    return particles::rectangle_from_corners(plain(corners[0]), plain(corners[1]), plain(corners[2]));
  });
}

template <class Scalar>
ShapeValues<Scalar> polygon(const ShapeArguments<Scalar>& a) {
  const auto vertices = a.places("points");
  // If a plate were less flat than this, its closed form would not agree with its particles.
  constexpr double flatness = 1e-8;
  a.check(shape_faults::polygon(a.owner(), plain(vertices), flatness));
  return a.values(Extent::area, shapes::polygon(vertices), [&] { return particles::polygon(plain(vertices)); });
}

template <class Scalar>
ShapeValues<Scalar> box(const ShapeArguments<Scalar>& a) {
  if (a.has("sides")) {
    const auto c = a.place("center");
    const auto s = a.sides(3);
    a.check(shape_faults::box(a.owner(), plain(c), plain(s[0]), plain(s[1]), plain(s[2])));
    return a.values(Extent::volume, shapes::box(c, s[0], s[1], s[2]),
                    [&] { return particles::box(plain(c), plain(s[0]), plain(s[1]), plain(s[2])); });
  }
  const auto c = a.places("corners", 2);
  a.check(shape_faults::box_between(a.owner(), plain(c[0]), plain(c[1])));
  return a.values(Extent::volume, shapes::box_between(c[0], c[1]),
                  [&] { return particles::box_between(plain(c[0]), plain(c[1])); });
}

template <class Scalar>
ShapeValues<Scalar> cube(const ShapeArguments<Scalar>& a) {
  if (a.has("diagonal")) {
    const auto ends = a.places("diagonal", 2);
    a.check(shape_faults::cube_from_diagonal(a.owner(), plain(ends[0]), plain(ends[1])));
    return a.values(Extent::volume, shapes::cube_from_diagonal(ends[0], ends[1]),
                    [&] { return particles::cube_from_diagonal(plain(ends[0]), plain(ends[1])); });
  }
  const auto center = a.place("center");
  const auto side = a.length("side");
  a.check(shape_faults::cube(a.owner(), plain(center), plain(side)));
  return a.values(Extent::volume, shapes::cube(center, side),
                  [&] { return particles::cube(plain(center), plain(side)); });
}

template <class Scalar>
ShapeValues<Scalar> ellipsoid(const ShapeArguments<Scalar>& a) {
  const auto center = a.place("center");
  const auto s = a.lengths("semi_axes", 3);
  using Vector = Vector3<Scalar>;
  std::vector<Vector> axes{Vector::unit(0), Vector::unit(1), Vector::unit(2)};
  if (a.has("axes")) axes = a.directions("axes", 3);
  for (const Scalar& length : s)
    if (!(plain(length) > 0)) a.refuse("its semi_axes must be more than zero");
  a.check(shape_faults::ellipsoid(a.owner(), plain(center), plain(s[0] * axes[0]), plain(s[1] * axes[1]),
                                  plain(s[2] * axes[2])));
  return a.values(Extent::volume, shapes::ellipsoid(center, s[0] * axes[0], s[1] * axes[1], s[2] * axes[2]), [&] {
    return particles::ellipsoid(plain(center), plain(s[0] * axes[0]), plain(s[1] * axes[1]), plain(s[2] * axes[2]));
  });
}

// A sector with an inner radius or a thickness.
template <class Scalar>
ShapeValues<Scalar> part_of_ring(const ShapeArguments<Scalar>& a) {
  const auto c = a.place("center"), n = a.direction("normal"), middle = a.toward("middle", c);
  const auto r = a.length("radius"), angle = a.angle("angle");
  const auto inner = a.has("inner_radius") ? a.length("inner_radius") : Scalar(0);
  a.check(shape_faults::sector(a.owner(), plain(c), plain(n), plain(r), plain(middle), plain(angle)));
  a.check(shape_faults::annulus(a.owner(), plain(c), plain(n), plain(r), plain(inner)));
  if (std::abs(plain(dot(n, middle))) > shape_faults::default_tolerance)
    a.refuse("middle does not lie across the normal");
  if (!a.has("thickness"))
    return a.values(Extent::area, shapes::annular_sector(c, n, r, inner, middle, angle), [&] {
      return particles::annular_sector(plain(c), plain(n), plain(r), plain(inner), plain(middle), plain(angle));
    });
  const auto thick = a.length("thickness");
  if (!(plain(thick) > 0)) a.refuse("its thickness must be more than zero");
  return a.values(Extent::volume, shapes::thick_sector(c, n, r, inner, middle, angle, thick), [&] {
    return particles::thick_sector(plain(c), plain(n), plain(r), plain(inner), plain(middle), plain(angle),
                                   plain(thick));
  });
}

// Each row: its words, its picture, closed form and particles, what else than round and straight surfaces it touches
// with, these surfaces.
template <class Scalar>
const std::map<std::string, ShapeRow<Scalar>>& rows() {
  static const std::map<std::string, ShapeRow<Scalar>> table{
      {"particle",
       {"particle", pictures::particle<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.place("points");
          a.check(shape_faults::particle(a.owner(), plain(P)));
          return a.values(Extent::point, shapes::particle(P), [&] { return particles::particle(plain(P)); });
        },
        OtherSurface::corners, nullptr, surfaces::particle<Scalar>}},
      {"rod",
       {"slender rod", pictures::rod<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.places("points", 2);
          a.check(shape_faults::rod(a.owner(), plain(P[0]), plain(P[1])));
          return a.values(Extent::length, shapes::rod(P[0], P[1]),
                          [&] { return particles::rod(plain(P[0]), plain(P[1])); });
        },
        OtherSurface::corners, nullptr, surfaces::points<Scalar>}},
      {"wire",
       {"wire", pictures::wire<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.places("points");
          a.check(shape_faults::polyline(a.owner(), plain(P)));
          return a.values(Extent::length, shapes::polyline(P), [&] { return particles::polyline(plain(P)); });
        },
        OtherSurface::corners, nullptr, surfaces::wire<Scalar>}},
      {"arc", {"arc", pictures::arc<Scalar>, arc<Scalar>, OtherSurface::corners, surfaces::arc<Scalar>}},
      {"ring",
       {"thin ring", pictures::ring<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), n = a.direction("normal");
          const auto r = a.length("radius");
          a.check(shape_faults::ring(a.owner(), plain(c), plain(n), plain(r)));
          return a.values(Extent::length, shapes::ring(c, n, r),
                          [&] { return particles::ring(plain(c), plain(n), plain(r)); });
        },
        OtherSurface::none, surfaces::circle<Scalar>}},
      {"rectangle",
       {"thin rectangular plate", pictures::rectangle<Scalar>, rectangle<Scalar>, OtherSurface::corners, nullptr,
        surfaces::rectangle<Scalar>}},
      {"triangle",
       {"thin triangular plate", pictures::triangle<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.places("points", 3);
          a.check(shape_faults::triangle(a.owner(), plain(P[0]), plain(P[1]), plain(P[2])));
          return a.values(Extent::area, shapes::triangle(P[0], P[1], P[2]),
                          [&] { return particles::polygon(plain(P)); });
        },
        OtherSurface::corners, nullptr, surfaces::points<Scalar>}},
      {"polygon",
       {"thin plate", pictures::polygon<Scalar>, polygon<Scalar>, OtherSurface::corners, nullptr,
        surfaces::points<Scalar>}},
      {"semicircle",
       {"thin half disk", pictures::semicircle<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.places("diameter", 2);
          const auto toward = a.toward("toward", Scalar(0.5) * (P[0] + P[1]));
          a.check(shape_faults::semicircle(a.owner(), plain(P[0]), plain(P[1]), plain(toward)));
          return a.values(Extent::area, shapes::semicircle(P[0], P[1], toward),
                          [&] { return particles::semicircle(plain(P[0]), plain(P[1]), plain(toward)); });
        },
        OtherSurface::corners, surfaces::arc<Scalar>, surfaces::semicircle<Scalar>}},
      {"disk",
       {"thin disk", pictures::disk<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), n = a.direction("normal");
          const auto r = a.length("radius");
          a.check(shape_faults::disk(a.owner(), plain(c), plain(n), plain(r)));
          return a.values(Extent::area, shapes::disk(c, n, r),
                          [&] { return particles::disk(plain(c), plain(n), plain(r)); });
        },
        OtherSurface::none, surfaces::circle<Scalar>}},
      {"annulus",
       {"annulus", pictures::annulus<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), n = a.direction("normal");
          const auto r = a.length("radius"), inner = a.length("inner_radius");
          a.check(shape_faults::annulus(a.owner(), plain(c), plain(n), plain(r), plain(inner)));
          return a.values(Extent::area, shapes::annulus(c, n, r, inner),
                          [&] { return particles::annulus(plain(c), plain(n), plain(r), plain(inner)); });
        },
        OtherSurface::none, surfaces::circle<Scalar>}},
      {"sector",
       {"sector", pictures::sector<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), n = a.direction("normal"), middle = a.toward("middle", c);
          const auto r = a.length("radius"), angle = a.angle("angle");
          if (std::abs(plain(dot(n, middle))) > shape_faults::default_tolerance)
            a.refuse("middle does not lie across the normal");
          a.check(shape_faults::sector(a.owner(), plain(c), plain(n), plain(r), plain(middle), plain(angle)));
          return a.values(Extent::area, shapes::sector(c, n, r, middle, angle),
                          [&] { return particles::sector(plain(c), plain(n), plain(r), plain(middle), plain(angle)); });
        },
        OtherSurface::corners, surfaces::arc<Scalar>, surfaces::sector<Scalar>}},
      {"annular_sector",
       {"sector between two radii", pictures::thick_sector<Scalar>, part_of_ring<Scalar>, OtherSurface::curved}},
      {"thick_sector", {"thick sector", pictures::thick_sector<Scalar>, part_of_ring<Scalar>, OtherSurface::curved}},
      {"box_shell",
       {"box shell", pictures::box_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.places("corners", 2);
          a.check(shape_faults::box_shell_between(a.owner(), plain(c[0]), plain(c[1])));
          return a.values(Extent::area, shapes::box_shell_between(c[0], c[1]),
                          [&] { return particles::box_shell_between(plain(c[0]), plain(c[1])); });
        },
        OtherSurface::corners, nullptr, surfaces::box<Scalar>}},
      {"sphere_shell",
       {"sphere shell", pictures::sphere_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center");
          const auto r = a.length("radius");
          a.check(shape_faults::sphere_shell(a.owner(), plain(c), plain(r)));
          return a.values(Extent::area, shapes::sphere_shell(c, r),
                          [&] { return particles::sphere_shell(plain(c), plain(r)); });
        },
        OtherSurface::none, surfaces::sphere<Scalar>}},
      {"hemisphere_shell",
       {"hemisphere shell", pictures::hemisphere_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), toward = a.toward("toward", c);
          const auto r = a.length("radius");
          a.check(shape_faults::hemisphere_shell(a.owner(), plain(c), plain(toward), plain(r)));
          return a.values(Extent::area, shapes::hemisphere_shell(c, toward, r),
                          [&] { return particles::hemisphere_shell(plain(c), plain(toward), plain(r)); });
        },
        OtherSurface::none, surfaces::hemisphere<Scalar>}},
      {"cylinder_shell",
       {"cylinder shell", pictures::cylinder_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto [A, B] = a.ends();
          const auto r = a.length("radius");
          a.check(shape_faults::cylinder_shell(a.owner(), plain(A), plain(B), plain(r)));
          return a.values(Extent::area, shapes::cylinder_shell(A, B, r),
                          [&, &A = A, &B = B] { return particles::cylinder_shell(plain(A), plain(B), plain(r)); });
        },
        OtherSurface::none, surfaces::cylinder<Scalar>}},
      {"closed_cylinder_shell",
       {"closed cylinder shell", pictures::closed_cylinder_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto [A, B] = a.ends();
          const auto r = a.length("radius");
          a.check(shape_faults::closed_cylinder_shell(a.owner(), plain(A), plain(B), plain(r)));
          return a.values(Extent::area, shapes::closed_cylinder_shell(A, B, r), [&, &A = A, &B = B] {
            return particles::closed_cylinder_shell(plain(A), plain(B), plain(r));
          });
        },
        OtherSurface::none, surfaces::cylinder<Scalar>}},
      {"cone_shell",
       {"cone shell", pictures::cone_shell<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto apex = a.place("apex"), base = a.place("base");
          const auto r = a.length("radius");
          a.check(shape_faults::cone_shell(a.owner(), plain(apex), plain(base), plain(r)));
          return a.values(Extent::area, shapes::cone_shell(apex, base, r),
                          [&] { return particles::cone_shell(plain(apex), plain(base), plain(r)); });
        },
        OtherSurface::none, surfaces::cone<Scalar>}},
      {"box",
       {"rectangular block", pictures::box<Scalar>, box<Scalar>, OtherSurface::corners, nullptr,
        surfaces::box<Scalar>}},
      {"cube", {"cube", pictures::cube<Scalar>, cube<Scalar>, OtherSurface::corners, nullptr, surfaces::cube<Scalar>}},
      {"sphere",
       {"sphere", pictures::sphere<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center");
          const auto r = a.length("radius");
          a.check(shape_faults::sphere(a.owner(), plain(c), plain(r)));
          return a.values(Extent::volume, shapes::sphere(c, r), [&] { return particles::sphere(plain(c), plain(r)); });
        },
        OtherSurface::none, surfaces::sphere<Scalar>}},
      {"hemisphere",
       {"hemisphere", pictures::hemisphere<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), toward = a.toward("toward", c);
          const auto r = a.length("radius");
          a.check(shape_faults::hemisphere(a.owner(), plain(c), plain(toward), plain(r)));
          return a.values(Extent::volume, shapes::hemisphere(c, toward, r),
                          [&] { return particles::hemisphere(plain(c), plain(toward), plain(r)); });
        },
        OtherSurface::none, surfaces::hemisphere<Scalar>}},
      {"cylinder",
       {"cylinder", pictures::cylinder<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto [A, B] = a.ends();
          const auto r = a.length("radius");
          a.check(shape_faults::cylinder(a.owner(), plain(A), plain(B), plain(r)));
          return a.values(Extent::volume, shapes::cylinder(A, B, r),
                          [&, &A = A, &B = B] { return particles::cylinder(plain(A), plain(B), plain(r)); });
        },
        OtherSurface::none, surfaces::cylinder<Scalar>}},
      {"tube",
       {"tube", pictures::tube<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto [A, B] = a.ends();
          const auto r = a.length("radius"), inner = a.length("inner_radius");
          a.check(shape_faults::tube(a.owner(), plain(A), plain(B), plain(r), plain(inner)));
          return a.values(Extent::volume, shapes::tube(A, B, r, inner),
                          [&, &A = A, &B = B] { return particles::tube(plain(A), plain(B), plain(r), plain(inner)); });
        },
        OtherSurface::none, surfaces::cylinder<Scalar>}},
      {"cone",
       {"cone", pictures::cone<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto apex = a.place("apex"), base = a.place("base");
          const auto r = a.length("radius");
          a.check(shape_faults::cone(a.owner(), plain(apex), plain(base), plain(r)));
          return a.values(Extent::volume, shapes::cone(apex, base, r),
                          [&] { return particles::cone(plain(apex), plain(base), plain(r)); });
        },
        OtherSurface::none, surfaces::cone<Scalar>}},
      {"frustum",
       {"frustum", pictures::frustum<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto A = a.place("base"), B = a.place("top");
          const auto r_A = a.length("base_radius"), r_B = a.length("top_radius");
          a.check(shape_faults::frustum(a.owner(), plain(A), plain(r_A), plain(B), plain(r_B)));
          return a.values(Extent::volume, shapes::frustum(A, r_A, B, r_B),
                          [&] { return particles::frustum(plain(A), plain(r_A), plain(B), plain(r_B)); });
        },
        OtherSurface::none, surfaces::frustum<Scalar>}},
      {"ellipsoid",
       {"ellipsoid", pictures::ellipsoid<Scalar>, ellipsoid<Scalar>, OtherSurface::curved,
        surfaces::ellipsoid<Scalar>}},
      {"torus",
       {"torus", pictures::torus<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto c = a.place("center"), n = a.direction("normal");
          const auto r = a.length("radius"), section = a.length("tube_radius");
          a.check(shape_faults::torus(a.owner(), plain(c), plain(n), plain(r), plain(section)));
          return a.values(Extent::volume, shapes::torus(c, n, r, section),
                          [&] { return particles::torus(plain(c), plain(n), plain(r), plain(section)); });
        },
        OtherSurface::curved, surfaces::torus<Scalar>}},
      {"tetrahedron",
       {"tetrahedron", pictures::tetrahedron<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto P = a.places("points", 4);
          a.check(shape_faults::tetrahedron(a.owner(), plain(P[0]), plain(P[1]), plain(P[2]), plain(P[3])));
          return a.values(Extent::volume, shapes::tetrahedron(P[0], P[1], P[2], P[3]),
                          [&] { return particles::tetrahedron(plain(P[0]), plain(P[1]), plain(P[2]), plain(P[3])); });
        },
        OtherSurface::corners, nullptr, surfaces::tetrahedron<Scalar>}},
      {"prism",
       {"prism", pictures::prism<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto base = a.places("base");
          const auto edge = a.place("along");
          constexpr double flatness = 1e-8;  // as of a polygon
          a.check(shape_faults::prism(a.owner(), plain(base), plain(edge), flatness));
          return a.values(Extent::volume, shapes::prism(base, edge),
                          [&] { return particles::prism(plain(base), plain(edge)); });
        },
        OtherSurface::corners, nullptr, surfaces::prism<Scalar>}},
      {"half_cylinder",
       {"half cylinder", pictures::half_cylinder<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto [A, B] = a.ends();
          const auto r = a.length("radius");
          const auto toward = a.toward("toward", a.place("center"));
          a.check(shape_faults::half_cylinder(a.owner(), plain(A), plain(B), plain(r), plain(toward)));
          return a.values(Extent::volume, shapes::half_cylinder(A, B, r, toward), [&, &A = A, &B = B] {
            return particles::half_cylinder(plain(A), plain(B), plain(r), plain(toward));
          });
        },
        OtherSurface::corners, surfaces::half_cylinder<Scalar>, surfaces::half_cylinder_face<Scalar>}},
      {"paraboloid",
       {"paraboloid", pictures::paraboloid<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto apex = a.place("apex"), base = a.place("base");
          const auto r = a.length("radius");
          a.check(shape_faults::paraboloid(a.owner(), plain(apex), plain(base), plain(r)));
          return a.values(Extent::volume, shapes::paraboloid(apex, base, r),
                          [&] { return particles::paraboloid(plain(apex), plain(base), plain(r)); });
        },
        OtherSurface::curved}},
      {"mesh",
       {"mesh", pictures::mesh<Scalar>,
        [](const ShapeArguments<Scalar>& a) {
          const auto at = a.has("at") ? a.place("at") : Vector3<Scalar>::zero();
          return mesh_shape(a, at);
        },
        OtherSurface::curved}},
  };
  return table;
}

}  // namespace

const Expression& shape_argument(const Shape& shape, const std::string& name, const std::string& file) {
  for (const NamedExpression& argument : shape.arguments)
    if (argument.name == name) return argument.value;
  fail(file, shape.mark, "a " + shape.kind + " needs '" + name + "'");
}

template <class Scalar>
const ShapeRow<Scalar>& shape_row(const std::string& kind) {
  const auto row = rows<Scalar>().find(kind);
  if (row == rows<Scalar>().end())
    throw std::logic_error("the shape '" + kind + "' is a key and has no row in its table");
  return row->second;
}

template <class Scalar>
ShapeValues<Scalar> shape_values(const Shape& shape, DataScope<Scalar>& data, const std::string& owner,
                                 bool particles) {
  const ShapeArguments<Scalar> arguments(shape, data, owner, particles);
  ShapeValues<Scalar> values = shape_row<Scalar>(shape.kind).values(arguments);
  const double measure = plain(values.properties.measure);
  const SymmetricMatrix3<double> I = plain(values.properties.inertia_center);
  if (values.extent != Extent::point && !(measure > 0))
    arguments.refuse("it has no extent", "its points coincide or lie in one line or plane");
  if (!std::isfinite(measure + I.xx + I.yy + I.zz + I.xy + I.yz + I.zx + norm(plain(values.properties.center))))
    arguments.refuse("its mass properties are beyond the range of numbers", "its lengths are too large");
  return values;
}

Outline shape_picture(const Shape& shape, DataScope<double>& data, const std::string& owner) {
  shape_values(shape, data, owner, false);
  return shape_row<double>(shape.kind).picture(ShapeArguments<double>(shape, data, owner, false));
}

template const ShapeRow<double>& shape_row(const std::string&);
template const ShapeRow<Dual<1>>& shape_row(const std::string&);
template const ShapeRow<Formula>& shape_row(const std::string&);
template ShapeValues<double> shape_values(const Shape&, DataScope<double>&, const std::string&, bool);
template ShapeValues<Dual<1>> shape_values(const Shape&, DataScope<Dual<1>>&, const std::string&, bool);
template ShapeValues<Formula> shape_values(const Shape&, DataScope<Formula>&, const std::string&, bool);

}  // namespace poinsot::problem
