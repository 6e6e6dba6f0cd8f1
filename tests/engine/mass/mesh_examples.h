// Closed meshes for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "poinsot/engine/mass/mesh.h"

namespace poinsot::testing {

// Box or parallelepiped from a corner with the edges a, b, c, which must be right-handed.
template <class Scalar>
TriangleMesh<Scalar> box_mesh(const Vector3<Scalar>& corner, const Vector3<Scalar>& a, const Vector3<Scalar>& b,
                              const Vector3<Scalar>& c) {
  return {
      {corner, corner + a, corner + a + b, corner + b, corner + c, corner + a + c, corner + a + b + c, corner + b + c},
      {{{0, 2, 1}},
       {{0, 3, 2}},
       {{4, 5, 6}},
       {{4, 6, 7}},
       {{0, 1, 5}},
       {{0, 5, 4}},
       {{1, 2, 6}},
       {{1, 6, 5}},
       {{2, 3, 7}},
       {{2, 7, 6}},
       {{3, 0, 4}},
       {{3, 4, 7}}}};
}

// Corners A, B, C counter-clockwise seen from the side away from D.
template <class Scalar>
TriangleMesh<Scalar> tetrahedron_mesh(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C,
                                      const Vector3<Scalar>& D) {
  return {{A, B, C, D}, {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 1}}, {{1, 3, 2}}}};
}

// A flat outline moved by `height`; the caps are fans from the first vertex, which may overlap for reflex corners but
// close the surface. The outline turns counter-clockwise about `height`.
template <class Scalar>
TriangleMesh<Scalar> prism_mesh(const std::vector<Vector3<Scalar>>& outline, const Vector3<Scalar>& height) {
  const auto n = static_cast<std::uint32_t>(outline.size());
  TriangleMesh<Scalar> mesh{outline, {}};
  for (const auto& vertex : outline) mesh.vertices.push_back(vertex + height);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
    if (i >= 1 && i + 1 < n) {
      mesh.triangles.push_back({0, j, i});
      mesh.triangles.push_back({n, i + n, j + n});
    }
  }
  return mesh;
}

// Ball of meridians and parallels.
inline TriangleMesh<double> ball_mesh(double radius, std::uint32_t parallels, std::uint32_t meridians) {
  TriangleMesh<double> mesh;
  mesh.vertices.push_back({0, 0, radius});
  for (std::uint32_t i = 1; i < parallels; ++i) {
    const double theta = std::numbers::pi * i / parallels;
    for (std::uint32_t k = 0; k < meridians; ++k) {
      const double phi = 2 * std::numbers::pi * k / meridians;
      mesh.vertices.push_back({radius * std::sin(theta) * std::cos(phi), radius * std::sin(theta) * std::sin(phi),
                               radius * std::cos(theta)});
    }
  }
  mesh.vertices.push_back({0, 0, -radius});
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto at = [=](std::uint32_t i, std::uint32_t k) { return 1 + (i - 1) * meridians + k % meridians; };
  for (std::uint32_t k = 0; k < meridians; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    mesh.triangles.push_back({last, at(parallels - 1, k + 1), at(parallels - 1, k)});
    for (std::uint32_t i = 1; i + 1 < parallels; ++i) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

template <class Scalar>
TriangleMesh<Scalar> inside_out(TriangleMesh<Scalar> mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// Both surfaces in one mesh.
template <class Scalar>
TriangleMesh<Scalar> together(TriangleMesh<Scalar> a, const TriangleMesh<Scalar>& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

}  // namespace poinsot::testing
