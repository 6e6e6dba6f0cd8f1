// The attitude of a body free of moments by Euler's angles about H_G, in fifty digits: the textbook road, with Boost's
// Jacobi functions and Legendre's integral of the third kind. It shares neither series nor variables with the closed
// form under test.
#pragma once

#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <utility>

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/quaternion.h"
#include "poinsot/engine/math/algebra/vector3.h"

namespace poinsot {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

struct OracleState {
  Quaternion<Digits50> attitude;
  Vector3<Digits50> angular_velocity;
};

// moments: three different ones, about the body axes. attitude: of any length. Not for exact rotation about a
// principal axis nor for motion on the separatrix.
inline OracleState torque_free_oracle(const Vector3<Digits50>& moments, const Quaternion<Digits50>& attitude,
                                      const Vector3<Digits50>& w, const Digits50& t) {
  using Number = Digits50;
  using Vector = Vector3<Number>;
  using Matrix = Matrix3<Number>;
  using std::sqrt;

  // Axes in the order of ascending moments, then 1, 2, 3 with 3 the encircled one, right-handed.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return moments[a] < moments[b]; });
  const Vector L{moments.x * w.x, moments.y * w.y, moments.z * w.z};
  const Number H2 = dot(L, L), H = sqrt(H2), T2 = dot(L, w);
  const bool about_largest = H2 > T2 * moments[order[1]];
  if (!about_largest) std::swap(order[0], order[2]);
  std::array<Vector, 3> axes{Vector::unit(order[0]), Vector::unit(order[1]), Vector::unit(order[2])};
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0) axes[1] = -axes[1];
  const Matrix P = Matrix::from_columns(axes[0], axes[1], axes[2]);
  const Number I1 = moments[order[0]], I2 = moments[order[1]], I3 = moments[order[2]];

  // Whittaker's constants: w1 = A1 cn, w2 = A2 sn, w3 = A3 dn.
  const Number m = (I2 - I1) * (T2 * I3 - H2) / ((I3 - I2) * (H2 - T2 * I1));
  const Number k = sqrt(m);
  const Vector v = transpose_times(P, w);
  const Number s1 = v.x < 0 ? -1 : 1, s3 = v.z < 0 ? -1 : 1;
  const Number A1 = s1 * sqrt((T2 * I3 - H2) / (I1 * (I3 - I1)));
  const Number A3 = s3 * sqrt((H2 - T2 * I1) / (I3 * (I3 - I1)));
  // I2 dw2/dt = (I3 - I1) w3 w1 fixes the sense.
  const Number sense = (I3 > I1 ? 1 : -1) * s1 * s3;
  const Number A2 = sense * sqrt((T2 * I3 - H2) / (I2 * (I3 - I2)));
  const Number rate = sqrt((I3 - I2) * (H2 - T2 * I1) / (I1 * I2 * I3));

  // Amplitudes at the start and at t; v.x has the sign of A1: the start is in the middle cell.
  const Number phi0 = atan2(Number(v.y / A2), Number(v.x / A1));
  const Number u0 = boost::math::ellint_1(k, phi0);
  const Number u = u0 + rate * t;
  const Number K = boost::math::ellint_1(k);
  const Number turns = round(Number(u / (2 * K)));
  Number cn, dn;
  Number sn = boost::math::jacobi_elliptic(k, Number(u - 2 * K * turns), &cn, &dn);
  const Number rest = atan2(sn, cn);

  if (turns - 2 * floor(Number(turns / 2)) != 0) {
    sn = -sn;
    cn = -cn;
  }
  const Vector now{A1 * cn, A2 * sn, A3 * dn};

  // d(precession)/dt = H (T2 - I3 w3^2)/(H^2 - I3^2 w3^2), where H^2 - I3^2 w3^2 = I1^2 A1^2 (1 - n sn^2).
  const Number n = 1 - I2 * (I3 - I1) / (I1 * (I3 - I2));
  const Number factor = (T2 * I3 - H2) / (I1 * I1 * A1 * A1) * H / (I3 * rate);
  // The integral over each half turn is that over the two quarter ones.
  const Number half_turn = 2 * boost::math::ellint_3(k, n);
  const Number integral = boost::math::ellint_3(k, n, rest) + turns * half_turn - boost::math::ellint_3(k, n, phi0);
  const Number precession = H * t / I3 + factor * integral;

  // Rotation of the axes about Z = H/|H| by phi, about y by theta, about z by psi; l = (-sin theta cos psi, sin theta
  // sin psi, cos theta).
  const auto rotation = [&](const Number& angle, const Vector& omega) {
    const Vector l{I1 * omega.x / H, I2 * omega.y / H, I3 * omega.z / H};
    const Number s = sqrt(Number(l.x * l.x + l.y * l.y));
    const Number cp = -l.x / s, sp = l.y / s, ca = cos(angle), sa = sin(angle);
    const Matrix about_z{{ca, -sa, 0}, {sa, ca, 0}, {0, 0, 1}};
    const Matrix about_y{{l.z, 0, s}, {0, 1, 0}, {-s, 0, l.z}};
    const Matrix spin{{cp, -sp, 0}, {sp, cp, 0}, {0, 0, 1}};
    return about_z * (about_y * spin);
  };
  const Number size = sqrt(norm_squared(attitude));
  const Quaternion<Number> q0{attitude.w / size, attitude.x / size, attitude.y / size, attitude.z / size};
  const Matrix turn = P * (transpose(rotation(0, v)) * (rotation(precession, now) * transpose(P)));

  // The quaternion of the turn, by its largest component.
  const Number trace = turn.row0.x + turn.row1.y + turn.row2.z;
  Quaternion<Number> q{1 + trace, turn.row2.y - turn.row1.z, turn.row0.z - turn.row2.x, turn.row1.x - turn.row0.y};
  const std::array<Number, 3> diagonal{turn.row0.x, turn.row1.y, turn.row2.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    if (diagonal[i] > trace && diagonal[i] >= diagonal[j] && diagonal[i] >= diagonal[l]) {
      std::array<Number, 3> x;
      x[i] = 1 + diagonal[i] - diagonal[j] - diagonal[l];
      x[j] = turn(i, j) + turn(j, i);
      x[l] = turn(i, l) + turn(l, i);
      q = {turn(l, j) - turn(j, l), x[0], x[1], x[2]};
    }
  }
  const Number length = sqrt(norm_squared(q));
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  return {q0 * q, P * now};
}

}  // namespace poinsot
