// Mass, mass center and inertia of a rigid body, and how those of parts add up (section 18.2 of docs/theory.md).
#pragma once

#include "poinsot/engine/math/algebra/matrix3.h"

namespace poinsot {

// On axes that the caller fixes. A massless body has mass zero, and then its center is meaningless and kept at zero.
template <class Scalar>
struct MassProperties {
  Scalar mass{};                              // kg; negative for a hole
  Vector3<Scalar> center{};                   // from the origin to the mass center G, m
  SymmetricMatrix3<Scalar> inertia_center{};  // tensor of inertia about G (Eq. 18.8), kg m^2
};

// Tensor of inertia about a point P (by the parallel-axis theorem), kg m^2. p_OP: from the origin to P, m.
template <class Scalar>
constexpr SymmetricMatrix3<Scalar> inertia_about(const MassProperties<Scalar>& body, const Vector3<Scalar>& p_OP) {
  return body.inertia_center + body.mass * unit_mass_inertia(body.center - p_OP);
}

}  // namespace poinsot
