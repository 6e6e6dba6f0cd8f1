// Pictures of solids and of thin shells, which look the same where they are closed.
#include <cmath>
#include <numbers>

#include "outline_builder.h"

namespace poinsot::outlines {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

// About the line from A to B, with heights from A.
Outline turned_about(const Point& A, const Point& B, const std::vector<ProfilePart>& parts,
                     const std::vector<bool>& rims, int per_turn) {
  OutlineBuilder builder;
  builder.turned(A, Triad(B - A), parts, rims, whole_turn(per_turn));
  return builder.finish();
}

}  // namespace

Outline box(const Point& center, const Point& edge_a, const Point& edge_b, const Point& edge_c) {
  OutlineBuilder builder;
  for (int k = 0; k < 8; ++k) {
    const auto half = [&](int bit, const Point& edge) { return ((k & bit) != 0 ? 0.5 : -0.5) * edge; };
    builder.vertex(center + half(1, edge_a) + half(2, edge_b) + half(4, edge_c));
  }
  const double sense = dot(edge_a, cross(edge_b, edge_c)) < 0 ? -1 : 1;
  const auto pair = [&](const std::vector<std::uint32_t>& low, std::uint32_t bit, const Point& across) {
    const Point normal = normalized(sense * across);
    std::vector<std::uint32_t> high;
    for (const std::uint32_t k : low) high.push_back(k + bit);
    builder.face(low, -normal);
    builder.face(high, normal);
  };
  pair({0, 2, 6, 4}, 1, cross(edge_b, edge_c));
  pair({0, 1, 5, 4}, 2, cross(edge_c, edge_a));
  pair({0, 1, 3, 2}, 4, cross(edge_a, edge_b));
  builder.edge({0, 1, 3, 2, 0});
  builder.edge({4, 5, 7, 6, 4});
  for (std::uint32_t k = 0; k < 4; ++k) builder.edge({k, k + 4});
  return builder.finish();
}

Outline box_between(const Point& corner, const Point& opposite) {
  const Point d = opposite - corner;
  return box(0.5 * (corner + opposite), {d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z});
}

Outline cube(const Point& center, double edge) { return box(center, {edge, 0, 0}, {0, edge, 0}, {0, 0, edge}); }

// As the particles have it, the three edges that meet at B lean evenly round the diagonal.
Outline cube_from_diagonal(const Point& B, const Point& C) {
  const Triad triad(C - B);
  const double length = norm(C - B);
  const auto edge = [&](int k) {
    return (length / 3) * triad.third +
           (length * std::numbers::sqrt2 / 3) * triad.at_angle(2 * std::numbers::pi * k / 3);
  };
  return box(0.5 * (B + C), edge(0), edge(1), edge(2));
}

Outline sphere(const Point& center, double radius, int per_turn) {
  OutlineBuilder builder;
  builder.turned(center, Triad({0, 0, 1}), {round({0, 0}, radius, -right_angle, right_angle, per_turn)}, {false, false},
                 whole_turn(per_turn));
  return builder.finish();
}

Outline hemisphere(const Point& center, const Point& axis, double radius, int per_turn) {
  return turned_about(center, center + axis,
                      {straight({0, 0}, {radius, 0}), round({0, 0}, radius, 0, right_angle, per_turn)},
                      {false, true, false}, per_turn);
}

Outline frustum(const Point& A, double radius_A, const Point& B, double radius_B, int per_turn) {
  const double height = norm(B - A);
  std::vector<ProfilePart> parts;
  std::vector<bool> rims;
  if (radius_A > 0) {
    parts.push_back(straight({0, 0}, {radius_A, 0}));
    rims.push_back(false);
  }
  parts.push_back(straight({radius_A, 0}, {radius_B, height}));
  rims.push_back(radius_A > 0);
  if (radius_B > 0) {
    parts.push_back(straight({radius_B, height}, {0, height}));
    rims.push_back(true);
  }
  rims.push_back(false);
  return turned_about(A, B, parts, rims, per_turn);
}

Outline cylinder(const Point& A, const Point& B, double radius, int per_turn) {
  return frustum(A, radius, B, radius, per_turn);
}

Outline cone(const Point& apex, const Point& base_center, double radius, int per_turn) {
  return frustum(base_center, radius, apex, 0, per_turn);
}

Outline tube(const Point& A, const Point& B, double outer_radius, double inner_radius, int per_turn) {
  if (!(inner_radius > 0)) return cylinder(A, B, outer_radius, per_turn);
  const double height = norm(B - A);
  const ProfilePoint a{inner_radius, 0}, b{outer_radius, 0}, c{outer_radius, height}, d{inner_radius, height};
  return turned_about(A, B, {straight(a, b), straight(b, c), straight(c, d), straight(d, a)},
                      {true, true, true, true, false}, per_turn);
}

Outline ellipsoid(const Point& center, const Point& semi_axis_a, const Point& semi_axis_b, const Point& semi_axis_c,
                  int per_turn) {
  return mapped(sphere(Point::zero(), 1, per_turn), center, semi_axis_a, semi_axis_b, semi_axis_c);
}

Outline torus(const Point& center, const Point& axis, double ring_radius, double tube_radius, int per_turn) {
  return turned_about(center, center + axis,
                      {round({ring_radius, 0}, tube_radius, -std::numbers::pi, std::numbers::pi, per_turn / 2)},
                      {false, false}, per_turn);
}

Outline tetrahedron(const Point& A, const Point& B, const Point& C, const Point& D) {
  OutlineBuilder builder;
  const std::array<Point, 4> P{A, B, C, D};
  for (const Point& point : P) builder.vertex(point);
  for (std::uint32_t opposite = 0; opposite < 4; ++opposite) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t k = 0; k < 4; ++k)
      if (k != opposite) corners.push_back(k);
    const Point normal = normalized(cross(P[corners[1]] - P[corners[0]], P[corners[2]] - P[corners[0]]));
    builder.face(corners, dot(normal, P[opposite] - P[corners[0]]) > 0 ? -normal : normal);
  }
  builder.edge({0, 1, 2, 0});
  for (std::uint32_t k = 0; k < 3; ++k) builder.edge({k, 3});
  return builder.finish();
}

Outline box_shell_between(const Point& corner, const Point& opposite) { return box_between(corner, opposite); }

Outline sphere_shell(const Point& center, double radius, int per_turn) { return sphere(center, radius, per_turn); }

Outline hemisphere_shell(const Point& center, const Point& axis, double radius, int per_turn) {
  return turned_about(center, center + axis, {round({0, 0}, radius, 0, right_angle, per_turn)}, {true, false},
                      per_turn);
}

Outline cylinder_shell(const Point& A, const Point& B, double radius, int per_turn) {
  return turned_about(A, B, {straight({radius, 0}, {radius, norm(B - A)})}, {true, true}, per_turn);
}

Outline closed_cylinder_shell(const Point& A, const Point& B, double radius, int per_turn) {
  return cylinder(A, B, radius, per_turn);
}

Outline cone_shell(const Point& apex, const Point& base_center, double radius, int per_turn) {
  return turned_about(base_center, apex, {straight({radius, 0}, {0, norm(apex - base_center)})}, {true, false},
                      per_turn);
}

// The base is cut into triangles as a plate is; what is outward of a side follows from the sense of the vertices.
Outline prism(const std::vector<Point>& base, const Point& edge) {
  const auto count = static_cast<std::uint32_t>(base.size());
  const Outline plate = polygon(base);
  const Point normal = plate.normals.front()[0];
  const double sense = dot(normal, edge) < 0 ? -1 : 1;
  OutlineBuilder builder;
  for (const Point& point : base) builder.vertex(point);
  for (const Point& point : base) builder.vertex(point + edge);
  const Point up = sense * normal;
  for (const auto& [i, j, k] : plate.triangles) {
    builder.triangle({i, j, k}, {-up, -up, -up});
    builder.triangle({i + count, j + count, k + count}, {up, up, up});
  }
  std::vector<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    builder.face({i, j, j + count, i + count}, normalized(sense * cross(base[j] - base[i], edge)));
    builder.edge({i, i + count});
    low.push_back(i);
    high.push_back(i + count);
  }
  low.push_back(0);
  high.push_back(count);
  builder.edge(std::move(low));
  builder.edge(std::move(high));
  return builder.finish();
}

Outline half_cylinder(const Point& A, const Point& B, double radius, const Point& toward, int per_turn) {
  const Triad triad(B - A, toward);
  const Turn turn = part_of_turn(-right_angle, 2 * right_angle, per_turn);
  OutlineBuilder builder;
  std::vector<std::uint32_t> at_A = builder.circle(A, triad, radius, turn);
  std::vector<std::uint32_t> at_B = builder.circle(B, triad, radius, turn);
  builder.face(at_A, -triad.third);
  builder.face(at_B, triad.third);
  builder.face({at_A.front(), at_A.back(), at_B.back(), at_B.front()}, -triad.first);
  for (std::size_t k = 0; k + 1 < at_A.size(); ++k) {
    const auto out = [&](std::size_t i) {
      return triad.at_angle(turn.from + turn.angle * static_cast<double>(i) / turn.segments);
    };
    builder.triangle({at_A[k], at_A[k + 1], at_B[k + 1]}, {out(k), out(k + 1), out(k + 1)});
    builder.triangle({at_A[k], at_B[k + 1], at_B[k]}, {out(k), out(k + 1), out(k)});
  }
  builder.edge({at_A.front(), at_B.front()});
  builder.edge({at_A.back(), at_B.back()});
  for (std::vector<std::uint32_t>* rim : {&at_A, &at_B}) {
    rim->push_back(rim->front());
    builder.edge(std::move(*rim));
  }
  return builder.finish();
}

Outline thick_sector(const Point& center, const Point& normal, double outer_radius, double inner_radius,
                     const Point& middle, double angle, double thickness, int per_turn) {
  const Triad triad(normal, middle);
  const Point low = center - 0.5 * thickness * triad.third, high = center + 0.5 * thickness * triad.third;
  const Turn turn = part_of_turn(-0.5 * angle, angle, per_turn);
  if (turn.whole()) return tube(low, high, outer_radius, inner_radius, per_turn);
  OutlineBuilder builder;
  std::vector<std::uint32_t> out_low = builder.circle(low, triad, outer_radius, turn);
  std::vector<std::uint32_t> out_high = builder.circle(high, triad, outer_radius, turn);
  // The tip of a sector takes the place of its inner arc.
  const auto inner_arc = [&](const Point& at) {
    if (inner_radius > 0) return builder.circle(at, triad, inner_radius, turn);
    return std::vector<std::uint32_t>(out_low.size(), builder.vertex(at));
  };
  std::vector<std::uint32_t> in_low = inner_arc(low), in_high = inner_arc(high);
  const std::size_t last = out_low.size() - 1;
  const auto outward = [&](std::size_t i) {
    return triad.at_angle(turn.from + turn.angle * static_cast<double>(i) / turn.segments);
  };
  const auto wall = [&](const std::vector<std::uint32_t>& below, const std::vector<std::uint32_t>& above, double side,
                        std::size_t k) {
    const Point here = side * outward(k), there = side * outward(k + 1);
    builder.triangle({below[k], below[k + 1], above[k + 1]}, {here, there, there});
    builder.triangle({below[k], above[k + 1], above[k]}, {here, there, here});
  };
  for (std::size_t k = 0; k < last; ++k) {
    builder.face({in_low[k], out_low[k], out_low[k + 1], in_low[k + 1]}, -triad.third);
    builder.face({in_high[k], out_high[k], out_high[k + 1], in_high[k + 1]}, triad.third);
    wall(out_low, out_high, 1, k);
    if (inner_radius > 0) wall(in_low, in_high, -1, k);
  }
  for (const std::size_t k : {std::size_t{0}, last}) {
    const double beside = k == 0 ? turn.from - right_angle : turn.from + turn.angle + right_angle;
    builder.face({in_low[k], out_low[k], out_high[k], in_high[k]}, triad.at_angle(beside));
    builder.edge({out_low[k], out_high[k]});
    if (inner_radius > 0 || k == 0) builder.edge({in_low[k], in_high[k]});
  }
  for (const auto& [out, in] : {std::pair{&out_low, &in_low}, std::pair{&out_high, &in_high}}) {
    if (inner_radius > 0)
      out->insert(out->end(), in->rbegin(), in->rend());
    else
      out->push_back(in->front());
    out->push_back(out->front());
    builder.edge(std::move(*out));
  }
  return builder.finish();
}

// The profile r^2 (1 - z/h) = x^2 above the base, in steps of x.
Outline paraboloid(const Point& apex, const Point& base_center, double radius, int per_turn) {
  const double height = norm(apex - base_center);
  const int steps = std::max(2, per_turn / 4);
  ProfilePart side;
  for (int k = steps; k >= 0; --k) {
    const double part = static_cast<double>(k) / steps, slope = 2 * height * part / radius;
    side.points.push_back({part * radius, height * (1 - part * part)});
    side.normals.push_back({slope / std::hypot(slope, 1), 1 / std::hypot(slope, 1)});
  }
  return turned_about(base_center, apex, {straight({0, 0}, {radius, 0}), std::move(side)}, {false, true, false},
                      per_turn);
}

}  // namespace poinsot::outlines
