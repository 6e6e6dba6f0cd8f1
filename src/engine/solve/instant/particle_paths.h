// What bodies as particles say of places, velocities, accelerations, momenta and moments of inertia: for answers, what
// poinsot/engine/solve/instant/particle_check.h is for the equations of motion, and by the same road.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/solve/instant/drawn_motion.h"

namespace poinsot::solve {

class ParticlePaths {
 public:
  using Real = drawn::Real;
  using Vector = Vector3<Real>;

  struct Body {
    int link = 0;
    const std::vector<Particle<double>>* particles = nullptr;  // in the drawn pose, on ground axes
  };
  // q, v, a: the coordinates, their rates and accelerations, in the order of State. reach: the length of the mechanism
  // where it is longer than its bodies tell, m.
  ParticlePaths(const std::vector<CheckLink>& links, std::vector<Body> bodies, const std::vector<double>& q,
                const std::vector<double>& v, const std::vector<double>& a, double reach = 0);

  // In the time 1/pace (s) everything moves by about its own size. The length (m) is that of the bodies.
  Real pace() const { return pace_; }
  Real length() const { return length_; }

  // Where the point of a link is now that is at a place of the drawing, and how the link has turned since.
  Vector place(int link, const Vector& drawn) const { return relative(now, link, -1)(drawn); }
  Matrix3<Real> turn(int link) const { return relative(now, link, -1).turn; }
  // Of the point of a link that is at a place now, seen from another link (-1 for the ground), on ground axes.
  Vector velocity(int link, const Vector& place, int from) const;
  Vector acceleration(int link, const Vector& place, int from) const;
  // Of a link, seen from another one.
  Vector angular_velocity(int link, int from) const;
  // Of a link, seen from the ground.
  Vector angular_acceleration(int link) const;

  // Sums over the particles of a link, or of all. The sizes are sums of the sizes of the terms.
  static constexpr int all = -2;
  struct Sums {
    Real mass = 0, kinetic_energy = 0, energy_size = 0;
    Vector first_moment = Vector::zero();  // sum m x
    Vector momentum = Vector::zero(), angular_momentum = Vector::zero();
    Vector rate = Vector::zero(), angular_rate = Vector::zero();  // of the momenta: sum m a, sum (x - P) x m a
    Real power = 0, power_size = 0;                               // of the kinetic energy: sum m v . a
    Matrix3<Real> moments{};                                      // sum m (x - P) (x - P)^T
    Real momentum_size = 0, angular_size = 0, rate_size = 0, angular_rate_size = 0, moments_size = 0;
  };
  Sums sums(int link, const Vector& P) const;

 private:
  static constexpr std::size_t now = 4;  // of the nine points of the differences
  struct Moving {
    Real mass = 0;
    Vector place, velocity, acceleration;
  };
  // Where a point of one link is on the way, by the axes of another as they stand now.
  template <class Where>
  Vector first_derivative(const Where& where) const;
  template <class Where>
  Vector second_derivative(const Where& where) const;
  template <class Derivative>
  Vector over_arms(int link, int from, const Derivative& derivative) const;
  // The particles of a body as they move now, found when they are first asked for. Not for several threads at once.
  const std::vector<Moving>& moving(std::size_t body) const;
  drawn::Displacement relative(std::size_t time, int link, int from) const;
  Vector drawn_place(int link, const Vector& place) const;

  std::vector<Body> bodies_;
  mutable std::vector<std::vector<Moving>> moving_;
  Real pace_ = 0, length_ = 0, step_ = 0;
  std::array<std::vector<drawn::Displacement>, 9> at_;
};

}  // namespace poinsot::solve
