// What the expression of a load means at an instant, from the statement and the bodies on their way from the figure:
// the second road to loads that depend on the motion, beside the steps that are recorded of them
// (machine/motion_loads.cpp).
#pragma once

#include <vector>

#include "engine/solve/instant/particle_paths.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Vectors are on the axes of a body or frame.
class StatedMotion : public Scope<double> {
 public:
  using Vector = solve::ParticlePaths::Vector;
  using Result = Value<double>;

  // All of them must outlive it. v: the rates of the coordinates; axes: the body or frame.
  StatedMotion(const solve::ParticlePaths& paths, const Machine& machine, DataScope<double>& data,
               const std::vector<double>& v, int axes)
      : paths_(paths), machine_(machine), data_(data), v_(v), axes_(axes) {}

  // The mass center of a body as drawn.
  Vector drawn_center(int body) const;

  Result name(const Name& name, const Mark& mark, const Evaluator<double>& evaluator) override;
  Result of(const Of& of, const Mark& mark, const Evaluator<double>& evaluator) override;
  Result member(const Member& member, const Mark& mark, const Evaluator<double>& evaluator) override;
  Result call(const Call& call, const Mark& mark, const Evaluator<double>& evaluator) override;

 private:
  struct Point {
    int body = ground;
    Vector now;
  };
  int body_of(const Expression& expression) const { return machine_.index.at(to_string(expression)); }
  Point point_of(const Expression& expression) const;
  Result seen(const Vector& on_ground, const Dimension& dimension) const;

  const solve::ParticlePaths& paths_;
  const Machine& machine_;
  DataScope<double>& data_;
  const std::vector<double>& v_;
  const int axes_;
};

}  // namespace poinsot::problem
