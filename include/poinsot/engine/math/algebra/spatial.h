// Spatial vectors: motions and forces of a rigid body as pairs of 3-vectors (Featherstone, Rigid Body Dynamics
// Algorithms, 2008, chapter 2). Angular part first; the point to which the pair belongs is named where it is used.
#pragma once

#include "poinsot/engine/math/algebra/matrix3.h"
#include "poinsot/engine/math/algebra/rotation.h"

namespace poinsot {

// Angular velocity (rad/s) and velocity of the body's point at the origin (m/s), or the like for displacements and
// accelerations.
template <class Scalar>
struct SpatialMotion {
  Vector3<Scalar> angular{};
  Vector3<Scalar> linear{};

  constexpr SpatialMotion& operator+=(const SpatialMotion& b) {
    angular += b.angular;
    linear += b.linear;
    return *this;
  }
  static constexpr SpatialMotion zero() { return {Vector3<Scalar>::zero(), Vector3<Scalar>::zero()}; }
};

// Moment about the origin (N m) and resultant force (N); also a momentum or an impulse.
template <class Scalar>
struct SpatialForce {
  Vector3<Scalar> moment{};
  Vector3<Scalar> force{};

  constexpr SpatialForce& operator+=(const SpatialForce& b) {
    moment += b.moment;
    force += b.force;
    return *this;
  }
  static constexpr SpatialForce zero() { return {Vector3<Scalar>::zero(), Vector3<Scalar>::zero()}; }
};

template <class Scalar>
constexpr SpatialMotion<Scalar> operator+(SpatialMotion<Scalar> a, const SpatialMotion<Scalar>& b) {
  return a += b;
}
template <class Scalar>
constexpr SpatialMotion<Scalar> operator-(const SpatialMotion<Scalar>& a, const SpatialMotion<Scalar>& b) {
  return {a.angular - b.angular, a.linear - b.linear};
}
template <class Scalar>
constexpr SpatialMotion<Scalar> operator*(const Scalar& s, const SpatialMotion<Scalar>& a) {
  return {s * a.angular, s * a.linear};
}
template <class Scalar>
constexpr SpatialForce<Scalar> operator+(SpatialForce<Scalar> a, const SpatialForce<Scalar>& b) {
  return a += b;
}
template <class Scalar>
constexpr SpatialForce<Scalar> operator-(const SpatialForce<Scalar>& a, const SpatialForce<Scalar>& b) {
  return {a.moment - b.moment, a.force - b.force};
}
template <class Scalar>
constexpr SpatialForce<Scalar> operator*(const Scalar& s, const SpatialForce<Scalar>& a) {
  return {s * a.moment, s * a.force};
}

// Power of a force on a motion, W; both about one point.
template <class Scalar>
constexpr Scalar dot(const SpatialMotion<Scalar>& v, const SpatialForce<Scalar>& f) {
  return dot(v.angular, f.moment) + dot(v.linear, f.force);
}
// v x m: rate of a motion m that is carried along with v (crossm).
template <class Scalar>
constexpr SpatialMotion<Scalar> cross_motion(const SpatialMotion<Scalar>& v, const SpatialMotion<Scalar>& m) {
  return {cross(v.angular, m.angular), cross(v.angular, m.linear) + cross(v.linear, m.angular)};
}
// v x* f: rate of a force f that is carried along with v (crossf).
template <class Scalar>
constexpr SpatialForce<Scalar> cross_force(const SpatialMotion<Scalar>& v, const SpatialForce<Scalar>& f) {
  return {cross(v.angular, f.moment) + cross(v.linear, f.force), cross(v.angular, f.force)};
}

// The pose of a frame B in a frame A: R takes components on B to components on A, p is the origin of B on axes of A, m.
template <class Scalar>
struct SpatialTransform {
  Matrix3<Scalar> R = Matrix3<Scalar>::identity();
  Vector3<Scalar> p = Vector3<Scalar>::zero();

  static constexpr SpatialTransform identity() { return {}; }
  static constexpr SpatialTransform translation(const Vector3<Scalar>& p) { return {Matrix3<Scalar>::identity(), p}; }
};

// X_AC = X_AB X_BC.
template <class Scalar>
constexpr SpatialTransform<Scalar> operator*(const SpatialTransform<Scalar>& X_AB,
                                             const SpatialTransform<Scalar>& X_BC) {
  return {X_AB.R * X_BC.R, X_AB.p + X_AB.R * X_BC.p};
}
// A point's components and place in A from those in B.
template <class Scalar>
constexpr Vector3<Scalar> operator*(const SpatialTransform<Scalar>& X_AB, const Vector3<Scalar>& point_B) {
  return X_AB.p + X_AB.R * point_B;
}
template <class Scalar>
constexpr SpatialTransform<Scalar> inverse(const SpatialTransform<Scalar>& X) {
  return {transpose(X.R), -transpose_times(X.R, X.p)};
}
// The same motion about the origin and on the axes of A (from) and back (to).
template <class Scalar>
constexpr SpatialMotion<Scalar> operator*(const SpatialTransform<Scalar>& X_AB, const SpatialMotion<Scalar>& v_B) {
  const Vector3<Scalar> w = X_AB.R * v_B.angular;
  return {w, X_AB.R * v_B.linear + cross(X_AB.p, w)};
}
template <class Scalar>
constexpr SpatialMotion<Scalar> inverse_times(const SpatialTransform<Scalar>& X_AB, const SpatialMotion<Scalar>& v_A) {
  return {transpose_times(X_AB.R, v_A.angular), transpose_times(X_AB.R, v_A.linear + cross(v_A.angular, X_AB.p))};
}
template <class Scalar>
constexpr SpatialForce<Scalar> operator*(const SpatialTransform<Scalar>& X_AB, const SpatialForce<Scalar>& f_B) {
  const Vector3<Scalar> f = X_AB.R * f_B.force;
  return {X_AB.R * f_B.moment + cross(X_AB.p, f), f};
}
template <class Scalar>
constexpr SpatialForce<Scalar> inverse_times(const SpatialTransform<Scalar>& X_AB, const SpatialForce<Scalar>& f_A) {
  return {transpose_times(X_AB.R, f_A.moment - cross(X_AB.p, f_A.force)), transpose_times(X_AB.R, f_A.force)};
}

// Inertia of a rigid body about the origin of its frame: ten numbers.
template <class Scalar>
struct SpatialInertia {
  Scalar mass{};                       // kg
  Vector3<Scalar> first_moment{};      // mass times the place of the mass center, kg m
  SymmetricMatrix3<Scalar> inertia{};  // tensor of inertia about the origin (Eq. 18.8), kg m^2

  static constexpr SpatialInertia zero() {
    return {Scalar(0), Vector3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
  }
  // center: from the origin to the mass center G, m. inertia_center: tensor of inertia about G, kg m^2.
  static constexpr SpatialInertia of(const Scalar& mass, const Vector3<Scalar>& center,
                                     const SymmetricMatrix3<Scalar>& inertia_center) {
    return {mass, mass * center, inertia_center + mass * unit_mass_inertia(center)};
  }
  constexpr SpatialInertia& operator+=(const SpatialInertia& b) {
    mass += b.mass;
    first_moment += b.first_moment;
    inertia += b.inertia;
    return *this;
  }
};

template <class Scalar>
constexpr SpatialInertia<Scalar> operator+(SpatialInertia<Scalar> a, const SpatialInertia<Scalar>& b) {
  return a += b;
}
// Momentum (H_O, L) of the motion v (Eqs. 18.11 to 18.13): H_O = I_O w + h x v_O, L = m v_O + w x h.
template <class Scalar>
constexpr SpatialForce<Scalar> operator*(const SpatialInertia<Scalar>& I, const SpatialMotion<Scalar>& v) {
  return {I.inertia * v.angular + cross(I.first_moment, v.linear),
          I.mass * v.linear + cross(v.angular, I.first_moment)};
}
// The same inertia on turned axes: R takes components on the old axes to the new ones.
template <class Scalar>
constexpr SpatialInertia<Scalar> turned(const Matrix3<Scalar>& R, const SpatialInertia<Scalar>& I) {
  return {I.mass, R * I.first_moment, turned(R, I.inertia)};
}
// The same inertia about a new origin from which the old one is at r (parallel axes, without passing through G).
template <class Scalar>
constexpr SpatialInertia<Scalar> shifted(const SpatialInertia<Scalar>& I, const Vector3<Scalar>& r) {
  const Vector3<Scalar> moment = I.first_moment + I.mass * r;
  const Vector3<Scalar> g = I.first_moment + moment;
  const Scalar xx = r.x * g.x;
  const Scalar yy = r.y * g.y;
  const Scalar zz = r.z * g.z;
  const Scalar half(0.5);
  const SymmetricMatrix3<Scalar> change{yy + zz,
                                        zz + xx,
                                        xx + yy,
                                        -half * (r.x * g.y + r.y * g.x),
                                        -half * (r.y * g.z + r.z * g.y),
                                        -half * (r.z * g.x + r.x * g.z)};
  return {I.mass, moment, I.inertia + change};
}
// The inertia of a body known in frame B, about the origin and on the axes of A.
template <class Scalar>
constexpr SpatialInertia<Scalar> operator*(const SpatialTransform<Scalar>& X_AB, const SpatialInertia<Scalar>& I_B) {
  return shifted(turned(X_AB.R, I_B), X_AB.p);
}

// Inertia felt at a body when the joints outboard of it give way: the symmetric 6x6 matrix [I H; H^T M] in 21 numbers.
// moment = I alpha + H a, force = H^T alpha + M a.
template <class Scalar>
struct ArticulatedInertia {
  SymmetricMatrix3<Scalar> inertia{};
  Matrix3<Scalar> coupling{};
  SymmetricMatrix3<Scalar> mass{};

  static constexpr ArticulatedInertia zero() {
    return {SymmetricMatrix3<Scalar>::zero(), Matrix3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
  }
  static constexpr ArticulatedInertia of(const SpatialInertia<Scalar>& I) {
    return {I.inertia, cross_matrix(I.first_moment), SymmetricMatrix3<Scalar>::diagonal(I.mass, I.mass, I.mass)};
  }
  constexpr ArticulatedInertia& operator+=(const ArticulatedInertia& b) {
    inertia += b.inertia;
    coupling = coupling + b.coupling;
    mass += b.mass;
    return *this;
  }
};

template <class Scalar>
constexpr SpatialForce<Scalar> operator*(const ArticulatedInertia<Scalar>& I, const SpatialMotion<Scalar>& a) {
  return {I.inertia * a.angular + I.coupling * a.linear, transpose_times(I.coupling, a.angular) + I.mass * a.linear};
}
// s n n^T.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> dyad(const Scalar& s, const Vector3<Scalar>& n) {
  const Vector3<Scalar> m = s * n;
  return {m.x * n.x, m.y * n.y, m.z * n.z, m.x * n.y, m.y * n.z, m.z * n.x};
}
// I - s U U^T.
template <class Scalar>
constexpr ArticulatedInertia<Scalar> reduced(const ArticulatedInertia<Scalar>& I, const SpatialForce<Scalar>& U,
                                             const Scalar& s) {
  const Vector3<Scalar> m = s * U.moment;
  const Vector3<Scalar> f = s * U.force;
  const auto lessened = [](const SymmetricMatrix3<Scalar>& A, const Vector3<Scalar>& scaled, const Vector3<Scalar>& u) {
    return SymmetricMatrix3<Scalar>{A.xx - scaled.x * u.x, A.yy - scaled.y * u.y, A.zz - scaled.z * u.z,
                                    A.xy - scaled.x * u.y, A.yz - scaled.y * u.z, A.zx - scaled.z * u.x};
  };
  return {lessened(I.inertia, m, U.moment),
          {I.coupling.row0 - m.x * U.force, I.coupling.row1 - m.y * U.force, I.coupling.row2 - m.z * U.force},
          lessened(I.mass, f, U.force)};
}
// The same inertia about a new origin from which the old one is at r. With M the mass block: H' = H + [r]x M and
// I' = I + ([r]x (H + H')^T)_sym.
template <class Scalar>
constexpr ArticulatedInertia<Scalar> shifted(const ArticulatedInertia<Scalar>& I, const Vector3<Scalar>& r) {
  const SymmetricMatrix3<Scalar>& M = I.mass;
  const Matrix3<Scalar> C{{I.coupling.row0.x + (r.y * M.zx - r.z * M.xy), I.coupling.row0.y + (r.y * M.yz - r.z * M.yy),
                           I.coupling.row0.z + (r.y * M.zz - r.z * M.yz)},
                          {I.coupling.row1.x + (r.z * M.xx - r.x * M.zx), I.coupling.row1.y + (r.z * M.xy - r.x * M.yz),
                           I.coupling.row1.z + (r.z * M.zx - r.x * M.zz)},
                          {I.coupling.row2.x + (r.x * M.xy - r.y * M.xx), I.coupling.row2.y + (r.x * M.yy - r.y * M.xy),
                           I.coupling.row2.z + (r.x * M.yz - r.y * M.zx)}};
  const Matrix3<Scalar> S = I.coupling + C;
  const Scalar half(0.5);
  const SymmetricMatrix3<Scalar> change{r.y * S.row0.z - r.z * S.row0.y,
                                        r.z * S.row1.x - r.x * S.row1.z,
                                        r.x * S.row2.y - r.y * S.row2.x,
                                        half * (r.y * S.row1.z - r.z * S.row1.y + r.z * S.row0.x - r.x * S.row0.z),
                                        half * (r.z * S.row2.x - r.x * S.row2.z + r.x * S.row1.y - r.y * S.row1.x),
                                        half * (r.x * S.row0.y - r.y * S.row0.x + r.y * S.row2.z - r.z * S.row2.y)};
  return {I.inertia + change, C, M};
}

// Inverse of a symmetric matrix by its adjugate; not finite for a singular one.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> inverse(const SymmetricMatrix3<Scalar>& a) {
  const Scalar cxx = a.yy * a.zz - a.yz * a.yz;
  const Scalar cxy = a.yz * a.zx - a.xy * a.zz;
  const Scalar czx = a.xy * a.yz - a.yy * a.zx;
  const Scalar s = Scalar(1) / (a.xx * cxx + a.xy * cxy + a.zx * czx);
  return {s * cxx, s * (a.zz * a.xx - a.zx * a.zx), s * (a.xx * a.yy - a.xy * a.xy),
          s * cxy, s * (a.xy * a.zx - a.xx * a.yz), s * czx};
}

}  // namespace poinsot
