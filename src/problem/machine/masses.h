// The mass properties of a body, and the same body as particles.
#pragma once

#include <functional>
#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "poinsot/engine/mass/particle_set.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// Gives values for what is left open by `any`: a value in SI units for each dimension.
using AnyValue = std::function<double(const Dimension&)>;

template <class Scalar>
struct BodyMassOf {
  MassProperties<Scalar> properties;        // on the axes of the ground, as drawn
  Vector3<Scalar> center;                   // of mass, before particles were absorbed
  std::vector<Particle<double>> particles;  // the same body for the check; only for doubles, and if wanted
};
using BodyMass = BodyMassOf<double>;

// The scalar is double, Dual<1> or Formula. lenient: negative masses and impossible inertias are accepted, as
// unknowns have trial values. particles: whether they are wanted then too. Throws StatementError for negative masses,
// shapes without extent, inertias that no body can have, and wrong dimensions.
template <class Scalar>
BodyMassOf<Scalar> body_mass(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient = false,
                             bool particles = false);

// The parts one by one, as drawn, on the axes of the ground: first those under parts: (a body known by numbers counts
// as one), then what is added to it, then particles that stay in it after a blow. A hole has negative mass. The
// scalar is double or Formula. Throws StatementError if a value is given as `any`, and what body_mass (masses.h)
// throws.
template <class Scalar>
std::vector<MassProperties<Scalar>> part_masses(const Body& body, DataScope<Scalar>& data);

}  // namespace poinsot::problem
