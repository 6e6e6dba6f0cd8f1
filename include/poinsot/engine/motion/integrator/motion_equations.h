// The equations of motion of a system as the integrators take them: coordinates q, velocities v,
//
//   dq/dt = position rate (t, q, v),   dv/dt = accelerations (t, q, v),
//
// further conditions (constraints, coordinates given as functions of time, unit quaternions), and the natural sizes
// in which errors are measured. What the functions refer to must outlive the equations.
#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/engine/model/model.h"

namespace poinsot {

// In this pose constraints depend on each other that do not do so elsewhere, or cannot all hold. The motion can
// continue in more than one way, or in none.
struct SingularPose : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A number that the motion conserves (energy, a component of an angular momentum). Its drift is reported.
struct ConservedQuantity {
  std::string name;
  std::function<double(double t, std::span<const double> q, std::span<const double> v)> value;
};

struct MotionEquations {
  int position_size = 0;
  int velocity_size = 0;
  // dq/dt, position_size numbers. Empty: dq/dt = v.
  std::function<void(double t, std::span<const double> q, std::span<const double> v, std::span<double> rate)>
      position_rate;
  // dv/dt, velocity_size numbers. A number that is not finite fails the step; an exception ends the integration and
  // passes through. q and v of a stage within a step keep constraints and unit quaternions only up to the error of
  // the step.
  std::function<void(double t, std::span<const double> q, std::span<const double> v, std::span<double> acceleration)>
      accelerations;
  // The same at eight instants together, for equations to which that costs little more than one: number k at instant i
  // stands at 8 k + i. accelerations_at_eight may be empty; else position_rate_at_eight is there if position_rate is.
  std::function<void(std::span<const double> t, std::span<const double> q, std::span<const double> v,
                     std::span<double> rate)>
      position_rate_at_eight;
  std::function<void(std::span<const double> t, std::span<const double> q, std::span<const double> v,
                     std::span<double> acceleration)>
      accelerations_at_eight;
  // Takes a state back onto the constraints and coordinates given in time to their values there; called once after
  // each step, with a state off by no more than the step's error. Empty: nothing but the quaternions to mind. Throws
  // SingularPose, which ends the integration.
  std::function<void(double t, std::span<double> q, std::span<double> v)> project;
  // First of the four position coordinates (w, x, y, z) of each unit quaternion: normalised after each step.
  std::vector<int> quaternions;
  // Natural sizes of the coordinates and velocities (their units): a step's error is held to tolerance times size.
  // Empty: 1 for coordinates, and for velocities the largest magnitude met so far but at least the largest size of a
  // coordinate per span of time integrated.
  std::vector<double> position_sizes;
  std::vector<double> velocity_sizes;
  std::vector<ConservedQuantity> conserved;
};

// Joint forces, one per velocity coordinate, and wrenches on the bodies (one each, on body axes about the body's
// origin); both come zeroed.
using LoadFunction = std::function<void(double t, std::span<const double> q, std::span<const double> v,
                                        std::span<double> joint_force, std::span<SpatialForce<double>> wrench)>;

// The equations of a tree of bodies all of whose coordinates are free, by the articulated-body algorithm, under gravity
// and loads. The model must outlive them. Errors: std::invalid_argument if a coordinate is not free.
MotionEquations tree_equations(const Model<double>& model, const LoadFunction& loads = {});

}  // namespace poinsot
