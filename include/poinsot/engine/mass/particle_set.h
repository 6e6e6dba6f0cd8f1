// A shape or body as a few weighted particles with the same mass, first and second moments.
//
// This is the independent road to every momentum, energy and force that the closed forms of
// poinsot/engine/mass/shapes.h lead to: nothing here or in the particle_*.h headers uses a formula for a centroid or a
// moment of inertia.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "poinsot/engine/mass/mass_properties.h"

namespace poinsot {

template <class Scalar>
struct Particle {
  Scalar mass{};               // kg; negative in holes
  Vector3<Scalar> position{};  // from the origin, m
};

template <class Scalar>
struct WeightedParticle {
  Scalar fraction{};           // of the shape's mass; all fractions add up to 1
  Vector3<Scalar> position{};  // from the origin, m
};

// A uniform shape as particles. The scalar is double or long double.
template <class Scalar>
struct ParticleSet {
  Scalar measure{};  // length (m), area (m^2) or volume (m^3) by the same cubature; 0 for a particle
  std::vector<WeightedParticle<Scalar>> particles;
};

template <class Scalar>
std::vector<Particle<Scalar>> particles_of_mass(const ParticleSet<Scalar>& set, const Scalar& mass) {
  std::vector<Particle<Scalar>> particles;
  particles.reserve(set.particles.size());
  for (const auto& p : set.particles) particles.push_back({mass * p.fraction, p.position});
  return particles;
}

// Density per length, area or volume, as the measure of the shape is.
template <class Scalar>
std::vector<Particle<Scalar>> particles_of_density(const ParticleSet<Scalar>& set, const Scalar& density) {
  return particles_of_mass(set, Scalar(density * set.measure));
}

// Mass, mass center and inertia by the sums that define them (Eqs. 18.5, 18.6). Without mass in total the center is
// zero and the inertia that about the origin.
template <class Scalar>
MassProperties<Scalar> mass_properties(const std::vector<Particle<Scalar>>& particles) {
  MassProperties<Scalar> body{Scalar(0), Vector3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
  Vector3<Scalar> first = Vector3<Scalar>::zero();
  for (const auto& p : particles) {
    body.mass += p.mass;
    first += p.mass * p.position;
  }
  if (body.mass != Scalar(0)) body.center = first / body.mass;
  for (const auto& p : particles) body.inertia_center += p.mass * unit_mass_inertia(p.position - body.center);
  return body;
}

namespace cubature {

template <class Scalar>
struct Node {
  Scalar at{};      // in [0, 1]
  Scalar weight{};  // all weights add up to 1
};

// Gauss-Legendre rule with n points on [0, 1], exact for polynomials of degree 2n - 1.
template <class Scalar>
std::vector<Node<Scalar>> gauss_nodes(int n) {
  std::vector<Node<Scalar>> nodes;
  for (int i = 0; i < n; ++i) {
    // Newton's iteration for the i-th root of the Legendre polynomial P_n from the usual first guess.
    Scalar x = -std::cos(std::numbers::pi_v<Scalar> * (Scalar(i) + Scalar(0.75)) / (Scalar(n) + Scalar(0.5)));
    Scalar slope{};
    for (int iteration = 0; iteration < 20; ++iteration) {
      Scalar p = 1;
      Scalar previous = 0;
      for (int k = 1; k <= n; ++k) {
        const Scalar next = (Scalar(2 * k - 1) * x * p - Scalar(k - 1) * previous) / Scalar(k);
        previous = p;
        p = next;
      }
      slope = Scalar(n) * (x * p - previous) / (x * x - 1);
      x -= p / slope;
    }
    nodes.push_back({(x + 1) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

// The same, found once for each n and scalar.
template <int n, class Scalar>
const std::vector<Node<Scalar>>& gauss() {
  static const std::vector<Node<Scalar>> nodes = gauss_nodes<Scalar>(n);
  return nodes;
}

// Points enough for integrals of cos^2, sin^2 over any arc up to a full turn to be exact to rounding.
inline constexpr int points_on_arc = 20;

// A right-handed set of unit vectors, the third along a given direction.
template <class Scalar>
struct Triad {
  Vector3<Scalar> first, second, third;

  explicit Triad(const Vector3<Scalar>& direction) : third(direction / norm(direction)) {
    using std::abs;
    // Start from the coordinate axis that is farthest from the direction.
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (abs(third[i]) < abs(third[smallest])) smallest = i;
    }
    const Vector3<Scalar> side = cross(third, Vector3<Scalar>::unit(smallest));
    first = side / norm(side);
    second = cross(third, first);
  }
  // The first vector in the half plane of `toward`.
  Triad(const Vector3<Scalar>& direction, const Vector3<Scalar>& toward) : third(direction / norm(direction)) {
    const Vector3<Scalar> side = cross(third, toward);
    second = side / norm(side);
    first = cross(second, third);
  }
  Vector3<Scalar> at_angle(const Scalar& angle) const { return std::cos(angle) * first + std::sin(angle) * second; }
};

// Gathers particles whose weights are elements of length, area or volume.
template <class Scalar>
class Gatherer {
 public:
  void add(const Vector3<Scalar>& position, const Scalar& weight) {
    set_.particles.push_back({weight, position});
    set_.measure += weight;
  }
  // Weight spread evenly on a circle: three points are exact for second moments.
  void add_circle(const Vector3<Scalar>& center, const Triad<Scalar>& triad, const Scalar& radius,
                  const Scalar& weight) {
    for (int k = 0; k < 3; ++k) {
      add(center + radius * triad.at_angle(2 * std::numbers::pi_v<Scalar> * Scalar(k) / 3), weight / 3);
    }
  }
  void add_rod(const Vector3<Scalar>& A, const Vector3<Scalar>& B) {
    for (const auto& s : gauss<2, Scalar>()) add(A + s.at * (B - A), s.weight * norm(B - A));
  }
  // The mid-edge rule, exact for second moments; `area` may be negative.
  void add_triangle(const Vector3<Scalar>& A, const Vector3<Scalar>& B, const Vector3<Scalar>& C, const Scalar& area) {
    add((A + B) / Scalar(2), area / 3);
    add((B + C) / Scalar(2), area / 3);
    add((C + A) / Scalar(2), area / 3);
  }
  void add_parallelogram(const Vector3<Scalar>& corner, const Vector3<Scalar>& edge_a, const Vector3<Scalar>& edge_b) {
    const Scalar area = norm(cross(edge_a, edge_b));
    for (const auto& s : gauss<2, Scalar>()) {
      for (const auto& t : gauss<2, Scalar>()) {
        add(corner + s.at * edge_a + t.at * edge_b, s.weight * t.weight * area);
      }
    }
  }
  // Flat ring between two radii, on the first two vectors of the triad.
  void add_annulus(const Vector3<Scalar>& center, const Triad<Scalar>& triad, const Scalar& inner,
                   const Scalar& outer) {
    for (const auto& s : gauss<2, Scalar>()) {
      const Scalar radius = inner + s.at * (outer - inner);
      add_circle(center, triad, radius, s.weight * (outer - inner) * 2 * std::numbers::pi_v<Scalar> * radius);
    }
  }
  // Sector from angle `from` to `to` in the triad's first two vectors; beyond an inner radius, if there is one.
  void add_sector(const Vector3<Scalar>& center, const Triad<Scalar>& triad, const Scalar& radius, const Scalar& from,
                  const Scalar& to, const Scalar& inner = Scalar(0)) {
    const Scalar wide = radius - inner;
    for (const auto& s : gauss<2, Scalar>()) {
      for (const auto& t : gauss<points_on_arc, Scalar>()) {
        const Scalar r = inner + s.at * wide;
        add(center + r * triad.at_angle(from + t.at * (to - from)), s.weight * wide * t.weight * (to - from) * r);
      }
    }
  }
  void add_arc(const Vector3<Scalar>& center, const Triad<Scalar>& triad, const Scalar& radius, const Scalar& from,
               const Scalar& to) {
    for (const auto& t : gauss<points_on_arc, Scalar>()) {
      add(center + radius * triad.at_angle(from + t.at * (to - from)), t.weight * (to - from) * radius);
    }
  }
  // Weights become fractions of the whole.
  ParticleSet<Scalar> finish() {
    for (auto& p : set_.particles) p.fraction /= set_.measure;
    return std::move(set_);
  }

 private:
  ParticleSet<Scalar> set_;
};

}  // namespace cubature
}  // namespace poinsot
