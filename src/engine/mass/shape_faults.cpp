#include "poinsot/engine/mass/shape_faults.h"

#include <algorithm>
#include <cmath>

#include "engine/mass/shape_check.h"

namespace poinsot::shape_faults {
namespace {

ShapeCheck& circle(ShapeCheck& check, const Point& center, const Point& normal, double radius) {
  return check.point("the center", center).direction("the normal", normal).positive("the radius", radius);
}

ShapeCheck& half_circle(ShapeCheck& check, const Point& A, const Point& B, const Point& toward) {
  return check.distinct("end A", A, "end B", B).across("the direction 'toward'", toward, "the diameter", B - A);
}

Fault dome(ShapeCheck check, const Point& center, const Point& axis, double radius) {
  return check.point("the center", center).direction("the axis", axis).positive("the radius", radius).result();
}

Fault round_bar(ShapeCheck check, const Point& A, const Point& B, double radius) {
  return check.distinct("end A", A, "end B", B).positive("the radius", radius).result();
}

ShapeCheck& conical(ShapeCheck& check, const Point& apex, const Point& base_center, double radius) {
  return check.distinct("the apex", apex, "the center of the base", base_center).positive("the radius", radius);
}

Fault three_edges(ShapeCheck check, const Point& center, const Point& a, const Point& b, const Point& c,
                  std::string_view what, double tolerance) {
  const std::string first = fmt::format("{} a", what);
  const std::string second = fmt::format("{} b", what);
  const std::string third = fmt::format("{} c", what);
  return check.point("the center", center)
      .edge(first, a)
      .edge(second, b)
      .edge(third, c)
      .perpendicular(first, a, second, b, tolerance)
      .perpendicular(second, b, third, c, tolerance)
      .perpendicular(third, c, first, a, tolerance)
      .result();
}

Fault between_corners(ShapeCheck check, const Point& corner, const Point& opposite, const Matrix3<double>& axes,
                      double tolerance) {
  check.point("the corner", corner).point("the opposite corner", opposite);
  constexpr std::array<const char*, 3> names{"axis x", "axis y", "axis z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point axis = axes.column(i);
    check.direction(names[i], axis);
    check.require(std::abs(norm(axis) - 1) <= tolerance, ShapeRule::given_direction,
                  "{} {} must be a unit vector, but has the length {:.10g}", names[i], text(axis), norm(axis));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    check.perpendicular(names[i], axes.column(i), names[j], axes.column(j), tolerance);
  }
  const double largest = std::max(norm(corner), norm(opposite));
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = dot(axes.column(i), opposite - corner);
    check.require(std::abs(size) > zero_length * largest, ShapeRule::positive_extent,
                  "the corners {} and {} have the same place along {}; a box needs three sizes more than "
                  "zero",
                  text(corner), text(opposite), names[i]);
  }
  return check.result();
}

ShapeCheck& two_radii(ShapeCheck& check, double outer_radius, double inner_radius) {
  return check.positive("the outer radius", outer_radius)
      .not_negative("the inner radius", inner_radius)
      .require(inner_radius < outer_radius, ShapeRule::radii_order,
               "the inner radius {:.10g} m must be less than the outer radius {:.10g} m", inner_radius, outer_radius);
}

}  // namespace

Fault particle(std::string_view name, const Point& point) {
  return ShapeCheck("particle", name).point("the position", point).result();
}

Fault rod(std::string_view name, const Point& A, const Point& B) {
  return ShapeCheck("rod", name).distinct("end A", A, "end B", B).result();
}

Fault polyline(std::string_view name, const std::vector<Point>& points) {
  ShapeCheck check("wire", name);
  check.require(points.size() >= 2, ShapeRule::enough_points, "a wire needs at least 2 points, but {} {} given",
                points.size(), points.size() == 1 ? "is" : "are");
  for (std::size_t i = 1; i < points.size() && check.good(); ++i) {
    check.distinct(fmt::format("point {}", i), points[i - 1], fmt::format("point {}", i + 1), points[i]);
  }
  return check.result();
}

Fault arc(std::string_view name, const Point& center, const Point& normal, const Point& start_direction, double radius,
          double angle) {
  ShapeCheck check("arc", name);
  return circle(check, center, normal, radius)
      .across("the start direction", start_direction, "the normal", normal)
      .turn("the angle", angle)
      .result();
}

Fault arc_from_point(std::string_view name, const Point& center, const Point& normal, const Point& start_point,
                     double angle, double tolerance) {
  return ShapeCheck("arc", name)
      .distinct("the center", center, "the start", start_point)
      .direction("the normal", normal)
      .perpendicular("the normal", normal, "the line from the center to the start", start_point - center, tolerance)
      .turn("the angle", angle)
      .result();
}

Fault ring(std::string_view name, const Point& center, const Point& normal, double radius) {
  ShapeCheck check("ring", name);
  return circle(check, center, normal, radius).result();
}

Fault semicircular_arc(std::string_view name, const Point& A, const Point& B, const Point& toward) {
  ShapeCheck check("semicircular wire", name);
  return half_circle(check, A, B, toward).result();
}

Fault rectangle(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b,
                double tolerance) {
  return ShapeCheck("rectangle", name)
      .point("the center", center)
      .edge("edge a", edge_a)
      .edge("edge b", edge_b)
      .perpendicular("edge a", edge_a, "edge b", edge_b, tolerance)
      .result();
}

Fault rectangle_from_corners(std::string_view name, const Point& A, const Point& B, const Point& C, double tolerance) {
  return ShapeCheck("rectangle", name)
      .distinct("corner A", A, "corner B", B)
      .distinct("corner B", B, "corner C", C)
      .perpendicular("the edge BA", A - B, "the edge BC", C - B, tolerance)
      .result();
}

Fault triangle(std::string_view name, const Point& A, const Point& B, const Point& C) {
  ShapeCheck check("triangle", name);
  check.distinct("corner A", A, "corner B", B)
      .distinct("corner B", B, "corner C", C)
      .distinct("corner C", C, "corner A", A);
  return check
      .require(norm(cross(B - A, C - A)) > zero_length * norm(B - A) * norm(C - A), ShapeRule::not_collinear,
               "the corners {}, {}, {} lie on one line; a plate needs an area", text(A), text(B), text(C))
      .result();
}

Fault disk(std::string_view name, const Point& center, const Point& normal, double radius) {
  ShapeCheck check("disk", name);
  return circle(check, center, normal, radius).result();
}

Fault annulus(std::string_view name, const Point& center, const Point& normal, double outer_radius,
              double inner_radius) {
  ShapeCheck check("annulus", name);
  check.point("the center", center).direction("the normal", normal);
  return two_radii(check, outer_radius, inner_radius).result();
}

Fault semicircle(std::string_view name, const Point& A, const Point& B, const Point& toward) {
  ShapeCheck check("semicircular plate", name);
  return half_circle(check, A, B, toward).result();
}

Fault sector(std::string_view name, const Point& center, const Point& normal, double radius,
             const Point& middle_direction, double angle) {
  ShapeCheck check("sector", name);
  return circle(check, center, normal, radius)
      .across("the middle direction", middle_direction, "the normal", normal)
      .turn("the angle", angle)
      .result();
}

Fault box_shell(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b,
                const Point& edge_c, double tolerance) {
  return three_edges(ShapeCheck("box of sheets", name), center, edge_a, edge_b, edge_c, "edge", tolerance);
}

Fault box_shell_between(std::string_view name, const Point& corner, const Point& opposite, const Matrix3<double>& axes,
                        double tolerance) {
  return between_corners(ShapeCheck("box of sheets", name), corner, opposite, axes, tolerance);
}

Fault sphere_shell(std::string_view name, const Point& center, double radius) {
  return ShapeCheck("spherical shell", name).point("the center", center).positive("the radius", radius).result();
}

Fault hemisphere_shell(std::string_view name, const Point& center, const Point& axis, double radius) {
  return dome(ShapeCheck("hemispherical shell", name), center, axis, radius);
}

Fault cylinder_shell(std::string_view name, const Point& A, const Point& B, double radius) {
  return round_bar(ShapeCheck("cylindrical shell", name), A, B, radius);
}

Fault closed_cylinder_shell(std::string_view name, const Point& A, const Point& B, double radius) {
  return round_bar(ShapeCheck("closed cylindrical shell", name), A, B, radius);
}

Fault cone_shell(std::string_view name, const Point& apex, const Point& base_center, double radius) {
  ShapeCheck check("conical shell", name);
  return conical(check, apex, base_center, radius).result();
}

Fault box(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b, const Point& edge_c,
          double tolerance) {
  return three_edges(ShapeCheck("box", name), center, edge_a, edge_b, edge_c, "edge", tolerance);
}

Fault box_between(std::string_view name, const Point& corner, const Point& opposite, const Matrix3<double>& axes,
                  double tolerance) {
  return between_corners(ShapeCheck("box", name), corner, opposite, axes, tolerance);
}

Fault cube(std::string_view name, const Point& center, double edge) {
  return ShapeCheck("cube", name).point("the center", center).positive("the edge", edge).result();
}

Fault cube_from_diagonal(std::string_view name, const Point& B, const Point& C) {
  return ShapeCheck("cube", name).distinct("corner B", B, "the opposite corner C", C).result();
}

Fault sphere(std::string_view name, const Point& center, double radius) {
  return ShapeCheck("sphere", name).point("the center", center).positive("the radius", radius).result();
}

Fault hemisphere(std::string_view name, const Point& center, const Point& axis, double radius) {
  return dome(ShapeCheck("hemisphere", name), center, axis, radius);
}

Fault cylinder(std::string_view name, const Point& A, const Point& B, double radius) {
  return round_bar(ShapeCheck("cylinder", name), A, B, radius);
}

Fault tube(std::string_view name, const Point& A, const Point& B, double outer_radius, double inner_radius) {
  ShapeCheck check("tube", name);
  check.distinct("end A", A, "end B", B);
  return two_radii(check, outer_radius, inner_radius).result();
}

Fault cone(std::string_view name, const Point& apex, const Point& base_center, double radius) {
  ShapeCheck check("cone", name);
  return conical(check, apex, base_center, radius).result();
}

Fault frustum(std::string_view name, const Point& A, double radius_A, const Point& B, double radius_B) {
  return ShapeCheck("frustum", name)
      .distinct("end A", A, "end B", B)
      .not_negative("the radius at A", radius_A)
      .not_negative("the radius at B", radius_B)
      .positive("the larger radius", std::max(radius_A, radius_B))
      .result();
}

Fault ellipsoid(std::string_view name, const Point& center, const Point& semi_axis_a, const Point& semi_axis_b,
                const Point& semi_axis_c, double tolerance) {
  return three_edges(ShapeCheck("ellipsoid", name), center, semi_axis_a, semi_axis_b, semi_axis_c, "semi-axis",
                     tolerance);
}

Fault torus(std::string_view name, const Point& center, const Point& axis, double ring_radius, double section_radius) {
  return ShapeCheck("torus", name)
      .point("the center", center)
      .direction("the axis", axis)
      .positive("the ring radius", ring_radius)
      .positive("the section radius", section_radius)
      .require(section_radius <= ring_radius, ShapeRule::radii_order,
               "the section radius {:.10g} m must not exceed the ring radius {:.10g} m", section_radius, ring_radius)
      .result();
}

Fault tetrahedron(std::string_view name, const Point& A, const Point& B, const Point& C, const Point& D) {
  ShapeCheck check("tetrahedron", name);
  check.point("corner A", A).point("corner B", B).point("corner C", C).point("corner D", D);
  const double size = std::max({norm(B - A), norm(C - A), norm(D - A), norm(C - B), norm(D - B), norm(D - C)});
  const double volume = std::abs(dot(B - A, cross(C - A, D - A))) / 6;
  return check
      .require(volume > zero_length * size * size * size, ShapeRule::not_collinear,
               "the corners {}, {}, {}, {} lie in one plane; a solid needs a volume", text(A), text(B), text(C),
               text(D))
      .result();
}

Fault half_cylinder(std::string_view name, const Point& A, const Point& B, double radius, const Point& toward) {
  ShapeCheck check("half_cylinder", name);
  return check.distinct("end A", A, "end B", B)
      .positive("the radius", radius)
      .across("the direction 'toward'", toward, "the axis", B - A)
      .result();
}

Fault paraboloid(std::string_view name, const Point& apex, const Point& base_center, double radius) {
  ShapeCheck check("paraboloid", name);
  return conical(check, apex, base_center, radius).result();
}

}  // namespace poinsot::shape_faults
