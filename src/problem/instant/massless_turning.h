// What turns and moves no mass: particles, rods about their own line. It rests unless something else is stated.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "poinsot/engine/motion/mechanism/mechanism_dynamics.h"
#include "problem/machine/machine.h"

namespace poinsot::problem {

// Of directions in which velocities are open, takes those that move no mass: at right angles to each other and of
// length one.
std::vector<std::vector<double>> take_massless(const Machine& machine, std::vector<std::vector<double>>& open);
// Takes the components along such directions out of velocities.
void remove_components(const std::vector<std::vector<double>>& directions, std::vector<double>& v);

// The turning of a body about a line fixed in it, about which it has no moment of inertia.
struct MasslessSpin {
  std::size_t first = 0;  // of three velocity coordinates
  Vector3<double> axis;   // unit vector on their axes
  bool alone = true;      // it moves no other body either
};
// That of the body to whose ball or free joint a velocity coordinate belongs; none if about all axes or no axis.
std::optional<MasslessSpin> massless_spin(const Machine& machine, int coordinate);
// Whether a coordinate turns nothing but a particle about an axis through it.
bool turns_particle(const Machine& machine, int coordinate);
// One of the open coordinates that can be held, since a turning without inertia is what is open in it.
std::optional<int> massless_coordinate(const Machine& machine, const std::vector<OpenCoordinate>& open);
// Takes it out of accelerations.
void take_out(const MasslessSpin& spin, std::span<double> accelerations);

}  // namespace poinsot::problem
