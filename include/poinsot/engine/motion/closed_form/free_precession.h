// Free motion of an axisymmetric body (Eqs. 18.46-18.49): steady precession about H_G, and the two cones.
//
// The special case of torque_free.h that needs no elliptic functions, in the terms of the chapter.
#pragma once

#include "poinsot/engine/motion/closed_form/polhode.h"

namespace poinsot {

struct FreePrecession {
  double angular_momentum = 0;  // H_G, kg m^2/s
  double momentum_angle = 0;    // theta, from the axis of symmetry to H_G, rad, 0 to pi
  double velocity_angle = 0;    // gamma, from the axis of symmetry to w, rad, 0 to pi: tan gamma = (I/I') tan theta
  double precession_rate = 0;   // d phi/dt = H_G/I', of the axis about H_G, rad/s
  double spin_rate = 0;         // d psi/dt = H_G cos theta (I' - I)/(I I'), about the axis, rad/s
  double body_cone = 0;         // half-angle of the cone of w about the axis in the body, rad, at most pi/2
  double space_cone = 0;        // half-angle of the cone of w about H_G in space, rad, less than pi/2
  PrecessionSense sense = PrecessionSense::none;  // direct: I < I', the cones touch from outside
};

// axial_moment I and transverse_moment I' at G, kg m^2, positive. axial_rate w_z of either sign and transverse_rate >=
// 0, the parts of w along and across the axis, rad/s. Throws std::invalid_argument otherwise.
FreePrecession free_precession(double axial_moment, double transverse_moment, double axial_rate,
                               double transverse_rate);

}  // namespace poinsot
