// Motion of a rigid body free of moments about G (or about a fixed point O), in closed form: any body, any spin, any
// time (section 18.11).
//
// The angular velocity runs on the polhode (polhode.h). For the attitude, let Z be along H_G, fixed in space, and x, y,
// z the polhode's body axes, l = H_G/H on them. The body is turned from (X, Y, Z) by the smallest rotation that takes l
// to Z, then about Z by an angle chi:
//
//   q = exp(k chi/2) (1 + l_z + l_y i - l_x j) / sqrt(2 (1 + l_z)),   dchi/dt = (2T/H + w_z)/(1 + l_z)
//
// Since l_z > 0 nothing is singular, unlike with precession and spin apart: chi is their sum. Its integral is one of
// the third kind. Split into a part even in time and the phase of a theta function it makes the two complex halves of q
// (Cayley's and Klein's parameters, q = alpha + beta i) theta functions themselves, but for one real factor (cf. C. G.
// J. Jacobi, Gesammelte Werke 2, 477; R. van Zon and J. Schofield, J. Comput. Phys. 225, 145, 2007; E. Celledoni et
// al., J. Comput. Phys. 227, 3698, 2008):
//
//   alpha = exp(k c t) theta_4(z - i s nu | 2 tau) / theta_4(i nu | 2 tau)
//   beta  = -k exp(k c t) a_x/(1 + a_z) theta_1(z - i s nu | 2 tau) / theta_1(-i s nu | 2 tau),   z = pi u/(2 K)
//
// with the half periods K and 2 K' of the lattice and nu = pi v/(2 K), sn^2(v | 1 - m) = D_yz/D_xz. The doubled
// imaginary period comes from 1 + l_z, which has poles and zeros twice as far apart as 1 - l_z^2; it squares the nome.
// alpha is nowhere zero, and both series keep their digits from axisymmetric bodies (m = 0) to the separatrix (m = 1).
#pragma once

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/elliptic/elliptic_functions.h"
#include "poinsot/engine/math/elliptic/elliptic_theta.h"
#include "poinsot/engine/motion/closed_form/polhode.h"
#include "poinsot/engine/motion/integrator/phase.h"

namespace poinsot {

// Prepared once in extended precision; evaluations take some hundred nanoseconds, allocate nothing and may run on
// several threads at once. Their errors are a few 1e-16 at any time, plus what the rounding of the data, of t among
// them, stands for.
class TorqueFreeMotion {
 public:
  struct State {
    Quaternion<double> attitude;       // body to ground
    Vector3<double> angular_velocity;  // on body axes, rad/s
  };

  // moments: principal moments at G, kg m^2, in any order, equal ones welcome. axes: their axes as columns, on body
  // axes. attitude: body to ground at t = 0, of any length but zero. angular_velocity: on body axes at t = 0, rad/s.
  // Throws std::invalid_argument where the data are no body's.
  TorqueFreeMotion(const Vector3<double>& moments, const Matrix3<double>& axes, const Quaternion<double>& attitude,
                   const Vector3<double>& angular_velocity);
  // For body axes that are principal.
  TorqueFreeMotion(const Vector3<double>& moments, const Quaternion<double>& attitude,
                   const Vector3<double>& angular_velocity);
  // From a tensor of inertia at G on body axes (Eq. 18.8).
  static TorqueFreeMotion of_tensor(const SymmetricMatrix3<double>& inertia, const Quaternion<double>& attitude,
                                    const Vector3<double>& angular_velocity);

  // At the time t, s, before or after t = 0.
  Quaternion<double> attitude(double t) const;       // body to ground, of unit length
  Vector3<double> angular_velocity(double t) const;  // on body axes, rad/s
  State at(double t) const;

  const Polhode& polhode() const { return polhode_; }
  // H_G, on ground axes, kg m^2/s: constant.
  const Vector3<double>& angular_momentum() const { return angular_momentum_; }
  double kinetic_energy() const { return polhode_.kinetic_energy(); }  // about G, J

  // Period of the angular velocity on body axes, s; zero where it is constant, infinite on the separatrix.
  double period() const { return polhode_.period(); }
  // Angle by which the encircled axis turns about H_G in one period, rad, in the sense of H_G: positive, and of any
  // number of turns. After a period the body is where a turn by this angle about H_G would have brought it. Zero where
  // the angular velocity is constant, infinite on the separatrix.
  double precession_per_period() const { return precession_per_period_; }
  // Its mean rate, rad/s: H_G/I' for an axisymmetric body. On the separatrix the rate in the limit, H_G/I_2. Zero where
  // the angular velocity is constant.
  double mean_precession_rate() const { return mean_precession_rate_; }

 private:
  TorqueFreeMotion(const Vector3<long double>& moments, const Matrix3<long double>& axes,
                   const Quaternion<double>& attitude, const Vector3<double>& angular_velocity);
  void set_up(const Quaternion<double>& attitude, const Vector3<double>& angular_velocity);

  Polhode polhode_;
  JacobiFunctions jacobi_;
  Vector3<double> angular_momentum_{};
  double precession_per_period_ = 0;
  double mean_precession_rate_ = 0;

  Quaternion<double> attitude_at(const CellPhase::Place& place, double t) const;
  Vector3<double> angular_velocity_at(const CellPhase::Place& place) const;

  bool constant_ = false;  // the angular velocity is
  CellPhase cells_;        // of u
  ThetaArgument<double> argument_;
  // attitude = left exp(k 2 pi (turns - cell_turns)) (alpha + beta i) right, or left exp(k ...) right where constant
  Phase turns_;       // by t
  Phase cell_turns_;  // by the count of cells
  ShiftedTheta<double, 4> alpha_, beta_;
  Quaternion<double> left_{}, right_{};
  // angular velocity = axes (amplitude . (cn, sn, dn))
  Matrix3<double> axes_{};
  Vector3<double> amplitude_{};
};

}  // namespace poinsot
