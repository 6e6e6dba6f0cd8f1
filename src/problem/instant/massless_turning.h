// Turning that moves no mass, as that of particles and of rods about their own line. It is zero unless stated
// otherwise.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "poinsot/engine/solve/stability/linearisation.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Takes from the open directions of velocities those that move no mass, and returns them perpendicular to each other
// and of length one.
std::vector<std::vector<double>> take_massless(const Machine& machine, std::vector<std::vector<double>>& open);
// Leaves of the components of the velocities along such directions this part: none if nothing is said.
void reduce_components(const std::vector<std::vector<double>>& directions, std::vector<double>& v, double part = 0);

// The turning of a body about a line fixed in it about which it has no moment of inertia.
struct MasslessSpin {
  std::size_t first = 0;  // index of the first of three velocity coordinates
  Vector3<double> axis;   // a unit vector on the axes of these coordinates
  bool alone = true;      // whether it moves no other body either
};
// The massless turning of the body whose ball or free joint has this velocity coordinate; nothing if there is no such
// line, or if every line is one.
std::optional<MasslessSpin> massless_spin(const Machine& machine, int coordinate);
// Whether a coordinate turns only a particle about an axis through it.
bool turns_particle(const Machine& machine, int coordinate);
// One of the open coordinates that may be held because a massless turning is what is open in it; nothing if there is
// none.
std::optional<int> massless_coordinate(const Machine& machine, const std::vector<OpenCoordinate>& open);
// Motions near a pose that move no mass and that nothing hinders, if the coordinates `held` do not move.
std::vector<solve::UnseenMotion> unseen_motions(const Mechanism<double>& mechanism, const std::vector<double>& q,
                                                const std::vector<int>& held);
// Takes the spin out of accelerations.
void take_out(const MasslessSpin& spin, std::span<double> accelerations);

}  // namespace poinsot::problem
