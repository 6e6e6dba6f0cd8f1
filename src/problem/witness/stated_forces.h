// What loads, springs, dampers, motors and a center that pulls exert as they are stated, by the places and velocities
// of the bodies on their way from the figure: a second road to the laws of force (engine/dynamics/force_law.h) and to
// how they were read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/solve/instant/particle_paths.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

struct StatedForce {
  using Real = solve::ParticlePaths::Real;
  using Vector = solve::ParticlePaths::Vector;

  std::size_t action = 0;  // its place among those of the mechanism
  Vector force = Vector::zero(), couple = Vector::zero();
  Vector at = Vector::zero();  // where the force acts
  // Of a motor within gimbals: only the couple about its own axis is stated, and about those that turn freely there is
  // none.
  std::optional<Vector> only_about{};
  std::vector<Vector> none_about{};
  Real size = 0;  // of the terms of either
  // Of the pull of a center, whose couple is small beside the moment of its force: what is to be seen of it, about the
  // place where the force acts.
  std::optional<Real> couple_size{};
};

// Of each load, spring, motor and pull of a center that is known and to which this road leads. loads: those that act;
// all of them if left out. v: the rates of the coordinates.
std::vector<StatedForce> stated_forces(const solve::ParticlePaths& paths, const Machine& machine,
                                       DataScope<double>& data, const std::vector<double>& v,
                                       const std::optional<std::vector<std::string>>& loads);

// The bodies of a machine on their way from the figure, in a state. reach: as of ParticlePaths.
solve::ParticlePaths paths_of(const solve::MechanismState& state, const Machine& machine, double reach);

// What acts at a place of a body as drawn, its mass center if none is given, and is drawn so on the axes of a body:
// where it acts in a state, and along what.
StatedForce drawn_force(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data, int body,
                        const std::optional<Expression>& at, int axes, const Vector3<double>& drawn);

// By how much what the laws of force exert in a state is otherwise than stated. unit: a length of the machine; force:
// the largest of its forces.
double misfit_of_laws(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data,
                      const std::optional<std::vector<std::string>>& loads, double unit, double force);
// The same beside a state, where all has moved a little and moves otherwise.
double misfit_of_laws_beside(const solve::MechanismState& state, const Machine& machine, DataScope<double>& data,
                             const std::optional<std::vector<std::string>>& loads, double unit, double pace);

}  // namespace poinsot::problem
