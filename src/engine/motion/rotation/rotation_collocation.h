// One step of the rotation of a rigid body, by Gauss-Legendre collocation of order 16 around the free motion of the
// symmetric body nearest to it (rotation.h).
//
// Frames of a step: B the principal axes; F, from which B turns by the angle theta = Omega t about its axis z (the
// principal axis across which the moments differ least); S, which turns from the ground G about the momentum L0 at the
// step's start at the rate a L0, a the mean of the reciprocal moments across z. Unknowns are the quaternion of F
// in S and l = L - L0 on the axes of S:
//
//   dq/dt = q (0, w)/2,   w = a R_SF^T l + d (cos 2theta, sin 2theta; sin 2theta, -cos 2theta) m_xy + ((1/I - a) m_z -
//   Omega) z,   dl/dt = torque - a L0 x l,   m = R_SF^T (L0 + l),
//
// d half the difference of the reciprocal moments across z. All that is fast is in the frames.
#pragma once

#include "engine/motion/rotation/principal_body.h"

namespace poinsot {

struct RotationStep {
  bool converged = false;
  bool finite = true;
  RotationState end;
  double error = 0.0;        // estimated, attitude in rad and momentum over its size
  double contraction = 0.0;  // by which an iteration reduced the error
  int iterations = 0;
};

// The step from state at t over h. momentum_size: what counts as 1 for errors of the momentum. accuracy: to which the
// implicit equations are solved, of the same measure as the error.
RotationStep rotation_step(const PrincipalBody& body, const RotationState& state, double t, double h,
                           double momentum_size, double accuracy);

// A first step: over which the departure from the free motion is of order one.
double natural_step(const PrincipalBody& body, const RotationState& state, double t, double span);

}  // namespace poinsot
