// The heavy symmetric top with a fixed point, in closed form (sections 18.9, 18.10): any spin, any start, any time. Its
// limits are the spherical pendulum (no spin), the planar pendulum, steady precession, the sleeping top, and free
// axisymmetric motion (no weight).
//
// Eulerian angles as in Eq. 18.33: precession phi about the fixed Z, upward, nutation theta from Z to the axis of
// symmetry z, spin psi about z; R = R_z(phi) R_y(theta) R_z(psi). I is the moment about z, I' the transverse one at O.
// With alpha = H_Z, beta = H_z and the energy E conserved, a = alpha/I', b = beta/I', kappa = 2 m g c/I',
// epsilon = (2E - beta^2/I)/I' and x = cos theta:
//
//   (dx/dt)^2 = (epsilon - kappa x)(1 - x^2) - (a - b x)^2 = kappa (x - x1)(x2 - x)(x3 - x),  -1 <= x1 <= x2 <= 1 <= x3
//   x = x1 + (x2 - x1) sn^2(u | m),  u = rate t + u_0,  4 rate^2 = kappa (x3 - x1),  m = (x2 - x1)/(x3 - x1)
//
// (E. T. Whittaker, Analytical Dynamics, sections 71-73). Each root is found about the point that it is nearest to: the
// start, theta = 0 or theta = pi. Small nutations, near misses of the vertical and slow passes near the sleeping
// position so keep their digits. Cayley's and Klein's parameters are theta functions but for one real factor (F. Klein
// and A. Sommerfeld, Ueber die Theorie des Kreisels, chapter VI):
//
//   cos(theta/2) exp(i (phi + psi)/2) ~ exp(i c1 t) theta_1(z - i nu_1),  sin(theta/2) exp(i (phi - psi)/2) ~
//   exp(i c2 t) theta_2(z - i nu_2),   z = pi u/(2 K)
//
// with shifts nu = pi y/(2 K) from sc^2(y_1 | 1 - m) = (1 + x1)/(x2 - x1), nd^2(y_2 | 1 - m) = (1 - x1)/(x2 - x1).
#pragma once

#include <vector>

#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/elliptic/elliptic_functions.h"
#include "poinsot/engine/math/elliptic/elliptic_theta.h"
#include "poinsot/engine/motion/closed_form/polhode.h"
#include "poinsot/engine/motion/integrator/phase.h"

namespace poinsot {

struct TopCubic;
struct TopCubicData;

struct TopParameters {
  double transverse_moment = 0;  // I' at O, kg m^2, positive
  double axial_moment = 0;       // I, kg m^2; zero for a spherical pendulum
  double gravity_moment = 0;     // m g c, N m, c the distance of G from O along z; negative if G is on -z
};

struct TopState {
  double nutation = 0;         // theta, rad, 0 to pi
  double nutation_rate = 0;    // d theta/dt, rad/s
  double precession = 0;       // phi, rad
  double precession_rate = 0;  // d phi/dt, rad/s; without effect at theta = 0 and pi but for its part in axial_rate
  double spin = 0;             // psi, rad
  double axial_rate = 0;       // w_z = d psi/dt + d phi/dt cos theta, rad/s
};

// What the axis does between its two circles of latitude on the unit sphere.
enum class TopCurve {
  steady,  // theta is constant, up to rounding
  planar,  // the axis swings in a vertical plane
  waved,   // the precession never reverses
  cusped,  // it stops at one of the circles
  looped,  // it reverses between them
};

// Prepared once in extended precision; evaluations allocate nothing and may run on several threads at once.
class SymmetricTop {
 public:
  // Throws std::invalid_argument for numbers that are not finite, I' <= 0, I < 0 and theta out of range.
  SymmetricTop(const TopParameters& parameters, const TopState& start);

  // At the time t, s, before or after the start at t = 0. phi and psi are continuous; where the axis passes exactly
  // through the vertical they jump by pi as theta, which stays within 0 and pi, turns back.
  TopState at(double t) const;
  // Body to ground, Z of the ground upward.
  Quaternion<double> attitude(double t) const;
  // On body axes, rad/s.
  Vector3<double> angular_velocity(double t) const;

  struct Turning {
    Quaternion<double> attitude;
    Vector3<double> angular_velocity;
  };
  Turning turning(double t) const;  // both of these, in the time of one

  // Conserved: H_Z (kg m^2/s), H_z, and the energy E with the potential m g c cos theta (J).
  double vertical_momentum() const { return vertical_momentum_; }
  double axial_momentum() const { return axial_momentum_; }
  double energy() const { return energy_; }

  // Extremes of theta, rad, from the cubic. Of an asymptotic motion the smallest, zero, is a limit.
  Range nutation_range() const { return nutation_range_; }
  TopCurve curve() const { return curve_; }
  // The motion tends to the upright position, forward and backward in time, and never returns.
  bool asymptotic() const { return endless_; }

  // Of theta, s; infinite in asymptotic motion. In steady precession that of vanishing nutations; infinite where these
  // grow.
  double nutation_period() const { return period_; }
  // Of phi and psi in one period of theta, rad; in asymptotic motion what is left when the means below are taken off:
  // infinite or not a number.
  double precession_per_period() const { return mean_precession_rate_ * period_; }
  double spin_per_period() const { return mean_spin_rate_ * period_; }
  // Means of d phi/dt and d psi/dt over a period, rad/s; in asymptotic motion their limits at late times.
  double mean_precession_rate() const { return mean_precession_rate_; }
  double mean_spin_rate() const { return mean_spin_rate_; }

  // All times in from <= t <= to, ascending, when theta takes the value given (rad); none if it never does, or always.
  // Extremes are met once per period. Throws std::invalid_argument if there would be more than a million.
  std::vector<double> times_at_nutation(double theta, double from, double to) const;

 private:
  using Real = long double;
  // All angles of the start, with the center of mass above O along z: turned over where m g c is negative.
  struct Start {
    Real nutation, nutation_rate, precession, precession_rate, spin, axial_rate, spin_rate;
  };
  struct Half {
    Phase turns;       // of the even part, by t
    Phase cell_turns;  // by the count of cells
    ShiftedTheta<double, 4> theta;
    ComplexValue<double> start{};  // the constant factor; its size is one, or in steady precession that of the half
    double rate = 0;               // of the even part, rad/s
    double drift = 0;              // mean growth of the theta function's angle by u
    double offset = 0;             // angle() at t = 0, rad
    int sense = 0;                 // in which the theta function winds
    int side = 1;                  // the sign of its real part in the middle cell
  };
  // cos(theta/2) exp(i (phi + psi)/2) and i sin(theta/2) exp(i (phi - psi)/2) times a common real function of t, and
  // their rates.
  struct Halves {
    ComplexValue<double> upper, lower, upper_rate, lower_rate;
  };
  struct Roots {
    Real above1, above2, below1, below2;  // 1 - x1, 1 - x2, 1 + x1, 1 + x2
    Real spread;                          // x2 - x1
    Real b, low, high;                    // b, a - b x1, a - b x2
    bool through_top, through_bottom;     // a = b, a = -b
  };
  struct Axis {
    double nutation, nutation_rate, precession_rate;
  };
  void set_up(const TopCubicData& data);
  void set_up_steady(const TopCubic& cubic);
  void set_up_nutation(const TopCubic& cubic, const TopCubicData& data);
  TopCurve curve_of(const TopCubic& cubic, const TopCubicData& data) const;
  Halves halves(double t) const;
  Quaternion<double> attitude_of(const Halves& h) const;
  Vector3<double> angular_velocity_of(const Halves& h) const;
  double angle(const Half& half, const CellPhase::Place& here) const;
  Axis axis_at(const CellPhase::Place& here) const;

  TopState given_{};
  bool inverted_ = false;  // m g c is negative: all below is of the body turned over, by half a turn about its y axis
  bool steady_ = false;
  bool endless_ = false;
  Start start_{};
  double vertical_momentum_ = 0, axial_momentum_ = 0, energy_ = 0;
  Range nutation_range_{};
  TopCurve curve_ = TopCurve::steady;
  double period_ = 0, mean_precession_rate_ = 0, mean_spin_rate_ = 0;
  Roots roots_{};
  Real rate_ = 0, initial_argument_ = 0, quarter_period_ = 0;
  EllipticParameter<Real> parameter_{};
  JacobiFunctions jacobi_{EllipticParameter<Real>{}};
  CellPhase cells_;  // of u
  ThetaArgument<double> argument_;
  Half upper_, lower_;
};

}  // namespace poinsot
