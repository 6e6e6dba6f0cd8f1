// Springs and dampers as they are stated: how far they are drawn out, from what the file says of their ends and by the
// places of these on the bodies' way from the figure, and not from the laws of force.
#pragma once

#include <optional>
#include <vector>

#include "engine/solve/instant/particle_paths.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

inline solve::ParticlePaths::Vector widened(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

struct DrawnSpring {
  using Real = solve::ParticlePaths::Real;
  using Vector = solve::ParticlePaths::Vector;

  Real out = 0, rate = 0;  // beyond its free length or angle, and how fast that grows
  Real size = 0;           // of what `out` was taken from
  // The end on the body `to` and the direction in which it goes as the spring is drawn out; of a twist the axis.
  Vector end = Vector::zero(), along = Vector::zero();
};

class StatedSprings {
 public:
  // All of them must outlive it. v: the rates of the coordinates.
  StatedSprings(const solve::ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
                const std::vector<double>& v)
      : paths_(paths), machine_(machine), data_(data), v_(v) {}

  // Nothing where a body swings while a torsional spring twists, or a freedom has no coordinate of its own.
  std::optional<DrawnSpring> drawn(const Spring& spring) const;
  std::optional<DrawnSpring> drawn(const Joint& joint, const Freedom& freedom) const;

  double stiffness(const Spring& spring) const;
  double damping(const Spring& spring) const;
  double stiffness(const Freedom& freedom) const;
  double damping(const Freedom& freedom) const;

 private:
  DrawnSpring between_points(const Spring& spring) const;
  std::optional<DrawnSpring> twisted(const Spring& spring) const;
  double number(const std::optional<Expression>& stated, const Dimension& dimension) const {
    return stated ? data_.number(*stated, dimension) : 0;
  }

  const solve::ParticlePaths& paths_;
  const Machine& machine_;
  DataScope<double>& data_;
  const std::vector<double>& v_;
};

}  // namespace poinsot::problem
