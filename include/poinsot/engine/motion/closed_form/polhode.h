// The path of the angular velocity in a body that moves free of moments: Poinsot's polhode, and the herpolhode on the
// invariable plane (section 18.11).
//
// With principal moments I1 <= I2 <= I3 the direction l = H_G/H of the angular momentum, on body axes, keeps
// l1^2 + l2^2 + l3^2 = 1 and l1^2/I1 + l2^2/I2 + l3^2/I3 = 2T/H^2, and runs around the axis of the smallest or of the
// largest moment. Let z be that axis, y the intermediate one, x the third, right-handed, with l_z and l_x positive
// somewhere on the path. Then (C. G. J. Jacobi 1850; E. T. Whittaker, Analytical Dynamics, section 69)
//
//   l_x = a_x cn(u | m),  l_y = s a_y sn(u | m),  l_z = a_z dn(u | m),  u = rate t + u_0,
//
// s = 1 about the largest moment, -1 about the smallest. With D_ij = |1/I_i - 1/I_j|:
//
//   a_x^2 = l_x^2 + (D_yz/D_xz) l_y^2    a_y^2 = l_y^2 + (D_xz/D_yz) l_x^2    a_z^2 = l_z^2 + (D_xy/D_xz) l_y^2
//   rate = H a_z sqrt(D_xz D_yz)         m = (D_xy/D_yz) a_x^2/a_z^2          1 - m = (D_yz l_z^2 - D_xy l_x^2)/(D_yz
//   a_z^2)
//
// These are sums of positive terms. The usual ones, from differences of H^2 and 2 T I, lose their digits for nearly
// axisymmetric bodies and for spins near a principal axis. Only 1 - m is a difference: its sign tells which axis
// is encircled, its size how far the separatrix is, and no form of it is better conditioned by the data.
#pragma once

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/elliptic/elliptic_integrals.h"

namespace poinsot {

enum class PolhodeKind {
  point,           // the angular velocity is constant: a principal axis, a spherical body, rest
  about_smallest,  // encircles the axis of the smallest moment; a circle if the other two are equal
  about_largest,   // encircles the axis of the largest moment
  separatrix,      // tends to the axis of the intermediate moment, forward and backward in time
};

// The sense of the precession of the encircled axis about H_G against the spin about that axis.
enum class PrecessionSense { none, direct, retrograde };

// Smallest and largest value of a quantity along a path.
struct Range {
  double minimum = 0;
  double maximum = 0;
};

// All for the body axes that the angular velocity w is given on.
class Polhode {
 public:
  // moments: principal moments of inertia at G (or at a fixed point that takes no moment), kg m^2, positive, in any
  // order. axes: columns, the principal axes on body axes, right-handed or not. w: angular velocity on body axes,
  // rad/s. Throws std::invalid_argument if a moment is not positive and finite, or w not finite.
  Polhode(const Vector3<double>& moments, const Matrix3<double>& axes, const Vector3<double>& w);
  Polhode(const Vector3<long double>& moments, const Matrix3<long double>& axes, const Vector3<double>& w);

  PolhodeKind kind() const { return kind_; }
  // About the largest moment retrograde, about the smallest direct (I > I' and I < I' of Eq. 18.49).
  PrecessionSense sense() const;

  double angular_momentum() const { return static_cast<double>(H_); }  // H_G, kg m^2/s
  double kinetic_energy() const { return static_cast<double>(T_); }    // about G, J
  // w . H_G / H_G = 2T/H_G, the distance of the invariable plane on the scale of w, rad/s; zero at rest.
  double invariable_plane_distance() const;

  // Of w in the body, s: 4 K/rate. Zero where w is constant, infinite on the separatrix.
  double period() const;

  // Range over all times of direction . w (rad/s times the unit of direction) and of the angle (rad, 0 to pi) between
  // an axis of the body and H_G: the nutation of that axis. direction and axis on body axes, axis not zero. On the
  // separatrix the ends may be limits that are never reached.
  Range angular_velocity_range(const Vector3<double>& direction) const;
  Range nutation_range(const Vector3<double>& axis) const;
  // Of |w|, rad/s.
  Range speed_range() const;
  // Radii of the herpolhode, of the part of w across H_G, rad/s.
  Range herpolhode_radii() const;

  // The closed form, for those who evaluate it. Where the polhode is a point l is constant and the rest unused.
  struct Solution {
    Matrix3<long double> axes;         // columns: x, y, z of the head of this file on body axes
    Vector3<long double> moments;      // about them, kg m^2
    long double angular_momentum = 0;  // H_G, kg m^2/s
    Vector3<long double> direction;    // l at t = 0 on them
    Vector3<long double> amplitude;    // a_x, a_y, a_z
    EllipticParameter<long double> parameter;
    long double rate = 0;              // rad/s
    long double sense = 1;             // s
    long double initial_argument = 0;  // u_0, in size at most K
    long double quarter_period = 0;    // K
    Vector3<long double> differences;  // D_yz, D_xz, D_xy
  };
  const Solution& solution() const { return solution_; }

 private:
  void set_up(const Vector3<long double>& moments, const Matrix3<long double>& axes, const Vector3<double>& w);
  struct Ends {
    Vector3<long double> at_minimum, at_maximum;
  };
  // Where on the path key(l), a monotonic function of c . l, is smallest and largest; c and l on the axes of the
  // solution.
  template <class Key>
  Ends ends_of(const Vector3<long double>& c, Key key) const;

  PolhodeKind kind_ = PolhodeKind::point;
  long double H_ = 0, T_ = 0;
  Solution solution_;
};

}  // namespace poinsot
