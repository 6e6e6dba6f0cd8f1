// Every uniform shape as a picture: outlines::NAME(placement...) -> Outline, with the names and arguments of
// poinsot/engine/mass/shapes.h. A last argument says how many segments a full turn has.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "poinsot/engine/mass/mesh.h"
#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

// Places are indices into `vertices`, which lie on the true shape.
struct Outline {
  std::vector<Vector3<double>> vertices;
  // Outward by the right-hand rule for solids and closed shells; of plates on the side of their normal.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // The unit normal of the true surface at each corner of each triangle.
  std::vector<std::array<Vector3<double>, 3>> normals;
  // What a draughtsman draws from any side: rims, corners, borders, and lines themselves. A closed one ends with its
  // first vertex.
  std::vector<std::vector<std::uint32_t>> edges;
};

namespace outlines {

using Point = Vector3<double>;

inline constexpr int usual_segments = 48;

// Lines
Outline particle(const Point& point);
Outline rod(const Point& A, const Point& B);
Outline polyline(const std::vector<Point>& points);
Outline arc_from_point(const Point& center, const Point& normal, const Point& start, double angle,
                       int per_turn = usual_segments);
Outline ring(const Point& center, const Point& normal, double radius, int per_turn = usual_segments);
Outline semicircular_arc(const Point& A, const Point& B, const Point& toward, int per_turn = usual_segments);

// Plates
Outline rectangle(const Point& center, const Point& edge_a, const Point& edge_b);
Outline rectangle_from_corners(const Point& A, const Point& B, const Point& C);
Outline triangle(const Point& A, const Point& B, const Point& C);
Outline polygon(const std::vector<Point>& vertices);
Outline disk(const Point& center, const Point& normal, double radius, int per_turn = usual_segments);
Outline annulus(const Point& center, const Point& normal, double outer_radius, double inner_radius,
                int per_turn = usual_segments);
Outline semicircle(const Point& A, const Point& B, const Point& toward, int per_turn = usual_segments);
Outline sector(const Point& center, const Point& normal, double radius, const Point& middle, double angle,
               int per_turn = usual_segments);
Outline annular_sector(const Point& center, const Point& normal, double outer_radius, double inner_radius,
                       const Point& middle, double angle, int per_turn = usual_segments);

// Shells
Outline box_shell_between(const Point& corner, const Point& opposite);
Outline sphere_shell(const Point& center, double radius, int per_turn = usual_segments);
Outline hemisphere_shell(const Point& center, const Point& axis, double radius, int per_turn = usual_segments);
Outline cylinder_shell(const Point& A, const Point& B, double radius, int per_turn = usual_segments);
Outline closed_cylinder_shell(const Point& A, const Point& B, double radius, int per_turn = usual_segments);
Outline cone_shell(const Point& apex, const Point& base_center, double radius, int per_turn = usual_segments);

// Solids
Outline box(const Point& center, const Point& edge_a, const Point& edge_b, const Point& edge_c);
Outline box_between(const Point& corner, const Point& opposite);
Outline cube(const Point& center, double edge);
Outline cube_from_diagonal(const Point& B, const Point& C);
Outline sphere(const Point& center, double radius, int per_turn = usual_segments);
Outline hemisphere(const Point& center, const Point& axis, double radius, int per_turn = usual_segments);
Outline cylinder(const Point& A, const Point& B, double radius, int per_turn = usual_segments);
Outline tube(const Point& A, const Point& B, double outer_radius, double inner_radius, int per_turn = usual_segments);
Outline cone(const Point& apex, const Point& base_center, double radius, int per_turn = usual_segments);
Outline frustum(const Point& A, double radius_A, const Point& B, double radius_B, int per_turn = usual_segments);
Outline ellipsoid(const Point& center, const Point& semi_axis_a, const Point& semi_axis_b, const Point& semi_axis_c,
                  int per_turn = usual_segments);
Outline torus(const Point& center, const Point& axis, double ring_radius, double tube_radius,
              int per_turn = usual_segments);
Outline tetrahedron(const Point& A, const Point& B, const Point& C, const Point& D);
Outline prism(const std::vector<Point>& base, const Point& edge);
Outline half_cylinder(const Point& A, const Point& B, double radius, const Point& toward,
                      int per_turn = usual_segments);
Outline thick_sector(const Point& center, const Point& normal, double outer_radius, double inner_radius,
                     const Point& middle, double angle, double thickness, int per_turn = usual_segments);
Outline paraboloid(const Point& apex, const Point& base_center, double radius, int per_turn = usual_segments);

// A closed mesh, moved by `at`. Edges are those at which its surface turns
// by more than a few ten degrees; elsewhere it is taken for round.
Outline solid_of_mesh(const TriangleMesh<double>& mesh, const Point& at);
// The box about the vertices of a mesh, which stands for one of too many triangles.
Outline box_of_mesh(const TriangleMesh<double>& mesh, const Point& at);

}  // namespace outlines
}  // namespace poinsot
