// The rotations that bench_integration measures, and who takes part.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "poinsot/motion/rotation.h"

namespace poinsot::bench {

// A body on its principal axes: moments I about the fixed point or mass center, weight times the arm along y of the
// body (N m), gravity along -z of the ground; attitude identity at the start.
struct RotationCase {
  std::string name;
  Vector3<double> I;
  double weight;
  Vector3<double> w;                   // rad/s, at the start
  double end;                          // s
  std::array<double, 4> end_attitude;  // quaternion, to the last digit of a double
};

// w (body axes) and attitude quaternion.
using RotationNumbers = std::array<double, 7>;

// The right-hand side as one would write it by hand.
inline void rotation_rates(const RotationCase& c, const RotationNumbers& y, RotationNumbers& rate) {
  const double w0 = y[0], w1 = y[1], w2 = y[2];
  const double q0 = y[3], q1 = y[4], q2 = y[5], q3 = y[6];
  double t0 = (c.I.y - c.I.z) * w1 * w2;
  double t2 = (c.I.x - c.I.y) * w0 * w1;
  if (c.weight != 0.0) {
    t0 -= c.weight * (q0 * q0 - q1 * q1 - q2 * q2 + q3 * q3);
    t2 += c.weight * 2.0 * (q1 * q3 - q0 * q2);
  }
  rate[0] = t0 / c.I.x;
  rate[1] = (c.I.z - c.I.x) * w2 * w0 / c.I.y;
  rate[2] = t2 / c.I.z;
  rate[3] = 0.5 * (-q1 * w0 - q2 * w1 - q3 * w2);
  rate[4] = 0.5 * (q0 * w0 + q2 * w2 - q3 * w1);
  rate[5] = 0.5 * (q0 * w1 - q1 * w2 + q3 * w0);
  rate[6] = 0.5 * (q0 * w2 + q1 * w1 - q2 * w0);
}

// A method: runs the case at a tolerance and gives the attitude at its end.
struct Integrator {
  std::string name;
  bool is_own = false;
  std::function<std::array<double, 4>(const RotationCase&, double tolerance)> run;
};

// Boost.odeint's Dormand-Prince 5(4) and Fehlberg 7(8).
std::vector<Integrator> odeint_integrators();
// CVODE's Adams methods and ARKODE's Fehlberg 8(7); empty if SUNDIALS is not there.
std::vector<Integrator> sundials_integrators();

}  // namespace poinsot::bench
