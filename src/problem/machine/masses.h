// Mass properties of a stated body, and the same body as particles.
#pragma once

#include <functional>
#include <vector>

#include "poinsot/engine/mass/mass_properties.h"
#include "poinsot/engine/mass/particle_set.h"
#include "problem/machine/data.h"

namespace poinsot::problem {

// Values for what a statement leaves open with `any`: called with the dimension, gives a value in SI.
using AnyValue = std::function<double(const Dimension&)>;

template <class Scalar>
struct BodyMassOf {
  MassProperties<Scalar> properties;        // on the ground's axes, as drawn
  Vector3<Scalar> center;                   // of mass, before it absorbed particles
  std::vector<Particle<double>> particles;  // the same body on the independent road; only of doubles, and not of trials
};
using BodyMass = BodyMassOf<double>;

// Scalar: double or Dual<1>. Throws StatementError: negative masses, shapes without extent, inertias that no body can
// have, wrong dimensions.
// lenient: for trial values of unknowns, negative masses and impossible inertias pass.
template <class Scalar>
BodyMassOf<Scalar> body_mass(const Body& body, DataScope<Scalar>& data, const AnyValue& any, bool lenient = false);

}  // namespace poinsot::problem
