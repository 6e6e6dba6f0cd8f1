// The equations of motion of a Mechanism for motion through time: fast, without allocation.
//
// Tree joints are eliminated by their coordinates v; what acts beyond them enters by its power (principle of virtual
// work). With M the mass matrix of the free coordinates, h what the velocities, the weights and the held coordinates
// bring, Q the generalised forces of loads, springs, drives and dampers, J the rows of the constraints
// (engine/dynamics/velocity_constraint.h) and b their biases,
//
//   M dv/dt + h = Q + J^T y,      J dv/dt + b = 0.
//
// With J^T = [Q1 Q2] [R; 0] by pivoted QR the motion splits into what the constraints demand and what they leave free,
//
//   dv/dt = Q1 u + Q2 z,   R^T u = -b,   (Q2^T M Q2) z = Q2^T (Q - h - M Q1 u),   R y = Q1^T (M dv/dt + h - Q):
//
// constraints may repeat one another (redundant loops), and M may be singular as long as what the constraints leave
// free has inertia (massless rods and links in loops). Coordinates are scaled by their inertia. Where unknown
// components do not stand along the constraints (a contact without friction on which nothing may slip, say), z and the
// components' sizes are found together. Without constraints the accelerations come from the articulated-body algorithm
// (engine/dynamics/hybrid_dynamics.h).
//
// The same equations, with every force named and determined or not: solve/instant/equations.h.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "poinsot/engine/dynamics/mechanism.h"
#include "poinsot/engine/dynamics/momentum.h"

namespace poinsot {

// A velocity coordinate whose acceleration nothing determines.
struct OpenCoordinate {
  int coordinate = 0;
  bool without_inertia = false;  // it moves no mass; else a force of unknown size acts on it
};

// One object serves one thread. Sizes of spans are the model's position_size() and velocity_size();
// std::invalid_argument if one is wrong or an index is out of range.
class MechanismDynamics {
 public:
  // Held coordinates have given accelerations: those of held drives, those of bodies that do not take part and have no
  // drive (frames), and those of also_held. All others are free. Every later call but redundant_constraints,
  // open_coordinates and their like works in the memory made here.
  explicit MechanismDynamics(const Mechanism<double>& mechanism, std::span<const int> also_held = {});
  MechanismDynamics(MechanismDynamics&& other) noexcept;
  MechanismDynamics& operator=(MechanismDynamics&& other) noexcept;
  ~MechanismDynamics();

  const Mechanism<double>& mechanism() const;
  double natural_length() const;  // the extent of its points, m

  // What changes with time. The caller keeps positions and velocities of held coordinates in q and v.
  bool is_held(int coordinate) const;
  std::span<const int> held_coordinates() const;
  void set_held_acceleration(int coordinate, double acceleration);   // rad/s^2 or m/s^2; 0 until set
  void set_force(std::size_t force, const Vector3<double>& vector);  // of mechanism().forces
  void set_effort(std::size_t drive, double effort);                 // known couple or force of mechanism().drives
  // The direction of a component, of mechanism().components, on the axes on which it stands there. One that stood along
  // a constraint must stay along it.
  void set_direction(std::size_t component, const Vector3<double>& along);
  // Whether a cord or contact acts: false while slack or lost. All act at first.
  void set_acting(int action, bool acting);
  bool is_acting(int action) const;

  // dv/dt of all coordinates, the held ones as set. Coordinates that are open get 0 as far as that goes. Quaternions in
  // q must be unit ones; constraints should hold as closely as the accelerations are wanted.
  void accelerations(std::span<const double> q, std::span<const double> v, std::span<double> acceleration);

  // After accelerations, at its state. ------------------------------------------------------------------------------
  // The size of mechanism().components[component]: the tension of a cord, the normal force of a contact. 0 while it
  // does not act, and for components of tree joints, which the equations of motion need not know.
  double component_force(std::size_t component) const;
  // Whether the equations of motion determine it. They do not for tree joints, nor where redundant constraints share
  // a load.
  bool component_determined(std::size_t component) const;
  // The couple or force on a held coordinate that gives it its acceleration, in addition to its known effort, spring
  // and damper.
  double held_effort(int coordinate) const;
  // Largest |J dv/dt + b|, relative to the largest term: constraints and given motions that contradict each other.
  double constraint_misfit();
  // Power of loads, known efforts, dampers and held coordinates, W: d(T + V)/dt.
  double power();

  // Constraints. ----------------------------------------------------------------------------------------------------
  // Moves the free positions by the least change that closes loops, tautens cords and lets contacts touch (Newton's
  // method), makes quaternions unit ones, then changes the free velocities least so that all constraints hold. Returns
  // the largest gap left, in natural lengths or rad. Changes are weighed by the inertia that they move.
  double project(std::span<double> q, std::span<double> v);
  // The same after each step of a motion. Throws SingularPose (motion_equations.h) where the constraints cannot hold,
  // or where they depend on one another as at no pose held before.
  void hold(std::span<double> q, std::span<double> v);
  // The same for positions only, and for velocities only.
  double project_positions(std::span<double> q);
  void project_velocities(std::span<const double> q, std::span<double> v);
  // The largest gap and rate of acting constraints: m or rad, m/s or rad/s.
  double largest_gap(std::span<const double> q);
  double largest_rate(std::span<const double> q, std::span<const double> v);
  // The gap of a single constraint, whether it acts or not: negative while a cord is slack, positive while a contact
  // is open. Then its rate.
  double gap(std::size_t constraint, std::span<const double> q);
  double gap_rate(std::size_t constraint, std::span<const double> q, std::span<const double> v);
  // After accelerations or project: how far the constraints that count are from depending on one another, from 1 to 0
  // in a singular pose, where branches of the motion cross. What they are told apart by is lost below some 1e-4.
  double independence() const;
  // Acting constraints that the others imply, wherever the mechanism stands.
  std::vector<std::size_t> redundant_constraints() const;
  // Free coordinates that the equations leave open at q: all of them together, or in some combination.
  std::vector<OpenCoordinate> open_coordinates(std::span<const double> q);

  // Conserved where nothing changes them. ---------------------------------------------------------------------------
  double kinetic_energy(std::span<const double> q, std::span<const double> v);  // J
  // Of weights, springs and springs of drives, J.
  double potential_energy(std::span<const double> q);
  // About a ground point.
  Momentum<double> momentum(std::span<const double> q, std::span<const double> v, const Vector3<double>& about);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot
