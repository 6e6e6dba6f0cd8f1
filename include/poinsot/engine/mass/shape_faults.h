// Whether the data of a shape make sense: one function for each shape of poinsot/engine/mass/shapes.h, with its name
// and arguments after the name of the body that stands in messages. Nothing is returned for a proper shape, else the
// first rule that is broken.
//
// Lengths count as zero below 1e-12 of the largest length given; flatness, right angles and the like may be off by
// `tolerance` (relative), since data are often typed with few digits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot::shape_faults {

enum class ShapeRule {
  finite_values,
  enough_points,
  positive_extent,  // a length, radius or edge that must exceed zero
  distinct_points,  // neighbouring points must differ
  given_direction,  // a direction must not be the zero vector
  clear_direction,  // "toward" must not be along the line it is measured from
  right_angle,
  flat,            // corners in one plane
  not_collinear,   // corners that span an area or a volume
  simple_outline,  // a polygon must not cross or touch itself
  angle_range,     // more than 0 and at most a full turn
  radii_order,     // inner radius less than outer, section less than ring
};

struct ShapeFault {
  ShapeRule rule{};
  std::string message;  // what is wrong, with the values, and what was expected
};

using Fault = std::optional<ShapeFault>;
using Point = Vector3<double>;
inline constexpr double default_tolerance = 1e-6;

Fault particle(std::string_view name, const Point& point);
Fault rod(std::string_view name, const Point& A, const Point& B);
Fault polyline(std::string_view name, const std::vector<Point>& points);
Fault arc(std::string_view name, const Point& center, const Point& normal, const Point& start_direction, double radius,
          double angle);
// The start must lie in the plane through the center.
Fault arc_from_point(std::string_view name, const Point& center, const Point& normal, const Point& start_point,
                     double angle, double tolerance = default_tolerance);
Fault ring(std::string_view name, const Point& center, const Point& normal, double radius);
Fault semicircular_arc(std::string_view name, const Point& A, const Point& B, const Point& toward);

Fault rectangle(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b,
                double tolerance = default_tolerance);
Fault rectangle_from_corners(std::string_view name, const Point& A, const Point& B, const Point& C,
                             double tolerance = default_tolerance);
Fault triangle(std::string_view name, const Point& A, const Point& B, const Point& C);
Fault polygon(std::string_view name, const std::vector<Point>& vertices, double tolerance = default_tolerance);
Fault polygon_in_plane(std::string_view name, const std::vector<std::array<double, 2>>& coordinates,
                       const Point& origin, const Point& axis_u, const Point& axis_v,
                       double tolerance = default_tolerance);
Fault disk(std::string_view name, const Point& center, const Point& normal, double radius);
Fault annulus(std::string_view name, const Point& center, const Point& normal, double outer_radius,
              double inner_radius);
Fault semicircle(std::string_view name, const Point& A, const Point& B, const Point& toward);
Fault sector(std::string_view name, const Point& center, const Point& normal, double radius,
             const Point& middle_direction, double angle);

Fault box_shell(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b,
                const Point& edge_c, double tolerance = default_tolerance);
Fault box_shell_between(std::string_view name, const Point& corner, const Point& opposite,
                        const Matrix3<double>& axes = Matrix3<double>::identity(),
                        double tolerance = default_tolerance);
Fault sphere_shell(std::string_view name, const Point& center, double radius);
Fault hemisphere_shell(std::string_view name, const Point& center, const Point& axis, double radius);
Fault cylinder_shell(std::string_view name, const Point& A, const Point& B, double radius);
Fault closed_cylinder_shell(std::string_view name, const Point& A, const Point& B, double radius);
Fault cone_shell(std::string_view name, const Point& apex, const Point& base_center, double radius);

Fault box(std::string_view name, const Point& center, const Point& edge_a, const Point& edge_b, const Point& edge_c,
          double tolerance = default_tolerance);
Fault box_between(std::string_view name, const Point& corner, const Point& opposite,
                  const Matrix3<double>& axes = Matrix3<double>::identity(), double tolerance = default_tolerance);
Fault cube(std::string_view name, const Point& center, double edge);
Fault cube_from_diagonal(std::string_view name, const Point& B, const Point& C);
Fault sphere(std::string_view name, const Point& center, double radius);
Fault hemisphere(std::string_view name, const Point& center, const Point& axis, double radius);
Fault cylinder(std::string_view name, const Point& A, const Point& B, double radius);
Fault tube(std::string_view name, const Point& A, const Point& B, double outer_radius, double inner_radius);
Fault cone(std::string_view name, const Point& apex, const Point& base_center, double radius);
Fault frustum(std::string_view name, const Point& A, double radius_A, const Point& B, double radius_B);
Fault ellipsoid(std::string_view name, const Point& center, const Point& semi_axis_a, const Point& semi_axis_b,
                const Point& semi_axis_c, double tolerance = default_tolerance);
Fault torus(std::string_view name, const Point& center, const Point& axis, double ring_radius, double section_radius);
Fault tetrahedron(std::string_view name, const Point& A, const Point& B, const Point& C, const Point& D);
Fault prism(std::string_view name, const std::vector<Point>& base, const Point& edge,
            double tolerance = default_tolerance);
Fault half_cylinder(std::string_view name, const Point& A, const Point& B, double radius, const Point& toward);
Fault paraboloid(std::string_view name, const Point& apex, const Point& base_center, double radius);

}  // namespace poinsot::shape_faults
