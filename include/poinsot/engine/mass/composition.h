// Bodies put together from parts, moved, turned, mirrored, and bodies given by their inertia.
//
// Tensors of inertia hold minus the products of inertia off the diagonal (Eq. 18.8); products have the plus sign of
// Eq. 18.6. R in `rotated` and `transformed` takes components on the old axes to components on the new ones.
#pragma once

#include <cstddef>
#include <vector>

#include "poinsot/engine/mass/inertia_tensors.h"
#include "poinsot/engine/mass/mass_properties.h"

namespace poinsot {

template <class Scalar>
constexpr MassProperties<Scalar> massless() {
  return {Scalar(0), Vector3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
}

// One body of several parts on common axes; holes are parts of negative mass. If the masses add up to zero, the center
// is zero and the inertia that about the origin; for scalars whose comparison gives no bool (packs) every sum of masses
// must differ from zero.
template <class Scalar>
MassProperties<Scalar> sum(const std::vector<MassProperties<Scalar>>& parts) {
  MassProperties<Scalar> whole = massless<Scalar>();
  if (parts.empty()) return whole;
  constexpr bool compares = requires(bool zero) { zero = whole.mass == Scalar(0); };
  // Parts in one place have their center there to the last digit: particles must not get a moment of inertia from
  // rounding. Counted from there the rate of the center is right too, over dual numbers.
  Vector3<Scalar> from = Vector3<Scalar>::zero();
  if constexpr (compares) {
    std::size_t first = 0;
    while (first + 1 < parts.size() && parts[first].mass == Scalar(0)) ++first;
    bool together = true;
    for (std::size_t i = first + 1; i < parts.size() && together; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        together = together && (parts[i].mass == Scalar(0) || parts[i].center[k] == parts[first].center[k]);
    if (together) from = parts[first].center;
  }
  Vector3<Scalar> first_moment = Vector3<Scalar>::zero();
  for (const auto& part : parts) {
    whole.mass += part.mass;
    first_moment += part.mass * (part.center - from);
  }
  if constexpr (compares) {
    if (!(whole.mass == Scalar(0))) whole.center = from + first_moment / whole.mass;
  } else {
    whole.center = from + first_moment / whole.mass;
  }
  for (const auto& part : parts) whole.inertia_center += inertia_about(part, whole.center);
  return whole;
}

// The same shape of mass with all densities multiplied by `factor`; -1 makes a hole of a part.
template <class Scalar>
constexpr MassProperties<Scalar> scaled(const Scalar& factor, const MassProperties<Scalar>& body) {
  return {factor * body.mass, body.center, factor * body.inertia_center};
}

// The body after a translation by d.
template <class Scalar>
constexpr MassProperties<Scalar> translated(const Vector3<Scalar>& d, const MassProperties<Scalar>& body) {
  return {body.mass, body.center + d, body.inertia_center};
}

// The same body on other axes with the same origin.
template <class Scalar>
constexpr MassProperties<Scalar> rotated(const Matrix3<Scalar>& R, const MassProperties<Scalar>& body) {
  return {body.mass, R * body.center, rotated(R, body.inertia_center)};
}

// On axes B, given on axes A: R = R_BA, p = from B's origin to A's, on B's axes.
template <class Scalar>
constexpr MassProperties<Scalar> transformed(const Matrix3<Scalar>& R, const Vector3<Scalar>& p,
                                             const MassProperties<Scalar>& body) {
  return translated(p, rotated(R, body));
}

// The mirror image in the plane through `point` with the given normal.
template <class Scalar>
MassProperties<Scalar> mirrored(const Vector3<Scalar>& point, const Vector3<Scalar>& normal,
                                const MassProperties<Scalar>& body) {
  const Vector3<Scalar> n = normalized(normal);
  const Matrix3<Scalar> M = Matrix3<Scalar>::identity() - Scalar(2) * as_matrix(dyad(n));
  return {body.mass, point + M * (body.center - point), rotated(M, body.inertia_center)};
}

// I_xy, I_yz, I_zx with the plus sign of Eq. 18.6, kg m^2.
template <class Scalar>
struct ProductsOfInertia {
  Scalar xy{};
  Scalar yz{};
  Scalar zx{};
};

// The tensor of Eq. 18.8 from moments (I_x, I_y, I_z) and products of inertia.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> inertia_tensor(const Vector3<Scalar>& moments,
                                                  const ProductsOfInertia<Scalar>& products) {
  return {moments.x, moments.y, moments.z, -products.xy, -products.yz, -products.zx};
}
template <class Scalar>
constexpr Vector3<Scalar> moments_of_inertia(const SymmetricMatrix3<Scalar>& tensor) {
  return {tensor.xx, tensor.yy, tensor.zz};
}
template <class Scalar>
constexpr ProductsOfInertia<Scalar> products_of_inertia(const SymmetricMatrix3<Scalar>& tensor) {
  return {-tensor.xy, -tensor.yz, -tensor.zx};
}

// Body given by its tensor of inertia about a point P; p_OP from the origin to P.
template <class Scalar>
constexpr MassProperties<Scalar> from_inertia_about(const Vector3<Scalar>& p_OP, const Scalar& mass,
                                                    const Vector3<Scalar>& center,
                                                    const SymmetricMatrix3<Scalar>& inertia) {
  return {mass, center, inertia - mass * unit_mass_inertia(center - p_OP)};
}
// Body given by moments and products of inertia about a point P.
template <class Scalar>
constexpr MassProperties<Scalar> from_moments_and_products(const Vector3<Scalar>& p_OP, const Scalar& mass,
                                                           const Vector3<Scalar>& center,
                                                           const Vector3<Scalar>& moments,
                                                           const ProductsOfInertia<Scalar>& products) {
  return from_inertia_about(p_OP, mass, center, inertia_tensor(moments, products));
}

// Body given by its radii of gyration (m) about principal axes through the mass center, the columns of `axes`
// (perpendicular unit vectors): I = m k^2.
template <class Scalar>
constexpr MassProperties<Scalar> from_radii_of_gyration(const Scalar& mass, const Vector3<Scalar>& center,
                                                        const Vector3<Scalar>& radii,
                                                        const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  const Vector3<Scalar> squares{radii.x * radii.x, radii.y * radii.y, radii.z * radii.z};
  return {mass, center, mass * principal_tensor(axes, squares)};
}
// The same with radii about parallel axes through a point P, principal there.
template <class Scalar>
constexpr MassProperties<Scalar> from_radii_of_gyration_about(
    const Vector3<Scalar>& p_OP, const Scalar& mass, const Vector3<Scalar>& center, const Vector3<Scalar>& radii,
    const Matrix3<Scalar>& axes = Matrix3<Scalar>::identity()) {
  return from_inertia_about(p_OP, mass, center, from_radii_of_gyration(mass, center, radii, axes).inertia_center);
}

// Body with moment of inertia `axial` about an axis of symmetry through the mass center, `transverse` across it.
template <class Scalar>
MassProperties<Scalar> axisymmetric(const Scalar& mass, const Vector3<Scalar>& center, const Vector3<Scalar>& axis,
                                    const Scalar& axial, const Scalar& transverse) {
  return {mass, center, axisymmetric_tensor(normalized(axis), axial, transverse)};
}
// The same with both moments about a point P (I and I' of a top about its fixed point).
template <class Scalar>
MassProperties<Scalar> axisymmetric_about(const Vector3<Scalar>& p_OP, const Scalar& mass,
                                          const Vector3<Scalar>& center, const Vector3<Scalar>& axis,
                                          const Scalar& axial, const Scalar& transverse) {
  return from_inertia_about(p_OP, mass, center, axisymmetric_tensor(normalized(axis), axial, transverse));
}

// Moment of inertia about the line through P in the given direction, kg m^2.
template <class Scalar>
Scalar moment_about_axis(const MassProperties<Scalar>& body, const Vector3<Scalar>& p_OP,
                         const Vector3<Scalar>& direction) {
  const Vector3<Scalar> n = normalized(direction);
  return dot(n, inertia_about(body, p_OP) * n);
}

}  // namespace poinsot
