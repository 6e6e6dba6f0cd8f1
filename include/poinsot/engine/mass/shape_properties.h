// Extent, center and inertia of uniform shapes, before they are given a mass or a density.
#pragma once

#include <vector>

#include "poinsot/engine/mass/mass_properties.h"

namespace poinsot {

// A uniform line, sheet or solid on axes that the caller fixes.
template <class Scalar>
struct ShapeProperties {
  Scalar measure{};                           // length (m), area (m^2) or volume (m^3); 0 for a particle
  Vector3<Scalar> center{};                   // from the origin to the centroid, m
  SymmetricMatrix3<Scalar> inertia_center{};  // tensor of inertia about the centroid per unit mass, m^2
};

// The shape with a given mass in kg; a negative mass makes a hole.
template <class Scalar>
constexpr MassProperties<Scalar> of_mass(const ShapeProperties<Scalar>& shape, const Scalar& mass) {
  return {mass, shape.center, mass * shape.inertia_center};
}

// The shape with a given mass per length (kg/m), area (kg/m^2) or volume (kg/m^3), as its measure is.
template <class Scalar>
constexpr MassProperties<Scalar> of_density(const ShapeProperties<Scalar>& shape, const Scalar& density) {
  return of_mass(shape, density * shape.measure);
}

// Several shapes of one uniform density as one shape: a bent wire, a box of sheets. Not finite when the measures add up
// to zero.
template <class Scalar>
ShapeProperties<Scalar> united(const std::vector<ShapeProperties<Scalar>>& parts) {
  ShapeProperties<Scalar> whole{Scalar(0), Vector3<Scalar>::zero(), SymmetricMatrix3<Scalar>::zero()};
  for (const auto& part : parts) {
    whole.measure += part.measure;
    whole.center += part.measure * part.center;
  }
  whole.center = whole.center / whole.measure;
  for (const auto& part : parts) {
    const Scalar share = part.measure / whole.measure;
    whole.inertia_center += share * (part.inertia_center + unit_mass_inertia(part.center - whole.center));
  }
  return whole;
}

}  // namespace poinsot
