// The motions that bench_integration measures, and who takes part.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "poinsot/engine/motion/rotation/rotation.h"

namespace poinsot::bench {

using Attitude = std::array<double, 4>;  // quaternion w x y z of any length

// A body on its principal axes: moments I about the fixed point or mass center, weight times the arm along y of the
// body (N m), gravity along -z of the ground; attitude identity at the start.
struct RotationCase {
  std::string name;
  Vector3<double> I;
  double weight;
  Vector3<double> w;      // rad/s, at the start
  double end;             // s
  Attitude end_attitude;  // to the last digit of a double

  // w (body axes) and attitude quaternion.
  using Numbers = std::array<double, 7>;
  Numbers start() const { return {w.x, w.y, w.z, 1.0, 0.0, 0.0, 0.0}; }
  double first_step() const { return 1e-3 / (1.0 + norm(w)); }
  static Attitude attitude(const double* y) { return {y[3], y[4], y[5], y[6]}; }
  // The right-hand side as one would write it by hand.
  void rates(const double* y, double* rate) const {
    const double w0 = y[0], w1 = y[1], w2 = y[2];
    const double q0 = y[3], q1 = y[4], q2 = y[5], q3 = y[6];
    double t0 = (I.y - I.z) * w1 * w2;
    double t2 = (I.x - I.y) * w0 * w1;
    if (weight != 0.0) {
      t0 -= weight * (q0 * q0 - q1 * q1 - q2 * q2 + q3 * q3);
      t2 += weight * 2.0 * (q1 * q3 - q0 * q2);
    }
    rate[0] = t0 / I.x;
    rate[1] = (I.z - I.x) * w2 * w0 / I.y;
    rate[2] = t2 / I.z;
    rate[3] = 0.5 * (-q1 * w0 - q2 * w1 - q3 * w2);
    rate[4] = 0.5 * (q0 * w0 + q2 * w2 - q3 * w1);
    rate[5] = 0.5 * (q0 * w1 - q1 * w2 + q3 * w0);
    rate[6] = 0.5 * (q0 * w2 + q1 * w1 - q2 * w0);
  }
};

// A disk on a rod in a fork: the fork turns freely by phi about the vertical, the rod by theta about a level axis, from
// hanging down (problem 18.C5). Per unit mass: moments across and along the rod about the hinge (m^2), weight (m/s^2
// m).
struct ForkCase {
  std::string name;
  double across, along, weight;
  double theta, phi_rate;  // at the start; rad, rad/s; at rest in the fork
  double end;
  Attitude end_attitude;

  // theta, phi and their rates.
  using Numbers = std::array<double, 4>;
  Numbers start() const { return {theta, 0.0, 0.0, phi_rate}; }
  double first_step() const { return 1e-3 / (1.0 + std::fabs(phi_rate)); }
  static Attitude attitude(const double* y) {
    const double s = std::sin(0.5 * y[0]), c = std::cos(0.5 * y[0]);
    const double sine = std::sin(0.5 * y[1]), cosine = std::cos(0.5 * y[1]);
    return {cosine * c, -sine * s, cosine * s, sine * c};
  }
  template <class Number>
  void rates(const Number* y, Number* rate) const {
    using std::cos, std::sin;
    const Number s = sin(y[0]), c = cos(y[0]);
    rate[0] = y[2];
    rate[1] = y[3];
    rate[2] = ((across - along) * s * c * y[3] * y[3] - weight * s) / across;
    rate[3] = -2.0 * (across - along) * s * c * y[2] * y[3] / (across * s * s + along * c * c);
  }
};

// A method: runs the case at a tolerance and gives the attitude at its end.
template <class Case>
struct Integrator {
  std::string name;
  bool is_own = false;
  std::function<Attitude(const Case&, double tolerance)> run;
};

// Boost.odeint's Dormand-Prince 5(4) and Fehlberg 7(8).
template <class Case>
std::vector<Integrator<Case>> odeint_integrators();
extern template std::vector<Integrator<RotationCase>> odeint_integrators();
extern template std::vector<Integrator<ForkCase>> odeint_integrators();
// CVODE's Adams methods and ARKODE's Fehlberg 8(7); empty if SUNDIALS is not there.
template <class Case>
std::vector<Integrator<Case>> sundials_integrators();
extern template std::vector<Integrator<RotationCase>> sundials_integrators();
extern template std::vector<Integrator<ForkCase>> sundials_integrators();

}  // namespace poinsot::bench
